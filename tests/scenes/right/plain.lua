-- A scene for others to include.
local dem = require "dem"
local p = dem.param { duration = { 1, "s" }, radius = 0.1 }
local rock = dem.material { name = "rock", youngs_modulus = 1e9, poissons_ratio = 0.2, density = 2000 }
local sim = dem.simulation { title = "plain" }
sim:body { name = "rock", material = rock, region = dem.disc { radius = 1 }, packing = dem.close_packed { radius = p.radius } }
sim:run { duration = p.duration }
