local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:fix { beam, where = function(x, y) return x end }
sim:run { duration = 1 }
-->:5: fix.where = 0.5: must return true or false
