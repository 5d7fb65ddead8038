local dem = require "dem"
dem.disks { { 0, 0, 1 }, { x = 2, y = 0, r = 1 }, 3 }
-->:2: disks[2].r = 1: unknown setting; known are x, y, radius, cluster
-->:2: disks[2].radius: is missing; it must be a number in m
-->:2: disks[3] = 3: must be given one table of settings; as in { x = 0, y = 0, radius = 0.01 }
