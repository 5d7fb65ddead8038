"""Runs of tools/work_precision: what is run, what it took, and how that is kept."""
import csv
import dataclasses
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ROOT / "scenarios"
PROGRAM = os.environ.get("DEMLUA", ROOT / "build" / "release" / "bin" / "demlua")
PACKS = ROOT / "build" / "work_precision"
SHORT = 3.0  # s; runs below it are repeated where there is one seed only
COLUMNS = ["scene", "curve", "level", "seed", "elements", "steps", "wall_s", "cpu_s", "repeats", "processor", "settings", "values"]


@dataclasses.dataclass(frozen=True)
class Level:
    """One point of a curve: what is set there, once for each seed, None where there is no pack. `when`: "always", not in --quick
    ("full") or only there ("quick")."""
    label: str
    settings: dict
    seeds: tuple = (1,)
    when: str = "always"


@dataclasses.dataclass(frozen=True)
class Curve:
    """One line of a picture: settings that its levels share, levels from cheap to dear."""
    name: str
    scene: str
    settings: dict
    levels: list

    def run_in(self, quick):
        return [level for level in self.levels if level.when != ("full" if quick else "quick")]


@dataclasses.dataclass
class Point:
    """The runs of one level; times are medians over its seeds."""
    curve: str
    level: str
    elements: int
    steps: int
    cpu: float
    wall: float
    values: list


def processor():
    file = pathlib.Path("/proc/cpuinfo")
    lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown")


def timed(command):
    """CPU seconds (user and system) and wall seconds of a process that must succeed."""
    with tempfile.TemporaryFile() as said:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said, env={**os.environ, "DEMLUA_CACHE": str(PACKS)})
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            said.seek(0)
            raise RuntimeError(" ".join(map(str, command)) + "\n" + said.read().decode())
    return usage.ru_utime + usage.ru_stime, wall


def run(curve, level, seed, figures, repeat):
    """One row of the CSV. `figures` reads what was measured from the folder of a run and its summary."""
    settings = {**curve.settings, **level.settings, "seed": seed} if seed else {**curve.settings, **level.settings}
    PACKS.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as parent:
        folder = pathlib.Path(parent) / "run"
        command = [PROGRAM, SCENES / curve.scene, "-o", folder, "--quiet", "--overwrite", "--threads", "1"]
        for name, value in settings.items():
            command += ["--set", f"{name}={value}"]
        if seed:
            timed([*command, "--explain"])  # leaves the pack in the store
        times = [timed(command)]
        wanted = repeat or (3 if times[0][1] < SHORT and len(level.seeds) == 1 else 1)
        times += [timed(command) for _ in range(wanted - 1)]
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        values = figures(folder, summary)
    cpu, wall = (statistics.median(column) for column in zip(*times))
    print(f"{curve.name}, {level.label}" + (f", seed {seed}" if seed else "") + f": {cpu:.2f} s of CPU, {wall:.2f} s, "
          + ", ".join(f"{name} {value:.6g}" for name, value in values.items()), file=sys.stderr, flush=True)
    return {"curve": curve.name, "level": level.label, "seed": seed or "", "elements": summary["elements"], "steps": summary["steps"],
            "wall_s": wall, "cpu_s": cpu, "repeats": wanted, "processor": processor(), "settings": settings, "values": values}


def rows_of(name, curves, figures, quick, repeat):
    rows = []
    for curve in curves:
        for level in curve.run_in(quick):
            for seed in level.seeds[:2] if quick else level.seeds:
                rows.append({"scene": name, **run(curve, level, seed, figures, repeat)})
    return rows


def points_of(rows):
    """Points in the order of the rows, as {(curve, level): Point}."""
    groups = {}
    for row in rows:
        groups.setdefault((row["curve"], row["level"]), []).append(row)
    return {key: Point(*key, round(statistics.fmean(row["elements"] for row in group)),
                       round(statistics.fmean(row["steps"] for row in group)), statistics.median(row["cpu_s"] for row in group),
                       statistics.median(row["wall_s"] for row in group), [row["values"] for row in group])
            for key, group in groups.items()}


def kept(file):
    """The rows of an earlier time."""
    if not file.exists():
        return []
    rows = []
    with file.open(newline="", encoding="utf-8") as text:
        for row in csv.DictReader(text):
            for name, kind in {"elements": int, "steps": int, "repeats": int, "wall_s": float, "cpu_s": float}.items():
                row[name] = kind(row[name])
            rows.append({**row, "settings": json.loads(row["settings"]), "values": json.loads(row["values"])})
    return rows


def keep(file, rows):
    with file.open("w", newline="", encoding="utf-8") as text:
        writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({**row, "wall_s": f"{row['wall_s']:.3f}", "cpu_s": f"{row['cpu_s']:.3f}",
                             "settings": json.dumps(row["settings"]), "values": json.dumps(row["values"])})
