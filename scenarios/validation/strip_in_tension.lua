-- Question: which Young's modulus and Poisson's ratio does a consolidated pack have, bonded in each way?
-- Source:   those of its material. Tavarez & Plesha 2007 pack so (section 4, clusters of three) and bond elements that touch
--           by eqs 15-16, which hold for close packing.
-- See:      `demlua study`: the modulus read in the middle of a strip pulled at both ends, one series for each way.
-- Takes:    a second; the study ten seconds.
local dem = require "dem"

local p = dem.param {
  count     = { 3000, help = "elements" },
  seed      = { 1, help = "of the pack" },
  stiffness = { "facets", help = "of the bonds: facets, delaunay or contacts" },
  search    = { 0.3, help = "gap across which contacts are bonded, in radii; at 0.1 some elements are held by nothing" },
  plane     = { "stress", help = "or strain" },
  nu        = { 0.3, help = "Poisson's ratio" },
}
local length, height, stretch = 3.0, 1.0, 1e-9 -- m, m, m

local by_pairs = p.plane == "stress" and p.nu <= 1 / 3 -- what eqs 15 and 16 allow

dem.study {
  vary = { count = { 1500, 3000 }, stiffness = by_pairs and { "facets", "delaunay", "contacts" } or { "facets" } },
  size = function(q) return math.sqrt(length * height / q.count) end, seeds = 3,
  measure = "modulus", reference = 1, unit = "Pa",
  tolerance = function(q) return ({ facets = 2e-3, delaunay = 0.05, contacts = 0.6 })[q.stiffness or "facets"] end,
  because = "facets: the held ends disturb the middle by exp(-4.2 x/H), 0.5 % at its rim; delaunay and contacts: their error is what is shown",
  source = "the material's own",
}

local sim = dem.simulation { title = "Strip of a consolidated pack", plane = p.plane }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = p.nu, density = 1 }
local strip = sim:body {
  name = "strip", material = solid,
  region  = dem.rectangle { size = { length, height } },
  packing = dem.consolidated { cluster = 3, count = p.count, seed = p.seed },
  bonds   = dem.elastic { stiffness = p.stiffness, search = p.search },
}
local depth = 0.1 -- of the ends that are moved as a piece
sim:fix  { strip, within = dem.rectangle { size = { depth, height } } }
sim:move { strip, within = dem.rectangle { at = { length - depth, 0 }, size = { depth, height } }, displacement = { stretch, 0 }, spin = 0 }
sim:solve_static { linear = true }

-- Mean strain of the middle, as the slope of displacements over places, and mean stress.
local middle = { strip, within = dem.rectangle { at = { length / 2 - 0.4, 0.15 }, size = { 0.8, height - 0.3 } } }
local function slope(measure, along_y)
  local place = {}
  local values = sim.now:field(measure, { middle[1], within = middle.within, where = function(x, y)
    place[#place + 1] = along_y and y or x
    return true
  end })
  local n, sx, sv, sxx, sxv = #values, 0, 0, 0, 0
  for k, value in ipairs(values) do
    sx, sv, sxx, sxv = sx + place[k], sv + value, sxx + place[k] ^ 2, sxv + place[k] * value
  end
  return (n * sxv - sx * sv) / (n * sxx - sx ^ 2)
end
local xx, yy = slope("displacement_x", false), slope("displacement_y", true)
local pull, across = sim.now:mean("stress_xx", middle), sim.now:mean("stress_yy", middle)
-- Hooke's law of the plane: xx = (pull - ratio across)/modulus, yy = (across - ratio pull)/modulus.
local compliance = (xx * pull - yy * across) / (pull ^ 2 - across ^ 2)
local ratio = (xx * across - yy * pull) / (pull ^ 2 - across ^ 2) / compliance
local modulus = 1 / compliance
if p.plane == "strain" then
  ratio = ratio / (1 + ratio)
  modulus = modulus * (1 - ratio ^ 2)
end
dem.result { modulus = modulus, ratio = ratio }
if p.stiffness == "facets" then
  dem.compare {
    what = "Poisson's ratio, facets, plane " .. p.plane, value = ratio, reference = p.nu, tolerance = 5e-3,
    because = "the held ends disturb the middle by exp(-4.2 x/H), 0.5 % at its rim", source = "the material's own",
  }
end
