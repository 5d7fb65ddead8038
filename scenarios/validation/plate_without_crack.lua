-- Question: does a plate without a crack bear its tensile strength, whatever the size of its elements?
-- Source:   as edge_crack.lua, whose set-up this is: Tavarez & Plesha 2007, section 8, "essentially 3.44 MPa".
-- See:      `demlua study`: it does when the end rows are kept from turning. With --set hold_rotation=false elements in the
--           corners turn and tear first.
-- Takes:    a quarter of a minute.
-- Quick:    no
local dem = require "dem"

dem.include "../edge_crack.lua" { crack = 0, hold_rotation = true, ramp = 0.1, head_start = 3.2e6, compare_with = "other code" }
