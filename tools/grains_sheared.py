"""Disks between two rough rows, for tools/compare_grains: scenarios/validation/shearing.lua in demlua and in LAMMPS."""
from grains_runs import atoms, disks_of, other, own, pair_laws

TITLE = "Shearing"
TEXT = ("Five hundred disks of four sizes, in a plane that repeats, between two rows of disks that do not turn: the upper row comes "
        "down until the bed is dense, then moves along it at constant height "
        "([shearing.lua](../scenarios/validation/shearing.lua)). Compared are means over the second half of the way along. Stresses are "
        "sums over contacts of force times the line of centres, over the area between the middles of the rows.")
COLUMNS = "xx", "yy", "xy", "touching", "motion", "turning", "spin", "spin_size", "force_x", "force_y"


def lammps_input(scene, counts, rim):
    bed, bottom, top = counts
    radii = sorted({r for name in ("bed", "bottom", "top") for _, _, r in disks_of(scene[name])})
    down = (scene["height"] - scene["high"]) / (scene["steps_down"] * scene["time_step"])
    return "\n".join([f"""units si
dimension 2
boundary p f p
newton off
atom_style sphere
comm_modify vel yes
read_data data
group bed id 1:{bed}
group rows id {bed + 1}:{bed + bottom + top}
group top id {bed + bottom + 1}:{bed + bottom + top}
neighbor {0.5 * rim!r} bin
neigh_modify every 1 delay 0 check yes exclude group rows rows
pair_style granular""", *pair_laws(scene, radii), f"""fix move bed nve/sphere disc
fix plane all enforce2d
compute virial all pressure NULL virial
variable xx equal c_virial[1]*lx*ly
variable yy equal c_virial[2]*lx*ly
variable xy equal c_virial[4]*lx*ly
compute near all contact/atom
compute touching bed reduce ave c_near
compute motion bed ke
compute turning bed erotate/sphere
compute omega bed property/atom omegaz
variable size atom abs(c_omega)
compute spin bed reduce ave c_omega v_size
compute force top reduce sum fx fy
timestep {scene['time_step']!r}
thermo {scene['every']:.0f}
thermo_style custom step v_xx v_yy v_xy c_touching c_motion c_turning c_spin[1] c_spin[2] c_force[1] c_force[2]
thermo_modify norm no format float %.15g
fix drive top move linear 0 {down!r} 0
run {scene['steps_down']:.0f}
unfix drive
fix drive top move linear {scene['speed']!r} 0 0
run {scene['steps'] - scene['steps_down']:.0f}"""]) + "\n"


def in_lammps(scene, folder):
    """Means over the time that counts, named as COLUMNS says."""
    lists = [disks_of(scene[name]) for name in ("bed", "bottom", "top")]
    disks = sum(lists, [])
    radii = sorted({r for _, _, r in disks})
    rim = radii[-1]
    box = (0.0, scene["width"]), (-2 * rim, scene["high"] + 2 * rim), (-rim, rim)
    (folder / "data").write_text(atoms(scene, disks, radii, box))
    (folder / "in").write_text(lammps_input(scene, [len(disks) for disks in lists], rim))
    rows = [row[1:] for row in other(folder) if row[0] * scene["time_step"] >= scene["start"]]
    return dict(zip(COLUMNS, (sum(column) / len(rows) for column in zip(*rows))))


def answers(pressure, along, shear, touching, kinetic, spin, spin_size):
    return {
        "pressure on the rows, kPa": 1e-3 * pressure,
        "pressure along them, over it": along / pressure,
        "shear stress, over it": shear / pressure,
        "disks that a disk touches": touching,
        "kinetic energy of a disk, mJ": 1e3 * kinetic,
        "spin, rad/s": spin,
        "size of the spin, rad/s": spin_size,
    }


def pair_of_answers(seed, folder):
    scene = own("shearing.lua", seed, folder / "own")
    mean = in_lammps(scene, folder)
    area = scene["width"] * scene["height"]
    disks = len(disks_of(scene["bed"]))
    kinetic = (mean["motion"] + 1.25 * mean["turning"]) / disks  # a disk's inertia is 1.25 times a sphere's
    return (answers(scene["pressure"], scene["along"], scene["ratio"] * scene["pressure"], scene["touching"], scene["kinetic"],
                    scene["spin"], scene["spin_size"]),
            answers(mean["yy"] / area, mean["xx"] / area, -mean["xy"] / area, mean["touching"], kinetic, mean["spin"], mean["spin_size"]))
