-- Question: where does a bar break when a pressure pulse is thrown back by its free end, and how fast does the end fly off?
-- Source:   waves in one dimension (scenarios/shared/handbook.lua, spall_of_block): reflected as tension, a pulse of constant stress
--           s0 and length l first pulls at l/2 from the free end; that piece takes the whole impulse, at 2 s0/(rho c).
-- See:      stress_xx in elements.pvd: pressure on its way right, nothing while it is thrown back, then tension that parts the bar.
-- Takes:    a few seconds.
local dem = require "dem"
local handbook = dem.include "shared/handbook.lua" {}

local p = dem.param {
  law       = { "cohesive", help = "of the bonds: any that breaks" },
  spacing   = { 1.6e-3, "m", help = "of the elements" },
  across    = { 3, help = "elements across the bar: a crack takes time to cross it, and the piece is pulled back meanwhile" },
  length    = { 0.9, "m", help = "of the bar" },
  pulse     = { 0.64, "m", help = "length of the pulse" },
  stress    = { 1.5, help = "of the pulse, over the tensile strength" },
  front     = { 4, help = "length of the pulse's rise and of its fall, in elements" },
  toughness = { 0.2e6, "Pa m^0.5", help = "the bonds' pull while they let go, the less the brittler, is not in the closed form" },
  ratio     = { 0.2, help = "Poisson's" },
  seed      = { 1, help = "of the pack" },
}
if p.stress <= 1 then error("stress: above 1, the strength") end
local stone = dem.material {
  name = "stone", youngs_modulus = 29.7e9, poissons_ratio = p.ratio, density = 2400,
  tensile_strength = 3.44e6, fracture_toughness = p.toughness, friction = 0.5,
}
local speed = math.sqrt(stone.youngs_modulus / stone.density)
local pressure, d, height = p.stress * stone.tensile_strength, p.spacing, p.across * p.spacing
local thickness, flight = handbook.spall_of_block(pressure, p.pulse, stone.density * speed)

dem.study {
  vary = { spacing = { 1.6e-3 } }, seeds = 3, measure = "thickness", unit = "m", reference = thickness,
  tolerance = d / thickness, because = "one element", source = "waves in one dimension",
}

local sim = dem.simulation { title = "Spall", plane = "stress" }
local loaded = dem.rectangle { at = { -d / 2, -d }, size = { d, height + 2 * d } }
local bar = sim:body {
  name = "bar", material = stone, region = dem.rectangle { size = { p.length, height } },
  packing = dem.relaxed { spacing = d, seed = p.seed, on_boundary = true, boundary_within = loaded },
  bonds = dem.bond_law(p.law) {},
}
-- Rise and fall are half a cosine each: where two such fronts meet, one place is pulled the most.
local rise, lasting = p.front * d / speed, p.pulse / speed
sim:traction { bar.left, stress_x = function(t)
  local share = math.min(t, lasting + rise - t) / rise
  return share <= 0 and 0 or pressure * (1 - math.cos(math.pi * math.min(share, 1))) / 2
end }
local duration = (p.length + p.pulse) / speed + 2 * rise -- until the pulse has left the free end
sim:history { every = duration / 200, speed_of_end = function(now) return now:mean("velocity_x", bar.right) end }
sim:output { every = duration / 20 }
sim:run { duration = duration }

-- The piece is what holds together with the free end. Loose bits between it and the rest count half.
local part, velocity = sim.now:field("fragment", bar), sim.now:field("velocity_x", bar)
local piece, rest = sim.now:mean("fragment", bar.right), sim.now:mean("fragment", bar.left)
local count, sum, loose = 0, 0, 0
for k, each in ipairs(part) do
  if each == piece then
    count, sum = count + 1, sum + velocity[k]
  elseif each ~= rest then
    loose = loose + 1
  end
end
local found = p.length * (count + loose / 2) / #part
dem.result { thickness = found, speed = sum / count, loose = loose, elements = #part }

-- 1-D: a bond under s0 lets go in t = ln(1 + 1/k) pi a_t/c, k = s0/strength - 1, and pulls with (1 + k) t - pi a_t/c meanwhile.
local k, zone = p.stress - 1, math.pi * handbook.transition_length(p.toughness, stone.tensile_strength)
local letting_go = zone * ((1 + k) * math.log(1 + 1 / k) - 1) / (p.stress * p.pulse)
dem.compare {
  what = "speed of the piece", unit = "m/s", value = sum / count, reference = flight, tolerance = letting_go + 2 * height / p.pulse,
  because = "the bonds' pull while they let go, and that of a bar which a crack crosses at c/2", source = "waves in one dimension",
}
