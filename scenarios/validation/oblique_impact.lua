-- Question: how does a disk leave a floor that it meets at an angle, and can it ever leave with more energy than it brought?
-- Source:   momentum, with friction mu N as long as the contact slides: v_t' = v_t - mu (1 + e) v_n,
--           omega' = 2 mu (1 + e) v_n / R, where tan(angle) = v_t / v_n > 3 mu (1 + e). Energy: at most what was brought.
-- See:      89 disks without dashpots at 1 to 89 degrees from the upright, 20 of them with spin at the start; and three that
--           lose a part of their speed to dashpots.
-- Takes:    a second.
local dem = require "dem"

local p = dem.param {
  friction      = { 0.3, help = "of the disks that must not gain energy" },
  step_fraction = { 1e-3, help = "time step as a share of the stable one" },
}
local radius, youngs_modulus, nu, density, speed = 0.01, 1e11, 0.2, 2000, 1
local e, mu = 0.6, 0.1 -- of the disks that keep to the closed form
local slides = { 35, 60, 80 }

local mass, stiffness = density * math.pi * radius ^ 2, youngs_modulus / (math.sqrt(3) * (1 - nu))
local shear = stiffness * (1 - 3 * nu) / (1 + nu)
local sim = dem.simulation { title = "Oblique impacts", plane = "stress", step_fraction = p.step_fraction }
local function rubber(name, restitution, friction)
  return dem.material {
    name = name, youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density,
    restitution = restitution, friction = friction,
  }
end
local hard, soft = rubber("hard", 1, p.friction), rubber("soft", e, mu)

-- They meet the floor within a contact's duration, each at another place between two time steps.
local contact = math.pi * math.sqrt(mass / stiffness)
local thrown_so_far = 0
local function thrown(name, angle, material, spin)
  local vt, vn = speed * math.sin(math.rad(angle)), speed * math.cos(math.rad(angle))
  thrown_so_far = thrown_so_far + 1
  local flight = contact * (thrown_so_far * 0.618 % 1)
  local body = sim:body {
    name = name, material = material, packing = dem.disks { { 4 * radius * thrown_so_far, radius + vn * flight, radius } },
    velocity = { vt, -vn }, spin = spin,
  }
  return { body = body, vt = vt, vn = vn, spin = spin, energy = mass * speed ^ 2 / 2 + mass * radius ^ 2 * spin ^ 2 / 4 }
end
local sliding, any = {}, {}
for k, angle in ipairs(slides) do sliding[k] = thrown("sliding" .. k, angle, soft, 0) end
for angle = 1, 89 do any[angle] = thrown("at" .. angle, angle, hard, angle % 4 == 0 and (angle % 8 - 2) * speed / radius or 0) end

sim:wall { name = "floor", path = { { 0, 0 }, { 4 * radius * (thrown_so_far + 1), 0 } } }
sim:run { duration = 2.5 * contact }

local frequency = math.sqrt(math.max(stiffness, 3 * shear) / mass) -- the larger of that of pressing and that of shearing
local step = frequency * sim.now.time_step
for k, angle in ipairs(slides) do
  local disk = sliding[k]
  dem.compare {
    what = "speed along the floor after " .. angle .. " degrees", unit = "m/s", value = disk.body.velocity.x,
    reference = disk.vt - mu * (1 + e) * disk.vn, tolerance = 1e-3 * mu * (1 + e) * disk.vn / disk.vt,
    because = "restitution is met to 1e-3, which changes the impulse by less than as much", source = "momentum, gross sliding",
  }
  dem.compare {
    what = "spin after " .. angle .. " degrees", unit = "rad/s", value = -disk.body.spin,
    reference = 2 * mu * (1 + e) * disk.vn / radius, tolerance = 1e-3, because = "as above", source = "momentum, gross sliding",
  }
end
local gain, at, parted = -1, 0, 0
for angle = 1, 89 do
  local disk = any[angle]
  local v, spin = disk.body.velocity, disk.body.spin
  local change = (mass * (v.x ^ 2 + v.y ^ 2) / 2 + mass * radius ^ 2 * spin ^ 2 / 4) / disk.energy - 1
  if v.y > 0 then parted = parted + 1 end
  if change > gain then gain, at = change, angle end
end
dem.compare { what = "disks that left the floor", value = parted, reference = 89, tolerance = 1e-12, because = "a count", source = "all of them" }
dem.compare {
  what = "greatest gain of energy, 1 to 89 degrees", value = math.max(0, gain), reference = 0, tolerance = step ^ 2 / 4,
  because = "a spring that is met and left between two steps gains at most (w dt)^2/4 of its energy", source = "conservation of energy",
}
dem.result { gain = gain, at_angle = at, step = step }
