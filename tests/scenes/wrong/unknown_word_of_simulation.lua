local dem = require "dem"
local sim = dem.simulation {}
sim:fixx { }
-->:3: unknown word of sim "fixx"; did you mean "fix"?
