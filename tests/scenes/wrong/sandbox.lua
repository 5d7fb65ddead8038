local dem = require "dem"
local lfs = require "lfs"
-->:2: require knows "dem" only, not "lfs"; another scene is run with dem.include "file" { ... }
