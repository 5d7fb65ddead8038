-- Question: does a notched beam bear what a cohesive zone of the same strength and fracture energy bears on its line?
-- Source:   as three_point_bend.lua, whose set-up this is; docs/theory/references.md, section Cracks. A crack through an irregular
--           pack must leave the line and passes its toughest place, so that it bears more (docs/theory/cohesive.md).
-- See:      `demlua study`.
-- Takes:    ten seconds; the study a minute.
-- Quick:    no
local dem = require "dem"

dem.include "../three_point_bend.lua" { against = "cohesive zone" }
