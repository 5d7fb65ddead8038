local dem = require "dem"
local sim = dem.simulation { plane = "strain" }
local m = dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, fracture_toughness = 1e6, fracture_energy = 33.67 }
sim:body { name = "b", material = m, packing = dem.disks { { 0, 0, 0.1 } } }
-->:3: material.fracture_energy = 33.67: contradicts fracture_toughness = 1000000, which means 32 J/m^2; give one of them; this energy means a toughness of 1025761.91 Pa m^0.5
