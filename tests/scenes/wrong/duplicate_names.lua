local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:body { name = "beam", material = concrete, packing = dem.disks { { 5, 5, 1 } } }
sim:wall { name = "floor", path = { { 0, 0 }, { 1, 0 } } }
sim:wall { name = "floor", path = { { 0, 0 }, { 1, 0 } } }
-->:5: body.name = "beam": is already the name of another body
-->:7: wall.name = "floor": is already the name of another wall or outline
