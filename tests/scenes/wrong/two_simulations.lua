local dem = require "dem"
local sim = dem.simulation {}
dem.simulation { title = "another" }
-->:3: simulation: only one to a scene
