-- Question: at which stress does a strip pulled at its end break, and how stiff is it before?
-- Source:   Tavarez & Plesha 2007, eqs 13-16 (stiffness) and 32-36 (strength and fracture energy of the bonds).
-- See:      stress over strain in history.csv: a straight line with the slope of Young's modulus, then a crack across the
--           strip near the tensile strength.
-- Takes:    a few seconds.
local dem = require "dem"

local p = dem.param {
  radius = { 5e-3, "m" },
  width  = { 0.1, "m" },
  height = { 0.2, "m" },
  speed  = { 0.05, "m/s", help = "of the upper end, after a smooth start" },
}

local concrete = dem.material {
  name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400,
  tensile_strength = 3.44e6, fracture_toughness = 1.0e6, friction = 0.5, contact_damping = 0.2,
}
local sim = dem.simulation { title = "Tension test", plane = "stress" }

local strip = sim:body {
  name = "strip", material = concrete,
  region  = dem.rectangle { size = { p.width, p.height } },
  packing = dem.close_packed { radius = p.radius, fit = "inside" },
  bonds   = dem.plateau { search = 0.1, damping = 0.05 },
}
local start = 1e-3
sim:fix  { strip.bottom, y = true, rotation = true }
sim:move { strip.top, velocity_y = dem.ramp { to = p.speed, over = start }, spin = 0 }

-- The middle half of the strip, away from its ends.
local middle = { strip, within = dem.rectangle { at = { 0, p.height / 4 }, size = { p.width, p.height / 2 } } }
local gauge = p.height - 2 * p.radius -- between the end rows; the top row may stand a little lower
local function strain(now)
  return (now:mean("displacement_y", strip.top) - now:mean("displacement_y", strip.bottom)) / gauge
end

local early, strength = nil, 0
sim:every { 2e-5, function(now)
  local stress, stretch = now:mean("stress_yy", middle), strain(now)
  if not early and stress > 0.4 * concrete.tensile_strength then early = stress / stretch end
  strength = math.max(strength, stress)
  if strength > 1e6 and stress < strength / 4 then now:stop("the strip is broken") end
end }
sim:history { every = 2e-5, stress = function(now) return now:mean("stress_yy", middle) end, strain = strain }
sim:output { every = 2e-4 }
sim:run { duration = 20e-3 }

dem.compare {
  what = "modulus", unit = "Pa", value = early or 0, reference = concrete.youngs_modulus, tolerance = 0.05,
  because = "the lattice carries the load on fewer rows than its outline is wide: one radius in ten",
  source  = "Tavarez & Plesha 2007, eqs. 13-16",
}
dem.compare {
  what = "strength", unit = "Pa", value = strength, reference = concrete.tensile_strength, tolerance = 0.1,
  because = "as the modulus, and the crack starts where the free edge turns elements",
  source  = "Tavarez & Plesha 2007, eqs. 32-36",
}
dem.result {
  modulus = early or 0, modulus_reference = concrete.youngs_modulus,
  strength = strength, strength_reference = concrete.tensile_strength,
}
