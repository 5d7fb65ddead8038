local dem = require "dem"
local sim = dem.simulation {}
local m = dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 3e6, fracture_toughness = 1e6 }
local box = dem.rectangle { size = { 4, 4 } }
local packing = dem.close_packed { radius = 0.2 }
sim:body { name = "a", material = m, region = box, packing = packing, bonds = dem.plateau {} }
sim:body { name = "b", material = m, region = box, packing = packing, bonds = dem.softening {} }
sim:body { name = "c", material = m, region = box, packing = packing, bonds = dem.plateau { stiffness = "facets" } }
sim:body { name = "d", material = m, region = box, packing = packing, bonds = dem.brittle_tensile {} }
-->:6: X
