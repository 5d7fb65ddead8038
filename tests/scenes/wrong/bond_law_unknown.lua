local dem = require "dem"
local p = dem.param { law = "platau" }
dem.bond_law(p.law) {}
-->:3: unknown bond law "platau"; did you mean "plateau"?
