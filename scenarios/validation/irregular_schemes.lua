-- Question: which ways of giving bonds their stiffness make an irregular pack as stiff as its material says?
-- Source:   the cantilever of irregular_cantilever.lua, bonded by facets and by pairs (Tavarez & Plesha 2007, eqs 15-16, on
--           all neighbouring cells). Bonds of touching elements alone, as the paper has them, leave some elements of this
--           pack to nothing: see strip_in_tension.lua.
-- See:      `demlua study`: a pair's stiffness keeps a bias however fine the pack is; the facets' error falls to nothing.
-- Takes:    seconds.
local dem = require "dem"

local p = dem.param {
  count = { 1200, help = "elements" },
  seed  = { 1, help = "of the pack" },
  stiffness = { "facets", help = "of the bonds: facets or delaunay" },
}
local length, height, force = 10.4, 1.0, 1e-9 -- m, m, N
local function spacing(count) return math.sqrt(length * height / (count * math.sqrt(3) / 2)) end

dem.study {
  vary = { count = { 1200, 2400 }, stiffness = { "facets", "delaunay" } },
  size = function(q) return spacing(q.count) end,
  measure = "compliance", reference = 4524.385, unit = "/(E t)", -- of the mean end deflection under the force
  tolerance = function(q) return ({ facets = 1e-3, delaunay = 0.06 })[q.stiffness] end,
  because = "facets: 0.1 % as in irregular_cantilever.lua; delaunay: its error is what is shown, some per cent that do not fall",
  source = "nine-node finite elements, 64 x 16 and finer",
}

local sim = dem.simulation { title = "Cantilever of an irregular pack, two ways", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
local left_end = dem.rectangle { at = { -1e-3, -1e-3 }, size = { 2e-3, height + 2e-3 } }
local bar = sim:body {
  name = "bar", material = solid,
  region  = dem.rectangle { size = { length, height } },
  packing = dem.relaxed {
    count = p.count, seed = p.seed, on_boundary = true, boundary_within = left_end + left_end:translated { length, 0 },
  },
  bonds = dem.elastic { stiffness = p.stiffness },
}
sim:fix { bar, within = left_end }
sim:traction { bar.right, stress_y = force / height }
sim:solve_static { linear = true }

local right_end = { bar, within = left_end:translated { length, 0 } }
dem.result { compliance = sim.now:mean("displacement_y", right_end) / force }
