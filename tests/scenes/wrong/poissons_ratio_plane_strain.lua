local dem = require "dem"
dem.material { youngs_modulus = 1e9, poissons_ratio = 0.3, density = 1000 }
dem.simulation { plane = "strain" }
-->:2: material.poissons_ratio = 0.3: must be at most 1/4 in plane strain; beyond it bonds would need a negative shear stiffness
