"""Other programs on the same work: the same elements, bonds, contact law, time step and number of steps."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import lammps
import liggghts
import yade
from figures import Figure

# Who can do which work.
ROWS = {"elastic_12k": [yade], "central_12k": [lammps, yade], "grains_12k": [lammps, liggghts]}
# What must agree at the end, and how well, relative. Without shear: the same differential equations and scheme, so nothing but
# rounding, which waves without damping do not blow up. With shear: Yade adds its shear displacement up from step to step; a
# stiffness wrong by 1 % would put the waves off by a fifteenth of a crossing of the beam. Grains: the height of the heap, to half
# a hundredth of what it has sunk; which grains meet when is chaotic.
AGREE = {"elastic_12k": ("stored", 1e-2), "central_12k": ("stored", 1e-6), "grains_12k": ("height", 3e-3)}


def install():
    """Says which programs cannot be had."""
    missing = [peer for peer in (lammps, liggghts, yade) if not shutil.which(peer.PROGRAM)]
    apt = [*([] if os.geteuid() == 0 else ["sudo"]), "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq"]
    if missing:
        subprocess.run([*apt, "update"], check=False)
    for peer in missing:
        print(f"bench: installing {peer.PACKAGE}", file=sys.stderr, flush=True)
        done = subprocess.run([*apt, "-y", "install", "--no-install-recommends", peer.PACKAGE], check=False,
                              stdout=subprocess.DEVNULL)
        if done.returncode or not shutil.which(peer.PROGRAM):
            print(f"bench: {peer.PACKAGE} cannot be installed here; its rows are left out", file=sys.stderr)


def own(work, binaries, file):
    done = subprocess.run([binaries / "demlua_bench", work, "--threads", "1", "--exchange", file], check=True,
                          stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)


def compared(work, peer, binaries, folder):
    """Own run, the other's, own run again: what the machine does to one it does to both."""
    file = folder / "scene.json"
    before = own(work, binaries, file)
    scene = json.loads(file.read_text())
    other = peer.run(work, scene, folder)
    after = own(work, binaries, "-")
    elements = before["elements"]
    ours = sorted(before["seconds_per_step"] + after["seconds_per_step"])
    quantity, tolerance = AGREE[work]
    apart = abs(other[quantity] / before[quantity] - 1)

    def figure(what, unit, samples):
        return Figure(work, peer.PACKAGE, 1, elements, what, unit, samples)
    yield figure("peer", "ns", [1e9 * time / elements for time in other["seconds_per_step"]])
    yield figure("demlua beside it", "ns", [1e9 * time / elements for time in ours])
    yield figure("peer over demlua", "", [time / ours[len(ours) // 2] for time in other["seconds_per_step"]])
    yield figure(f"{quantity} apart", f"of {tolerance:g} allowed", [apart])


def measured(rows, binaries):
    install()
    figures = []
    for work, peers in ROWS.items():
        if rows and not any(work.startswith(row) for row in rows):
            continue
        for peer in peers:
            if not shutil.which(peer.PROGRAM):
                continue
            print(f"bench: {work} with {peer.PACKAGE}", file=sys.stderr, flush=True)
            with tempfile.TemporaryDirectory() as folder:
                figures += compared(work, peer, binaries, pathlib.Path(folder))
    return figures
