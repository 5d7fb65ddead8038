-- Question: how does a steel projectile slow down in a concrete beam, and how does the beam break?
-- Source:   F. A. Tavarez, M. E. Plesha, Int. J. Numer. Meth. Engng 70 (2007) 379-404, section 9, fig. 17. The paper gives
--           neither speed nor sizes nor materials; those below are this project's own.
-- See:      the nose drives a wedge through the beam, cracks run to the faces, and two halves part with rubble between.
--           Elements by speed, bonds by state, in elements.pvd and bonds.pvd; speed and nose depth in history.csv.
-- Takes:    about half a minute on two cores.
local dem = require "dem"

local p = dem.param {
  impact_speed     = { 80, "m/s", help = "straight down, at mid-span" },
  duration         = { 6e-3, "s" },
  elements         = { 12000, help = "of the beam" },
  cluster          = { 3, help = "elements in a cluster of the beam's pack" },
  seed             = { 1, help = "of the beam's pack" },
  rate_factor      = { 3, help = "constant strain-rate factor on the concrete's strength and fracture energy" },
  break_in_shear   = { true, help = "bonds also break when plastic slip has spent the fracture energy; false: the printed law" },
  projectile       = { "13 elements wide", help = "or \"as wide\" in metres as 13 elements are in a beam of 12,000" },
  rigid_projectile = { false, help = "the projectile moves as one piece" },
  supports_on      = { true, help = "hold the lower corners of the beam" },

  beam_length      = { 1.5, "m" },
  beam_depth       = { 0.25, "m" },
  support_width    = { 0.05, "m" },

  concrete_modulus   = { 30e9, "Pa" },
  concrete_ratio     = { 0.2 },
  concrete_density   = { 2400, "kg/m^3" },
  concrete_strength  = { 3.44e6, "Pa" },
  concrete_toughness = { 1.0e6, "Pa m^0.5" },
  steel_modulus      = { 200e9, "Pa" },
  steel_ratio        = { 0.3 },
  steel_density      = { 7850, "kg/m^3" },
  friction           = { 0.5 },
  contact_damping    = { 0.2, help = "fraction of critical" },
  bond_damping       = { 0.02, help = "fraction of critical" },
  stiffness          = { "contacts", help = "of the beam: \"contacts\" as the paper bonds it, too soft; \"facets\" exact" },
  search             = { 0.1, help = "share of the radius across which elements are bonded" },

  step_fraction      = { 0.9, help = "share of the critical time step" },
  precision          = { "double", help = "or \"mixed\": bonds kept in single precision" },
  history_every      = { 1e-5, "s" },
  frame_every        = { 1e-3 / 6, "s" },
}

if p.projectile ~= "13 elements wide" and p.projectile ~= "as wide" then error('projectile: "13 elements wide" or "as wide"') end

local concrete = dem.material {
  name = "concrete",
  youngs_modulus = p.concrete_modulus, poissons_ratio = p.concrete_ratio, density = p.concrete_density,
  tensile_strength = p.concrete_strength, fracture_toughness = p.concrete_toughness, rate_factor = p.rate_factor,
  friction = p.friction, contact_damping = p.contact_damping,
}

local sim = dem.simulation { title = "Penetration", plane = "stress", thickness = 1, step_fraction = p.step_fraction,
                             precision = p.precision }

local length, depth = p.beam_length, p.beam_depth
local beam = sim:body {
  name = "beam", material = concrete,
  region  = dem.rectangle { size = { length, depth } },
  packing = dem.consolidated { cluster = p.cluster, count = p.elements, seed = p.seed },
  bonds   = dem.plateau { stiffness = p.stiffness, search = p.search, damping = p.bond_damping, break_in_shear = p.break_in_shear },
}

-- The projectile: a wedge of rows of 1 to 12 elements, then 21 rows of 13, all of the beam's radius: 351. As wide in metres in
-- any beam, it has as many elements across as come closest, is as much longer or shorter as whole rows allow, and its
-- density makes up for what is left. Its outline is drawn in radii around the centre of the lowest element, half a radius
-- outside the outermost centres.
local R, row = beam.radius, math.sqrt(3)
local across, straight, heavier = 13, 21, 1
if p.projectile == "as wide" then
  local finer = p.elements / 12000
  local function elements() return across * (across - 1) / 2 + straight * across end
  local wanted = elements() * finer
  across = math.floor(across * math.sqrt(finer) + 0.5)
  straight = math.floor((wanted - across * (across - 1) / 2) / across + 0.5)
  heavier = wanted / elements()
end
local rows = across - 1 + straight
local outline = {
  { -0.5, -0.5 }, { 0.5, -0.5 },
  { across + 0.5, across * row - 0.5 }, { across + 0.5, (rows - 0.5) * row },
  { 0.5 - across, (rows - 0.5) * row }, { 0.5 - across, (across - 1) * row },
}
local steel = dem.material {
  name = "steel",
  youngs_modulus = p.steel_modulus, poissons_ratio = p.steel_ratio, density = heavier * p.steel_density,
  friction = p.friction, contact_damping = p.contact_damping,
}

local tip = { length / 2, depth + R } -- the lowest element just touches the beam
for _, corner in ipairs(outline) do
  corner[1], corner[2] = tip[1] + R * corner[1], tip[2] + R * corner[2]
end
local shot = sim:body {
  name = "projectile", material = steel,
  region   = dem.polygon(outline),
  packing  = dem.close_packed { radius = R, fit = "centres", origin = tip },
  bonds    = dem.elastic { search = p.search, damping = p.bond_damping },
  rigid    = p.rigid_projectile,
  velocity = { 0, -p.impact_speed },
}

if p.supports_on then
  for _, x in ipairs { 0, length - p.support_width } do
    sim:fix { beam, within = dem.rectangle { at = { x, 0 }, size = { p.support_width, 2 * R } } }
  end
end

sim:history {
  every = p.history_every,
  projectile_speed = function(now) return -now.body.projectile.velocity.y end,
  nose_depth       = function(now) return depth - now.body.projectile.lowest end,
}
sim:output { every = p.frame_every }
sim:run { duration = p.duration }

dem.result {
  projectile_speed = -shot.velocity.y,
  nose_depth       = depth - shot.lowest,
  broken_share     = sim.now.broken_bonds / math.max(1, sim.now.bonds),
}
