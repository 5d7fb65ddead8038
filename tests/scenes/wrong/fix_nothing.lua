local dem = require "dem"
local sim = dem.simulation {}
sim:fix {}
-->:3: fix: selects nothing: give a body, a side, within or where
