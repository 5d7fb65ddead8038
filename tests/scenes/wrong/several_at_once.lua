local dem = require "dem"
local steel = dem.material { youngs_modulus = 0, poissons_ratio = 0.3, density = 7850, freeze = 1 }
local sim = dem.simulation { gravity = 9.81 }
sim:body { name = "shot", material = steel, region = dem.disc { radius = -1 }, packing = dem.close_packed { radius = 1e-3 } }
-->:2: material.freeze = 1: unknown setting; known are name, youngs_modulus, poissons_ratio, density, tensile_strength, fracture_toughness, fracture_energy, rate_factor, friction, rolling_friction, wear_energy_density, restitution, contact_damping
-->:2: material.youngs_modulus = 0: must be positive
-->:3: simulation.gravity = 9.81: must be two numbers { x, y } in m/s^2
-->:4: disc.radius = -1: must be positive
