-- Question: does a bond pulled to its end carry the force, reach the stretch and spend the energy its law promises?
-- Source:   Tavarez & Plesha 2007, eqs. 31-36: the cap f = R t s (sqrt 3 - nu / sqrt 3) / (2 (1 - nu)), the greatest stretch
--           G 2 R t / f + f / (2 Kn), and the area G 2 R t under the curve, G = K_Ic^2 / E.
-- See:      work over stretch in history.csv: a curve, then a straight line whose slope is the plateau.
-- Takes:    less than a second.
local dem = require "dem"

local radius, speed = 5e-3, 1e-3
local concrete = dem.material {
  name = "concrete", youngs_modulus = 29.7e9, poissons_ratio = 0.3, density = 2400,
  tensile_strength = 3.44e6, fracture_toughness = 1e6,
}
local nu, strength = concrete.poissons_ratio, concrete.tensile_strength
local fracture_energy = concrete.fracture_toughness ^ 2 / concrete.youngs_modulus
local stiffness = concrete.youngs_modulus / (math.sqrt(3) * (1 - nu))
local cap = radius * strength / (2 * (1 - nu)) * (math.sqrt(3) - nu / math.sqrt(3))
local greatest_stretch = 2 * radius * fracture_energy / cap + cap / (2 * stiffness)

local sim = dem.simulation { title = "One bond pulled apart", plane = "stress" }
local pair = sim:body {
  name = "pair", material = concrete,
  packing = dem.disks { { 0, 0, radius }, { 2 * radius, 0, radius } },
  bonds   = dem.plateau {},
}
local pulled = { pair, within = dem.half_plane { point = { radius, 0 }, outward = { -1, 0 } } }
sim:fix { pair, within = dem.disc { radius = radius / 2 } }
sim:move { pulled, velocity_x = speed, velocity_y = 0, spin = 0 }

-- The force is the work done over the way it was done on.
local force, stretch, work, step = 0, 0, 0, nil
sim:every { greatest_stretch / speed / 100, function(now)
  local here, done = now:mean("displacement_x", pulled), now.ledger.work
  if here > stretch then force = math.max(force, (done - work) / (here - stretch)) end
  stretch, work = here, done
end }
local broken_at
sim:every { 1e-9, function(now)
  step = now.time_step
  if now.broken_bonds == 0 then broken_at = now:mean("displacement_x", pulled) else now:stop("the bond is broken") end
end }
sim:history { every = 1e-4, stretch = function(now) return now:mean("displacement_x", pulled) end, work = function(now) return now.ledger.work end }
sim:run { duration = 1.2 * greatest_stretch / speed }

local ledger = sim.now.ledger
local source = "Tavarez & Plesha 2007, eqs. 31-36"
dem.compare { what = "plateau force", unit = "N", value = force, reference = cap, tolerance = 1e-9, because = "round-off of the energies it is the slope of", source = source }
dem.compare {
  what = "stretch at breaking", unit = "m", value = broken_at, reference = greatest_stretch,
  tolerance = 2 * speed * step / greatest_stretch, because = "seen within two steps", source = source,
}
dem.compare {
  what = "energy spent", unit = "J", value = ledger.plastic + ledger.fracture, reference = 2 * radius * fracture_energy,
  tolerance = 2 * speed * step / greatest_stretch, because = "seen within two steps", source = source,
}
