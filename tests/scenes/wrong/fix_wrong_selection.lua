local dem = require "dem"
local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400 }
local sim = dem.simulation {}
local beam = sim:body { name = "beam", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
sim:fix { { beam, withn = dem.disc { radius = 1 } } }
sim:fix { 3 }
sim:fix { beam, where = true }
-->:5: fix[1].withn = a region: unknown setting; did you mean "within"?
-->:6: fix[1] = 3: must be a body, a side of a body, a region, a function of place, or a table of these such as { beam, within = region }
-->:7: fix.where = true: must be a function of x and y that gives true or false
