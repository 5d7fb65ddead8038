local dem = require "dem"
local p = dem.param { impact_speed = 80 }
print(p.impct_speed)
-->:3: unknown parameter "impct_speed"; did you mean "impact_speed"?
