local dem = require "dem"
dem.material { youngs_modulus = 1e9, poissons_ratio = 0.5, density = 1000 }
-->:2: material.poissons_ratio = 0.5: must lie between -1 and 0.5
