local dem = require "dem"
dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 0 }
-->:2: material.density = 0: must be positive
