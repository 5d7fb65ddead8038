-- Question: does a bar whose walls stand slanted to all axes and to its ends bend as it should?
-- Source:   finite elements of this project (docs/theory/references.md): upright ends, long sides at 20 degrees, clamped on the
--           left, a unit force upwards as even traction on the right.
-- See:      `demlua study`: mean and scatter over the packs. turned_bar.lua pulls a rectangle that is turned.
-- Takes:    half a second; the study ten seconds.
local dem = require "dem"

local p = dem.param {
  count = { 1200, help = "elements" },
  seed  = { 1, help = "of the pack" },
}
local length, height, force = 6.0, 1.0, 1e-9 -- m, m, N
local rise = length * math.tan(math.rad(20))
local function spacing(count) return math.sqrt(length * height / (count * math.sqrt(3) / 2)) end

dem.study {
  vary = { count = { 300, 600, 1200, 2400, 4800 } }, size = function(q) return spacing(q.count) end, seeds = 10,
  measure = "compliance", reference = 1109.123, unit = "/(E t)", -- of the mean end deflection under the force
  tolerance = function(q) return math.max(1e-2, (spacing(q.count) / height) ^ 2) end,
  because = "1 % asked for; (h/H)^2 of the bending where cells are coarse",
  source = "nine-node finite elements, 96 x 24 and finer",
}

local sim = dem.simulation { title = "Slanted cantilever", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
local left_end = dem.rectangle { at = { -1e-3, -1e-3 }, size = { 2e-3, height + 2e-3 } }
local right_end = left_end:translated { length, rise }
local bar = sim:body {
  name = "bar", material = solid,
  region  = dem.polygon { { 0, 0 }, { length, rise }, { length, rise + height }, { 0, height } },
  packing = dem.relaxed { count = p.count, seed = p.seed, on_boundary = true, boundary_within = left_end + right_end },
  bonds   = dem.elastic {},
}
sim:fix { bar, within = left_end }
sim:traction { bar.right, stress_y = force / height }
sim:solve_static { linear = true }

dem.result { compliance = sim.now:mean("displacement_y", { bar, within = right_end }) / force }
