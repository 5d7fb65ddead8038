local dem = require "dem"
dem.param { shape = { dem }, size = { 1, "m", hlp = "how large" } }
-->:2: param.shape = a table: must have a finite number, a text, true or false as default
-->:2: param.size.hlp: unknown setting; did you mean "help"?
