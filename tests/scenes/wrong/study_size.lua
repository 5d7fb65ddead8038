local dem = require "dem"
local p = dem.param { radius = 1, fraction = 0.5 }
dem.study { vary = { radius = { 1, 2 }, fraction = { 0.5, 0.25 } }, measure = "x", reference = 1 }
dem.simulation {}
-->:3: study.size: must name the one of fraction, radius that is the element size
