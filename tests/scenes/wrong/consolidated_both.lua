local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "beam", material = concrete, region = dem.disc { radius = 1 }, packing = dem.consolidated { count = 100, radius = 0.1 } }
-->:4: consolidated.count = 100: exactly one of count and radius must be given
