local dem = require "dem"
dem.material { youngs_modulus = -30e9, poissons_ratio = 0.2, density = 2400, friction = -0.5 }
-->:2: material.youngs_modulus = -30000000000: must be positive
-->:2: material.friction = -0.5: must not be negative
