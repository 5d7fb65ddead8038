local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:move { beam.top }
sim:move { beam.top, velocity_x = 1, displacement_x = 2 }
-->:5: move: prescribes nothing: give velocity, displacement or spin
-->:6: move.displacement_x: must not be given beside velocity_x
