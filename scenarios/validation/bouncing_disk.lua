-- Question: does a disk that falls on a floor bounce with the restitution its material was given?
-- Source:   definition of restitution: speed after over speed before. Without dashpots the contact is a spring k under a mass m:
--           greatest overlap v sqrt(m/k), duration pi sqrt(m/k), k = E t / (sqrt 3 (1 - nu)).
-- See:      five disks side by side, hard to soft; the speeds with which they leave the floor.
-- Takes:    a second.
local dem = require "dem"

local p = dem.param {
  drop          = { 0.05, "m", help = "how deep the disks have fallen when they touch the floor" },
  step_fraction = { 1e-3, help = "time step as a share of the stable one" },
}
local radius, gravity, youngs_modulus, nu, density = 0.01, 9.81, 1e10, 0.2, 2000
local restitutions = { 1, 0.8, 0.6, 0.4, 0.2 }

local speed = math.sqrt(2 * gravity * p.drop)
local mass, stiffness = density * math.pi * radius ^ 2, youngs_modulus / (math.sqrt(3) * (1 - nu))
local unit = math.sqrt(mass / stiffness) -- of time

local sim = dem.simulation {
  title = "Bouncing disks", plane = "stress", gravity = { 0, -gravity }, step_fraction = p.step_fraction,
}
sim:wall { name = "floor", path = { { -1, 0 }, { 1, 0 } } }

-- The last bit of the fall is enough: it begins with the speed the disks have there.
local gap = speed * unit
local disks = {}
for k, e in ipairs(restitutions) do
  disks[k] = sim:body {
    name = "disk" .. k, packing = dem.disks { { 4 * radius * k, radius + gap, radius } },
    velocity = { 0, -math.sqrt(speed ^ 2 - 2 * gravity * gap) },
    material = dem.material { name = "rubber" .. k, youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density, restitution = e },
  }
end

local deepest, touching, before = 0, 0, 0
sim:every { 1e-9, function(now)
  local overlap = radius - now.body.disk1.position.y
  deepest = math.max(deepest, overlap)
  if overlap > 0 then touching = touching + now.time - before end
  before = now.time
end }
sim:run { duration = 8 * unit }

-- A share eps = g sqrt(m/k) / v of the motion is gravity's: it shifts the middle of the bounce by so much, to either side.
local eps = gravity * unit / speed
local step = sim.now.time_step / unit
local source = "definition of the coefficient of restitution"
for k, e in ipairs(restitutions) do
  local after = math.sqrt(disks[k].velocity.y ^ 2 + 2 * gravity * (disks[k].position.y - radius))
  dem.compare {
    what = "restitution, " .. e .. " asked", value = after / speed, reference = e, tolerance = 1e-3,
    because = "1e-3 asked for; dashpots see the speed of half a step ago", source = source,
  }
end
dem.compare {
  what = "greatest overlap", unit = "m", value = deepest, reference = speed * unit, tolerance = 2 * eps + step ^ 2,
  because = "gravity adds the static overlap, and the step (w dt)^2", source = "spring and mass",
}
dem.compare {
  what = "duration of the contact", unit = "s", value = touching, reference = math.pi * unit,
  tolerance = (2 * eps + 2 * step) / math.pi, because = "seen within two steps, and longer by gravity's share", source = "spring and mass",
}
dem.result { gravity_share = eps, step = step }
