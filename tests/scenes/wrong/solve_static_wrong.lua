local dem = require "dem"
local sim = dem.simulation {}
sim:solve_static { tolerance = 0, linea = true }
-->:3: solve_static.linea = true: unknown setting; did you mean "linear"?
-->:3: solve_static.tolerance = 0: must be positive
-->:3: solve_static: there is no body to run
