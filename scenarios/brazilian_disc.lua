local dem = require "dem"
local handbook = dem.include "shared/handbook.lua" {}

local p = dem.param {
  law      = { "cohesive", help = "of the bonds: any that breaks" },
  count    = { 2400, help = "elements" },
  seed     = { 1, help = "of the pack" },
  diameter = { 20, help = "of the disc, in a_t" },
  arc      = { 5, help = "degrees to either side of the load's axis on which it presses" },
  ratio    = { 0.2, help = "Poisson's" },
}
local concrete = dem.material {
  name = "concrete", youngs_modulus = 29.7e9, poissons_ratio = p.ratio, density = 2400,
  tensile_strength = 3.44e6, fracture_toughness = 1.0e6, friction = 0.5,
}
local strength = concrete.tensile_strength
local R = p.diameter / 2 * handbook.transition_length(concrete.fracture_toughness, strength)
local arc = math.rad(p.arc)
local tension = handbook.disc_tension(2 * R, 1, arc) -- per force
local region = dem.disc { radius = R }
local d = math.sqrt(region:area() / (p.count * math.sqrt(3) / 2))

local sim = dem.simulation { title = "Brazilian disc", plane = "stress" }
local disc = sim:body {
  name = "disc", material = concrete, region = region,
  packing = dem.relaxed { count = p.count, seed = p.seed, on_boundary = true }, bonds = dem.bond_law(p.law) {},
}
local function pressed(way)
  return { disc, where = function(x, y) return x * x + y * y > (R - 0.1 * d) ^ 2 and way * y > R * math.cos(arc) end }
end
local most = 1.5 * strength / tension
local upper = sim:force { pressed(1), y = dem.ramp { to = -most, over = 1 } }
sim:force { pressed(-1), y = dem.ramp { to = most, over = 1 } }
sim:fix { disc, within = dem.disc { centre = { -R, 0 }, radius = 0.6 * d }, x = true, y = true }
sim:fix { disc, within = dem.disc { centre = { R, 0 }, radius = 0.6 * d }, y = true }
-- While nothing yields the centre says how good the stresses are.
local centre, opened
sim:every { 0.05, function(now)
  if now.ledger.plastic + now.ledger.fracture > 0 then return end
  centre = {}
  for k = 2, 6, 2 do centre[k] = now:mean("stress_xx", { disc, within = dem.disc { radius = k * d } }) / (-upper.y * tension) end
end }
sim:on_bond_break(function(event, now) opened = opened or -upper.y * tension / strength end)
sim:output { every = 1 / 20 }
sim:run { duration = 1, driver = "quasi-static" }
dem.result { r2 = centre[2], r4=centre[4], r6=centre[6], opened=opened or 0, strength = -upper.y * tension / strength, broken=sim.now.broken_bonds }
