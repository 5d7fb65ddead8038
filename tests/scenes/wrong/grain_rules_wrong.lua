local dem = require "dem"
local stone = dem.material { youngs_modulus = 1e9, poissons_ratio = 0.2, density = 2600, wear_energy_density = 1e4 }
local sim = dem.simulation { periodic_x = { 0.3, 0.1 } }
sim:contact { stone, stone, restitution = 0.5, contact_damping = 0.1 }
sim:grains { name = "bed", material = stone, region = dem.rectangle { size = { 0.1, 0.1 } }, radius = 2e-3, porosity = 0.3, shape = dem.cluster { elements = 3, bonds = dem.elastic {} } }
sim:run { duration = 1 }
-->:4: contact.contact_damping = 0.1: must not be given beside restitution; each follows from the other
-->:5: body.bonds = "elastic": must be able to break, for the material has a wear_energy_density; take another law, or rigid clusters
-->:3: simulation.periodic_x = 0.3, 0.1: must be the left edge and then the right one
