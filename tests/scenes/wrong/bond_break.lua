local dem = require "dem"
local sim = dem.simulation {}
sim:on_bond_break {}
sim:on_bond_break { 3, every = 1 }
sim:on_bond_break(nil)
sim.on_bond_break { function(event, now) end }
-->:3: on_bond_break.act: is missing; it must be a function
-->:4: on_bond_break.every = 1: unknown setting; known are act
-->:4: on_bond_break[1] = 3: must be a function
-->:5: on_bond_break: must be given one table of settings; as in sim:on_bond_break { function(event, now) print(event.time, event.x, event.y, now.broken_bonds) end }
-->:6: call it with a colon: sim:on_bond_break { ... }
