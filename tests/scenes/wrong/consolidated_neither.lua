local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body { name = "beam", material = concrete, region = dem.disc { radius = 1 }, packing = dem.consolidated { cluster = 5, seed = -1 } }
-->:4: consolidated.cluster = 5: must be 1, 2, 3, 4 or 7
-->:4: consolidated.seed = -1: must not be negative
