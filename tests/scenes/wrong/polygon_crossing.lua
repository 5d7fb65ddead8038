local dem = require "dem"
dem.polygon { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }
-->:2: polygon: sides must not cross: those after corners 1 and 3 do
