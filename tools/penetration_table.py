#!/usr/bin/env python3
"""Runs scenarios/penetration.lua over seeds and variants and prints the table of docs/penetration.md.

    tools/penetration_table.py PROGRAM [--seeds N] [--variants fast,printed,...]
"""
import argparse
import csv
import json
import pathlib
import statistics
import subprocess
import tempfile

SCENARIO = pathlib.Path(__file__).resolve().parent.parent / "scenarios" / "penetration.lua"
VARIANTS = {
    "breaks in shear": [],
    "printed law": ["break_in_shear=false"],
    "rigid projectile": ["rigid_projectile=true"],
    "no bonds to speak of": ["concrete_strength=1e3", "concrete_toughness=1e2"],
    "half the step": ["step_fraction=0.45"],
    "20 m/s": ["impact_speed=20", "duration=15e-3"],
}
TIMES = (1e-3, 2.67e-3, 6e-3)


def run(program, settings, seed):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, str(SCENARIO), "-o", folder + "/run", "--quiet", "--set", f"seed={seed}"]
        for setting in settings + ["frame_every=1"]:
            command += ["--set", setting]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        with open(folder + "/run/history.csv", newline="") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        with open(folder + "/run/summary.json") as file:
            summary = json.load(file)
    return figures(rows, summary)


def figures(rows, summary):
    def at(time):
        return min(rows, key=lambda row: abs(row["time"] - time))

    end = rows[-1]
    return {
        "speed, m/s": [at(time)["projectile_speed"] for time in TIMES],
        "nose depth, mm": [1e3 * at(time)["nose_depth"] for time in TIMES],
        "broken share": [summary["results"]["broken_share"]],
        "crack length, m": [end["crack_length"]],
        "fragments": [end["fragments"]],
        "ledger error, %": [100 * end["energy_error"] / rows[0]["kinetic_energy"]],
        "wall time, s": [summary["timings"]["running"]],
    }


def cell(samples):
    """Mean, and in parentheses the standard deviation over the seeds, of each figure."""
    texts = []
    for values in zip(*samples):
        mean = statistics.fmean(values)
        spread = f"({statistics.stdev(values):.2g})" if len(values) > 1 else ""
        texts.append(f"{mean:.4g}{spread}")
    return " / ".join(texts)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--seeds", type=int, default=6)
    parser.add_argument("--variants", default=",".join(VARIANTS))
    options = parser.parse_args()
    header = None
    for name in options.variants.split(","):
        results = [run(options.program, VARIANTS[name], seed) for seed in range(1, options.seeds + 1)]
        if header is None:
            header = ["variant (seeds)"] + list(results[0])
            print("| " + " | ".join(header) + " |")
            print("|" + "---|" * len(header))
        cells = [cell([result[key] for result in results]) for key in results[0]]
        print(f"| {name} ({options.seeds}) | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
