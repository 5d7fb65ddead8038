local dem = require "dem"
dem.material { youngs_modulus = 1 / 0, poissons_ratio = 0 / 0, density = 2400 }
-->:2: material.youngs_modulus = inf: must be finite
-->:2: material.poissons_ratio = nan: must be finite
