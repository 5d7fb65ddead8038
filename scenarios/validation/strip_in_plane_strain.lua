-- Question: does a consolidated pack of facets keep E and nu where the solid hardly gives in volume?
-- Source:   as strip_in_tension.lua, whose set-up this is, in plane strain with nu = 0.45. Eqs 15 and 16 end at nu = 1/4.
-- See:      modulus and ratio in the results.
-- Takes:    a second; the study ten seconds.
local dem = require "dem"

dem.include "strip_in_tension.lua" { plane = "strain", nu = 0.45 }
