local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "soil", material = concrete, region = dem.half_plane { outward = { 0, 1 } }, packing = dem.close_packed { radius = 0.1 } }
-->:4: body.region: has no end; cut it with a * b where b is finite
