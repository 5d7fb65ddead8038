local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:force { beam.top, x = { 0, 1 }, y = "up" }
sim:move { beam.top, velocity = 3 }
-->:5: force.x = { 0, 1 }: must be a number, a table of { time, value } pairs or a function of time in N
-->:5: force.y = "up": must be a number, a table of { time, value } pairs or a function of time in N
-->:6: move.velocity = 3: must be { x, y }, each a number, a table of { time, value } pairs or a function of time in m/s
