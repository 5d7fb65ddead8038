local dem = require "dem"
local sim = dem.simulation {}
local m = dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 3e6, fracture_toughness = 1e6 }
local box = dem.rectangle { size = { 1, 1 } } - dem.disc { centre = { 0.5, 0.5 }, radius = 0.2 }
local packing = dem.close_packed { radius = 0.05 }
local good = sim:body { name = "good", material = m, region = box, packing = packing, bonds = dem.plateau {} }
local whole = sim:body { name = "whole", material = m, region = box, packing = packing, bonds = dem.elastic {} }
local loose = sim:body { name = "loose", material = m, region = box, packing = packing }
local stiff = sim:body { name = "stiff", material = m, region = box, packing = packing, bonds = dem.plateau {}, rigid = true }
sim:notch { good, from = { -0.1, 0.5 }, to = { 0.1, 0.5 } }
sim:notch { good, from = { -0.3, 0.5 }, to = { -0.1, 0.5 } }
sim:notch { good, from = { 0.4, 0.5 }, to = { 0.6, 0.5 } }
sim:notch { whole, from = { 0, 0.5 }, to = { 0.1, 0.5 } }
sim:notch { loose, from = { 0, 0.5 }, to = { 0.1, 0.5 } }
sim:notch { stiff, from = { 0, 0.5 }, to = { 0.1, 0.5 } }
-->:11: notch = (-0.3, 0.5) to (-0.1, 0.5) m: lies outside body "good"
-->:12: notch = (0.4, 0.5) to (0.6, 0.5) m: lies outside body "good"
-->:13: notch.body = "whole": must have bonds that can break, but has dem.elastic; a law such as dem.plateau lets bonds be cut
-->:14: notch.body = "loose": must have bonds that can break, but has no bonds; a law such as dem.plateau lets bonds be cut
-->:15: notch.body = "stiff": must have bonds that can break, but is rigid; a law such as dem.plateau lets bonds be cut
