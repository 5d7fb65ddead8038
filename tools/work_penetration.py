"""The penetration of tools/work_precision: speed and depth of the nose at two times, over packs."""
import csv
import math
import statistics

from work_page import Judged, Section, share
from work_runs import Curve, Level

NAME = "penetration"
TITLE = "The projectile through the beam"
SCENE = "penetration.lua"
TIMES = (2.67e-3, 6e-3)  # s
QUANTITIES = {f"{name} at {1e3 * time:g} ms": (column, time)
              for name, column in {"speed": "projectile_speed", "depth": "nose_depth"}.items() for time in TIMES}
COMMON = {"projectile": "as wide", "frame_every": 1, "history_every": 3e-5}
ACROSS = {5: 1780, 7: 3480, 9: 5750, 13: 12000}  # elements of the beam, by those across the projectile


def packs(n, *seeds, when="always"):
    return Level(f"{n} across", {"elements": ACROSS[n]}, seeds, when)


def shot(name, levels, **settings):
    return Curve(name, SCENE, {**COMMON, **settings}, levels)


CONTACTS, FACETS = "reference, contacts", "reference, facets"
PLAIN, HALVED = "contacts, 0.9 of the step", "contacts, 0.45 of the step"
RIGID, EXACT = "contacts, rigid projectile, 0.9 of the step", "facets, 0.9 of the step"
MIXED = "contacts, mixed precision, 0.9 of the step"
# Packs of the references are others than those measured by them.
CURVES = [
    shot(CONTACTS, [packs(13, 11, 12, 13, when="full"), packs(7, 11, 12, when="quick")], step_fraction=0.45),
    shot(FACETS, [packs(13, 11, 12, when="full"), packs(7, 11, 12, when="quick")], step_fraction=0.9, stiffness="facets"),
    shot(PLAIN, [packs(5, 1, 2, 3), packs(7, 1, 2, 3), packs(9, 1, 2, when="full"), packs(13, 1, 2, when="full")], step_fraction=0.9),
    shot(HALVED, [packs(5, 1, 2, 3), packs(7, 1, 2, 3, when="full"), packs(9, 1, when="full")], step_fraction=0.45),
    shot(RIGID, [packs(5, 1, 2, 3), packs(7, 1, 2, 3, when="full"), packs(9, 1, when="full")], step_fraction=0.9, rigid_projectile="true"),
    shot(MIXED, [packs(5, 1, 2, 3), packs(7, 1, 2, 3, when="full")], step_fraction=0.9, precision="mixed"),
    shot(EXACT, [packs(5, 1, 2), packs(7, 1, 2, when="full"), packs(9, 1, when="full")], step_fraction=0.9, stiffness="facets"),
]

TEXT = """\
The scene's beam and projectile ([penetration.md](penetration.md)), with `projectile = "as wide"`: in the scene as it stands the
projectile is 13 elements wide whatever their size, so that fewer elements make a larger projectile. Here it keeps width, mass
and the shape of its nose, with 5, 7, 9 or 13 elements across, in beams of {counts} elements.

A beam in pieces is chaotic: the pack and the last bit of a sum change which bonds break. So the references are means over
the finest packs, of seeds of their own, with half the step for contacts (for facets it would take too long); ± is the standard deviation
from pack to pack.

{references}

The error of a setting is the root mean square, over its packs, of single runs against the mean of the reference with the same
stiffness: what one run with one pack must be expected to be off by. The mean of so few reference packs is itself uncertain; errors
below twice its standard error (scatter over root of the number of packs) are told as *below* that."""

JUDGED = """\
The picture and the first table show the largest of the four errors, against the least certain of the four references. Several
packs: root mean square; one pack: that of this pack; time is that of one run. Methods whose errors differ by less than packs scatter are not ranked by it."""

CLOSING = """\
- **5 % is what one run with contacts gives; 1 % and 0.1 % cannot be told.** The reference's own packs differ by up to {scatter} (one standard
  deviation), so a single pack is off by about as much whatever is spent on it. References would need some {per_cent} packs of
  12,000 elements before a per cent could be judged, and {per_mille} for a tenth.
- **Half the step** moves the means of the same packs by at most {halved} from 7 across on; at 7 across packs differ by up to {coarse}.
  What it improves is the ledger: at {finest} {ledger_full} of the projectile's energy is unaccounted for at 0.9 of the step and
  {ledger_half} at 0.45. So the scene takes 0.9.
- **A rigid projectile** moves them by at most {moved} and takes {rigid:.2g} times the CPU time for as many steps. For speed and depth it
  would do. The scene keeps the deformable one because the paper's is, and for the waves in it.
- **Mixed precision** moves them by at most {mixed}, as any other last bit does, and takes {mixed_time:.2g} times the CPU time.
- **The number of elements** follows from what is asked: the first table says from where on speed and depth are within 5 %. The
  scene has 12,000 for its cracks and fragments, which coarser beams do not show, and because the paper's figure has as many.
- **Facets need more elements.** At {finest} the largest of the four errors is still {facets_error}, and their reference, no finer than
  13 across, may move on with finer elements. They take {facets:.2g} times the CPU time of contacts, which settle sooner. Contacts are
  the default because the paper bonds so; they make the softer beam all the same."""


def figures(folder, summary):
    with (folder / "history.csv").open(newline="", encoding="utf-8") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    found = {name: min(rows, key=lambda row: abs(row["time"] - time))[column] for name, (column, time) in QUANTITIES.items()}
    return {**found, "ledger error": rows[-1]["energy_error"] / rows[0]["kinetic_energy"],
            "broken share": summary["results"]["broken_share"]}


class Reference:
    def __init__(self, points, curve):
        self.point = next(point for (name, _), point in points.items() if name == curve)
        self.packs = len(self.point.values)
        columns = {name: [values[name] for values in self.point.values] for name in QUANTITIES}
        self.mean = {name: statistics.fmean(column) for name, column in columns.items()}
        self.scatter = {name: statistics.stdev(column) if self.packs > 1 else math.nan for name, column in columns.items()}
        self.floor = {name: 2 * self.scatter[name] / math.sqrt(self.packs) / self.mean[name] for name in QUANTITIES}

    def row(self):
        cells = [f"{self.mean[name]:.4g} ± {self.scatter[name]:.2g} m" + ("/s" if name.startswith("speed") else "") for name in QUANTITIES]
        return f"| {self.point.curve.split(', ')[1]} | {self.point.level} | {self.packs} | " + " | ".join(cells) + " |"

    def judged(self, point):
        errors = {name: math.sqrt(statistics.fmean((values[name] / self.mean[name] - 1) ** 2 for values in point.values))
                  for name in QUANTITIES}
        cells = [share(errors[name]) if not errors[name] <= self.floor[name] else f"below {share(self.floor[name])}" for name in QUANTITIES]
        return Judged(point, max(errors.values()), max(self.floor.values()), [str(len(point.values)), *cells])


def references(points):
    return {"contacts": Reference(points, CONTACTS), "facets": Reference(points, FACETS)}


def sections(points):
    against = references(points)
    found = [against[name.split(",")[0]].judged(point) for (name, _), point in points.items() if name not in (CONTACTS, FACETS)]
    return [Section("Speed and depth", JUDGED, "speed_and_error_penetration.svg", ["packs", *QUANTITIES], found)]


def introduction(points):
    against = references(points)
    table = ["| stiffness | reference | packs | " + " | ".join(QUANTITIES) + " |", "|---" * (3 + len(QUANTITIES)) + "|",
             *(one.row() for one in against.values())]
    return TEXT.format(counts=", ".join(f"{n:,}" for n in ACROSS.values()), references="\n".join(table))


def moved(points, curve):
    """The greatest change of a mean over the packs that a curve shares with the plain one, as a share."""
    changes = []
    for (name, level), point in points.items():
        if name == curve and (level != "5 across" or (curve, "7 across") not in points):
            plain = points[PLAIN, level].values[:len(point.values)]
            changes += [abs(statistics.fmean(v[q] for v in point.values) / statistics.fmean(v[q] for v in plain) - 1) for q in QUANTITIES]
    return max(changes)


def scatter_of(values):
    """The greatest standard deviation from pack to pack, as a share."""
    columns = [[one[name] for one in values] for name in QUANTITIES]
    return max(statistics.stdev(column) / statistics.fmean(column) for column in columns) if len(values) > 1 else math.nan


def closing(points):
    against = references(points)
    finest = "9 across" if (PLAIN, "9 across") in points else "5 across"
    scatter = scatter_of(against["contacts"].point.values)

    def ledger(curve):
        return share(statistics.fmean(abs(values["ledger error"]) for values in points[curve, finest].values))

    def dearer(curve):
        levels = [level for name, level in points if name == curve]
        return sum(points[curve, level].cpu for level in levels) / sum(points[PLAIN, level].cpu for level in levels)

    def needed(goal):
        return f"{float(f'{(2 * scatter / goal) ** 2:.1g}'):.0f}"

    return CLOSING.format(scatter=share(scatter), per_cent=needed(0.01),
                          per_mille=needed(0.001),
                          coarse=share(scatter_of(points[PLAIN, "7 across"].values)), halved=share(moved(points, HALVED)),
                          moved=share(moved(points, RIGID)), finest=finest, ledger_full=ledger(PLAIN), ledger_half=ledger(HALVED),
                          mixed=share(moved(points, MIXED)), mixed_time=dearer(MIXED), rigid=dearer(RIGID), facets=dearer(EXACT), facets_error=share(against["facets"].judged(points[EXACT, finest]).error))
