local dem = require "dem"
dem.include "../right/plain.lua" { duratoin = 1 }
-->:2: include.duratoin: is not a parameter of ../right/plain.lua; did you mean "duration"?
