-- Question: how fast do disks run out of a hopper, and does it matter how many are still in it?
-- Source:   trend: W = C rho sqrt(g) (D - k d)^(3/2), D the width of the outlet, d the mean diameter, k between 1 and 2, whatever
--           the filling (Beverloo, Leniger & van de Velde, Chem. Eng. Sci. 15 (1961) 260, in two dimensions).
-- See:      three hoppers side by side with outlets 6, 9 and 12 disks wide, whose slides are drawn at half a second.
-- Takes:    half a minute.
-- Quick:    no
local dem = require "dem"

local p = dem.param {
  friction = { 0.4 },
  columns  = { 24, help = "disks side by side in each hopper" },
  layers   = { 60, help = "disks above each other" },
  seed     = { 1 },
}
local outlets = { 6, 9, 12 } -- mean diameters
local largest, gravity = 5e-3, 9.81
local diameter = 1.8 * largest
math.randomseed(p.seed)

local sim = dem.simulation { title = "Three hoppers", plane = "stress", gravity = { 0, -gravity } }
local grain = dem.material {
  name = "grain", youngs_modulus = 1.5e6, poissons_ratio = 0.2, density = 2000, friction = p.friction, restitution = 0.3,
}
local pitch = 2.1 * largest
local width, high = pitch * (p.columns + 0.5), 1.1 * pitch * p.layers

-- Far enough below not to back up, near enough for no disk to become so fast that the search for contacts is kept busy.
local ground = -0.4
sim:wall { name = "ground", path = { { 0, ground }, { 1.5 * width * (#outlets + 1), ground } } }

local hoppers = {}
for n, share in ipairs(outlets) do
  local middle, opening = 1.5 * width * n, share * diameter
  for side = -1, 1, 2 do
    local outer, inner = middle + side * width / 2, middle + side * opening / 2
    sim:wall { name = "side" .. 2 * n + (side - 1) / 2, path = { { outer, high }, { outer, 0 }, { inner, 0 } } }
  end
  local list = {}
  for layer = 1, p.layers do
    for k = 1, p.columns do
      local x = middle - width / 2 + (k - 0.5 + layer % 2 / 2) * pitch
      list[#list + 1] = { x, (layer - 0.5) * pitch, largest * (0.8 + 0.2 * math.random()) }
    end
  end
  hoppers[n] = {
    opening = opening, list = list, filling = sim:body { name = "filling" .. n, material = grain, packing = dem.disks(list) },
    slide = sim:wall { name = "slide" .. n, path = { { middle - opening / 2, 0 }, { middle + opening / 2, 0 } }, friction = 0 },
  }
end

sim:output { every = 0.02 }
sim:run { duration = 0.5 } -- the disks settle
for _, hopper in ipairs(hoppers) do
  hopper.slide:move { velocity_x = { { 0.5, -2 }, { 0.5 + 1.1 * hopper.opening / 2, -2 }, { 0.501 + 1.1 * hopper.opening / 2, 0 } } }
end

-- What has run out, in kg per metre.
local function out(hopper)
  local uy, area = hopper.filling:field "displacement_y", 0
  for k, disk in ipairs(hopper.list) do
    if disk[2] + uy[k] < -largest then area = area + math.pi * disk[3] ^ 2 end
  end
  return grain.density * area
end
local function weigh()
  local weights = {}
  for n, hopper in ipairs(hoppers) do weights[n] = out(hopper) end
  return weights, sim.now.time
end
sim:run { duration = 0.3 } -- until it runs evenly
local a, begin = weigh()
sim:run { duration = 0.25 }
local b, middle = weigh()
sim:run { duration = 0.25 }
local c, ending = weigh()

local flow, early, late = {}, 0, 0
for n in ipairs(hoppers) do
  flow[n] = (c[n] - a[n]) / (ending - begin)
  early, late = early + (b[n] - a[n]) / (middle - begin), late + (c[n] - b[n]) / (ending - middle)
end
local first, last = flow[1] ^ (2 / 3), flow[3] ^ (2 / 3)
local share = (outlets[2] - outlets[1]) / (outlets[3] - outlets[1])
local between = (first + share * (last - first)) ^ 1.5
local k = (outlets[1] * last - outlets[3] * first) / (last - first)
local source = "trend of Beverloo et al. 1961"
dem.compare {
  what = "flow of the middle outlet, of the other two's law", value = flow[2] / between, reference = 1, tolerance = 0.1,
  because = "a trend: flow of a few hundred disks comes in bursts", source = source,
}
dem.compare {
  what = "k, by which the outlet is narrower, in diameters", value = k, reference = 1.5, tolerance = 2 / 3,
  because = "a band from 0.5 to 2.5: an extrapolation from outlets of 6 diameters and more", source = source,
}
dem.compare {
  what = "flow later, of that before", value = late / early, reference = 1, tolerance = 0.1, because = "a trend, as above", source = source,
}
dem.result { narrow = flow[1], middle = flow[2], wide = flow[3] }
