local dem = require "dem"
local steel = dem.material { name = "steel", youngs_modulus = 200e9, poissons_ratio = 0.3, density = 7800 }
local sim = dem.simulation { greatest_move = 0.6 }
sim:outline { name = "a", material = steel }
sim:outline { name = "b", material = steel, region = dem.disc { radius = 1 } }
sim:outline { name = "b", material = steel, path = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } } }
dem.sawtooth { from = { 0, 0 }, to = { 0, 0 }, height = 1, pitch = 1 }
-->:7: sawtooth.to: must differ from from
-->:4: outline.region: exactly one of path and region must be given
-->:5: outline.region: must have straight sides; say a curved one by as many corners of a path as it needs
-->:6: outline.path: sides must not cross: those after corners 1 and 3 do
-->:3: simulation.greatest_move = 0.6: must be at most 0.5 in a scene with walls; elements that move farther in a step could pass a wall unseen
-->:6: outline.name = "b": is already the name of another wall or outline
