local dem = require "dem"
dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, densty = 2400 }
-->:2: material.densty = 2400: unknown setting; did you mean "density"?
