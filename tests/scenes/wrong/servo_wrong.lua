local dem = require "dem"
local sim = dem.simulation {}
sim:wall { name = "a", path = { { 0, 0 }, { 1, 0 } }, servo = { gain = 0.1 } }
sim:wall { name = "b", path = { { 0, 0 }, { 1, 0 } }, servo = { stress_x = 1e5 } }
sim:wall { name = "c", path = { { 0, 0 }, { 1, 0 } }, servo = { stress_y = 1e5, force_y = 1 } }
sim:wall { name = "d", path = { { 0, 0 }, { 1, 0 } }, servo = { stress_y = 1e5, travel = 0 } }
sim:wall { name = "e", path = { { 0, 0 }, { 1, 0 }, { 0, 0 } } }
-->:6: wall.servo.travel = 0: must be positive
-->:3: wall.servo: seeks nothing: give stress_x, stress_y, force_x or force_y
-->:4: wall.servo.stress_x: needs a wall with a height; give force_x
-->:5: wall.servo.force_y: must not be given beside stress_y
-->:7: wall.path: must have three points or more to be closed
