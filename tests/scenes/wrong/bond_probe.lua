local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 }, bonds = dem.elastic {} }
local sand = sim:body { name = "sand", material = concrete, region = dem.rectangle { at = { 2, 0 }, size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:bond_probe { beam, name = "both", at = { 0.5, 0.5 }, between = { 0, 1 } }
sim:bond_probe { sand, name = "loose", at = { 2.5, 0.5 } }
sim:bond_probe { beam, name = "loose", between = { 0, 1 } }
sim:bond_probe { beam, name = "half", between = { 0, 0.5 } }
sim:bond_probe { name = "none", at = { 0.5, 0.5 } }
-->:9: bond_probe.between = { 0, 0.5 }: must be whole numbers from 0 on
-->:10: bond_probe.body: is missing; it must be a body made with sim:body
-->:6: bond_probe.at: exactly one of at and between must be given
-->:7: bond_probe.body = "sand": has no bonds
-->:8: bond_probe.name = "loose": is already the name of another bond_probe
