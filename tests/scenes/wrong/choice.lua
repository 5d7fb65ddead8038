local dem = require "dem"
dem.simulation { plane = "stres", step_rule = "exact" }
-->:2: simulation.plane = "stres": must be "stress" or "strain"; did you mean "stress"?
-->:2: simulation.step_rule = "exact": must be "bound" or "paper"
