local dem = require "dem"
local m = dem.material { youngs_modulus = 1e9, poissons_ratio = 0.3, density = 1000 }
local sim = dem.simulation { plane = "strain" }
sim:body { name = "b", material = m, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 }, bonds = dem.elastic {} }
-->:2: material.poissons_ratio = 0.3: must be at most 1/4 in plane strain; beyond it bonds would need a negative shear stiffness; stiffness = "facets" takes more
