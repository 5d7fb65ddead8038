local dem = require "dem"
local sim = dem.simulation {}
sim.fix { }
-->:3: call it with a colon: sim:fix { ... }
