-- Question: does the beam stop a slow projectile? A slow hit tells bond laws apart more clearly than a fast one.
-- Source:   as penetration.lua, whose set-up this is, at 20 m/s for 15 ms.
-- See:      fewer and longer cracks; the projectile loses more than half of its speed.
-- Takes:    about a minute and a half on two cores.
local dem = require "dem"

dem.include "penetration.lua" { impact_speed = 20, duration = 15e-3, history_every = 2e-5, frame_every = 2.5e-4 }
