"""The cantilever of tools/work_precision: deflection at rest and amplitude when driven, against finite elements."""
import math
import statistics

from work_page import Judged, Section, share, signed
from work_runs import Curve, Level

NAME = "cantilever"
TITLE = "The cantilever"
BEND, SWING = "cantilever.lua", "cantilever_dynamic.lua"
FLOOR = 2.5e-5  # what the two meshes of finite elements differ by, docs/theory/references.md


def of_rows(*rows):
    return [Level(f"{n} rows", {"rows": n}, (None,), "always" if n < 27 else "full") for n in rows]


def of_elements(*counts, seeds=(1, 2, 3)):
    return [Level(f"{n} elements", {"count": n}, seeds, "always" if n < 2400 else "full") for n in counts]


def marching(periods, fraction, **more):
    return {"solver": "marching", "settle": periods, "step_fraction": fraction, **more}


PACK = {"packing": "irregular"}
CLOSE_PACKED, IRREGULAR = "direct solve, close-packed", "direct solve, irregular"
AT_REST = [
    Curve(CLOSE_PACKED, BEND, {}, of_rows(3, 9, 27)),
    Curve("direct solve, close-packed, against the slab the rows fill", BEND, {"height": "rows"}, of_rows(3, 9, 27)),
    Curve(IRREGULAR, BEND, PACK, of_elements(600, 1200, 2400, 9600)),
    Curve("marched 1.5 periods at 0.9 of the step, close-packed", BEND, marching(1.5, 0.9), of_rows(3, 9, 27)),
    Curve("marched 2 periods at 0.9 of the step, close-packed", BEND, marching(2, 0.9), of_rows(3, 9, 27)),
    Curve("marched 2 periods at 0.45 of the step, close-packed", BEND, marching(2, 0.45), of_rows(3, 9, 27)),
    Curve("marched 2 periods at 0.9 of the step, irregular", BEND, marching(2, 0.9, **PACK), of_elements(600, 1200, 2400, seeds=(1,))),
    Curve("marched 3 periods at 0.9 of the step, irregular", BEND, marching(3, 0.9, **PACK), of_elements(600, 1200, 2400, seeds=(1,))),
]
MIXED = {pack: f"mixed precision, 0.9 of the step, {pack}" for pack in ("close-packed", "irregular")}
DRIVEN = [
    Curve("0.9 of the step, close-packed", SWING, {"step_fraction": 0.9}, of_rows(3, 9, 15, 27)),
    Curve("0.5 of the step, close-packed", SWING, {"step_fraction": 0.5}, of_rows(3, 9, 15)),
    Curve("0.25 of the step, close-packed", SWING, {"step_fraction": 0.25}, of_rows(3, 9)),
    Curve(MIXED["close-packed"], SWING, {"step_fraction": 0.9, "precision": "mixed"}, of_rows(3, 9, 15)),
    Curve("0.9 of the step, irregular", SWING, {"step_fraction": 0.9, **PACK}, of_elements(600, 1200, 2400, seeds=(1,))),
    Curve(MIXED["irregular"], SWING, {"step_fraction": 0.9, "precision": "mixed", **PACK}, of_elements(600, 1200, 2400, seeds=(1,))),
    Curve("0.45 of the step, irregular", SWING, {"step_fraction": 0.45, **PACK}, of_elements(600, seeds=(1,))),
]
CURVES = AT_REST + DRIVEN

TEXT = """\
A slab 1.08 m long and 0.104 m deep, clamped at one end and loaded at the other ([cantilever.md](cantilever.md)). The
references are nine-node finite elements of the same slab, known to {floor}. Close-packed rows are compared with a slab as
stiff in bending as they are, once also with the slab they fill; irregular packs with the slab itself. Where several packs
were run, the error is the root mean square over them, the time that of one."""

REST = """\
*Direct* is `sim:solve_static`. *Marched* means the load put on at once and the motion damped critically, by mass, in the first
mode, for so many of its periods. What is then left of the motion is told by the direct solution of the same elements; picture and
first table add its size to that of the direct solution's error, so that one cannot make up for the other."""

SWUNG = """\
The load is a sine of a fifth of the slab's first frequency: one period while it sets in, one over which the amplitude is
read."""

CLOSING = """\
- **The step does not enter.** Results of one set of rows at different fractions of the critical step differ by less than
  {same} of themselves: at the frequencies of a structure the central difference has no error to speak of, for the step is
  bounded by the shortest waves. So the fraction may stand as near to one as stability allows.
- **Mixed precision** (`precision = "mixed"`: what a step reads of bonds is kept in single) moves the amplitude by {mixed} at
  most and takes {mixed_time} of the CPU time with close-packed rows, {mixed_irregular} in irregular packs. Double is the default: it is what everything else is
  tested in, and where a scene is small enough for the near memory, mixed gains little.
- **At rest, solve.** With 27 rows marching takes {ratio} times the CPU time of the direct solve and is less exact, as some of
  the motion is left. That is why `sim:solve_static` is there, and the scene uses it.
- **The pack.** An irregular pack with facets is within a tenth of a per cent from 1200 elements on. Close-packed rows need a
  correction for what their outer rows lack; without it they need more than a hundred rows for the same."""


def figures(_folder, summary):
    results = summary["results"]
    value = results.get("amplitude", results.get("compliance"))
    return {"value": value, "error": value / results["reference"] - 1}


def judged(points, point, solved):
    """`solved`: the curve that solves directly what this one marches to. Its error and what is left of the motion count
    without their signs, so that one cannot make up for the other."""
    errors = [values["error"] for values in point.values]
    error = math.sqrt(statistics.fmean(e * e for e in errors))
    told = signed(errors[0], FLOOR) if len(errors) == 1 else f"{share(error)} ({len(errors)} packs)"
    left = None
    if solved:
        direct = points[solved, point.level]
        left = point.values[0]["value"] / direct.values[0]["value"] - 1
        error = abs(left) + abs(direct.values[0]["error"])
    value = f"{statistics.fmean(v['value'] for v in point.values):.7g}"
    return Judged(point, error, FLOOR, [value, told] if solved is None else [value, told, signed(left) if solved else ""])


def chosen(points, curves, solved_by):
    return [judged(points, points[curve.name, level.label], solved_by(curve))
            for curve in curves for level in curve.levels if (curve.name, level.label) in points]


def at_rest_by(curve):
    if "solver" not in curve.settings:
        return ""
    return IRREGULAR if "packing" in curve.settings else CLOSE_PACKED


def sections(points):
    return [
        Section("At rest", REST, "speed_and_error_cantilever.svg",
                ["E t times deflection over load", "error", "left of the motion"],
                chosen(points, AT_REST, at_rest_by)),
        Section("Driven", SWUNG, "speed_and_error_cantilever_driven.svg",
                ["amplitude, m", "error"], chosen(points, DRIVEN, lambda curve: None)),
    ]


def apart(points):
    """The greatest relative difference of amplitudes of the same rows at different fractions of the step."""
    values = {}
    for curve in DRIVEN:
        for level in curve.levels:
            if (curve.name, level.label) in points and "rows" in level.settings and "precision" not in curve.settings:
                values.setdefault(level.label, []).append(points[curve.name, level.label].values[0]["value"])
    return max(max(found) / min(found) - 1 for found in values.values())


def mixed_against_double(points, pack):
    """The greatest relative change of an amplitude, and the share of the CPU time, on the levels that both have."""
    changes, mixed, double = [], 0.0, 0.0
    for (name, level), point in points.items():
        plain = points.get((f"0.9 of the step, {pack}", level))
        if name != MIXED[pack] or plain is None:
            continue
        changes.append(abs(point.values[0]["value"] / plain.values[0]["value"] - 1))
        mixed += point.cpu
        double += plain.cpu
    return max(changes), mixed / double


def closing(points):
    rows, irregular = (mixed_against_double(points, pack) for pack in MIXED)
    finest = [level.label for level in AT_REST[0].levels if (AT_REST[0].name, level.label) in points][-1]
    ratio = points[AT_REST[4].name, finest].cpu / points[AT_REST[0].name, finest].cpu
    return CLOSING.format(mixed=f"{max(rows[0], irregular[0]):.0e}", mixed_time=f"{rows[1]:.2f}", mixed_irregular=f"{irregular[1]:.2f}",
                          same=f"{max(apart(points), 1e-12):.0e}", ratio=f"{ratio:.0f}")


def introduction(_points):
    return TEXT.format(floor=share(FLOOR))
