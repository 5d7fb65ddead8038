-- Question: how do a thousand disks settle in a box, and how densely do they come to lie?
-- Source:   the same disks under the same law of contact in LAMMPS: `tools/compare_grains` runs both and writes docs/grains.md.
--           By itself: momentum, floor and sides carry the weight.
-- See:      the kinetic energy in history.csv rises while the disks fall, and dies away when they have met.
-- Takes:    five seconds.
-- Quick:    --set layers=15 --set duration=1
local dem = require "dem"

local p = dem.param {
  columns  = { 25, help = "disks side by side" },
  layers   = { 40, help = "disks above each other" },
  friction = { 0.3 },
  duration = { 1.5, "s" },
  seed     = { 1 },
  publish  = { false, help = "disks and law among the results, for another program to start from" },
}
local largest, gravity, youngs_modulus, nu, density, restitution = 5e-3, 9.81, 3e6, 0.2, 2000, 0.5
math.randomseed(p.seed)

local sim = dem.simulation { title = "Disks settling in a box", plane = "stress", gravity = { 0, -gravity } }
local grain = dem.material {
  name = "grain", youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density, friction = p.friction, restitution = restitution,
}
local pitch = 2.3 * largest
local width, high = pitch * p.columns, pitch * (p.layers + 1)
local box = sim:wall { name = "box", path = { { 0, high }, { 0, 0 }, { width, 0 }, { width, high } } }
local list = {}
for layer = 1, p.layers do
  for k = 1, p.columns do
    local function off() return 0.1 * largest * (2 * math.random() - 1) end
    list[#list + 1] = { (k - 0.5) * pitch + off(), (layer - 0.5) * pitch + off(), largest * (0.7 + 0.1 * math.random(0, 3)) }
  end
end
local grains = sim:body { name = "grains", material = grain, packing = dem.disks(list) }

-- Force on the box over the last third of the run: single contacts still open and close in it.
local felt, samples = 0, 0
sim:history {
  every = 5e-3,
  force_on_box = function(now)
    local force = -now.wall.box.force.y
    if now.time > 2 / 3 * p.duration then felt, samples = felt + force, samples + 1 end
    return force
  end,
  kinetic = function(now) return now.ledger.kinetic end,
  height = function(now) return now.body.grains.position.y end,
}
sim:run { duration = p.duration }

dem.compare {
  what = "mean force on the box, of the weight", value = felt / samples / (grains.mass * gravity), reference = 1, tolerance = 1e-3,
  because = "a thousandth of the weight may still be swinging", source = "momentum",
}
dem.result { height = grains.position.y, coordination = sim.now:mean("coordination", grains) }

-- Numbers to the last digit, one disk to a line.
local function lines(columns)
  local text = {}
  for k = 1, #columns[1] do
    local numbers = {}
    for n, column in ipairs(columns) do numbers[n] = string.format("%.17g", column[k]) end
    text[k] = table.concat(numbers, " ")
  end
  return table.concat(text, "\n")
end
if p.publish then
  local x, y, r, now_x, now_y = {}, {}, {}, grains:field "displacement_x", grains:field "displacement_y"
  for k, disk in ipairs(list) do
    x[k], y[k], r[k] = disk[1], disk[2], disk[3]
    now_x[k], now_y[k] = x[k] + now_x[k], y[k] + now_y[k]
  end
  local normal = youngs_modulus / (math.sqrt(3) * (1 - nu))
  dem.result {
    width = width, high = high, gravity = gravity, density = density, friction = p.friction, restitution = restitution,
    normal_stiffness = normal, shear_stiffness = normal * (1 - 3 * nu) / (1 + nu), time_step = sim.now.time_step,
    steps = sim.now.step, at_start = lines { x, y, r }, at_end = lines { now_x, now_y, r },
  }
end
