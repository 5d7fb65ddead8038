local dem = require "dem"
dem.rectangel { size = { 1, 1 } }
-->:2: unknown word of dem "rectangel"; did you mean "rectangle"?
