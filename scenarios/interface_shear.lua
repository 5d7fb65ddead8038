-- Question: how much shear does a bed of grains carry over a rough wall, how far do its grains turn, and what wears off?
-- Source:   Tavarez & Plesha 2007, section 3, after Jensen et al. (2001): clusters rotate less than single disks and carry
--           more shear; elements leave their clusters when sliding has spent W0 per volume on them (eqs 1 and 2).
-- See:      the history's `ratio`, shear over normal stress on the wall, rising to a plateau; the results say which.
-- Takes:    half a minute; `tools/shear_table` runs it over seeds, grains and W0 and writes docs/interface_shear.md.
-- Quick:    no
local dem = require "dem"

local p = dem.param {
  elements      = { 3, help = "of a grain: 1 for single disks, else rigid clusters" },
  wear          = { 0, "J/m^3", help = "critical energy density W0; 0 for none" },
  normal_stress = { 100e3, "Pa" },
  friction      = { 0.5 },
  grain         = { 1.5e-3, "m", help = "radius of a disk of the area of a grain" },
  width         = { 0.09, "m" },
  height        = { 0.036, "m" },
  slip          = { 0.03, "m", help = "of the rough wall" },
  speed         = { 0.4, "m/s", help = "of the rough wall" },
  seed          = { 1 },
}

local sand = dem.material {
  name = "sand", youngs_modulus = 5e7, poissons_ratio = 0.2, density = 2650, friction = p.friction, restitution = 0.4,
  wear_energy_density = p.wear > 0 and p.wear or nil,
}
local sim = dem.simulation { title = "Interface shear", plane = "strain", periodic_x = { 0, p.width } }

local teeth = math.floor(p.width / (2 * p.grain) + 0.5)
local rough = sim:wall {
  name = "rough", friction = p.friction,
  path = dem.sawtooth { from = { 0, 0 }, to = { p.width, 0 }, height = p.grain, pitch = p.width / teeth },
}
local above = p.height + 2 * p.grain
local lid = sim:wall { -- its teeth, larger than those of the rough wall, hold the bed
  name  = "lid", friction = p.friction,
  path  = dem.sawtooth { from = { p.width, above }, to = { 0, above }, height = 2 * p.grain, pitch = 2 * p.width / teeth },
  servo = { stress_y = p.normal_stress },
}

local element = p.grain / math.sqrt(p.elements)
local bed = sim:grains {
  name = "bed", material = sand, seed = p.seed,
  region   = dem.rectangle { at = { 0, p.grain }, size = { p.width, p.height - 1.01 * p.grain } },
  shape    = p.elements > 1 and dem.cluster { elements = p.elements, rigid = true } or nil,
  radius   = { 0.8 * element, 1.2 * element },
  porosity = 0.22,
}

sim:damping { fraction = 0.2, frequency = 200 } -- while the bed settles under the lid
local settled = sim:run { duration = 0.3, until_rest = true }
sim:damping { fraction = 0, frequency = 200 }

local begin = bed:field("rotation")
local function turned()
  local sum, now = 0, bed:field("rotation")
  for k = 1, #now do sum = sum + math.abs(now[k] - begin[k]) end
  return sum / #now
end
local ratios, stresses, count = 0, 0, 0
local function ratio() return rough.force.x / rough.force.y end
sim:every { 1e-4, function(now)
  if now.time > 0 and rough.position.x > p.slip / 2 then
    ratios, stresses, count = ratios + ratio(), stresses + lid.stress.y, count + 1
  end
end }
rough:move { velocity = { dem.ramp { to = p.speed, over = 5e-3, start = sim.now.time }, 0 } }
sim:history { every = 5e-4, ratio = ratio, turned = turned, lid = function() return lid.stress.y end }
sim:output { every = 5e-3 }
sim:run { duration = p.slip / p.speed }

local ledger = sim.now.ledger
dem.compare {
  what = "mean stress under the lid", unit = "Pa", value = stresses / count, reference = p.normal_stress, tolerance = 0.02,
  because = "grains that rearrange push the lid faster than it answers, now and then", source = "what the servo was asked for",
}
dem.compare {
  what = "energy unaccounted over work", value = ledger.error / ledger.work, reference = 0, tolerance = 1e-3,
  because = "contacts that begin and end within a step", source = "conservation of energy",
}
dem.result {
  settled = settled.reason, ratio = ratios / count, turned = turned(), worn = sim.now.worn, thickness = lid.position.y,
  elements = sim.now.elements,
}
