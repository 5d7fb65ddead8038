#!/usr/bin/env python3
"""Makes a picture of a run: elements at their true radius, cracks as lines, several instants on one sheet.

Cracks are black and move with the elements beside them, as long as these are neighbours; with --cracks they are shown where
they arose, and their colour tells when, how, at what cost, or which belong together.

Needs VTK's Python module to read the files and write the picture, and no display: the disks are few and plain enough to
be filled row by row here. Run it as tools/render, which finds the right interpreter.
"""
import argparse
import math
import os
import sys
import xml.etree.ElementTree as xml

from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (gives vtkTextRenderer its fonts)

FINENESS = 2  # pixels drawn per pixel shown, along each side, so that edges come out smooth
BACKGROUND = (255, 255, 255)
BODIES = [(208, 208, 204), (70, 116, 166), (190, 140, 90), (120, 160, 110), (150, 120, 165), (200, 175, 95)]
SCALE = [(68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37)]  # dark to light, even in brightness
PALE = (232, 232, 230)  # of bodies under coloured cracks
MODES = [(200, 30, 40), (30, 90, 200), (0, 0, 0), (20, 140, 60)]  # tension, shear, notch, wear
MODE_WORDS = "tension red, shear blue, notch black, wear green"
WALL = (60, 60, 60)
CLUSTERS = [(200, 30, 40), (30, 90, 200), (20, 140, 60), (230, 140, 0), (130, 50, 160), (0, 150, 170), (120, 80, 40)]
COLOURED_BY = ("time", "mode", "energy", "cluster")
CRACK = (0, 0, 0)
BROKEN = 2  # value of the bond field "state"
NEAR = 1.3  # a broken bond shows as a crack while its elements are nearer than this times the sum of their radii
GAP = 12  # pixels between pictures
CAPTION = 26  # pixels
SHEET = 1200  # pixels across, unless told otherwise


class Fault(Exception):
    """Something the user can put right."""


# ---- reading -----------------------------------------------------------------------------------------------------


def series(folder, name):
    """[(time, file)] of an index; empty when there is none."""
    index = os.path.join(folder, name + ".pvd")
    if not os.path.isfile(index):
        return []
    return [(float(d.get("timestep")), os.path.join(folder, d.get("file"))) for d in xml.parse(index).iter("DataSet")]


def numbers(array):
    """A VTK array as a list, of lists where it has several components."""
    return memoryview(array).tolist()


def read(file):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


class Frame:
    """One instant: elements, walls as (x0, y0, x1, y1), and cracks as (x0, y0, x1, y1, value).

    They are those on record with the field `by` as their value; else broken bonds that still lie between neighbours."""

    def __init__(self, time, elements_file, bonds_file, cracks_file=None, walls_file=None, by=None):
        self.time = time
        grid = read(elements_file)
        self.data = grid.GetPointData()
        self.centres = [(p[0], p[1]) for p in numbers(grid.GetPoints().GetData())]
        self.radii = self.values("radius")
        if by:
            self.cracks = self.recorded_cracks(read(cracks_file), by) if cracks_file else []
        else:
            self.cracks = self.find_cracks(read(bonds_file)) if bonds_file else []
        self.walls = self.segments(read(walls_file)) if walls_file else []

    def values(self, name):
        """One number for each element: a field, a component of it by suffix (_x, _yy), or a vector's length."""
        array = self.data.GetArray(name)
        if array is not None:
            rows = numbers(array)
            return [math.hypot(*row) for row in rows] if array.GetNumberOfComponents() > 1 else rows
        stem, _, suffix = name.rpartition("_")
        array = self.data.GetArray(stem) if stem else None
        if array is not None:
            for c in range(array.GetNumberOfComponents()):
                if array.GetComponentName(c) == suffix:
                    return [row[c] for row in numbers(array)]
        known = ", ".join(self.data.GetArrayName(k) for k in range(self.data.GetNumberOfArrays()))
        raise Fault(f"no field {name}; there are {known}")

    @staticmethod
    def segments(grid):
        if grid.GetNumberOfCells() == 0:
            return []
        points = numbers(grid.GetPoints().GetData())
        ends = numbers(grid.GetCells().GetConnectivityArray())
        first = numbers(grid.GetCells().GetOffsetsArray())
        return [(*points[ends[k]][:2], *points[ends[k + 1]][:2])
                for begin, end in zip(first, first[1:]) for k in range(begin, end - 1)]

    @staticmethod
    def recorded_cracks(grid, by):
        if grid.GetNumberOfCells() == 0:
            return []
        points = numbers(grid.GetPoints().GetData())
        values = numbers(grid.GetCellData().GetArray(by))
        return [(*points[2 * k][:2], *points[2 * k + 1][:2], value) for k, value in enumerate(values)]

    def find_cracks(self, bonds):
        state = bonds.GetCellData().GetArray("state")
        if state is None:
            return []
        ends = numbers(bonds.GetCells().GetConnectivityArray())
        cracks = []
        for k, value in enumerate(numbers(state)):
            if value != BROKEN:
                continue
            i, j = ends[2 * k], ends[2 * k + 1]
            (xi, yi), (xj, yj) = self.centres[i], self.centres[j]
            distance = math.hypot(xj - xi, yj - yi)
            if 0.0 < distance < NEAR * (self.radii[i] + self.radii[j]):
                half = min(self.radii[i], self.radii[j]) / distance
                x, y, dx, dy = (xi + xj) / 2, (yi + yj) / 2, -half * (yj - yi), half * (xj - xi)
                cracks.append((x - dx, y - dy, x + dx, y + dy, None))
        return cracks

    def bounds(self):
        disks = list(zip(self.centres, self.radii))
        return (min(x - r for (x, _), r in disks), min(y - r for (_, y), r in disks),
                max(x + r for (x, _), r in disks), max(y + r for (_, y), r in disks))


def choose(frames, wanted):
    """The frames nearest to the wanted times; without any, four spread over the run."""
    if not wanted:
        count = min(4, len(frames))
        picks = [round(k * (len(frames) - 1) / max(count - 1, 1)) for k in range(count)]
    else:
        picks = [min(range(len(frames)), key=lambda k: abs(frames[k][0] - time)) for time in wanted]
    return picks


def load(folder, wanted, by):
    elements = series(folder, "elements")
    if not elements:
        raise Fault(f"{folder} holds no run: elements.pvd is missing or empty")
    bonds, cracks, walls = (dict(series(folder, name)) for name in ("bonds", "cracks", "walls"))
    if by and not cracks:
        raise Fault(f"{folder} holds no cracks: cracks.pvd is missing, no bond of the scene can break")
    return [Frame(time, file, bonds.get(time), cracks.get(time), walls.get(time), by)
            for time, file in (elements[k] for k in choose(elements, wanted))]


def view(frames):
    """What to show: all elements, but no farther from where the first frame has them than half its smaller side."""
    boxes = [frame.bounds() for frame in frames]
    x0, y0, x1, y1 = boxes[0]
    room = 0.5 * min(x1 - x0, y1 - y0)
    box = [max(min(b[0] for b in boxes), x0 - room), max(min(b[1] for b in boxes), y0 - room),
           min(max(b[2] for b in boxes), x1 + room), min(max(b[3] for b in boxes), y1 + room)]
    margin = 0.01 * max(box[2] - box[0], box[3] - box[1])
    return box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin


# ---- drawing -----------------------------------------------------------------------------------------------------


class Canvas:
    """Rows of red, green, blue from the bottom up, as VTK has them."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.bytes = bytearray(bytes(BACKGROUND) * (width * height))

    def row(self, y, x0, x1, colour):
        """Pixels x0 to x1 (not included) of row y, as far as they are on the canvas."""
        x0, x1 = max(x0, 0), min(x1, self.width)
        if 0 <= y < self.height and x0 < x1:
            begin = 3 * (y * self.width + x0)
            self.bytes[begin:begin + 3 * (x1 - x0)] = colour * (x1 - x0)

    def disk(self, x, y, radius, colour):
        for row in range(math.ceil(y - radius - 0.5), math.floor(y + radius - 0.5) + 1):
            half = math.sqrt(max(radius * radius - (row + 0.5 - y) ** 2, 0.0))
            self.row(row, round(x - half), round(x + half), colour)

    def line(self, x0, y0, x1, y1, width, colour):
        steps = max(int(math.hypot(x1 - x0, y1 - y0)), 1)
        for k in range(steps + 1):
            self.disk(x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps, width / 2, colour)

    def paste(self, image, x, y):
        """Puts an image of red, green, blue(, alpha) with its lower left corner at x, y."""
        wide, high, _ = image.GetDimensions()
        pixels = memoryview(image.GetPointData().GetScalars())
        channels = image.GetPointData().GetScalars().GetNumberOfComponents()
        flat = pixels.tobytes()
        for row in range(min(high, self.height - y)):
            begin = 3 * ((y + row) * self.width + x)
            if channels == 3:
                self.bytes[begin:begin + 3 * wide] = flat[3 * wide * row:3 * wide * (row + 1)]
                continue
            for column in range(min(wide, self.width - x)):
                *ink, alpha = flat[4 * (row * wide + column):4 * (row * wide + column) + 4]
                at = begin + 3 * column
                for c in range(3):
                    self.bytes[at + c] = (ink[c] * alpha + self.bytes[at + c] * (255 - alpha)) // 255

    def image(self):
        array = vtkUnsignedCharArray()
        array.SetNumberOfComponents(3)
        array.SetArray(self.bytes, len(self.bytes), 1)
        image = vtkImageData()
        image.SetDimensions(self.width, self.height, 1)
        image.GetPointData().SetScalars(array)
        return image


def darker(colour):
    return bytes(int(0.72 * c) for c in colour)


def on_scale(share):
    share = min(max(share, 0.0), 1.0) * (len(SCALE) - 1)
    k = min(int(share), len(SCALE) - 2)
    return bytes(round(a + (share - k) * (b - a)) for a, b in zip(SCALE[k], SCALE[k + 1]))


def crack_inks(frame, by, limits):
    values = [value for *_, value in frame.cracks]
    if by == "mode":
        return [bytes(MODES[value]) for value in values]
    if by == "cluster":
        return [bytes(CLUSTERS[value % len(CLUSTERS)]) for value in values]
    if by:
        return [on_scale((value - limits[0]) / (limits[1] - limits[0] or 1.0)) for value in values]
    return [bytes(CRACK)] * len(values)


def crack_limits(frames, by):
    """Least and greatest value of the cracks of all frames, for those coloured on a scale."""
    values = [value for frame in frames for *_, value in frame.cracks] if by in ("time", "energy") else []
    return [min(values, default=0.0), max(values, default=0.0)]


def crack_words(by, limits):
    if by == "mode":
        return f"    cracks: {MODE_WORDS}"
    if by == "cluster":
        return "    cracks: a colour for each"
    return f"    cracks by {by}: {limits[0]:.4g} (dark) to {limits[1]:.4g} (light)" if by else ""


def colours(frame, field, limits, pale):
    if field is None and pale:
        return [bytes(PALE)] * len(frame.centres)
    if field is None:
        return [bytes(BODIES[int(body) % len(BODIES)]) for body in frame.values("body")]
    low, high = limits
    width = high - low or 1.0
    return [on_scale((value - low) / width) for value in frame.values(field)]


def clipped(segment, box):
    """The part of a segment inside a box (x0, y0, x1, y1), or None."""
    x0, y0, x1, y1 = segment
    begin, end = 0.0, 1.0
    for start, way, low, high in ((x0, x1 - x0, box[0], box[2]), (y0, y1 - y0, box[1], box[3])):
        if way == 0.0:
            if not low <= start <= high:
                return None
            continue
        enters, leaves = sorted(((low - start) / way, (high - start) / way))
        begin, end = max(begin, enters), min(end, leaves)
    if begin > end:
        return None
    return (x0 + begin * (x1 - x0), y0 + begin * (y1 - y0), x0 + end * (x1 - x0), y0 + end * (y1 - y0))


def draw(frame, box, width, height, inks, lines, thickness):
    canvas = Canvas(FINENESS * width, FINENESS * height)
    scale = min(canvas.width / (box[2] - box[0]), canvas.height / (box[3] - box[1]))
    left = box[0] - (canvas.width / scale - (box[2] - box[0])) / 2
    low = box[1] - (canvas.height / scale - (box[3] - box[1])) / 2
    for (x, y), radius, ink in zip(frame.centres, frame.radii, inks):
        px, py, pr = (x - left) * scale, (y - low) * scale, radius * scale
        # An edge tells one disk from the next where there are pixels for it.
        if pr >= 3.0:
            canvas.disk(px, py, pr, darker(ink))
            pr -= 0.5 * FINENESS
        canvas.disk(px, py, max(pr, 0.5), ink)
    strokes = [(*part, 1.2, bytes(WALL)) for part in (clipped(wall, box) for wall in frame.walls) if part]
    strokes += [(x0, y0, x1, y1, thickness, ink) for (x0, y0, x1, y1, _), ink in zip(frame.cracks, lines)]
    for x0, y0, x1, y1, wide, ink in strokes:
        canvas.line((x0 - left) * scale, (y0 - low) * scale, (x1 - left) * scale, (y1 - low) * scale, wide * FINENESS, ink)
    shrink = vtkImageShrink3D()
    source = canvas.image()
    shrink.SetInputData(source)
    shrink.SetShrinkFactors(FINENESS, FINENESS, 1)
    shrink.MeanOn()
    shrink.Update()
    return shrink.GetOutput()


def caption(text):
    style = vtkTextProperty()
    style.SetFontSize(17)
    style.SetColor(0.1, 0.1, 0.1)
    image = vtkImageData()
    if not vtkTextRenderer.GetInstance().RenderString(style, text, image, [0, 0], 96):
        raise Fault("VTK cannot draw text")
    return image


def time_text(time, longest):
    unit, factor = next(((u, f) for u, f in (("s", 1.0), ("ms", 1e3), ("us", 1e6)) if longest * f >= 1.0), ("us", 1e6))
    return f"{time * factor:.3g} {unit}"


def sheet(frames, field, limits, by, box, size):
    """The frames, each under its time: one below another, or side by side when what they show is higher than wide."""
    across = len(frames) if box[3] - box[1] > box[2] - box[0] else 1
    down = len(frames) // across
    width = size[0] or max((SHEET + GAP) // across - GAP, 1)
    height = size[1] or max(round(width * (box[3] - box[1]) / (box[2] - box[0])), 1)
    canvas = Canvas(across * (width + GAP) - GAP, down * (height + CAPTION + GAP) - GAP)
    longest = max(frame.time for frame in frames)
    of_cracks = crack_limits(frames, by)
    for k, frame in enumerate(frames):
        left = k % across * (width + GAP)
        top = canvas.height - k // across * (height + CAPTION + GAP)
        text = time_text(frame.time, longest)
        if field:
            text += f"    {field}: {limits[0]:.4g} (dark) to {limits[1]:.4g} (light)"
        text += crack_words(by, of_cracks)
        canvas.paste(caption(text), left + 8, top - CAPTION)
        picture = draw(frame, box, width, height, colours(frame, field, limits, by is not None),
                       crack_inks(frame, by, of_cracks), 1.6 if by else 0.8)
        canvas.paste(picture, left, top - CAPTION - height)
    return canvas


def write(canvas, file):
    writer = vtkPNGWriter()
    source = canvas.image()
    writer.SetInputData(source)
    writer.SetFileName(file)
    writer.Write()
    if writer.GetErrorCode() != 0 or not os.path.isfile(file):
        raise Fault(f"{file} cannot be written")


# ---- command line ------------------------------------------------------------------------------------------------


def separated(text, separator, kind):
    return [kind(part) for part in text.split(separator)] if text else []


def options():
    parser = argparse.ArgumentParser(prog="render", description=__doc__.split("\n")[0])
    parser.add_argument("folder", metavar="DIR", help="folder that a run has written")
    parser.add_argument("--times", default="", help="instants in seconds, e.g. 0,1e-3,6e-3; else four over the run")
    parser.add_argument("--field", help="colour by an element field (stress_xx, speed, ...) instead of by body")
    parser.add_argument("--range", default="", metavar="LOW,HIGH", help="of the field; else from least to greatest")
    parser.add_argument("--cracks", choices=COLOURED_BY, metavar="FIELD",
                        help="show cracks where they arose, coloured by " + ", ".join(COLOURED_BY))
    parser.add_argument("--view", default="", metavar="X0,Y0,X1,Y1", help="part of the plane to show, in metres")
    parser.add_argument("--size", default="", metavar="WxH",
                        help="pixels of each picture; W alone fits H; else what makes a sheet 1200 wide")
    parser.add_argument("-o", dest="file", help="the PNG to write; else render.png in DIR")
    given = parser.parse_args()
    try:
        given.times = separated(given.times, ",", float)
        given.range = separated(given.range, ",", float)
        given.view = separated(given.view, ",", float)
        given.size = (separated(given.size, "x", int) + [0, 0])[:2]
    except ValueError as error:
        parser.error(str(error))
    if len(given.range) not in (0, 2) or len(given.view) not in (0, 4) or min(given.size) < 0:
        parser.error("--range takes two numbers, --view four, --size positive ones")
    return given


def main():
    given = options()
    try:
        frames = load(given.folder, given.times, given.cracks)
        limits = given.range
        if given.field and not limits:
            values = [value for frame in frames for value in frame.values(given.field)]
            limits = [min(values), max(values)]
        file = given.file or os.path.join(given.folder, "render.png")
        box = given.view or view(frames)
        write(sheet(frames, given.field, limits, given.cracks, box, given.size), file)
        print(file)
    except Fault as fault:
        print(f"render: {fault}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
