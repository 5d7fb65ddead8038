local dem = require "dem"
dem.simulation { plane = "stres", time_step = "exact" }
-->:2: simulation.plane = "stres": must be "stress" or "strain"; did you mean "stress"?
-->:2: simulation.time_step = "exact": must be "sharp", "bound" or "paper"
