-- Question: what is the period of two bonded disks that swing along their bond?
-- Source:   a spring between one held mass and one free mass, period 2 pi sqrt(m / Kn); Kn from Tavarez & Plesha 2007, eq. 15.
-- See:      a sine in the column `stretch` of history.csv; the results `period` and `reference` agree.
-- Takes:    less than a second.
local dem = require "dem"

local p = dem.param {
  radius = { 0.01, "m" },
  speed  = { 1e-3, "m/s", help = "of the free disk at the start" },
  cycles = { 10, help = "how many are timed" },
}

local rubber = dem.material { name = "rubber", youngs_modulus = 1e7, poissons_ratio = 0.2, density = 1000 }
local sim = dem.simulation { title = "Bonded pair", plane = "stress", step_fraction = 0.1 }

local pair = sim:body {
  name = "pair", material = rubber,
  packing  = dem.disks { { 0, 0, p.radius }, { 2 * p.radius, 0, p.radius } },
  bonds    = dem.elastic {},
  velocity = { p.speed, 0 },
}
sim:fix { pair, within = dem.disc { radius = p.radius / 2 } }

-- The free disk passes its middle twice in a period; times are interpolated between readings.
local free = { pair, within = dem.half_plane { point = { p.radius, 0 }, outward = { -1, 0 } } }
local last, passes = nil, {}
local stiffness = rubber.youngs_modulus / (math.sqrt(3) * (1 - rubber.poissons_ratio))
local mass = rubber.density * math.pi * p.radius ^ 2 -- of a disk listed by itself, 1 m thick
local reference = 2 * math.pi * math.sqrt(mass / stiffness)

sim:every { reference / 200, function(now)
  local here = { time = now.time, stretch = now:mean("displacement_x", free) }
  if last and last.stretch < 0 and here.stretch >= 0 then
    passes[#passes + 1] = last.time + (here.time - last.time) * last.stretch / (last.stretch - here.stretch)
  end
  last = here
end }
sim:history { every = reference / 50, stretch = function(now) return now:mean("displacement_x", free) end }
sim:output { every = reference / 10 }
sim:run { duration = (p.cycles + 1.5) * reference }

local period = #passes > 1 and (passes[#passes] - passes[1]) / (#passes - 1) or 0
dem.result { period = period, reference = reference, error = period / reference - 1 }
dem.compare {
  what = "period", unit = "s", value = period, reference = reference, tolerance = 2e-3,
  because = "central difference shortens it by (w dt)^2/24, 1.7e-3 at a tenth of the stable step",
  source  = "one mass on one spring, Kn of Tavarez & Plesha 2007, eq. 15",
}
