"""What tools/compare_grains needs of both programs whatever the disks do: a run of each, and the law of contact they share."""
import json
import math
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ROOT / "scenarios" / "validation"
PROGRAM = os.environ.get("DEMLUA", ROOT / "build" / "release" / "bin" / "demlua")
LAMMPS = "lmp"


def damping_fraction(e):
    """Of critical, of a spring and dashpot that let go when their force is zero; see engine/law/restitution.hpp."""
    def restitution(xi):
        return math.exp(-xi / math.sqrt(1 - xi * xi) * (math.pi - 2 * math.asin(xi)))
    low, high = 0.0, 1 - 1e-9
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if restitution(middle) > e else (low, middle)
    return 0.5 * (low + high)


def pair_law(scene, mass):
    """One line of the granular pair style: `mass` is the reduced mass, from which demlua takes the dashpots."""
    kn, kt = scene["normal_stiffness"], scene["shear_stiffness"]
    dashpot = 2 * damping_fraction(scene["restitution"]) * math.sqrt(kn * mass)
    return (f"hooke {kn!r} {dashpot!r} tangential linear_history {kt!r} {math.sqrt(kt / kn)!r} {scene['friction']!r} "
            "damping velocity limit_damping")


def pair_laws(scene, radii):
    """Lines for every pair of atom types, one type for each radius, so that every pair has its own dashpots."""
    masses = [scene["density"] * math.pi * r * r for r in radii]
    return [f"pair_coeff {a + 1} {b + 1} " + pair_law(scene, masses[a] * masses[b] / (masses[a] + masses[b]))
            for a in range(len(radii)) for b in range(a, len(radii))]


def atoms(scene, disks, radii, box):
    """The data file of disks (x, y, r) in a `box` of (least, greatest) along x, y and z."""
    lines = ["disks", "", f"{len(disks)} atoms", f"{len(radii)} atom types",
             *(f"{low!r} {high!r} {axis}lo {axis}hi" for axis, (low, high) in zip("xyz", box)), "", "Atoms", ""]
    for k, (x, y, r) in enumerate(disks):
        density = scene["density"] * 3 / (4 * r)  # as a sphere's: the mass is then the disk's
        lines.append(f"{k + 1} {radii.index(r) + 1} {2 * r!r} {density!r} {x!r} {y!r} 0")
    return "\n".join(lines) + "\n"


def disks_of(text):
    return [tuple(map(float, line.split())) for line in text.splitlines()]


def own(scene, seed, folder):
    """Runs demlua on a scene that publishes its disks and its law; the results."""
    subprocess.run([PROGRAM, SCENES / scene, "-o", folder, "--quiet", "--set", f"seed={seed}", "--set", "publish=true"], check=True,
                   stdout=subprocess.DEVNULL)
    return json.loads((folder / "summary.json").read_text())["results"]


def other(folder):
    """Runs LAMMPS on `in` and `data` in the folder; what it noted of the motion, a list of numbers for each row."""
    done = subprocess.run([LAMMPS, "-in", "in", "-log", "none"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    if done.returncode:
        raise RuntimeError("\n".join(done.stdout.strip().splitlines()[-3:]))
    rows = re.findall(r"^ *(\d+(?: +[-+.\de]+)+) *$", done.stdout, re.MULTILINE)
    return [list(map(float, row.split())) for row in rows]
