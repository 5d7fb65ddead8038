-- Question: how steep may a slope be for a disk to roll down without slipping, and how fast does it go on either side of that?
-- Source:   it rolls where tan(slope) <= 3 mu, with 2/3 g sin(slope); beyond, it goes with g (sin(slope) - mu cos(slope)) and
--           turns with 2 mu g cos(slope) / R.
-- See:      eight disks on slopes of their own, half as steep to three times as steep as the threshold.
-- Takes:    a second.
local dem = require "dem"

local p = dem.param {
  friction = { 0.2 },
  duration = { 0.3, "s" },
}
local radius, gravity, youngs_modulus, nu, density = 0.01, 9.81, 1e8, 0.2, 2000
local mass, stiffness = density * math.pi * radius ^ 2, youngs_modulus / (math.sqrt(3) * (1 - nu))
local shear = stiffness * (1 - 3 * nu) / (1 + nu)

local sim = dem.simulation { title = "Disks on slopes", plane = "stress", gravity = { 0, -gravity }, step_fraction = 0.2 }
local rubber = dem.material {
  name = "rubber", youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density, restitution = 0.05, friction = p.friction,
}

-- Each starts at rest, sunk in as far as it will be.
local length = gravity * p.duration ^ 2 / 2
local slopes = {}
for k, share in ipairs { 0.5, 0.8, 0.95, 0.99, 1.01, 1.05, 1.5, 3 } do
  local slope = math.atan(3 * p.friction * share)
  local along, up = { math.cos(slope), -math.sin(slope) }, { math.sin(slope), math.cos(slope) }
  local y = (length + 4 * radius) * k -- none reaches the next
  local lifted = radius - mass * gravity * math.cos(slope) / stiffness
  sim:wall {
    name = "slope" .. k,
    path = { { -2 * radius * along[1], y - 2 * radius * along[2] }, { length * along[1], y + length * along[2] } },
  }
  slopes[k] = {
    share = share, slope = slope,
    body = sim:body { name = "disk" .. k, material = rubber, packing = dem.disks { { lifted * up[1], y + lifted * up[2], radius } } },
  }
end

-- Friction begins at nothing and swings about its value; accelerations are taken after that has died away.
local function motion(disk)
  local v = disk.body.velocity
  return v.x * math.cos(disk.slope) - v.y * math.sin(disk.slope), -radius * disk.body.spin
end
local begin = p.duration / 3
sim:run { duration = begin }
for _, disk in ipairs(slopes) do disk.v, disk.turning = motion(disk) end
begin = sim.now.time
sim:run { duration = p.duration - begin }
local time = sim.now.time - begin

local sunk = mass * gravity / stiffness / radius
for _, disk in ipairs(slopes) do
  local s, c = math.sin(disk.slope), math.cos(disk.slope)
  local rolls = disk.share <= 1
  local v, turning = motion(disk)
  local at = string.format(" at %g of the threshold", disk.share)
  local because = "the lever is shorter by the overlap, of which friction's work takes its share"
  dem.compare {
    what = "acceleration" .. at, unit = "m/s^2", value = (v - disk.v) / time,
    reference = gravity * (rolls and 2 / 3 * s or s - p.friction * c), tolerance = 2 * sunk, because = because, source = "rolling and sliding of a disk",
  }
  dem.compare {
    what = "R times angular acceleration" .. at, unit = "m/s^2", value = (turning - disk.turning) / time,
    reference = gravity * (rolls and 2 / 3 * s or 2 * p.friction * c), tolerance = 2 * sunk, because = because, source = "rolling and sliding of a disk",
  }
end
dem.result { static_overlap = sunk, shear_over_normal = shear / stiffness }
