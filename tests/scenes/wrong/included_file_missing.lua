local dem = require "dem"
dem.include "not_there.lua" { speed = 1 }
-->:2: include = "not_there.lua": no such file
