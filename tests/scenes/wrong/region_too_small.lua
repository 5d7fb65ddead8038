local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "chip", material = concrete, region = dem.rectangle { size = { 1, 0.1 } }, packing = dem.close_packed { radius = 0.1 } }
-->:4: body.region = 1 m by 0.1 m: is too small for one element of radius 0.1 m
