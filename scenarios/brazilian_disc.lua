-- Question: which tension splits a disc that is pressed across a diameter, and is it the tensile strength?
-- Source:   Hondros 1959 (scenarios/shared/handbook.lua, disc_tension): 2 P/(pi D t) at the centre for loads on lines, and three
--           times as much pressure along the load. Even vertical loads on the chords of two arcs of half angle a: the same times
--           (sin 2a + sin(4a)/2)/(4 sin a), as at the centre nothing of them counts but mean and second harmonic of the pressure.
-- See:      stress_xx in elements.pvd, up to the last rest. With driver=dynamic two flat platens close until the disc is split along
--           the load, with wedges under the platens: cracks.pvd.
--           Other laws have caps on shear that the pressure reaches first: "plateau" and "softening" split at half the strength.
-- Takes:    a few seconds, platens ten; the study a minute.
local dem = require "dem"
local handbook = dem.include "shared/handbook.lua" {}

local p = dem.param {
  law      = { "cohesive", help = "of the bonds: any that breaks" },
  count    = { 1200, help = "elements" },
  seed     = { 1, help = "of the pack" },
  diameter = { 20, help = "of the disc, in a_t = (K_Ic/strength)^2/pi" },
  arc      = { 8, help = "degrees to either side of the load's axis on which it presses" },
  ratio    = { 0.2, help = "Poisson's" },
  driver   = { "quasi-static", help = "even forces on the arcs, from rest to rest; or \"dynamic\": platens that close" },
  speed    = { 0.05, "m/s", help = "at which the platens close" },
}
local concrete = dem.material {
  name = "concrete", youngs_modulus = 29.7e9, poissons_ratio = p.ratio, density = 2400, contact_damping = 0.2,
  tensile_strength = 3.44e6, fracture_toughness = 1.0e6, friction = 0.5,
}
local strength = concrete.tensile_strength
local R = p.diameter / 2 * handbook.transition_length(concrete.fracture_toughness, strength)
local arc, platens = math.rad(p.arc), p.driver == "dynamic"
local tension = handbook.disc_tension(2 * R, 1, 0) -- at the centre, of a unit force
if not platens then tension = tension * (math.sin(2 * arc) + math.sin(4 * arc) / 2) / (4 * math.sin(arc)) end
local region = dem.disc { radius = R }
local function spacing(count) return math.sqrt(region:area() / (count * math.sqrt(3) / 2)) end
local d = spacing(p.count)

dem.study {
  vary = { count = { 600, 1200, 2400 } }, size = function(q) return spacing(q.count) end, seeds = 3,
  measure = "splitting_strength", unit = "Pa", reference = strength,
  tolerance = 0.1, because = "asked for", source = "Hondros 1959, and the strength of the bonds",
}

local sim = dem.simulation { title = "Brazilian disc", plane = "stress" }
local disc = sim:body {
  name = "disc", material = concrete, region = region,
  packing = dem.relaxed { count = p.count, seed = p.seed, on_boundary = not platens }, bonds = dem.bond_law(p.law) {},
}
local force
if platens then
  for name, way in pairs { upper = 1, lower = -1 } do
    local y = way * (R + 1e-6 * R)
    sim:wall { name = name, path = { { -R, y }, { R, y } }, velocity = { 0, -way * p.speed / 2 } }
  end
  force = function(now) return (now.wall.upper.force.y - now.wall.lower.force.y) / 2 end
else
  local function pressed(way)
    return { disc, where = function(x, y) return x * x + y * y > (R - 0.1 * d) ^ 2 and way * y > R * math.cos(arc) end }
  end
  local most = 1.5 * strength / tension
  local upper = sim:force { pressed(1), y = dem.ramp { to = -most, over = 1 } }
  sim:force { pressed(-1), y = dem.ramp { to = most, over = 1 } }
  force = function() return -upper.y end
  -- The loads balance; the ends of the other diameter keep the disc from floating.
  sim:fix { disc, within = dem.disc { centre = { -R, 0 }, radius = 0.6 * d }, x = true, y = true }
  sim:fix { disc, within = dem.disc { centre = { R, 0 }, radius = 0.6 * d }, y = true }
end

-- While nothing yields the centre is compared with its closed form; the greatest force is the strength.
local reach, centre, peak = 3 * d, nil, 0
local duration = platens and 40 * R * strength / concrete.youngs_modulus / p.speed or 1
sim:every { duration / 50, function(now)
  local P = force(now)
  peak = math.max(peak, P)
  if now.ledger.plastic + now.ledger.fracture == 0 and P > 0 then
    centre = now:mean("stress_xx", { disc, within = dem.disc { radius = reach } }) / (P * tension)
  end
  if platens and P < peak / 2 and now.broken_bonds > 0 then now:stop("the disc is split") end
end }
sim:history { every = duration / 200, force = force }
sim:output { every = duration / 20 }
sim:run { duration = duration, driver = p.driver }
peak = math.max(peak, force(sim.now))

dem.result {
  splitting_strength = peak * tension, share_of_strength = peak * tension / strength, centre = centre or 0,
  broken_bonds = sim.now.broken_bonds, elements = sim.now.elements,
}
if not platens then -- how wide they touch is not known
  dem.compare {
    what = "stress at the centre", unit = "of its closed form", value = centre or 0, reference = 1 - (reach / R) ^ 2, tolerance = 1e-2,
    because = "1 % asked for; the mean over a probe of radius a is (a/R)^2 lower", source = "Hondros 1959",
  }
end
