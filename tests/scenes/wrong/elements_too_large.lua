local dem = require "dem"
local sim = dem.simulation {}
local m = dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 3e6, fracture_toughness = 1e6 }
local box = dem.rectangle { size = { 4, 4 } }
local packing = dem.close_packed { radius = 0.4 }
sim:body { name = "a", material = m, region = box, packing = packing, bonds = dem.plateau {} }
sim:body { name = "b", material = m, region = box, packing = packing, bonds = dem.softening {} }
sim:body { name = "c", material = m, region = box, packing = packing, bonds = dem.plateau { stiffness = "facets" } }
sim:body { name = "d", material = m, region = box, packing = packing, bonds = dem.brittle_tensile {} }
-->:6: body.bonds = dem.plateau: cannot be resolved by elements of radius 0.4 m: bonds would store more than their fracture energy before they yield (delta_max < delta_crit); the largest radius is 0.314204 m
-->:7: body.bonds = dem.softening: cannot be resolved by elements of radius 0.4 m: bonds would store more than their fracture energy before they yield (delta_max < delta_crit); the largest radius is 0.265448 m
-->:8: body.bonds = dem.plateau: cannot be resolved by elements that stand apart by 0.8 m: bonds would store more than their fracture energy before they yield (delta_max < delta_crit); the largest distance is 0.222222 m
