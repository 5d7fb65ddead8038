local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
sim:body {
  name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } },
  packing = dem.close_packed { radius = 0.1 }, bonds = dem.plateau {},
}
-->:4: body.bonds = dem.plateau: needs tensile_strength in material "concrete"
-->:4: body.bonds = dem.plateau: needs fracture_toughness or fracture_energy in material "concrete"
