-- Question: how fast does a crack run through a strip that is already strained, and when does it branch?
-- Source:   no crack runs faster along its plane than Rayleigh waves (L. B. Freund, Dynamic Fracture Mechanics, Cambridge 1990,
--           section 7.4). A long strip between held edges gives a crack sigma^2 (1 - nu^2) height/(2 E) of energy per area.
-- See:      cracks.pvd coloured by time over elements.pvd; `tip` in history.csv: the foremost break from the notch on.
-- Takes:    some seconds; the study a few minutes (docs/dynamic_crack.md).
-- Quick:    --set radius=0.8e-3
local dem = require "dem"

local p = dem.param {
  load    = { 2, help = "energy that the strained strip has for the crack, over the fracture energy" },
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
local stress = math.sqrt(2 * p.load * glassy.fracture_energy * E / (1 - nu ^ 2) / height)
if stress >= glassy.tensile_strength then error("load: the whole strip would break") end
local shear_speed = math.sqrt(E / (2 * (1 + nu)) / glassy.density)
local rayleigh_speed = shear_speed * (0.862 + 1.14 * nu) / (1 + nu) -- Freund, eq. 2.4 of its kind: within 0.5 %

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

-- Strained whole between held edges, then cut.
local strain = stress * (1 - nu ^ 2) / E
local apart = strain * (height - d)
sim:move { strip.top, displacement = { 0, apart / 2 }, spin = 0 }
sim:move { strip.bottom, displacement = { 0, -apart / 2 }, spin = 0 }
sim:solve_static {}
sim:notch { strip, from = { -d, 0 }, to = { notch, 0 } }

local breaks, tip, passed = {}, notch, {}
sim:on_bond_break { function(event, now)
  breaks[#breaks + 1] = { x = event.x, y = event.y }
  if event.x > tip then
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
