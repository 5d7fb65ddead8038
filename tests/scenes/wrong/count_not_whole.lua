local dem = require "dem"
dem.consolidated { count = 12.5 }
-->:2: consolidated.count = 12.5: must be a whole number
