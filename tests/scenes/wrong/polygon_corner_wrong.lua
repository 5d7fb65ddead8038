local dem = require "dem"
dem.polygon { { 0, 0 }, { 1, "0" }, { 1 }, { 0, 1 } }
-->:2: polygon[2] = { 1, "0" }: must be two numbers { x, y } in m
-->:2: polygon[3] = { 1 }: must be two numbers { x, y } in m
