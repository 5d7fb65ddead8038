-- Question: does the first bond at the tip of an edge crack break when another code says it does?
-- Source:   as edge_crack.lua, whose set-up this is: Tavarez & Plesha 2007, section 8, fig. 15, without the finest radius.
-- See:      `demlua study`: 2.535 and 2.510 MPa for a ramp of 50 ms with ends that are free to turn.
-- Takes:    half a minute.
-- Quick:    no
local dem = require "dem"

dem.include "../edge_crack.lua" { compare_with = "other code" }
