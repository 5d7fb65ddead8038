local dem = require "dem"
local sim = dem.simulation {}
sim:wall { name = "a", path = { { 0, 0 }, { 0, 0 } } }
sim:wall { name = "b", path = { { 0, 0 } } }
-->:3: wall.path[2]: must differ from the point before it
-->:4: wall.path: must have at least two points
