-- Question: which stress far away does a cracked plate bear, whatever its size, its crack and the pack it is made of?
-- Source:   linear elastic fracture mechanics (scenarios/shared/handbook.lua) for cracks and ligaments many times
--           a_t = (K_Ic/strength)^2/pi; in between a cohesive zone on the crack's line with linear softening, solved with finite
--           elements that share nothing with this code (docs/theory/references.md, section Cracks).
-- See:      cracks.pvd over elements.pvd: facets that have broken; the stress at which there is no rest any more.
-- Takes:    ten seconds; the study a few minutes.
-- Quick:    no
local dem = require "dem"
local handbook = dem.include "shared/handbook.lua" {}

local p = dem.param {
  kind    = { "edge", help = "of crack: \"edge\", \"centre\" or \"double\"" },
  width   = { 25, help = "of the plate, in a_t" },
  share   = { 0.25, help = "of the width that the crack takes, along itself; both cracks, where there are two" },
  angle   = { 0, help = "degrees by which a centre crack is slanted" },
  spacing = { 10e-3, "m", help = "of elements along the crack's line" },
  packing = { "relaxed", help = "\"relaxed\", finer along the crack's line; or rows \"along\" the crack or \"across\" it" },
  seed    = { 1, help = "of the relaxed pack" },
  law     = { "cohesive", help = "of the bonds" },
  ratio   = { 0.3, help = "Poisson's" },
}

local concrete = dem.material {
  name = "concrete", youngs_modulus = 29.7e9, poissons_ratio = p.ratio, density = 2400,
  tensile_strength = 3.44e6, fracture_toughness = 1.0e6, friction = 0.5,
}
local strength, toughness = concrete.tensile_strength, concrete.fracture_toughness
local length = (toughness / strength) ^ 2 / math.pi
local width, height = p.width * length, 3 * p.width * length
local crack = p.share * width
local d, middle = p.spacing, height / 2

-- Peak stress over strength of the cohesive zone, by kind, width in a_t and share.
local cohesive_zone = {
  edge   = { [25] = { [0.125] = 0.3757, [0.25] = 0.2264, [0.5] = 0.0846 }, [50] = { [0.125] = 0.2907, [0.25] = 0.1723, [0.5] = 0.0644 },
             [100] = { [0.125] = 0.2170, [0.25] = 0.1272, [0.5] = 0.0476 } },
  centre = { [25] = { [0.25] = 0.4471, [0.5] = 0.2852 }, [50] = { [0.25] = 0.3454, [0.5] = 0.2181 }, [100] = { [0.25] = 0.2570, [0.5] = 0.1610 } },
  double = { [25] = { [0.25] = 0.4306, [0.5] = 0.2982 }, [50] = { [0.25] = 0.3279, [0.5] = 0.2252 }, [100] = { [0.25] = 0.2421, [0.5] = 0.1649 } },
}
local function solved(q)
  local share = ((cohesive_zone[q.kind] or {})[q.width] or {})[q.share]
  return q.angle == 0 and share and share * strength
end
local shape = { edge = handbook.edge_crack, centre = handbook.centre_crack, double = handbook.double_edge_crack }
if not shape[p.kind] then error('kind: "edge", "centre" or "double"') end
if p.angle ~= 0 and p.kind ~= "centre" then error("angle: of a centre crack only") end
local brittle = handbook.critical_stress(toughness, p.kind == "edge" and crack or crack / 2, shape[p.kind](p.share))
-- Slanted: a wide plate's, by the hoop stress at the tip, and the width's factor.
local slant = math.rad(p.angle)
if p.angle ~= 0 then brittle = handbook.slanted_critical_stress(toughness, crack / 2, slant) / handbook.centre_crack(p.share) end

-- Only plates for which a cohesive zone was solved can be judged.
if solved(p) then
  dem.study {
    vary = { spacing = { 20e-3, 10e-3, 5e-3 } }, measure = "critical_stress", unit = "Pa", reference = solved,
    tolerance = 0.05, because = "asked for; the pack's own roughness makes the crack's way",
    source = "cohesive zone with linear softening, finite elements (docs/theory/references.md)",
  }
end

-- Along the crack's line elements stand d apart; away from it each next row is up to a fifth farther.
local rise = crack / 2 * math.sin(math.abs(slant))
local function size(x, y) return d + 0.2 * math.max(0, math.abs(y - middle) - rise - 8 * d) end
local pack
if p.packing == "relaxed" then
  pack = dem.relaxed { size = size, seed = p.seed }
elseif p.packing == "along" or p.packing == "across" then
  pack = dem.close_packed { radius = d / 2, rows = p.packing == "along" and "horizontal" or "vertical", fit = "inside" }
else
  error('packing: "relaxed", "along" or "across"')
end

local sim = dem.simulation { title = "Cracked plate", plane = "stress" }
local plate = sim:body {
  name = "plate", material = concrete, region = dem.rectangle { size = { width, height } },
  packing = pack, bonds = dem.bond_law(p.law) {},
}
-- A hair above the middle, so that the cut passes between rows and through no centre.
local y = middle + 1e-3 * d
local cuts = {
  edge   = { { -d, crack } },
  centre = { { (width - crack) / 2, (width + crack) / 2 } },
  double = { { -d, crack / 2 }, { width - crack / 2, width + d } },
}
for _, cut in ipairs(cuts[p.kind]) do
  local function at(x) return { width / 2 + (x - width / 2) * math.cos(slant), y + (x - width / 2) * math.sin(slant) } end
  sim:notch { plate, from = p.angle == 0 and { cut[1], y } or at(cut[1]), to = p.angle == 0 and { cut[2], y } or at(cut[2]) }
end

-- The loads balance; one place far from the crack keeps the plate from floating.
sim:fix { plate, within = dem.disc { centre = { width / 2, 0.1 * height }, radius = 0.75 * size(0, 0.1 * height) } }
local most, over = 1.2 * math.min(brittle, strength), 1
local pull = sim:traction { plate.top, stress_y = dem.ramp { to = most, over = over } }
sim:traction { plate.bottom, stress_y = dem.ramp { to = -most, over = over } }

local opened
sim:on_bond_break(function(event, now) opened = opened or pull.stress_y end)
sim:output { every = over / 4 }
sim:run { duration = over, driver = "quasi-static" }

dem.result {
  critical_stress = pull.stress_y, first_break = opened or 0, elements = sim.now.elements,
  share_of_handbook = pull.stress_y / brittle,
}
if solved(p) then dem.result { share_of_cohesive_zone = pull.stress_y / solved(p) } end
