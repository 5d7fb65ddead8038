#!/usr/bin/env python3
"""Runs the small scenarios as a reader would and compares what they publish with its closed form."""
import json
import os
import pathlib
import subprocess
import sys

PROGRAM = os.environ["DEMLUA"]
SCENARIOS = pathlib.Path(os.environ["DEMLUA_SOURCE_DIR"]) / "scenarios"


def results(name, *options):
    folder = pathlib.Path(name + ".out")
    subprocess.run([PROGRAM, SCENARIOS / f"{name}.lua", "-o", folder, "--quiet", *options], check=True)
    summary = json.loads((folder / "summary.json").read_text())
    assert summary["ending"]["state"] in ("finished", "stopped"), summary["ending"]
    return summary["results"]


def close(what, got, expected, share):
    print(f"{what}: {got:.6g}, expected {expected:.6g} within {100 * share:.3g} %")
    return abs(got - expected) <= share * abs(expected)


def main():
    right = []
    pair = results("bonded_pair")
    # Two masses on a spring; a step of 0.1 of the limit shortens the period by (w dt)^2/24, below 1e-3.
    right.append(close("period of the bonded pair, s", pair["period"], pair["reference"], 2e-3))

    disks = results("colliding_disks")
    right.append(close("restitution", disks["measured"], disks["reference"], 3e-3))

    strip = results("tension_test")
    # The lattice carries the load on fewer rows than its outline is wide: one radius in ten.
    right.append(close("modulus of the strip, Pa", strip["modulus"], strip["modulus_reference"], 0.05))
    right.append(close("strength of the strip, Pa", strip["strength"], strip["strength_reference"], 0.10))

    bent = results("cantilever", "--set", "rows=3")
    swung = results("cantilever_dynamic", "--set", "rows=3")
    # Finite elements grow by 1.0404 at w, a fifth of their frequency; these rows are 16.6 % softer: 1 / (1 - 0.0388 x 1.166).
    # Mass 1.5 R beyond the loaded column is 4 x 1.5 / 54 of what the mode moves, and adds that share of the growth: 0.5 %.
    right.append(close("growth of the driven cantilever", swung["amplitude"] / bent["deflection"], 1.0474, 0.01))
    slab = results("cantilever", "--set", "packing=irregular", "--set", "count=600", "--overwrite")
    # Ten seeds scatter by 0.12 %.
    right.append(close("compliance of an irregular cantilever", slab["compliance"], 4514.39, 5e-3))

    plate = results("edge_crack", "--set", "radius=7.8125e-3")
    # A code that shares nothing with this one found 2.535 MPa; 1 % is what is asked for.
    right.append(close("first bond of the edge crack, Pa", plate["first_bond_stress"], 2.535e6, 0.01))
    # It is the next one ahead of the tip.
    right.append(0.03125 < plate["first_x"] < 0.03125 + 2 * 7.8125e-3)

    disc = results("brazilian_disc", "--set", "count=600")
    # Hondros (1959); 10 % is what is asked for.
    right.append(close("strength of the split disc, of its material's", disc["share_of_strength"], 1.0, 0.10))

    notched = results("three_point_bend")
    # ASTM E399; 5 % asked for, and twice the 3 % by which packs scatter.
    right.append(close("force on the notched beam, of the handbook's", notched["share_of_handbook"], 1.0, 0.11))

    spall = results("spall")
    # Half of the pulse, to an element; twice its particle velocity, less what the bonds hold back (the scene derives 1.7 %).
    right.append(close("thickness of the spalled piece, m", spall["thickness"], 0.32, 1.6e-3 / 0.32))
    right.append(close("speed of the spalled piece, m/s", spall["speed"], 1.22235, 0.0173))

    running = results("dynamic_crack", "--set", "load=2", "--set", "radius=0.65e-3")
    # No crack runs faster than Rayleigh waves; this one has twice the energy it takes, and runs to the end.
    right.append(0.0 < running["speed_over_rayleigh"] < 1.0 and running["tip"] > 0.08)

    beam = results("penetration", "--set", "elements=1500", "--set", "duration=2e-4")
    # Between no resistance at all and what 80 m/s could lose to a wall.
    right.append(40.0 < beam["projectile_speed"] < 80.0)

    subprocess.run([PROGRAM, SCENARIOS / "penetration_slow.lua", "--check"], check=True)
    return 0 if all(right) else 1


if __name__ == "__main__":
    sys.exit(main())
