-- Question: what is the longest period of a close-packed bar that swings along itself?
-- Source:   a free bar, period 2 L / c with c = sqrt(E / rho). The outer rows have lost half of their slanted bonds: in a
--           bar of n rows and nu = 0 they leave 1 - 1/(3 n) of E. The lattice slows waves along its rows: with Kt = Kn,
--           m w^2 = 2 K (1 - cos 2 q R) + 4 (1 - 1/n) K (1 - cos q R), by 0.131 (q R)^2 for five rows.
-- See:      `demlua study`: an error that falls with the square of the element radius.
-- Takes:    seconds.
local dem = require "dem"

local p = dem.param {
  per_row  = { 20, help = "elements in the longer rows" },
  cycles   = { 3, help = "how many are timed" },
}
local rows, length = 5, 1.0 -- three long rows and two short ones between; their mean length, m

local rubber = dem.material { name = "rubber", youngs_modulus = 1e7, poissons_ratio = 0, density = 1000 }
local function radius_for(per_row) return length / (2 * per_row - 4 / rows) end
local radius = radius_for(p.per_row)
local speed = math.sqrt(rubber.youngs_modulus / rubber.density * (1 - 1 / (3 * rows)))
local period = 2 * length / speed
local phase = math.pi * radius / length -- q R

dem.study {
  vary = { per_row = { 20, 40, 80, 160 } }, measure = "period", reference = period, unit = "s",
  size = function(q) return radius_for(q.per_row) end,
  tolerance = 0.133 * phase ^ 2 + 18 * phase ^ 3 / math.pi, order = { 1.9, 2.8 },
  because = "0.131 (q R)^2 of dispersion, and end zones of 3 R with twice the compliance: 2/3 pi^2 (3 R / L)^3",
  source = "waves in a close-packed lattice with Kt = Kn",
}

local sim = dem.simulation { title = "Longest period of a bar", plane = "stress", step_fraction = 0.2 }
local height = (2 + (rows - 1) * math.sqrt(3)) * radius
local bar = sim:body {
  name = "bar", material = rubber,
  region  = dem.rectangle { size = { 2 * radius * p.per_row, height * 1.000001 } },
  packing = dem.close_packed { radius = radius },
  bonds   = dem.elastic {},
}

-- Half a period of push in the shape of the mode, column by column; then the bar swings freely.
local shift = 1 / 2 - radius * p.per_row / length -- the bar's middle is a node
local mass = 2 * math.sqrt(3) * radius ^ 2 * rubber.density
for column = 1, 2 * p.per_row - 1 do
  local x = column * radius
  sim:force {
    { bar, where = function(at) return math.abs(at - x) < radius / 4 end },
    x = { { 0, 0 }, { period / 4, 1e-3 * mass * math.cos(math.pi * (x / length + shift)) }, { period / 2, 0 } },
  }
end

local last, passes = nil, {}
sim:every { period / 400, function(now)
  local here = { time = now.time, stretch = now:mean("displacement_x", bar.right) - now:mean("displacement_x", bar.left) }
  if last and here.time > period / 2 and last.stretch < 0 and here.stretch >= 0 then
    passes[#passes + 1] = last.time + (here.time - last.time) * last.stretch / (last.stretch - here.stretch)
  end
  last = here
end }
sim:run { duration = (p.cycles + 2) * period }

dem.result { period = (passes[1 + p.cycles] - passes[1]) / p.cycles }
