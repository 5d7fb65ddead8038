local dem = require "dem"
local sim = dem.simulation {}
sim:history { every = 1e-3, a = "sped", b = 3 }
-->:3: history.a = "sped": is not a field of elements; did you mean "speed"?
-->:3: history.b = 3: must be a function of now or the name of an element field
