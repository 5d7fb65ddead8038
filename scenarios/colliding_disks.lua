-- Question: how fast do two disks part after a head-on impact?
-- Source:   definition of the coefficient of restitution: relative speed after over relative speed before.
-- See:      the disks meet and part; the result `measured` equals the parameter `restitution`, and momentum stays zero.
-- Takes:    less than a second.
local dem = require "dem"

local p = dem.param {
  restitution = { 0.5 },
  speed       = { 1, "m/s", help = "of each disk" },
  radius      = { 0.01, "m" },
}

local clay = dem.material {
  name = "clay", youngs_modulus = 1e8, poissons_ratio = 0.2, density = 2000, restitution = p.restitution,
}
local sim = dem.simulation { title = "Colliding disks", plane = "stress", step_fraction = 0.02 }

local gap = p.radius / 10
local function disk(name, side)
  return sim:body {
    name = name, material = clay,
    packing  = dem.disks { { side * (p.radius + gap / 2), 0, p.radius } },
    velocity = { -side * p.speed, 0 },
  }
end
local left, right = disk("left", -1), disk("right", 1)

local duration = 4 * gap / p.speed
sim:history { every = duration / 200, parting_speed = function(now) return right.velocity.x - left.velocity.x end }
sim:output { every = duration / 40 }
sim:run { duration = duration }

local parting = right.velocity.x - left.velocity.x
dem.compare {
  what = "restitution", value = parting / (2 * p.speed), reference = p.restitution, tolerance = 3e-3,
  because = "the instant of parting is found within a step of 0.02 of the stable one",
  source  = "definition of the coefficient of restitution",
}
dem.result { measured = parting / (2 * p.speed), reference = p.restitution, momentum = sim.now.momentum.x }
