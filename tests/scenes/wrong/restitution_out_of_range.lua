local dem = require "dem"
dem.material { youngs_modulus = 1e9, poissons_ratio = 0.3, density = 1000, restitution = 1.5 }
-->:2: material.restitution = 1.5: must be above 0 and at most 1
