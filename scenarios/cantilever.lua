-- Question: how far does a cantilever bend, and how does that depend on the elements' size?
-- Source:   F. A. Tavarez, M. E. Plesha, Int. J. Numer. Meth. Engng 70 (2007) 379-404, section 7, figs 6 to 9, table II. The
--           paper gives neither size nor density nor load; those below are this project's own (docs/cantilever.md).
--           References are finite elements (docs/theory/references.md): compliance 4514.39 / (E t).
-- See:      `demlua study` on this file: compliances for both supports, against the slab and against a slab as stiff as the
--           rows; with --set packing=irregular those of irregular packs. cantilever_dynamic.lua drives it.
-- Takes:    a second; the study a few, of irregular packs a quarter of a minute.
local dem = require "dem"

local p = dem.param {
  load    = { "static", help = "\"static\", or \"dynamic\": F0 sin(w t) at a fifth of the slab's first frequency" },
  packing = { "close-packed", help = "or \"irregular\"" },
  rows    = { 9, help = "close-packed: of 9 times as many elements each; 3, 9 and 27 are the paper's" },
  wall    = { true, help = "close-packed: one column more is held, else the first of the columns" },
  height  = { "equal bending", help = "of the slab compared with: \"rows\", as they fill it, or as stiff in bending as they are" },
  count   = { 1200, help = "irregular: elements; 600, 1200 and 2400 are the paper's" },
  seed    = { 1, help = "irregular: of the pack" },
  periods = { 1, help = "dynamic: whole ones of the load, over which the amplitude is read after one in which it sets in" },
  solver  = { "direct", help = "static: \"direct\", or \"marching\" to rest under critical damping by mass from a sudden load on" },
  settle  = { 2, help = "marching: for so many periods of the slab's first frequency" },
  step_fraction = { 0.8, help = "share of the critical time step" },
  precision = { "double", help = "or \"mixed\": bonds kept in single precision" },
}
local close_packed = p.packing == "close-packed"
if not close_packed and p.packing ~= "irregular" then error('packing: "close-packed" or "irregular"') end
if p.load ~= "static" and p.load ~= "dynamic" then error('load: "static" or "dynamic"') end
if p.solver ~= "direct" and p.solver ~= "marching" then error('solver: "direct" or "marching"') end
if p.rows < 2 or p.rows % 1 ~= 0 then error("rows: a whole number from 2") end
if p.height ~= "rows" and p.height ~= "equal bending" then error('height: "rows" or "equal bending"') end

local E, nu, density, thickness, F0 = 1.2e9, 0.3, 1200, 1, 100 -- Pa, -, kg/m^3, m, N
local R0 = 20e-3                                               -- radius in three rows, m
local length, depth = 54 * R0, 3 * math.sqrt(3) * R0

-- ---- what it is compared with: finite elements of the slab ----
local slab_compliance, slab_frequency, slab_growth = 4514.39, 89.8727, 1.040388 -- times 1/(E t), rad/s, at w over at rest

-- Bending and shear of Timoshenko's beam, times E t.
local function beam_compliance(h) return 4 * (length / h) ^ 3 + 2.4 * (1 + nu) * length / h end

-- The depth of a slab with the bending stiffness of n rows: each row by its own, and bonds between rows.
local function depth_of_rows(n)
  local k1, k2, s = 2 / (3 - 3 * nu), (1 - 3 * nu) / (3 - 3 * nu), depth / n
  return s * (k1 * n * (n ^ 2 - 1) + k2 * (n - 1) * ((n - 1) ^ 2 - 1)) ^ (1 / 3)
end

local function softer(q) -- than the slab of finite elements
  if q.packing ~= "close-packed" or q.height == "rows" then return 1 end
  return beam_compliance(depth_of_rows(q.rows)) / beam_compliance(depth)
end

-- One mode at w, which the softer slab has closer to its own frequency.
local function growth(q) return 1 / (1 - (1 - 1 / slab_growth) * softer(q)) end

-- What is known to be off, as a share: rows missing at the faces, and the length lost to the held column.
local function allowed(q)
  if q.packing ~= "close-packed" then return 5e-3 end
  local rows = q.height == "rows" and (depth / depth_of_rows(q.rows)) ^ 3 - 1 or 0
  local held = q.wall and 0 or 1 - (1 - 1 / (9 * q.rows)) ^ 3
  return 1e-3 + 1.2 * math.max(rows, held)
end

if p.load == "static" then
  local all = { measure = "compliance", tolerance = allowed, source = "finite elements, E t times deflection over load",
                reference = function(q) return slab_compliance * softer(q) end }
  if close_packed then
    all.vary = { rows = { 3, 9, 27 }, wall = { false, true }, height = { "rows", "equal bending" } }
    all.size = function(q) return 3 * R0 / q.rows end
    all.because = "0.1 % asked at 9 rows; more by the bending stiffness the rows lack or the length lost to the held column"
  else
    all.vary, all.seeds = { count = { 600, 1200, 2400 } }, 10
    all.size = function(q) return math.sqrt(length * depth / q.count) end
    all.because = "half a per cent asked of an irregular pack"
  end
  dem.study(all)
end

-- ---- the experiment ----
local sim = dem.simulation { title = "Cantilever", plane = "stress", thickness = thickness, step_fraction = p.step_fraction,
                             precision = p.precision }
local polymer = dem.material { name = "polymer", youngs_modulus = E, poissons_ratio = nu, density = density }
local region, packing, held_to, loaded_from
if close_packed then
  local R, columns, first = 3 * R0 / p.rows, 9 * p.rows, p.wall and -1 or 0
  region = dem.rectangle { at = { (2 * first - 1) * R, -R },
                           size = { (2 * (columns - first) + 1.001) * R, (2.001 + (p.rows - 1) * math.sqrt(3)) * R } }
  packing = dem.close_packed { radius = R }
  held_to, loaded_from = (2 * first + 1.5) * R, (2 * columns - 2.5) * R
else
  local thin = 1e-3 * depth
  local end_face = dem.rectangle { at = { -thin, -thin }, size = { 2 * thin, depth + 2 * thin } }
  region = dem.rectangle { size = { length, depth } }
  packing = dem.relaxed { count = p.count, seed = p.seed, on_boundary = true,
                          boundary_within = end_face + end_face:translated { length, 0 } }
  held_to, loaded_from = thin, length - thin
end
local beam = sim:body { name = "beam", material = polymer, region = region, packing = packing, bonds = dem.elastic {} }
local tip = { beam, where = function(x) return x > loaded_from end }
sim:fix { beam, where = function(x) return x < held_to end }

if p.load == "static" then
  sim:force { tip, y = F0 }
  if p.solver == "direct" then
    sim:solve_static { linear = true }
  else
    sim:damping { fraction = 1, frequency = slab_frequency / (2 * math.pi) }
    sim:run { duration = p.settle * 2 * math.pi / slab_frequency }
  end
  local deflection = sim.now:mean("displacement_y", tip)
  local compliance = deflection * E * thickness / F0
  local published = { [3] = { 4795.56, 5364.13 }, [9] = { 4471.19, 4640.19 }, [27] = { 4486.13, 4541.75 } }
  if p.solver == "direct" and close_packed and published[p.rows] then
    dem.compare { what = "compliance", value = compliance, reference = published[p.rows][p.wall and 2 or 1],
                  tolerance = 1.2e-6, because = "known to two decimals", source = "the same network solved elsewhere" }
  end
  dem.result { compliance = compliance, deflection = deflection, reference = slab_compliance * softer(p) }
  return
end

local w = 0.2 * slab_frequency
local period = 2 * math.pi / w
sim:damping { fraction = 0.1, frequency = 1 / period }
sim:force { tip, y = function(t)
  local set_in = t < period and (1 - math.cos(math.pi * t / period)) / 2 or 1
  return F0 * set_in * math.sin(w * t)
end }
sim:history { every = period / 100, tip = function(now) return now:mean("displacement_y", tip) end }
sim:output { every = period / 4 }
sim:run { duration = period }

-- The Fourier coefficient at w over whole periods, by trapezoids between the instants read; it hardly sees the beam ring.
local real, imaginary, last = 0, 0, nil
local function read(now)
  local u = now:mean("displacement_y", tip)
  local here = { time = now.time, cosine = u * math.cos(w * now.time), sine = u * math.sin(w * now.time) }
  if last then
    real = real + (here.time - last.time) * (here.cosine + last.cosine) / 2
    imaginary = imaginary + (here.time - last.time) * (here.sine + last.sine) / 2
  end
  last = here
end
read(sim.now)
sim:every { period / 400, read }
sim:run { duration = p.periods * period }

local over = last.time - period
local amplitude = 2 * math.sqrt(real ^ 2 + imaginary ^ 2) / over
local expected = slab_compliance * F0 / (E * thickness) * softer(p) * growth(p)
dem.result { amplitude = amplitude, reference = expected, phase = math.atan(-real, imaginary), read_over = over / period }
