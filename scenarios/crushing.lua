-- Question: how does a bed of grains that can break give way under a platen?
-- Source:   Tavarez & Plesha 2007, section 3: clusters whose bonds follow the fracture laws. No closed form: bands and trend.
-- See:      stress against the platen's way bends over as grains break; the number of broken bonds rises with it and the
--           largest fragment stays a grain.
-- Takes:    ten seconds.
-- Quick:    no
local dem = require "dem"

local p = dem.param {
  elements  = { 7, help = "of a grain" },
  element   = { 1e-3, "m", help = "mean radius" },
  width     = { 0.1, "m" },
  height    = { 0.06, "m" },
  strength  = { 20e6, "Pa", help = "tensile, of the grains" },
  toughness = { 0.4e6, "Pa m^0.5" },
  squeeze   = { 0.08, help = "way of the platen over the height" },
  speed     = { 1.0, "m/s" },
  seed      = { 1 },
}

local quartz = dem.material {
  name = "quartz", youngs_modulus = 5e9, poissons_ratio = 0.2, density = 2650, friction = 0.5, restitution = 0.3,
  tensile_strength = p.strength, fracture_toughness = p.toughness,
}
local sim = dem.simulation { title = "Crushing", plane = "stress" }

local inside = dem.rectangle { size = { p.width, p.height } }
local bed = sim:grains {
  name = "bed", material = quartz, region = inside, seed = p.seed, porosity = 0.25,
  shape  = dem.cluster { elements = p.elements, bonds = dem.plateau { damping = 0.05, break_in_shear = true } },
  radius = { 0.9 * p.element, 1.1 * p.element },
}
local box = sim:wall { name = "box", path = { { 0, 2 * p.height }, { 0, 0 }, { p.width, 0 }, { p.width, 2 * p.height } }, friction = 0.2 }
local platen = sim:wall {
  name = "platen", path = { { 0, p.height }, { p.width, p.height } }, friction = 0.2,
  velocity = { 0, dem.ramp { to = -p.speed, over = 1e-3 } },
}

local function stress() return platen.force.y / p.width end
local crushing -- the stress at which a twentieth of the bonds is broken
sim:every { 2e-5, function(now)
  if not crushing and now.broken_bonds > now.bonds / 20 then crushing = stress() end
end }
sim:history { every = 5e-5, stress = stress, way = function() return p.height - platen.position.y end }
sim:output { every = 5e-4 }
sim:run { duration = p.squeeze * p.height / p.speed }

local size = {}
for _, part in ipairs(bed:field("fragment")) do size[part] = (size[part] or 0) + 1 end
local largest = 0
for _, elements in pairs(size) do largest = math.max(largest, elements) end
local ledger = sim.now.ledger
dem.compare {
  what = "largest fragment", value = largest, reference = p.elements, tolerance = 0.5,
  because = "nothing mends: no fragment is larger than a grain, and a few grains outlive the squeeze nearly whole",
  source = "what fragments are",
}
dem.compare {
  what = "energy unaccounted over work", value = ledger.error / ledger.work, reference = 0, tolerance = 1e-3,
  because = "yielding and breaking within a step", source = "conservation of energy",
}
dem.result {
  crushing_stress = crushing, final_stress = stress(), broken_bonds = sim.now.broken_bonds, bonds = sim.now.bonds,
  fragments = sim.now.fragments,
}
