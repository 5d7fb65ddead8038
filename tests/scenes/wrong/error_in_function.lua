local dem = require "dem"
local function twice(x)
  return 2 * x
end
twice({})
-->:3: attempt to perform arithmetic on a table value (local 'x')
