local dem = require "dem"
dem.bond_law "rubber" {}
-->:2: unknown bond law "rubber"; known are elastic, plateau, softening, brittle_tensile, brittle_toughness, cohesive
