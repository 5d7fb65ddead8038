-- Question: how far does the cantilever swing under a slow sinusoidal load, and what do finer rows change?
-- Source:   as cantilever.lua, whose set-up this is; figs 6 and 7 of the paper. The amplitude is that of finite elements.
-- See:      `demlua study`: an amplitude within half a per cent of finite elements with 27 rows. --set height=rows compares
--           with the slab the rows fill, --set wall=false holds the first column in place of one more.
-- Takes:    seconds; the study two to three minutes on two cores, nearly all of it with 27 rows.
-- Quick:    no
local dem = require "dem"

dem.study {
  vary = { rows = { 3, 9, 27 } }, measure = "amplitude", unit = "m",
  size = function(q) return 0.06 / q.rows end,
  tolerance = function(q)
    local clamp = q.wall and 0 or 1 - (1 - 1 / (9 * q.rows)) ^ 3 -- length lost
    local faces = q.height == "rows" and 1 / (7 * q.rows) + 0.86 / q.rows ^ 2 or 0 -- bending stiffness lost there
    return 5e-3 + clamp + faces
  end,
  because = "half a per cent asked at 27 rows; more by the length lost to the held column or the bending stiffness the rows lack",
  source = "finite elements of the slab, driven",
}
dem.include "cantilever.lua" { load = "dynamic" }
