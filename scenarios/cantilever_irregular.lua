-- Question: does an irregular pack of few elements swing as far as the slab it fills?
-- Source:   as cantilever.lua, whose set-up this is; figs 8 and 9 of the paper, which ended 6.5 % stiffer than finite elements.
-- See:      `demlua study`: amplitudes of 600, 1200 and 2400 elements, all close to that of finite elements.
-- Takes:    half a minute; the study about two minutes on two cores.
-- Quick:    no
local dem = require "dem"

dem.study {
  vary = { count = { 600, 1200, 2400 } }, measure = "amplitude", unit = "m",
  size = function(q) return math.sqrt(1.08 * 0.06 * math.sqrt(3) / q.count) end,
  tolerance = 5e-3, because = "half a per cent asked of an irregular pack",
  source = "finite elements of the slab, driven",
}
dem.include "cantilever.lua" { load = "dynamic", packing = "irregular" }
