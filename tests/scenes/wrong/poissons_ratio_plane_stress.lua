local dem = require "dem"
local sim = dem.simulation { plane = "stress" }
local m = dem.material { youngs_modulus = 1e9, poissons_ratio = 0.34, density = 1000 }
sim:body { name = "b", material = m, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 }, bonds = dem.elastic {} }
-->:3: material.poissons_ratio = 0.34: must be at most 1/3 in plane stress; beyond it bonds would need a negative shear stiffness; stiffness = "facets" takes more
