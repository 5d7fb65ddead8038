local dem = require "dem"
dem.material { poissons_ratio = 0.2 }
-->:2: material.youngs_modulus: is missing; it must be a number in Pa
-->:2: material.density: is missing; it must be a number in kg/m^3
