local dem = require "dem"
dem.bond_law "softening" { damping = -1 }
dem.brittle_tensile { break_in_shear = true }
-->:2: softening.damping = -1: must not be negative
-->:3: brittle_tensile.break_in_shear = true: unknown setting; known are stiffness, search, damping
