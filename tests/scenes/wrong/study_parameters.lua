local dem = require "dem"
local p = dem.param { radius = 1, scheme = "plain" }
dem.study { vary = { radios = { 1, 2 }, scheme = { 3 } }, measure = "x", reference = 1, seeds = 3 }
dem.simulation {}
-->:3: study.vary.radios: no such parameter in this scene; did you mean "radius"?
-->:3: study.vary.scheme = 3: must be a text, as the parameter is
-->:3: study.seeds: there is no parameter "seed" in this scene
