local dem = require "dem"
dem.material { youngs_modulus = "30e9", poissons_ratio = 0.2, density = { 1 } }
-->:2: material.youngs_modulus = "30e9": must be a number in Pa
-->:2: material.density = { 1 }: must be a number in kg/m^3
