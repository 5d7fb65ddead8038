-- Question: how does a bed of grains that can break give way under a platen?
-- Source:   Tavarez & Plesha 2007, section 3: clusters whose bonds follow the fracture laws. No closed form: bands and trend.
-- See:      stress against the platen's way bends over as grains break; the number of broken bonds rises with it and the
--           largest fragment stays a grain.
-- Takes:    about a minute.
local dem = require "dem"

local p = dem.param {
  elements  = { 7, help = "of a grain" },
  element   = { 1e-3, "m", help = "mean radius" },
  width     = { 0.1, "m" },
  height    = { 0.06, "m" },
  strength  = { 4e6, "Pa", help = "tensile, of the grains" },
  toughness = { 0.15e6, "Pa m^0.5" },
  squeeze   = { 0.15, help = "way of the platen over the height" },
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
local peak = 0
sim:every { 2e-5, function() peak = math.max(peak, stress()) end }
sim:history { every = 1e-4, stress = stress, way = function() return p.height - platen.position.y end }
sim:output { every = 5e-3 }
sim:run { duration = p.squeeze * p.height / p.speed }
local largest = {}
for _, part in ipairs(bed:field("fragment")) do largest[part] = (largest[part] or 0) + 1 end
local most = 0
for _, size in pairs(largest) do most = math.max(most, size) end
dem.result { peak_stress = peak, broken_bonds = sim.now.broken_bonds, bonds = sim.now.bonds, largest_fragment = most }
