-- Question: do grains that have come to rest stay at rest?
-- Source:   equilibrium: nothing moves.
-- See:      three disks on a floor, a pyramid in a tray and a column that leans from wall to wall of a shaft come to rest with
--           damping, which is then taken away; the kinetic energy in history.csv falls to rounding and stays there.
-- Takes:    a second.
local dem = require "dem"

local p = dem.param {
  friction = { 0.5 },
  settling = { 1, "s", help = "with damping" },
  duration = { 10, "s", help = "without" },
  rows     = { 8, help = "of the pyramid" },
}
local radius, gravity = 0.05, 9.81

local sim = dem.simulation { title = "Stacks at rest", plane = "stress", gravity = { 0, -gravity } }
local rubber = dem.material {
  name = "rubber", youngs_modulus = 1e7, poissons_ratio = 0.2, density = 1000, friction = p.friction, restitution = 0.5,
}
sim:wall { name = "floor", path = { { -1, 0 }, { -0.1, 0 } } }

local function pyramid(name, x, rows)
  local list = {}
  for row = 1, rows do
    for k = row, rows do list[#list + 1] = { x + (2 * k - row) * radius, radius + (row - 1) * math.sqrt(3) * radius, radius } end
  end
  return sim:body { name = name, material = rubber, packing = dem.disks(list) }
end
local heap = pyramid("heap", 0, p.rows)
local three = pyramid("three", -0.6, 2)
sim:wall { name = "tray", path = { { 0, 2 * radius }, { 0, 0 }, { 2 * p.rows * radius, 0 }, { 2 * p.rows * radius, 2 * radius } } }

-- Centres lie 60 degrees above each other, so that the disks lean on both walls.
local left, height = 1.2, 10
local column = {}
for k = 1, height do
  column[k] = { left + radius * (k % 2 == 1 and 1 or 2), radius + (k - 1) * math.sqrt(3) * radius, radius }
end
local width = 3 * radius
sim:wall { name = "shaft", path = { { left, 2 * height * radius }, { left, 0 }, { left + width, 0 }, { left + width, 2 * height * radius } } }
local leaning = sim:body { name = "column", material = rubber, packing = dem.disks(column) }

sim:damping { fraction = 0.3, frequency = 20 }
local function places()
  local all = {}
  for _, body in ipairs { three, heap, leaning } do
    for _, field in ipairs { "displacement_x", "displacement_y" } do
      for _, u in ipairs(body:field(field)) do all[#all + 1] = u / radius end
    end
    for _, turn in ipairs(body:field("rotation")) do all[#all + 1] = turn end
  end
  return all
end
local function greatest_change(before)
  local greatest = 0
  for k, now in ipairs(places()) do greatest = math.max(greatest, math.abs(now - before[k])) end
  return greatest
end

sim:history { every = p.duration / 500, kinetic = function(now) return now.ledger.kinetic end }
sim:run { duration = p.settling }
sim:damping { fraction = 0, frequency = 20 }
sim:run { duration = p.duration / 10 }
local early, kinetic_early = places(), sim.now.ledger.kinetic
sim:run { duration = 0.9 * p.duration }

local fallen = -sim.now.ledger.potential
dem.compare {
  what = "greatest creep in 9 s, of a radius", value = greatest_change(early), reference = 0, tolerance = 1e-12,
  because = "rounding; 1e-6 asked for", source = "equilibrium",
}
dem.compare {
  what = "kinetic energy, of the potential it fell by", value = sim.now.ledger.kinetic / fallen, reference = 0, tolerance = 1e-20,
  because = "speeds of rounding, squared", source = "equilibrium",
}
dem.result { kinetic_early = kinetic_early, kinetic = sim.now.ledger.kinetic, creep = greatest_change(early) }
