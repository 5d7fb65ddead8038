local dem = require "dem"
local hole = dem.disc { radius = 1 } - 1
-->:2: a - b takes a region from a region, not 1
