"""Inputs for LAMMPS (lammps.org), and what it answers."""
import math
import os
import re
import subprocess

PACKAGE = "lammps"
PROGRAM = "lmp"
SKIN = 0.5  # of the largest radius; not tuned


def box(elements, margin):
    return [f"{min(elements[axis]) - margin:.12g} {max(elements[axis]) + margin:.12g} {axis}lo {axis}hi" for axis in "xy"]


def central_files(scene, folder):
    """Harmonic bonds of one length between points: what a close-packed body without shear stiffness is."""
    elements, bonds = scene["elements"], scene["bonds"]
    length = bonds["length"][0]
    lines = ["bonded", "", f"{len(elements['x'])} atoms", f"{len(bonds['i'])} bonds", "1 atom types", "1 bond types",
             "6 extra bond per atom", *box(elements, 4 * length), f"{-length} {length} zlo zhi", "", "Masses", "",
             f"1 {elements['mass'][0]!r}", "", "Atoms", ""]
    lines += [f"{k + 1} 1 1 {x!r} {y!r} 0" for k, (x, y) in enumerate(zip(elements["x"], elements["y"]))]
    lines += ["", "Velocities", ""]
    lines += [f"{k + 1} {x!r} {y!r} 0" for k, (x, y) in enumerate(zip(elements["vx"], elements["vy"]))]
    lines += ["", "Bonds", ""]
    lines += [f"{k + 1} 1 {i + 1} {j + 1}" for k, (i, j) in enumerate(zip(bonds["i"], bonds["j"]))]
    (folder / "data").write_text("\n".join(lines) + "\n")
    return f"""units si
dimension 2
boundary f f p
atom_style bond
pair_style none
comm_modify cutoff {3 * length!r}
neighbor {0.5 * length!r} bin
neigh_modify every 1000000 delay 0 check no
bond_style harmonic
read_data data
bond_coeff 1 {0.5 * bonds['Kn']!r} {length!r}
fix move all nve
"""


def grains_files(scene, folder):
    """Disks with a linear contact law and friction with history, in a box. Damping is a rate over an effective mass here: that
    of two mean grains stands for all."""
    elements, contact = scene["elements"], scene["contact"]
    xs, ys = [[point[axis] for point in scene["wall"]] for axis in (0, 1)]
    largest = max(elements["radius"])
    lines = ["grains", "", f"{len(elements['x'])} atoms", "1 atom types",
             f"{min(xs) - largest} {max(xs) + largest} xlo xhi", f"{min(ys) - largest} {2 * max(ys)} ylo yhi",
             f"{-largest} {largest} zlo zhi", "", "Atoms", ""]
    for k, (x, y, radius, mass) in enumerate(zip(*(elements[name] for name in ("x", "y", "radius", "mass")))):
        density = mass / (4 / 3 * math.pi * radius ** 3)  # as a sphere's: the mass is then the disk's
        lines.append(f"{k + 1} 1 {2 * radius!r} {density!r} {x!r} {y!r} 0")
    (folder / "data").write_text("\n".join(lines) + "\n")
    mean = sum(elements["mass"]) / len(elements["mass"])

    def law(stiffness, shear, mass):
        rates = [2 * contact["damping_fraction"] * math.sqrt(each / mass) for each in (stiffness, shear)]
        return " ".join(map(repr, [stiffness, shear, *rates, contact["friction"]])) + " 1"
    wall = "hooke/history " + law(contact["wall_Kn"], contact["wall_Kt"], mean)
    return f"""units si
dimension 2
boundary f f p
newton off
atom_style sphere
comm_modify vel yes
read_data data
neighbor {SKIN * largest!r} bin
neigh_modify every 1 delay 0 check yes
pair_style gran/hooke/history {law(contact['Kn'], contact['Kt'], 0.5 * mean)}
pair_coeff * *
fix sides all wall/gran {wall} xplane {min(xs)!r} {max(xs)!r}
fix floor all wall/gran {wall} yplane {min(ys)!r} NULL
fix weight all gravity {scene['gravity']} vector 0 -1 0
fix move all nve/sphere disc
fix plane all enforce2d
compute height all reduce ave y
"""


def follow(program, text, scene, folder):
    """Runs the input over the scene's steps; seconds per step of each batch, and what is left at the end."""
    columns = {"kinetic": "ke", "height": "c_height"} if "compute height" in text else {"stored": "pe", "kinetic": "ke"}
    text += f"timestep {scene['dt']!r}\nthermo 1000000\nthermo_style custom step {' '.join(columns.values())}\n"
    text += "thermo_modify norm no format float %.15g\n"
    if scene["steps_before"]:
        text += f"run {scene['steps_before']}\n"
    text += f"run {scene['steps_per_batch']}\n" * scene["batches"]
    (folder / "in").write_text(text)
    done = subprocess.run([program, "-in", "in", "-log", "none"], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    if done.returncode:
        raise RuntimeError(done.stdout.strip().splitlines()[-1])
    loops = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", done.stdout, re.MULTILINE)
    number = r"[-+\d.]+(?:e[-+]\d+)?"
    last = re.findall(rf"^ *\d+(?: +{number}){{{len(columns)}}} *$", done.stdout, re.MULTILINE)[-1].split()
    return {"seconds_per_step": [float(time) / int(steps) for time, steps in loops[-scene["batches"]:]],
            **dict(zip(columns, map(float, last[1:])))}


def run(work, scene, folder):
    text = {"central_12k": central_files, "grains_12k": grains_files}[work](scene, folder)
    return follow(PROGRAM, text, scene, folder)
