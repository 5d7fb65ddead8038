#!/usr/bin/env python3
"""Runs a small scene and reads what it wrote with VTK: counts, fields, times, both series.

Exit code 77 (skipped) where there is no VTK for this interpreter.
"""
import json
import math
import os
import subprocess
import sys
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    print("skipped: no VTK for this python3 (python3-vtk9)")
    sys.exit(77)

DEMLUA = os.environ["DEMLUA"]
SCENE = os.path.join(os.environ["DEMLUA_SOURCE_DIR"], "scenarios", "tension_test.lua")
VTK_VERTEX, VTK_LINE = 1, 3
# Fields that every bonded scene has, with their components as VTK has them (plane vectors get a z).
ELEMENT_FIELDS = {"id": 1, "radius": 1, "body": 1, "velocity": 3, "speed": 1, "force": 3, "stress": 3}
BOND_FIELDS = {"force": 1, "shear_force": 1, "stretch": 1}

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
    folder = "run"
    subprocess.run([DEMLUA, SCENE, "-o", folder, "--quiet", "--overwrite"], check=True)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as handle:
        summary = json.load(handle)
    check(summary["ending"]["state"] in ("finished", "stopped"), f"the run ended as {summary['ending']}")
    check_series(folder, "elements", summary, check_elements)
    check_series(folder, "bonds", summary, check_bonds)
    for line in failures[:20]:
        print(line)
    print(f"{summary['frames']} frames, {summary['elements']} elements, {summary['bonds']} bonds read back")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
