local dem = require "dem"
local sim = dem.simulation {}
dem.material { youngs_modulus = 1e9, poissons_ratio = 0.3, density = 1000, restitution = 0.5, contact_damping = 0.2 }
-->:3: material.contact_damping = 0.2: must not be given beside restitution; each follows from the other
