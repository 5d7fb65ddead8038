-- Question: how far does a ring of an irregular pack give when it is squeezed across a diameter?
-- Source:   series of the plane theory and finite elements of this project (docs/theory/references.md): pressure on the arcs
--           within 10 degrees of the y axis, resultant 1 on each.
-- See:      `demlua study`: curved free walls, inside and outside, at every angle.
-- Takes:    a second; the study half a minute.
local dem = require "dem"

local p = dem.param {
  count = { 2400, help = "elements" },
  seed  = { 1, help = "of the pack" },
  inner = { 0.5, "m", help = "radius of the hole" },
}
