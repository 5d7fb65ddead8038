local dem = require "dem"
dem.rectangle { size = { 1, 0 } }
-->:2: rectangle.size = { 1, 0 }: must be positive
