local dem = require "dem"
local sim = dem.simulation {}
local rock = dem.material { name = "rock", youngs_modulus = 1e9, poissons_ratio = 0.2, density = 2000 }
local box = dem.rectangle { size = { 1, 1 } }

local function body(name, packing)
  sim:body { name = name, material = rock, region = box, packing = packing }
end

body("negative", dem.relaxed { size = function(x, y) return -x end })
body("zero", dem.relaxed { size = function(x, y) return 0 end })
body("none", dem.relaxed { size = function(x, y) end })
body("text", dem.relaxed { size = function(x, y) return "fine" end })
body("nan", dem.relaxed { size = function(x, y) return 0 / 0 end })
body("number", dem.relaxed { size = 0.1 })
body("nothing", dem.relaxed { steps = 3 })
body("both", dem.relaxed { count = 10, spacing = 0.1 })
sim:run { duration = 1 }
-->:15: relaxed.size = 0.1: must be a function of x and y that gives a positive number
-->:10: relaxed.size = -0.5: must return a positive number
-->:11: relaxed.size = 0: must return a positive number
-->:12: relaxed.size = nil: must return a positive number
-->:13: relaxed.size = "fine": must return a positive number
-->:14: relaxed.size = nan: must return a positive number
-->:7: relaxed.count: exactly one of count, spacing and size must be given
-->:7: relaxed.count: exactly one of count, spacing and size must be given
-->:7: relaxed.count = 10: exactly one of count, spacing and size must be given
