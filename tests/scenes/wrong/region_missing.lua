local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "beam", material = concrete, packing = dem.close_packed { radius = 0.1 } }
-->:4: body.region: is missing or empty; only dem.disks needs none
