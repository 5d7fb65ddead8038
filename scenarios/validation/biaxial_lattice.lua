-- Question: how much more can a close-packed bed of loose disks bear than what holds its sides?
-- Source:   rows horizontal: each disk is carried by two at 60 degrees, whose forces lean by the angle of friction when they
--           slide: s1/s3 = sqrt(3) tan(60 deg + phi), tan(phi) = mu (Rowe 1962).
-- See:      s1/s3 over strain in history.csv: it rises until the disks of a row let go of each other, then falls.
-- Takes:    a second; the study twenty seconds.
--
-- Why so: smooth platens press slowly, so that inertia adds little; the sides are pulled in by a force on the disks that stand
-- out, every second row, which is where a uniform stress in a lattice comes to its edge: the first and last row must be inner
-- ones. s1 and s3 are then exact at any size. Disks are hard against s3, so that angles are still 60 degrees at the peak.
-- Dashpots in the contacts keep the bed from ringing; a drag on the disks would carry part of the load.
local dem = require "dem"

local p = dem.param {
  friction  = { 0.25 },
  share     = { 1 / 8, help = "a disk's of a longer row, which has an even number of them; there are three rows more" },
  softness  = { 1e-4, help = "share of a radius by which s3 would squeeze a contact" },
  crossings = { 200, help = "how often a wave could cross the bed while it is pressed" },
  strain    = { 8, help = "how far it is pressed, over softness" },
}
local columns = math.floor(1 / p.share + 0.5)
local layers = columns + 3
local radius, youngs_modulus, nu, density = 0.01, 1e8, 0.2, 2000
local mass, stiffness = density * math.pi * radius ^ 2, youngs_modulus / (math.sqrt(3) * (1 - nu))
local row = math.sqrt(3) * radius

dem.study {
  vary = { friction = { 0, 0.1, 0.25 }, share = { 1 / 8, 1 / 12, 1 / 18 } }, size = "share",
  measure = "peak", reference = function(q) return math.sqrt(3) * math.tan(math.pi / 3 + math.atan(q.friction)) end,
  tolerance = 0.02, because = "2 % asked for; a bed pressed more slowly and against harder disks comes closer",
  source = "Rowe 1962",
}

local sim = dem.simulation { title = "Close-packed bed, pressed", plane = "stress" }
local steel = dem.material {
  name = "disks", youngs_modulus = youngs_modulus, poissons_ratio = nu, density = density, friction = p.friction, restitution = 0.1,
}
local list = {}
for layer = 1, layers do
  local short = layer % 2 -- rows 1, 3 .. have a disk less
  for k = 1, columns - short do list[#list + 1] = { (2 * k + short) * radius, (layer - 1) * row + radius, radius } end
end
local bed = sim:body { name = "bed", material = steel, packing = dem.disks(list) }

local height, width = (layers - 1) * row + 2 * radius, 2 * (columns + 1) * radius
local bottom = sim:wall { name = "bottom", path = { { -width, 0 }, { 2 * width, 0 } }, friction = 0 }
local top = sim:wall { name = "top", path = { { -width, height }, { 2 * width, height } }, friction = 0 }

local s3 = p.softness * stiffness / row * radius
local crossing = height / (radius * math.sqrt(stiffness / mass))
local held = 2 * row * s3 * (layers - 1) / 2 -- the rows that stand out take it
local settling = 10 * crossing
sim:force { bed.left, x = dem.ramp { to = held, over = settling } }
sim:force { bed.right, x = dem.ramp { to = -held, over = settling } }
sim:run { duration = 2 * settling }

local function ratio(now)
  local s1 = (now.wall.top.force.y - now.wall.bottom.force.y) / 2 / ((columns - 1) * 2 * radius)
  return s1 / s3
end
local begin, duration = sim.now.time, p.crossings * crossing
local speed = p.strain * p.softness * height / duration
local function inwards(way) return dem.ramp { to = way * speed / 2, start = begin, over = 0.1 * duration } end
bottom:move { velocity_y = inwards(1) }
top:move { velocity_y = inwards(-1) }

-- Over two crossings of a wave, which lets the bed's ringing cancel; past the peak it falls apart, and the run may end.
local recent, peak = {}, 0
local function smooth(now)
  table.insert(recent, ratio(now))
  if #recent > 40 then table.remove(recent, 1) end
  local sum = 0
  for _, each in ipairs(recent) do sum = sum + each end
  return sum / #recent
end
sim:every { crossing / 20, function(now)
  local here = smooth(now)
  peak = math.max(peak, here)
  if now.time > begin + 0.1 * duration and here < 0.985 * peak then now:stop("past the peak") end
end }
sim:history { every = duration / 300, ratio = ratio }
sim:run { duration = duration }

dem.result { peak = peak, contacts = sim.now.contacts }
