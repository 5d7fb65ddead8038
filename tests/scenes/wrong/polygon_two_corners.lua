local dem = require "dem"
dem.polygon { { 0, 0 }, { 1, 0 } }
-->:2: polygon: must have at least three corners
