-- Question: how does the time step change the period of a bonded pair?
-- Source:   central difference on one mass and one spring: sin(w' dt/2) = w dt/2, so the period is short by (w dt)^2/24.
-- See:      `demlua study`: the error of the period falls with the square of the fraction of the stable step.
-- Takes:    less than a second for each level.
local dem = require "dem"

local p = dem.param {
  fraction = { 0.1, help = "time step as a share of the stable one" },
  cycles   = { 5, help = "how many are run" },
}
local radius, speed = 0.01, 1e-3

local rubber = dem.material { name = "rubber", youngs_modulus = 1e7, poissons_ratio = 0.2, density = 1000 }
local stiffness = rubber.youngs_modulus / (math.sqrt(3) * (1 - rubber.poissons_ratio))
local mass = rubber.density * math.pi * radius ^ 2 -- of a disk listed by itself, 1 m thick
local frequency = math.sqrt(stiffness / mass)      -- rad/s
local period = 2 * math.pi / frequency

dem.study {
  vary = { fraction = { 0.2, 0.1, 0.05, 0.025 } }, measure = "period", reference = period, unit = "s",
  tolerance = p.fraction ^ 2 / 6, order = { 1.9, 2.1 },
  because = "(w dt)^2/24 with w dt at most twice the fraction",
  source = "central difference applied to one mass and one spring",
}

local sim = dem.simulation { title = "Period against time step", plane = "stress", step_fraction = p.fraction }
local pair = sim:body {
  name = "pair", material = rubber,
  packing  = dem.disks { { 0, 0, radius }, { 2 * radius, 0, radius } },
  bonds    = dem.elastic {},
  velocity = { speed, 0 },
}
sim:fix { pair, within = dem.disc { radius = radius / 2 } }
local free = { pair, within = dem.half_plane { point = { radius, 0 }, outward = { -1, 0 } } }

-- After whole periods the disk would be at its middle again; its place and speed tell the phase it has gained.
sim:run { duration = p.cycles * period }
local place, pace = sim.now:mean("displacement_x", free), sim.now:mean("velocity_x", free)
local ahead = math.atan(place * frequency, pace) / (2 * math.pi * p.cycles)
dem.result { period = period / (1 + ahead) }
