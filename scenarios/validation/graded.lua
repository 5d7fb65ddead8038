-- Question: how many elements does a cantilever need when they are small only where it bends?
-- Source:   the cantilever of irregular_cantilever.lua, finite elements of this project (docs/theory/references.md).
-- See:      `demlua study`: one series of even packs, one of elements four times as large at the tip as at the clamp, and
--           there half as large again at the bottom as at the top: a fifth fewer elements for the same error and scatter.
-- Takes:    a second; the study half a minute.
local dem = require "dem"

local p = dem.param {
  fine   = { 0.07, "m", help = "distance of elements at the clamp" },
  graded = { true, help = "larger towards the tip; else alike" },
  seed   = { 1, help = "of the pack" },
}
local length, height, force = 10.4, 1.0, 1e-9 -- m, m, N

dem.study {
  vary = { fine = { 0.1, 0.07, 0.05 }, graded = { false, true } }, size = "fine", seeds = 10,
  measure = "compliance", reference = 4524.385, unit = "/(E t)", -- of the mean end deflection under the force
  tolerance = function(q) return q.fine > 0.08 and 3e-3 or 1e-3 end,
  because = "as irregular_cantilever.lua: 0.1 % where elements at the clamp are below 0.08 H, which is a thousand of them; 0.3 % above",
  source = "nine-node finite elements, 64 x 16 and finer",
}
local function size(x, y)
  if not p.graded then return p.fine end
  return p.fine * (1 + 3 * (x / length) ^ 3) * (1 + (height - y) / (2 * height) * (1 - x / length))
end

local sim = dem.simulation { title = "Cantilever of a graded pack", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
local left_end = dem.rectangle { at = { -1e-3, -1e-3 }, size = { 2e-3, height + 2e-3 } }
local right_end = left_end:translated { length, 0 }
local bar = sim:body {
  name = "bar", material = solid,
  region  = dem.rectangle { size = { length, height } },
  packing = dem.relaxed { size = size, seed = p.seed, on_boundary = true, boundary_within = left_end + right_end },
  bonds   = dem.elastic {},
}
sim:fix { bar, within = left_end }
sim:traction { bar.right, stress_y = force / height }
sim:solve_static { linear = true }

dem.result { compliance = sim.now:mean("displacement_y", { bar, within = right_end }) / force }
