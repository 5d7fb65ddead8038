local dem = require "dem"
dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 0, fracture_toughness = 1e6 }
dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 3e6, fracture_toughness = -1e6 }
dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 3e6, fracture_energy = 0 }
-->:2: material.tensile_strength = 0: must be positive
-->:3: material.fracture_toughness = -1000000: must be positive
-->:4: material.fracture_energy = 0: must be positive
