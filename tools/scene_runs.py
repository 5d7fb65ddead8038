"""Runs scenes and reads what they found; imported by the tools that write tables over them."""
import concurrent.futures
import json
import os
import pathlib
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = os.environ.get("DEMLUA", ROOT / "build" / "release" / "bin" / "demlua")


def results(scene, settings):
    """Results of a scenario, by file name, with these parameters, on one thread."""
    with tempfile.TemporaryDirectory() as folder:
        command = [PROGRAM, ROOT / "scenarios" / scene, "-o", folder + "/run", "--quiet", "--threads", "1"]
        for name, value in settings.items():
            command += ["--set", f"{name}={value}"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        with open(folder + "/run/summary.json", encoding="utf-8") as file:
            return json.load(file)["results"]


def results_of_all(scene, plans, jobs):
    """The same for each of some settings, as many side by side as `jobs` says."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(lambda settings: results(scene, settings), plans))


def mean_and_scatter(values, mean, scatter):
    """Mean and, of more than one, standard deviation, in these formats."""
    text = format(statistics.fmean(values), mean)
    return text if len(values) < 2 else f"{text} ± {format(statistics.stdev(values), scatter)}"
