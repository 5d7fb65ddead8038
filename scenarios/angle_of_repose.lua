-- Question: how steep is a heap of disks that is let go?
-- Source:   a band and a trend, no closed form: disks that roll freely lie at 10 to 25 degrees on a rough floor once they have
--           friction enough, and flatter with less.
-- See:      three blocks of disks, each between two walls; the walls are lifted slowly, and the disks run out until a heap is
--           left: the more friction, the steeper.
-- Takes:    half a minute.
-- Quick:    no
local dem = require "dem"

local p = dem.param {
  columns = { 18, help = "disks side by side before the walls are lifted" },
  layers  = { 26, help = "disks above each other" },
  lifting = { 0.1, "m/s", help = "speed of the walls" },
  seed    = { 1 },
}
local frictions = { 0.05, 0.2, 0.5 }
local radius, gravity = 5e-3, 9.81
math.randomseed(p.seed)

local sim = dem.simulation { title = "Angle of repose", plane = "stress", gravity = { 0, -gravity } }
local function gravel(friction)
  return dem.material {
    name = "gravel " .. friction, youngs_modulus = 3e6, poissons_ratio = 0.2, density = 2000, friction = friction, restitution = 0.3,
  }
end

-- The floor is a row of disks, held, so that the lowest of the heap cannot roll away.
local width, high = 2.2 * radius * p.columns, 2.4 * p.layers * radius
local reach = 2.5 * width
local heaps, walls = {}, {}
for n, friction in ipairs(frictions) do
  local middle = 2.2 * reach * n
  local rough, list = {}, {}
  for k = 0, math.floor(reach / radius) do rough[#rough + 1] = { middle + 2 * radius * k - reach, -radius, radius } end
  for layer = 1, p.layers do
    for k = 1, p.columns do
      local x = middle + (k - 0.5) / p.columns * width - width / 2 + (layer % 2 - 0.5) * radius / 10
      list[#list + 1] = { x, (2.2 * layer - 1) * radius, radius * (0.5 + 0.5 * math.random()) }
    end
  end
  sim:fix { sim:body { name = "floor" .. n, material = gravel(friction), packing = dem.disks(rough) } }
  heaps[n] = {
    middle = middle, list = list, body = sim:body { name = "heap" .. n, material = gravel(friction), packing = dem.disks(list) },
  }
  for side = -1, 1, 2 do
    local x = middle + side * width / 2
    walls[#walls + 1] = sim:wall { name = "wall" .. #walls, path = { { x, radius / 10 }, { x, high } }, friction = 0 }
  end
end

sim:output { every = 0.05 }
sim:run { duration = 1 } -- the disks settle
for _, wall in ipairs(walls) do wall:move { velocity_y = p.lifting } end
sim:every { 0.1, function(now)
  if now.time > 1.5 and now.ledger.kinetic < 1e-9 * -now.ledger.potential then now:stop("the heaps lie still") end
end }
sim:run { duration = high / p.lifting + 1 }

-- A triangle of half base b and height h has its middle at h/3, and its area lies about the middle line with the mean square
-- b^2/6: all disks together say how steep the heap is.
local function repose(heap)
  local ux, uy = heap.body:field "displacement_x", heap.body:field "displacement_y"
  local area, sx, sy, sxx = 0, 0, 0, 0
  for k, disk in ipairs(heap.list) do
    local x, y, share = disk[1] + ux[k] - heap.middle, disk[2] + uy[k], disk[3] ^ 2
    area, sx, sy, sxx = area + share, sx + share * x, sy + share * y, sxx + share * x * x
  end
  local variance = sxx / area - (sx / area) ^ 2
  return math.deg(math.atan(3 * sy / area / math.sqrt(6 * variance)))
end
local angles, steeper = {}, 0
for n, heap in ipairs(heaps) do
  angles[n] = repose(heap)
  if n > 1 and angles[n] > angles[n - 1] then steeper = steeper + 1 end
end
dem.compare {
  what = "slope at friction 0.5", unit = "degrees", value = angles[3], reference = 17.5, tolerance = 7.5 / 17.5,
  because = "a band from 10 to 25 degrees", source = "a band, no closed form",
}
dem.compare {
  what = "heaps steeper than the one with less friction", value = steeper, reference = #frictions - 1, tolerance = 1e-12,
  because = "a count", source = "a trend, no closed form",
}
dem.result { least = angles[1], middle = angles[2], most = angles[3] }
