local dem = require "dem"
local sim = dem.simulation {}
dem.rectangle(1, 2)
-->:3: rectangle = 1: must be given one table of settings; as in dem.rectangle { at = { 0, 0 }, size = { 1.5, 0.25 } }
