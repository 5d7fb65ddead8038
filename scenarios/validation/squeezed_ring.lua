-- Question: how far does a ring (or disc, see squeezed_disc.lua) of an irregular pack give when squeezed across a diameter?
-- Source:   series of plane elasticity and finite elements of this project (docs/theory/references.md): pressure on the arcs
--           within 10 degrees of the y axis, with the resultant 1 on each.
-- See:      `demlua study`: curved free walls inside and outside, with a row of elements on both.
-- Takes:    a second; the study half a minute.
local dem = require "dem"

local p = dem.param {
  count = { 2400, help = "elements" },
  seed  = { 1, help = "of the pack" },
  inner = { 0.5, "m", help = "radius of the hole: 0.5 or 0" },
}
local outer, force, arc = 1.0, 1e-9, math.rad(10) -- m, N, rad either side of the y axis
local pressure = force / (2 * outer * math.sin(arc))
local hollow = p.inner > 0
local ring = dem.disc { radius = outer }
if hollow then ring = ring - dem.disc { radius = p.inner } end
local function spacing(count) return math.sqrt(ring:area() / (count * math.sqrt(3) / 2)) end
local reference = "series of plane elasticity, nine-node finite elements"

dem.study {
  vary = { count = { 600, 1200, 2400, 4800 } }, size = function(q) return spacing(q.count) end, seeds = 5,
  measure = "closing", reference = hollow and -9.401275 or -2.898971, unit = "/(E t)", -- of the diameter along y, mean over the arcs, under the force
  tolerance = function(q) return math.max(1e-2, (spacing(q.count) / (2 * arc * outer)) ^ 2) end,
  because = "1 % asked for; (h/a)^2 where elements are coarse under loaded arcs of the length a", source = reference,
}

local sim = dem.simulation { title = (hollow and "Ring" or "Disc") .. " squeezed across a diameter", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
local body = sim:body {
  name = "ring", material = solid, region = ring,
  packing = dem.relaxed { count = p.count, seed = p.seed, on_boundary = true },
  bonds   = dem.elastic {},
}

-- A moment at rest, after which elements can be asked where they stand: those on the outer wall, by their angle.
sim:force { body, x = 0 }
sim:run { duration = 1e-9 }
local rim = {}
sim.now:field("radius", { body, where = function(x, y)
  if x * x + y * y > (1 - 1e-3 * spacing(p.count)) * outer ^ 2 then rim[#rim + 1] = { x = x, y = y, angle = math.atan(y, x) } end
  return true
end })
table.sort(rim, function(a, b) return a.angle < b.angle end)
local function alone(place) return { body, within = dem.disc { centre = { place.x, place.y }, radius = 1e-3 * spacing(p.count) } } end

-- An element takes the pressure on the arc from halfway to the one before it to halfway to the one after it.
local function load_arc(middle)
  local loaded = {}
  for k = 2, #rim - 1 do
    local from = math.max((rim[k - 1].angle + rim[k].angle) / 2, middle - arc)
    local to = math.min((rim[k].angle + rim[k + 1].angle) / 2, middle + arc)
    if from < to then
      local place = alone(rim[k])
      sim:force {
        place, x = -pressure * outer * (math.sin(to) - math.sin(from)), y = -pressure * outer * (math.cos(from) - math.cos(to)),
      }
      loaded[#loaded + 1] = { place = place, share = (to - from) / (2 * arc) }
    end
  end
  return loaded
end
local upper, lower = load_arc(math.pi / 2), load_arc(-math.pi / 2)

-- Held against rigid motion at the ends of the x axis, where a load in balance asks nothing of supports.
local function nearest(x, y)
  local found
  for _, place in ipairs(rim) do
    place.distance = math.sqrt((place.x - x) ^ 2 + (place.y - y) ^ 2)
    if not found or place.distance < found.distance then found = place end
  end
  return alone(found)
end
sim:fix { nearest(-outer, 0), x = true, y = true }
sim:fix { nearest(outer, 0), y = true }
sim:solve_static { linear = true }

local function mean_over(loaded)
  local sum = 0
  for _, each in ipairs(loaded) do sum = sum + each.share * sim.now:mean("displacement_y", each.place) end
  return sum
end
local widening = (sim.now:mean("displacement_x", nearest(outer, 0)) - sim.now:mean("displacement_x", nearest(-outer, 0))) / force
dem.result { closing = (mean_over(upper) - mean_over(lower)) / force, widening = widening }
dem.compare {
  what = "widening across the load", unit = "/(E t)", value = widening, reference = hollow and 6.064598 or 0.566732, tolerance = 1e-2,
  because = "1 % asked for at 2400 elements", source = reference,
}
if not hollow then
  local reach = 2.5 * spacing(p.count)
  for _, each in ipairs { { "stress_xx", 0.307016 }, { "stress_yy", -0.946880 } } do
    dem.compare {
      what = each[1] .. " at the centre", unit = "/(R t)",
      value = sim.now:mean(each[1], { body, within = dem.disc { radius = reach } }) / force,
      reference = each[2], tolerance = 1e-2 + (reach / outer) ^ 2,
      because = "1 % asked for, and (a/R)^2 for the mean over a probe of radius a, 2.5 elements", source = reference,
    }
  end
end
