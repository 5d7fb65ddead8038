local dem = require "dem"
local density = 2400
dem.material { youngs_modulus = 30e9, poissons_ratio = 0.2, density = desnity }
-->:3: unknown variable "desnity"
