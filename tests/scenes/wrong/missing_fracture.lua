local dem = require "dem"
local sim = dem.simulation {}
local plain = dem.material { name = "plain", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local tough = dem.material { name = "tough", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, fracture_energy = 30 }
local box = dem.rectangle { size = { 1, 1 } }
local packing = dem.close_packed { radius = 0.05 }
sim:body { name = "a", material = plain, region = box, packing = packing, bonds = dem.brittle_tensile {} }
sim:body { name = "b", material = plain, region = box, packing = packing, bonds = dem.brittle_toughness {} }
sim:body { name = "c", material = tough, region = box, packing = packing, bonds = dem.brittle_toughness {} }
sim:body { name = "d", material = tough, region = box, packing = packing, bonds = dem.softening {} }
-->:7: body.bonds = dem.brittle_tensile: needs tensile_strength in material "plain"
-->:8: body.bonds = dem.brittle_toughness: needs fracture_toughness or fracture_energy in material "plain"
-->:10: body.bonds = dem.softening: needs tensile_strength in material "tough"
