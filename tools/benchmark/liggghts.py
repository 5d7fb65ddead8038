"""Inputs for LIGGGHTS (liggghts.com), and what it answers. Grains only: it has no bonds."""
import math

import lammps

PACKAGE = "liggghts"
PROGRAM = "liggghts"


def grains_files(scene, folder):
    """Spheres of the disks' masses in a plane; their rotational inertia is 4/5 of a disk's."""
    elements, contact = scene["elements"], scene["contact"]
    lammps.grains_files(scene, folder)  # the same data file
    xs, ys = [[point[axis] for point in scene["wall"]] for axis in (0, 1)]
    largest = max(elements["radius"])
    mass = 0.5 * sum(elements["mass"]) / len(elements["mass"])
    rates = [2 * contact["damping_fraction"] * math.sqrt(contact[each] / mass) for each in ("Kn", "Kt")]
    values = {"kn": contact["Kn"], "kt": contact["Kt"], "gamman": rates[0], "gammat": rates[1],
              "coefficientFriction": contact["friction"]}
    properties = "\n".join(f"fix {name} all property/global {name} peratomtypepair 1 {value!r}"
                           for name, value in values.items())
    law = "model hooke/stiffness tangential history"
    walls = "\n".join(f"fix {name} all wall/gran {law} primitive type 1 {plane}" for name, plane in
                      (("left", f"xplane {min(xs)!r}"), ("right", f"xplane {max(xs)!r}"), ("floor", f"yplane {min(ys)!r}")))
    return f"""units si
boundary f f f
newton off
atom_style granular
atom_modify map array
communicate single vel yes
read_data data
neighbor {lammps.SKIN * largest!r} bin
neigh_modify delay 0
{properties}
pair_style gran {law}
pair_coeff * *
{walls}
fix weight all gravity {scene['gravity']} vector 0.0 -1.0 0.0
fix move all nve/sphere
compute height all reduce ave y
"""


def run(work, scene, folder):
    return lammps.follow(PROGRAM, grains_files(scene, folder), scene, folder)
