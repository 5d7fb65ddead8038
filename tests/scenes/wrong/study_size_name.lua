local dem = require "dem"
local p = dem.param { radius = 1, fraction = 0.5 }
dem.study { vary = { radius = { 1, 2 } }, size = "radios", measure = "x", reference = 1 }
dem.simulation {}
-->:3: study.size = "radios": is no number that study.vary varies; did you mean "radius"?
