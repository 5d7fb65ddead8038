-- Question: how fast does a crack run through a strip that is already strained, and when does it branch?
-- Source:   no crack runs faster along its plane than Rayleigh waves (L. B. Freund, Dynamic Fracture Mechanics, Cambridge 1990).
--           A long strip between held edges gives a crack sigma^2 height/(2 E) of energy per area.
-- See:      cracks.pvd coloured by time over elements.pvd; `tip` in history.csv: the foremost break that the crack has reached.
-- Takes:    seven seconds. Speeds and branches by load: docs/dynamic_crack.md.
local dem = require "dem"

local p = dem.param {
  load    = { 3, help = "energy that the strained strip has for the crack, over the fracture energy" },
  radius  = { 0.5e-3, "m", help = "of the elements" },
  packing = { "relaxed", help = "or close-packed rows \"along\" the notch, or \"across\" it: these are symmetric about it" },
  law     = { "cohesive", help = "of the bonds: any that breaks" },
  seed    = { 1, help = "of the relaxed pack" },
  damping = { 0, help = "of the bonds, fraction of critical" },
  rates   = { 0, "Pa", help = "compressive strength by which strain rates strengthen dem.plateau and dem.softening; 0: not at all" },
}

local width, height, notch = 0.1, 0.04, 0.02
local glassy = dem.material {
  name = "glassy", youngs_modulus = 32e9, poissons_ratio = 0.2, density = 2450,
  tensile_strength = 6e6, fracture_energy = 3, friction = 0.5,
}
local E, nu = glassy.youngs_modulus, glassy.poissons_ratio
local stress = math.sqrt(2 * p.load * glassy.fracture_energy * E / height)
if stress >= glassy.tensile_strength then error("load: the whole strip would break") end

-- Rayleigh's equation (2 - z^2)^2 = 4 sqrt((1 - z^2) (1 - k z^2)), z speed over that of shear waves, k square of the ratio of
-- shear to longitudinal waves in plane stress.
local shear_speed = math.sqrt(E / (2 * (1 + nu)) / glassy.density)
local k, low, high = (1 - nu) / 2, 0.5, 1
for _ = 1, 60 do
  local z2 = ((low + high) / 2) ^ 2
  local below = (2 - z2) ^ 2 < 4 * math.sqrt((1 - z2) * (1 - k * z2))
  if below then low = math.sqrt(z2) else high = math.sqrt(z2) end
end
local rayleigh_speed = low * shear_speed

local d = 2 * p.radius
local packs = {
  relaxed = dem.relaxed { spacing = d, seed = p.seed },
  along   = dem.close_packed { radius = p.radius, rows = "horizontal" },
  across  = dem.close_packed { radius = p.radius, rows = "vertical", origin = { p.radius, 0 } },
}
if not packs[p.packing] then error('packing: "relaxed", "along" or "across"') end
local law = { damping = p.damping }
if p.rates > 0 then law.rate_compressive_strength = p.rates end

local sim = dem.simulation { title = "Running crack", plane = "stress" }
local strip = sim:body {
  name = "strip", material = glassy, region = dem.rectangle { at = { 0, -height / 2 }, size = { width, height } },
  packing = packs[p.packing], bonds = dem.bond_law(p.law)(law),
}

-- Strained whole between edges that are held along y and free to slide, then cut.
local grip, strain = 1.2 * d, stress / E
local function gripped(side) return function(x, y) return side * y > height / 2 - grip end end
for _, side in ipairs { 1, -1 } do
  sim:move { strip, where = gripped(side), displacement_y = side * strain * (height - grip) / 2, spin = 0 }
  sim:fix { strip, where = function(x, y) return gripped(side)(x, y) and x > width - grip end, x = true }
end
sim:solve_static {}
-- Across the rows a slit on the mirror line: two cuts, with loose elements between them.
for _, y in ipairs(p.packing == "across" and { p.radius / 2, -p.radius / 2 } or { 0 }) do
  sim:notch { strip, from = { -d, y }, to = { notch, y } }
end

local breaks, tip, passed = {}, notch, {}
sim:on_bond_break { function(event, now)
  breaks[#breaks + 1] = { x = event.x, y = event.y }
  if event.x > tip and event.x < tip + 5 * d then -- a break farther ahead is another crack
    tip = event.x
    passed[#passed + 1] = { time = event.time, x = tip }
  end
  if tip > width - 10 * d then now:stop("the crack is through") end
end }
sim:history { every = 1e-6, tip = function() return tip end }
sim:output { every = 1e-5 }
sim:run { duration = 2e-4 }

-- Speeds along the strip: from a fifth of the way to its end, and the greatest over ten elements' widths.
local function when(x)
  for _, at in ipairs(passed) do if at.x >= x then return at.time end end
end
local reached = tip - notch
local speed, greatest = 0, 0
if reached > 30 * d then
  local from, to = notch + reached / 5, tip
  speed = (to - from) / (passed[#passed].time - when(from))
  for x = from, to - 10 * d, d do greatest = math.max(greatest, 10 * d / (when(x + 10 * d) - when(x))) end
end

-- Cracks that a line across the strip meets, where breaks three elements apart are of two: the most that three such lines,
-- two elements apart, have in common.
local function cracks_at(x)
  local ys = {}
  for _, at in ipairs(breaks) do if math.abs(at.x - x) <= d then ys[#ys + 1] = at.y end end
  table.sort(ys)
  local count = #ys > 0 and 1 or 0
  for n = 2, #ys do if ys[n] - ys[n - 1] > 3 * d then count = count + 1 end end
  return count
end
local cracks, before, last = 0, 0, 0
for x = notch, tip, 2 * d do
  local here = cracks_at(x)
  cracks, before, last = math.max(cracks, math.min(here, before, last)), last, here
end

dem.result {
  stress = stress, rayleigh_speed = rayleigh_speed, tip = tip, speed = speed, greatest_speed = greatest,
  speed_over_rayleigh = speed / rayleigh_speed, greatest_over_rayleigh = greatest / rayleigh_speed, cracks = cracks,
  broken = #breaks, elements = sim.now.elements, energy_error = sim.now.ledger.error,
}
dem.compare {
  what = "mean speed of the tip beyond that of Rayleigh waves", unit = "", value = math.max(0, speed / rayleigh_speed - 1),
  reference = 0, tolerance = 1e-12, because = "a bound from above", source = "Freund 1990",
}
