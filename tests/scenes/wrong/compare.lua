local dem = require "dem"
dem.simulation {}
dem.compare { what = "period", value = 1, tolerance = 0 }
-->:3: compare.reference: is missing; it must be a number
-->:3: compare.tolerance = 0: must be positive
