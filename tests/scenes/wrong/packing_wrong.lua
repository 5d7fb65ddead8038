local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "beam", material = "concrete", region = { 1, 1 }, packing = dem.close_packed, bonds = dem.elastic }
-->:4: body.material = "concrete": must be a material made with dem.material
-->:4: body.region = { 1, 1 }: must be a region, such as dem.rectangle { ... }
-->:4: body.packing = a function: must be a packing: dem.close_packed, dem.consolidated, dem.relaxed or dem.disks
-->:4: body.bonds = a function: must be a bond law, such as dem.plateau {}
