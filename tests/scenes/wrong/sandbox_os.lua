local dem = require "dem"
os.execute("true")
-->:2: attempt to call a nil value (field 'execute')
