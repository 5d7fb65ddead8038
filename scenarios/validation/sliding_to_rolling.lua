-- Question: when does a disk that is set down sliding begin to roll, and how fast is it then?
-- Source:   friction mu m g slows it down and turns it: it rolls at two thirds of its speed after u0 / (3 mu g).
-- See:      speed and R times spin meet in history.csv and then stay together.
-- Takes:    less than a second.
local dem = require "dem"

local p = dem.param {
  speed    = { 0.5, "m/s", help = "at the start" },
  friction = { 0.3 },
}
local radius, gravity, youngs_modulus, nu, density = 0.01, 9.81, 1e8, 0.2, 2000
local mass, stiffness = density * math.pi * radius ^ 2, youngs_modulus / (math.sqrt(3) * (1 - nu))
local rolls_at = p.speed / (3 * p.friction * gravity)
local sunk = mass * gravity / stiffness -- at rest

local sim = dem.simulation { title = "From sliding to rolling", plane = "stress", gravity = { 0, -gravity }, step_fraction = 0.2 }
sim:wall { name = "floor", path = { { -radius, 0 }, { 2 * p.speed * rolls_at + radius, 0 } } }
local disk = sim:body {
  name = "disk", packing = dem.disks { { 0, radius - sunk, radius } }, velocity = { p.speed, 0 },
  material = dem.material {
    name = "rubber", youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density,
    restitution = 0.2, friction = p.friction,
  },
}

local function slip(now) return now.body.disk.velocity.x + (radius - sunk) * now.body.disk.spin end
local stopped
sim:every { 1e-9, function(now) if not stopped and slip(now) <= 0 then stopped = now.time end end }
sim:history {
  every = rolls_at / 100,
  speed = function(now) return now.body.disk.velocity.x end,
  turning = function(now) return -radius * now.body.disk.spin end,
}
sim:run { duration = 1.5 * rolls_at }

local shear = stiffness * (1 - 3 * nu) / (1 + nu)
local growth = p.friction * mass * gravity / (shear * p.speed) -- time in which the spring takes up the friction
local lever = 2 * sunk / radius
local source = "friction m a = -mu m g, and the moment mu m g R"
dem.compare {
  what = "rolling from", unit = "s", value = stopped, reference = rolls_at, source = source,
  tolerance = lever + (2 * sim.now.time_step + growth) / rolls_at,
  because = "seen within two steps; friction grows in mu m g / (Kt u0), and its lever is shorter by the overlap",
}
for _, each in ipairs { { "speed of rolling", disk.velocity.x }, { "R times spin", -radius * disk.spin } } do
  dem.compare {
    what = each[1], unit = "m/s", value = each[2], reference = 2 * p.speed / 3, tolerance = lever, source = source,
    because = "the lever is shorter by the overlap",
  }
end
