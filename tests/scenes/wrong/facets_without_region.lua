local dem = require "dem"
local sim = dem.simulation {}
local m = dem.material { youngs_modulus = 1e9, poissons_ratio = 0.1, density = 1000 }
sim:body { name = "b", material = m, packing = dem.disks { { 0, 0, 1 }, { 2, 0, 1 } }, bonds = dem.elastic { stiffness = "facets" } }
-->:4: body.bonds = "facets": needs the body's region, which its cells share out
