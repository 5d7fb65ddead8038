-- Question: with which frequency does a cantilever of an irregular pack swing?
-- Source:   first natural frequency by finite elements of this project (docs/theory/references.md).
-- See:      the bar is bent at rest, let go, and followed for three periods; the frequency is what the phase at the tip
--           gains from one window of two periods to the next, a period later.
-- Takes:    three seconds at 600 elements; the study four minutes, most of it at 2400 elements.
-- Quick:    no
local dem = require "dem"

local p = dem.param {
  count = { 1200, help = "elements" },
  seed  = { 1, help = "of the pack" },
}
local length, height, stress = 10.4, 1.0, 1e-9 -- m, m, Pa
local expected = 9.32609e-3 -- rad/s, times sqrt(E / rho) / m
local period = 2 * math.pi / expected
local function spacing(count) return math.sqrt(length * height / (count * math.sqrt(3) / 2)) end

dem.study {
  vary = { count = { 150, 300, 600, 1200, 2400 } }, size = function(q) return spacing(q.count) end, seeds = 3,
  measure = "frequency", reference = expected, unit = "rad/s",
  tolerance = function(q) return math.max(1e-3, (spacing(q.count) / height) ^ 2 / 6) end,
  because = "half the error of the compliance in irregular_cantilever.lua, and as much for the second mode",
  source = "nine-node finite elements, 64 x 16",
}

local sim = dem.simulation { title = "Swinging cantilever of an irregular pack", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
local left_end = dem.rectangle { at = { -1e-3, -1e-3 }, size = { 2e-3, height + 2e-3 } }
local right_end = left_end:translated { length, 0 }
local bar = sim:body {
  name = "bar", material = solid,
  region  = dem.rectangle { size = { length, height } },
  packing = dem.relaxed { count = p.count, seed = p.seed, on_boundary = true, boundary_within = left_end + right_end },
  bonds   = dem.elastic {},
}
sim:fix { bar, within = left_end }
local push = sim:traction { bar.right, stress_y = stress }
sim:solve_static {}
push:set { stress_y = 0 }

-- Fourier coefficients of the tip's motion at the expected frequency, each in a window (1 - cos)/2 of two periods.
local begin, samples = sim.now.time, 200
local windows = { { from = 0, re = 0, im = 0 }, { from = period, re = 0, im = 0 } }
sim:every { period / samples, function(now)
  local time = now.time - begin
  local tip = now:mean("displacement_y", { bar, within = right_end })
  for _, window in ipairs(windows) do
    local share = (time - window.from) / (2 * period)
    if share > 0 and share < 1 then
      local weight = (1 - math.cos(2 * math.pi * share)) / 2
      window.re = window.re + weight * tip * math.cos(expected * time)
      window.im = window.im + weight * tip * math.sin(expected * time)
    end
  end
end }
sim:run { duration = 3.01 * period }

local function phase(window) return math.atan(window.im, window.re) end
dem.result { frequency = expected - (phase(windows[2]) - phase(windows[1])) / period }
