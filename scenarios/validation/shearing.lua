-- Question: which stress does a dense bed of disks bear that two rough rows shear at constant height, and how do its disks move?
-- Source:   the same disks under the same law of contact in LAMMPS: `tools/compare_grains` runs both and writes docs/grains.md.
--           By itself: the stress in the bed does the work that the upper row puts in.
-- See:      `pressure` and `shear` in history.csv rise as the upper row comes down and then waver about a mean.
-- Takes:    three seconds.
-- Quick:    --set strain=3
local dem = require "dem"

local p = dem.param {
  columns  = { 20, help = "disks side by side" },
  layers   = { 25, help = "disks above each other" },
  solid    = { 0.86, help = "area of the disks over area between the middles of the rows, once the upper row is down" },
  speed    = { 0.5, "m/s", help = "of the upper row" },
  strain   = { 4, help = "way of the upper row over height; the second half counts" },
  friction = { 0.3 },
  restitution = { 0.5 },
  seed     = { 1 },
  publish  = { false, help = "disks and law among the results, for another program to start from" },
}
local largest, youngs_modulus, nu, density, restitution = 5e-3, 3e6, 0.2, 2000, p.restitution
math.randomseed(p.seed)

local pitch = 2.3 * largest
local width, high = pitch * p.columns, pitch * (p.layers + 1)
local sim = dem.simulation { title = "Disks sheared between rows", plane = "stress", periodic_x = { 0, width } }
local grain = dem.material {
  name = "grain", youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density, friction = p.friction, restitution = restitution,
}

local bed_list, area = {}, 0
for layer = 1, p.layers do
  for k = 1, p.columns do
    local function off() return 0.1 * largest * (2 * math.random() - 1) end
    local radius = largest * (0.7 + 0.1 * math.random(0, 3))
    bed_list[#bed_list + 1] = { (k - 0.5) * pitch + off(), layer * pitch + off(), radius }
    area = area + math.pi * radius ^ 2
  end
end
local function row(y)
  local list = {}
  for k = 1, p.columns do list[k] = { (k - 0.5) * pitch, y, largest } end
  area = area + p.columns * math.pi * largest ^ 2 / 2 -- half of each lies between the middles
  return list
end
local lists = { bed_list, row(0), row(high) }
local bed = sim:body { name = "bed", material = grain, packing = dem.disks(lists[1]) }
local bottom = sim:body { name = "bottom", material = grain, packing = dem.disks(lists[2]) }
local top = sim:body { name = "top", material = grain, packing = dem.disks(lists[3]) }
sim:fix { bottom }

local height = area / (p.solid * width)
local lowering = 1.0
local drive = sim:move { top, velocity = { 0, -lowering }, spin = 0 }
sim:run { duration = (high - height) / lowering }
local down_at, down_steps = sim.now.time, sim.now.step
height = top.position.y

drive:set { top, velocity = { p.speed, 0 }, spin = 0 }
local duration = p.strain * height / p.speed
local start = down_at + duration / 2

-- Sum over contacts of force times the line of centres, over the space between the rows: the cell of a loose disk is the disk.
local function stress(component)
  local sum = 0
  for n, body in ipairs { bed, bottom, top } do
    local values = body:field("stress_" .. component)
    for k, disk in ipairs(lists[n]) do sum = sum + values[k] * math.pi * disk[3] ^ 2 end
  end
  return sum / (width * height)
end
local function mean_size(field)
  local sum, values = 0, bed:field(field)
  for k = 1, #values do sum = sum + math.abs(values[k]) end
  return sum / #values
end
local measures = {
  pressure = function() return -stress "yy" end,
  along = function() return -stress "xx" end,
  shear = function() return stress "xy" end,
  touching = function(now) return now:mean("coordination", bed) end,
  kinetic = function() return bed:sum "kinetic_energy" / #bed_list end,
  spin = function(now) return now:mean("spin", bed) end,
  spin_size = function() return mean_size "spin" end,
}
local sums, count, every = {}, 0, 20
local work_before
for name in pairs(measures) do sums[name] = 0 end
sim:every { every * sim.now.time_step, function(now)
  if now.time < start then return end
  work_before = work_before or now.ledger.work
  for name, measure in pairs(measures) do sums[name] = sums[name] + measure(now) end
  count = count + 1
end }
sim:history { every = 5e-3, pressure = measures.pressure, shear = measures.shear, touching = measures.touching }
sim:run { duration = duration }

local mean = {}
for name, sum in pairs(sums) do mean[name] = sum / count end
local ledger = sim.now.ledger
dem.compare {
  what = "mean shear stress", unit = "Pa", value = mean.shear, reference = (ledger.work - work_before) / (width * p.speed * duration / 2),
  tolerance = 2e-2, because = "momentum that the disks carry: at most their kinetic energy over the area, 0.6 %, and its change",
  source = "work of the upper row",
}
dem.compare {
  what = "energy unaccounted over work", value = ledger.error / ledger.work, reference = 0, tolerance = 1e-3,
  because = "contacts that begin and end within a step", source = "conservation of energy",
}
dem.result {
  pressure = mean.pressure, ratio = mean.shear / mean.pressure, touching = mean.touching, kinetic = mean.kinetic,
  along = mean.along, spin = mean.spin, spin_size = mean.spin_size, samples = count, height = height, speed = p.speed,
}

-- Disks to the last digit, one to a line.
if p.publish then
  for n, name in ipairs { "bed", "bottom", "top" } do
    local text = {}
    for k, disk in ipairs(lists[n]) do text[k] = string.format("%.17g %.17g %.17g", disk[1], disk[2], disk[3]) end
    dem.result { [name] = table.concat(text, "\n") }
  end
  local normal = youngs_modulus / (math.sqrt(3) * (1 - nu))
  dem.result {
    width = width, high = high, density = density, friction = p.friction, restitution = restitution,
    normal_stiffness = normal, shear_stiffness = normal * (1 - 3 * nu) / (1 + nu), time_step = sim.now.time_step,
    start = start, steps_down = down_steps, steps = sim.now.step, every = every,
  }
end
