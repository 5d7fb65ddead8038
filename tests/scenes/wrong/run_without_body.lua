local dem = require "dem"
local sim = dem.simulation {}
sim:run { duration = 1 }
-->:3: run: there is no body to run
