local dem = require "dem"
local sim = dem.simulation {}
sim:damping { fraction = 0.1, frequency = 100, second_fraction = 0.1 }
-->:3: damping.second_frequency: is missing: it goes with second_fraction
