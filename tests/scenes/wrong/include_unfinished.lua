local dem = require "dem"
local sim = dem.simulation {}
dem.include "../right/plain.lua"
-->:3: include: must be given one table of parameters; as in dem.include "file.lua" { speed = 2 }
