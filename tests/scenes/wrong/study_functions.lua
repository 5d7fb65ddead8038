local dem = require "dem"
local p = dem.param { radius = 1 }
dem.study {
  vary = { radius = { 1, 2 } }, measure = "x",
  size = function(q) return -q.radius end, reference = function(q) return q.height end, tolerance = function() return "x" end,
}
dem.simulation {}
-->:3: study.size = -1: must be positive
-->:5: unknown parameter "height"
-->:3: study.tolerance = "x": must give a finite number
