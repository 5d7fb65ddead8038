local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:run { duration = 1 }
local speed = beam.velocity.y
sim:fix { beam, within = dem.disc { radius = speed } }
sim:run { duratoin = 2 }
-->:8: run.duratoin = 2: unknown setting; did you mean "duration"?
