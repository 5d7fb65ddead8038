"""Rows that time the program itself, from its start to its end."""
import json
import pathlib
import subprocess
import tempfile
import time

from figures import Figure

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NAMES = ["start", "penetration"]
STARTS = 20
FRAMES = 60

SMALL_SCENE = """local dem = require "dem"
local stuff = dem.material { name = "stuff", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400,
                             tensile_strength = 3e6, fracture_toughness = 1e6 }
local sim = dem.simulation { title = "Start" }
sim:body { name = "block", material = stuff, region = dem.rectangle { size = { 0.1, 0.1 } },
           packing = dem.close_packed { radius = 5e-3 }, bonds = dem.plateau {} }
sim:run { duration = 1e-7 }
"""


def start(binaries, _threads):
    """The whole program on a scene of some hundred elements and one step: start, reading, assembly, summary."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "start.lua"
        scene.write_text(SMALL_SCENE)
        out = pathlib.Path(folder) / "start.out"
        seconds = []
        for _ in range(STARTS):
            begin = time.monotonic()
            subprocess.run([binaries / "demlua", scene, "-o", out, "--overwrite", "--quiet", "--threads", "1"],
                           check=True)
            seconds.append(time.monotonic() - begin)
        summary = json.loads((out / "summary.json").read_text())
    what = f"program from start to end, {summary['steps']} step(s) of a small scene"
    yield Figure("start", what, 1, summary["elements"], "start to end", "ms", [1e3 * each for each in seconds])


def penetration(binaries, threads):
    """The whole scene with FRAMES frames."""
    for count in threads:
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "penetration.out"
            subprocess.run([binaries / "demlua", ROOT / "scenarios" / "penetration.lua", "-o", out, "--quiet",
                            "--threads", str(count), "--set", f"frame_every={6e-3 / FRAMES}"], check=True)
            summary = json.loads((out / "summary.json").read_text())
        times = summary["timings"]

        def figure(quantity, unit, value, count=count, elements=summary["elements"]):
            return Figure("penetration", "scenarios/penetration.lua, the whole run", count, elements, quantity, unit,
                          [value])
        yield figure("element-step", "ns", 1e9 * times["running"] / summary["steps"] / summary["elements"])
        yield figure(f"writer busy, {summary['frames']} frames", "% of run", 100 * times["writing"] / times["running"])
        yield figure("run", "s", times["running"])


def measured(name, binaries, threads):
    return list({"start": start, "penetration": penetration}[name](binaries, threads))
