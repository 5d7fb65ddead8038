"""Disks that fall into a box, for tools/compare_grains: scenarios/validation/settling.lua in demlua and in LAMMPS."""
import csv
import math

from grains_runs import atoms, disks_of, other, own, pair_law, pair_laws

ROWS_EVERY = 134  # steps between what is noted of the motion
TITLE = "Settling"
TEXT = ("A thousand disks of four sizes fall into a box "
        "([settling.lua](../scenarios/validation/settling.lua)).")


def in_demlua(seed, folder):
    """The results, with the motion as (time, kinetic energy) and the disks as (x, y, r)."""
    results = own("settling.lua", seed, folder)
    for name in ("at_start", "at_end"):
        results[name] = disks_of(results[name])
    with open(folder / "history.csv", newline="") as file:
        results["motion"] = [(float(row["time"]), float(row["kinetic"])) for row in csv.DictReader(file)]
    return results


def lammps_input(scene, radii):
    walls = []
    for a, r in enumerate(radii):
        law = pair_law(scene, scene["density"] * math.pi * r * r)
        walls += [f"group size{a} type {a + 1}", f"fix sides{a} size{a} wall/gran granular {law} xplane 0 {scene['width']!r}",
                  f"fix floor{a} size{a} wall/gran granular {law} yplane 0 NULL"]
    return "\n".join([f"""units si
dimension 2
boundary f f p
newton off
atom_style sphere
comm_modify vel yes
read_data data
neighbor {0.5 * radii[-1]!r} bin
neigh_modify every 1 delay 0 check yes
pair_style granular""", *pair_laws(scene, radii), *walls, f"""fix weight all gravity {scene['gravity']!r} vector 0 -1 0
fix move all nve/sphere disc
fix plane all enforce2d
compute motion all ke
compute spin all erotate/sphere
variable kinetic equal c_motion+1.25*c_spin # a disk's inertia is 1.25 times a sphere's
timestep {scene['time_step']!r}
thermo {ROWS_EVERY}
thermo_style custom step v_kinetic
thermo_modify norm no format float %.15g
run {scene['steps']:.0f}
write_dump all custom end id x y radius modify sort id format float %.17g"""]) + "\n"


def in_lammps(scene, folder):
    """The same from the same start."""
    disks = scene["at_start"]
    radii = sorted({r for _, _, r in disks})
    rim = radii[-1]
    box = (-rim, scene["width"] + rim), (-rim, 2 * scene["high"]), (-rim, rim)
    (folder / "data").write_text(atoms(scene, disks, radii, box))
    (folder / "in").write_text(lammps_input(scene, radii))
    motion = [(step * scene["time_step"], kinetic) for step, kinetic in other(folder)]
    table = (folder / "end").read_text().split("ITEM: ATOMS id x y radius", 1)[1].split("\n")[1:]
    return {"motion": motion, "at_end": [tuple(map(float, line.split()[1:])) for line in table if line.strip()]}


def below(disk, level):
    """Area of the part of a disk below a level."""
    _, y, r = disk
    up = max(-1.0, min(1.0, (level - y) / r))
    return r * r * (math.acos(-up) + up * math.sqrt(1 - up * up))


def coordination(disks):
    """Mean number of disks that a disk touches."""
    size = 2 * max(r for _, _, r in disks)
    cells = {}
    for k, (x, y, _) in enumerate(disks):
        cells.setdefault((int(x // size), int(y // size)), []).append(k)
    touching = 0
    for (column, row), members in cells.items():
        near = [k for dx in (-1, 0, 1) for dy in (-1, 0, 1) for k in cells.get((column + dx, row + dy), [])]
        for a in members:
            touching += sum(1 for b in near if b != a and math.hypot(disks[a][0] - disks[b][0], disks[a][1] - disks[b][1])
                            < disks[a][2] + disks[b][2])
    return touching / len(disks)


def first_below(motion, share):
    """When the kinetic energy, once at its greatest, has fallen below a share of it."""
    greatest = max(range(len(motion)), key=lambda n: motion[n][1])
    return next((time for time, kinetic in motion[greatest:] if kinetic < share * motion[greatest][1]), math.nan)


def answers(run, scene):
    disks, motion = run["at_end"], run["motion"]
    area = sum(r * r for _, _, r in disks)
    middle = sum(r * r * y for _, y, r in disks) / area
    low, high = 0.4 * middle, 1.4 * middle  # a fifth and seven tenths of the bed
    solid = sum(below(disk, high) - below(disk, low) for disk in disks)
    return {
        "height of the centre of mass, mm": 1e3 * middle,
        "porosity between 0.4 and 1.4 of that height": 1 - solid / (scene["width"] * (high - low)),
        "disks that a disk touches": coordination(disks),
        "greatest kinetic energy, J": max(kinetic for _, kinetic in motion),
        "time to a hundredth of it, s": first_below(motion, 1e-2),
        "time to a ten-thousandth of it, s": first_below(motion, 1e-4),
    }


def pair_of_answers(seed, folder):
    scene = in_demlua(seed, folder / "own")
    return answers(scene, scene), answers(in_lammps(scene, folder), scene)
