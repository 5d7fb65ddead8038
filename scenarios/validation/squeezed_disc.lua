-- Question: how far does a disc of an irregular pack give when it is squeezed across a diameter, and how is it stressed inside?
-- Source:   as squeezed_ring.lua, whose set-up this is, without the hole.
-- See:      `demlua study`: the diameter along the load. The run itself compares the stresses at the centre.
-- Takes:    a second; the study half a minute.
local dem = require "dem"

dem.include "squeezed_ring.lua" { inner = 0 }
