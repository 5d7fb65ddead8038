local dem = require "dem"
dem.half_plane { outward = { 0, 0 } }
-->:2: half_plane.outward = { 0, 0 }: must not be zero
