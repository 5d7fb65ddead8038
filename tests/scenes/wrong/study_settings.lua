local dem = require "dem"
local p = dem.param { radius = 1, count = 3 }
dem.study { vary = { radius = 1, count = { 3, 3 } }, measure = 5, seeds = 0.5, reference = "coarsest", tolerance = true, sizes = "radius", order = 2, repeats = 0 }
dem.study { measure = "x" }
-->:3: study.sizes = "radius": unknown setting; did you mean "size"?
-->:3: study.measure = 5: must be a text in quotes
-->:3: study.repeats = 0: must be at least 1
-->:3: study.order = 2: must be two numbers { x, y }
-->:3: study.vary.count[2] = 3: is in the list already
-->:3: study.vary.radius = 1: must be a list of at least one value
-->:3: study.seeds = 0.5: must be a whole number from 1 to 1000
-->:3: study.reference = "coarsest": must be a number, a function of the parameters or "finest"
-->:3: study.tolerance = true: must be a number or a function of the parameters
-->:4: study: only one to a scene
