local dem = require "dem"
local sand = dem.material { name = "sand", youngs_modulus = 1e8, poissons_ratio = 0.2, density = 2650, tensile_strength = 1e6, fracture_energy = 100 }
local sim = dem.simulation {}
local box = dem.rectangle { size = { 0.05, 0.05 } }
sim:grains { name = "a", material = sand, region = box, shape = dem.cluster { elements = 1, bonds = dem.plateau {} }, radius = 1e-3, porosity = 0.2 }
sim:grains { name = "b", material = sand, region = box, shape = dem.cluster { elements = 3, bonds = dem.plateau {}, rigid = true }, radius = 1e-3, porosity = 0.2 }
sim:grains { name = "c", material = sand, region = box, shape = dem.cluster { disks = { { 0, 0, 1 }, { 3, 0, 1 } } }, radius = 1e-3, porosity = 0.2 }
sim:grains { name = "d", material = sand, region = box, shape = dem.cluster {}, radius = 1e-3, porosity = 0.2 }
sim:grains { name = "e", material = sand, region = box, radius = { 2e-3, 1e-3 }, porosity = 0.2 }
sim:grains { name = "f", material = sand, region = box, radius = { { 1e-3 } }, porosity = 0.2 }
sim:grains { name = "g", material = sand, region = box, radius = 0.3, porosity = 0.2 }
sim:grains { name = "h", material = sand, region = box, radius = 1e-3 }
sim:grains { name = "i", material = sand, region = box, radius = 1e-3, porosity = 0.2, count = 3 }
sim:grains { name = "j", material = sand, region = box, radius = { 1e-3, 2e-3, 3e-3 }, porosity = 1.2, method = "snow" }
sim:grains { name = "k", material = sand, region = box, shape = dem.cluster { elements = 3, bonds = dem.elastic { stiffness = "facets" } }, radius = 1e-3, porosity = 0.2 }
sim:body { name = "l", material = sand, packing = dem.disks { { 0, 0, 1, 1 }, { 2, 0, 1 } }, rigid = true, in_clusters = true }
sim:body { name = "m", material = sand, region = box, packing = dem.close_packed { radius = 1e-3 }, rigid = true, in_clusters = true }
sim:body { name = "n", material = sand, region = box, packing = dem.consolidated { count = 100, removed = 0.1 }, bonds = dem.elastic {} }
-->:5: cluster.bonds: have nothing to hold together: the cluster is a single disk; leave them away or take more elements
-->:6: cluster.rigid = true: must not be given beside bonds; a rigid cluster needs none
-->:7: cluster.disks = 2 of them: each disk must touch or overlap another of its cluster, directly or through others; nothing joins number 2 to the first
-->:8: cluster.elements: exactly one of elements and disks must be given
-->:10: grains.radius[1].share: is missing; it must be a number
-->:14: grains.radius = { 0.001, 0.002, 0.003 }: must be a number, two numbers { least, greatest } or a list of { radius, share } in m
-->:14: grains.porosity = 1.2: must be above 0 and below 1
-->:14: grains.method = "snow": must be "consolidation", "insertion" or "rain"
-->:16: disks[2].cluster: must be given for all disks or for none
-->:9: grains.radius = { 0.002, 0.001 }: the first must not exceed the second
-->:11: grains.region = 0.05 m by 0.05 m: is too small for an element of radius 0.3 m
-->:12: grains.porosity: is missing: this or count must be given; only rain can fill the region by itself
-->:13: grains.count = 3: must not be given beside porosity; each follows from the other
-->:15: body.bonds: across facets cannot hold clusters together one by one: cells share out the whole region; take stiffness = "contacts"
-->:17: body.in_clusters = true: needs a packing that comes in clusters; such as dem.consolidated, or dem.disks with a cluster given for each
-->:18: consolidated.removed: would leave no holes: the cells of body "n" share out the whole region; take bonds with stiffness = "contacts" or "unit cell"
