local dem = require "dem"
dem.material { youngs_modulus = 30e9
dem.simulation {}
-->:3: syntax error: '}' expected (to close '{' at line 2) near 'dem'
