-- Question: how stiff is a cantilever of an irregular pack, and how fast does its error fall with more elements?
-- Source:   finite elements of this project (docs/theory/references.md), meshes that agree to 4e-6. Nothing is fitted:
--           facet bonds take E and nu as they are said.
-- See:      `demlua study`: mean and scatter over ten packs, error against element size and against time; the error falls
--           with the square of the size, or faster.
-- Takes:    half a second at 1200 elements; the study two minutes.
local dem = require "dem"

local p = dem.param {
  count = { 1200, help = "elements" },
  seed  = { 1, help = "of the pack" },
  held_turning = { false, help = "whether the elements of the held end are held against turning too" },
}
local length, height, force = 10.4, 1.0, 1e-9 -- m, m, N
local nu = 0.3
local function spacing(count) return math.sqrt(length * height / (count * math.sqrt(3) / 2)) end

dem.study {
  vary = { count = { 150, 300, 600, 1200, 2400, 4800, 9600 } }, size = function(q) return spacing(q.count) end, seeds = 10,
  measure = "compliance", reference = 4524.385, unit = "/(E t)", -- of the mean end deflection under the force
  tolerance = function(q)
    local share = (spacing(q.count) / height) ^ 2 / 10
    return q.count < 1200 and share or math.min(share, 1e-3)
  end,
  because = "second order asked, (h/H)^2/10, and 0.1 % from 1200 elements on",
  source = "nine-node finite elements, 128 x 32",
}

local sim = dem.simulation { title = "Cantilever of an irregular pack", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = nu, density = 1 }
local left_end = dem.rectangle { at = { -1e-3, -1e-3 }, size = { 2e-3, height + 2e-3 } }
local bar = sim:body {
  name = "bar", material = solid,
  region  = dem.rectangle { size = { length, height } },
  packing = dem.relaxed {
    count = p.count, seed = p.seed, on_boundary = true, boundary_within = left_end + left_end:translated { length, 0 },
  },
  bonds = dem.elastic {},
}
-- The end is held, its elements turn as the solid does there; those in its two corners have nothing that would turn them right.
local corner = dem.rectangle { at = { -1e-3, -1e-3 }, size = { 2e-3, 2e-3 } }
sim:fix { bar, within = left_end, x = true, y = true, rotation = p.held_turning }
sim:fix { bar, within = corner + corner:translated { 0, height } }
sim:traction { bar.right, stress_y = force / height }
sim:solve_static { linear = true }

local right_end = { bar, within = left_end:translated { length, 0 } }
dem.result { compliance = sim.now:mean("displacement_y", right_end) / force }
