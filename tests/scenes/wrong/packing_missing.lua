local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "beam", material = concrete, region = dem.disc { radius = 1 }, bonds = dem.elastic {} }
-->:4: body.packing: is missing; it must be a packing: dem.close_packed, dem.consolidated, dem.relaxed or dem.disks
