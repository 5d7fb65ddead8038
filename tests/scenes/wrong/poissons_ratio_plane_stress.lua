local dem = require "dem"
dem.simulation { plane = "stress" }
dem.material { youngs_modulus = 1e9, poissons_ratio = 0.34, density = 1000 }
-->:3: material.poissons_ratio = 0.34: must be at most 1/3 in plane stress; beyond it bonds would need a negative shear stiffness
