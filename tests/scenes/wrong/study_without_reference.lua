local dem = require "dem"
local p = dem.param { radius = 1 }
dem.study { vary = { radius = { 1, 2 } }, measure = "x" }
dem.simulation {}
dem.result { x = 1 }
-->:3: study.reference: is missing; give a number, a function of the parameters or "finest", or publish `reference` with dem.result
