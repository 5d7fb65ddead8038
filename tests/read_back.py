#!/usr/bin/env python3
"""Runs a small scene and reads what it wrote with VTK: counts, fields, times, all series, a picture of its cracks.

Exit code 77 (skipped) where there is no VTK for this interpreter.
"""
import csv
import json
import math
import os
import subprocess
import sys
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    print("skipped: no VTK for this python3 (python3-vtk9)")
    sys.exit(77)

DEMLUA = os.environ["DEMLUA"]
SOURCE = os.environ["DEMLUA_SOURCE_DIR"]
SCENE = os.path.join(SOURCE, "scenarios", "tension_test.lua")
FOLDER = "run"
VTK_VERTEX, VTK_LINE = 1, 3
# Fields that every bonded scene has, with their components as VTK has them (plane vectors get a z).
ELEMENT_FIELDS = {"id": 1, "radius": 1, "body": 1, "velocity": 3, "speed": 1, "force": 3, "stress": 3}
BOND_FIELDS = {"force": 1, "shear_force": 1, "stretch": 1}
CRACK_FIELDS = {"time": 1, "step": 1, "mode": 1, "energy": 1, "i": 1, "j": 1, "cluster": 1}

failures = []


def check(holds, what):
    if not holds:
        failures.append(what)


def read(file):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    check(reader.GetErrorCode() == 0, f"{file}: VTK reports error {reader.GetErrorCode()}")
    return reader.GetOutput()


def pvd(folder, name):
    index = xml.parse(os.path.join(folder, name + ".pvd"))
    return [(d.get("file"), float(d.get("timestep"))) for d in index.iter("DataSet")]


def series(folder, name):
    with open(os.path.join(folder, name + ".vtu.series"), encoding="utf-8") as handle:
        return [(entry["name"], entry["time"]) for entry in json.load(handle)["files"]]


def check_fields(where, data, rows, expected):
    for name, components in expected.items():
        array = data.GetArray(name)
        if array is None:
            failures.append(f"{where}: field {name} is missing")
            continue
        check(array.GetNumberOfComponents() == components, f"{where}: {name} has {array.GetNumberOfComponents()} components")
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        check(array.GetNumberOfTuples() == rows, f"{where}: {array.GetName()} has {array.GetNumberOfTuples()} rows")


def check_elements(where, grid, summary):
    count = summary["elements"]
    check(grid.GetNumberOfPoints() == count, f"{where}: {grid.GetNumberOfPoints()} points for {count} elements")
    check(grid.GetNumberOfCells() == count, f"{where}: {grid.GetNumberOfCells()} cells for {count} elements")
    check(all(grid.GetCellType(k) == VTK_VERTEX for k in range(count)), f"{where}: cells that are no vertices")
    data = grid.GetPointData()
    check_fields(where, data, count, ELEMENT_FIELDS)
    if failures:
        return
    check([data.GetArray("id").GetValue(k) for k in range(count)] == list(range(count)), f"{where}: ids out of order")
    check(data.GetArray("radius").GetRange()[0] > 0.0, f"{where}: radii that are not positive")
    velocity, speed, stress = data.GetArray("velocity"), data.GetArray("speed"), data.GetArray("stress")
    check([stress.GetComponentName(c) for c in range(3)] == ["xx", "yy", "xy"], f"{where}: stress components unnamed")
    for k in range(count):
        vx, vy, vz = velocity.GetTuple3(k)
        check(vz == 0.0 and math.isclose(math.hypot(vx, vy), speed.GetValue(k), rel_tol=1e-12, abs_tol=1e-300),
              f"{where}: velocity and speed of element {k} differ")


def check_bonds(where, grid, summary):
    count = summary["bonds"]
    check(grid.GetNumberOfCells() == count, f"{where}: {grid.GetNumberOfCells()} cells for {count} bonds")
    check(grid.GetNumberOfPoints() == summary["elements"], f"{where}: {grid.GetNumberOfPoints()} points")
    check_fields(where, grid.GetCellData(), count, BOND_FIELDS)
    for k in range(grid.GetNumberOfCells()):
        ends = grid.GetCell(k).GetPointIds()
        check(grid.GetCellType(k) == VTK_LINE and ends.GetId(0) != ends.GetId(1), f"{where}: bond {k} is no line")


def values(data, name):
    array = data.GetArray(name)
    return [array.GetValue(k) for k in range(array.GetNumberOfTuples())]


def history_at(time):
    with open(os.path.join(FOLDER, "history.csv"), encoding="utf-8") as handle:
        rows = list(csv.DictReader(handle))
    return min(rows, key=lambda row: abs(float(row["time"]) - time))


def check_cracks(where, grid, summary):
    """Frames fall on rows of the history, which tells how many cracks there are, how long and at what cost."""
    now = grid.GetFieldData().GetArray("TimeValue").GetValue(0)
    row = history_at(now)
    count = int(float(row["broken_bonds"]))
    check(grid.GetNumberOfCells() == count, f"{where}: {grid.GetNumberOfCells()} cells for {count} broken bonds")
    check(grid.GetNumberOfPoints() == 2 * count, f"{where}: {grid.GetNumberOfPoints()} points")
    check_fields(where, grid.GetCellData(), count, CRACK_FIELDS)
    if failures or count == 0:
        return
    field = {name: values(grid.GetCellData(), name) for name in CRACK_FIELDS}
    length = 0.0
    for k in range(count):
        (x0, y0, _), (x1, y1, _) = (grid.GetPoint(grid.GetCell(k).GetPointId(end)) for end in (0, 1))
        check(grid.GetCellType(k) == VTK_LINE, f"{where}: crack {k} is no line")
        length += math.hypot(x1 - x0, y1 - y0)
    check(math.isclose(length, float(row["crack_length"]), rel_tol=1e-9), f"{where}: cracks are {length} m long")
    check(math.isclose(sum(field["energy"]), float(row["surface_energy"]), rel_tol=1e-9), f"{where}: energies differ")
    check(field["time"] == sorted(field["time"]) and field["time"][-1] <= now, f"{where}: times {field['time'][:3]}")
    check(set(field["mode"]) <= {0, 1}, f"{where}: modes {set(field['mode'])} without a notch")
    check(all(i < j < summary["elements"] for i, j in zip(field["i"], field["j"])), f"{where}: ids out of order")
    check(all(c <= k for k, c in enumerate(field["cluster"])), f"{where}: a crack older than its first break")


def check_picture():
    """Tension breaks this strip: a sheet of its cracks by mode shows red, and black only where letters are."""
    file = "cracks.png"
    subprocess.run([os.path.join(SOURCE, "tools", "render"), FOLDER, "--times", "1", "--cracks", "mode", "--size", "200x400",
                    "-o", file], check=True, stdout=subprocess.DEVNULL)
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    check(image.GetDimensions()[0] == 200, f"{file} is {image.GetDimensions()[0]} pixels wide")
    pixels = bytes(memoryview(image.GetPointData().GetScalars()))
    red = sum(1 for k in range(0, len(pixels), 3) if pixels[k] > 180 and pixels[k + 1] < 80 and pixels[k + 2] < 80)
    check(red > 100, f"{file} shows {red} pixels of cracks")


def check_series(folder, name, summary, check_grid):
    frames = pvd(folder, name)
    check(frames == series(folder, name), f"{name}: the two indexes differ")
    check(len(frames) == summary["frames"], f"{name}: {len(frames)} frames indexed, {summary['frames']} written")
    times = [time for _, time in frames]
    check(times == sorted(set(times)), f"{name}: times do not rise")
    check(times and times[0] == 0.0 and times[-1] == summary["time"], f"{name}: times {times[:1]} to {times[-1:]}")
    for file, time in frames:
        grid = read(os.path.join(folder, file))
        stamp = grid.GetFieldData().GetArray("TimeValue")
        check(stamp is not None and stamp.GetValue(0) == time, f"{file}: TimeValue is not {time}")
        check_grid(file, grid, summary)


def main():
    folder = FOLDER
    subprocess.run([DEMLUA, SCENE, "-o", folder, "--quiet", "--overwrite"], check=True)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as handle:
        summary = json.load(handle)
    check(summary["ending"]["state"] in ("finished", "stopped"), f"the run ended as {summary['ending']}")
    check_series(folder, "elements", summary, check_elements)
    check_series(folder, "bonds", summary, check_bonds)
    check_series(folder, "cracks", summary, check_cracks)
    check_picture()
    for line in failures[:20]:
        print(line)
    print(f"{summary['frames']} frames, {summary['elements']} elements, {summary['bonds']} bonds read back")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
