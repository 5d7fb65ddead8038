local dem = require "dem"
local sim = dem.simulation {}
local m = dem.material { youngs_modulus = 1e9, poissons_ratio = -0.1, density = 1000 }
sim:body { name = "b", material = m, region = dem.rectangle { size = { 1, 1 } }, packing = dem.relaxed { count = 100 }, bonds = dem.elastic {} }
-->:3: material.poissons_ratio = -0.1: must not be negative with stiffness = "facets"
