-- Question: does a bar that lies across the axes stretch as one that lies along them?
-- Source:   a rectangle turned by 20 degrees, pulled along itself by an even stress: elongation force L / (E H t), exactly.
-- See:      `demlua study`: slanted walls, elements on the loaded ends only.
-- Takes:    half a second; the study ten seconds.
local dem = require "dem"

local p = dem.param {
  spacing = { 0.076, "m", help = "of the elements; 1,200 of them" },
  seed    = { 1, help = "of the pack" },
}
local length, height, force = 6.0, 1.0, 1e-9 -- m, m, N
local slope = math.rad(20)
local turn = { angle = slope }

dem.study {
  vary = { spacing = { 0.15, 0.106, 0.076, 0.053 } }, seeds = 10,
  measure = "elongation", reference = 6, unit = "/(E t)", -- under the force
  tolerance = function(q) return 4 * q.spacing ^ 2 / (length * height) end,
  because = "even stress is in equilibrium along free walls, not in the four corners: an element there yields by up to 2 h too much, h/(2 H) of its end",
  source = "uniform stress",
}

local sim = dem.simulation { title = "Turned bar in tension", plane = "stress" }
local solid = dem.material { name = "solid", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 }
local function strip(at, size) return dem.rectangle { at = at, size = size }:rotated(turn) end
local left_end = strip({ -1e-3, -1e-3 }, { 2e-3, height + 2e-3 })
local right_end = strip({ length - 1e-3, -1e-3 }, { 2e-3, height + 2e-3 })
local between = strip({ -1e-2, p.spacing / 2 }, { length + 2e-2, height - p.spacing })
local bar = sim:body {
  name = "bar", material = solid,
  region  = dem.rectangle { size = { length, height } }:rotated(turn),
  packing = dem.relaxed { spacing = p.spacing, seed = p.seed, on_boundary = true, boundary_within = left_end + right_end },
  bonds   = dem.elastic {},
}

-- An element in a corner of the bar takes half the share of one between corners.
local gaps = math.floor(height / p.spacing + 0.5)
local function pull(row, tension)
  local x, y = tension * math.cos(slope), tension * math.sin(slope)
  sim:force { bar, within = row * between, x = x * (1 - 1 / gaps), y = y * (1 - 1 / gaps) }
  sim:force { bar, within = row - between, x = x / gaps, y = y / gaps }
end
pull(left_end, -force)
pull(right_end, force)
local function corner(x, y) return { bar, within = strip({ x - 1e-3, y - 1e-3 }, { 2e-3, 2e-3 }) } end
sim:fix { corner(0, 0), x = true, y = true }
sim:fix { corner(length, 0), y = true }
sim:solve_static { linear = true }

-- Between the means over the ends, each element counting as it is loaded; how the whole has turned does not count.
local function along(row)
  local mean = 0
  for _, part in ipairs { { row * between, 1 - 1 / gaps }, { row - between, 1 / gaps } } do
    local rows = { bar, within = part[1] }
    local x, y = sim.now:mean("displacement_x", rows), sim.now:mean("displacement_y", rows)
    mean = mean + part[2] * (x * math.cos(slope) + y * math.sin(slope))
  end
  return mean
end
dem.result { elongation = (along(right_end) - along(left_end)) / force }
