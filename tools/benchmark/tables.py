"""Figures as text and as CSV, beside the machine they were taken on."""
import csv
import json
import platform
import re
import shlex

# ns per element and step asked for, by row and threads; 1,000 elements on two threads shall be no slower than on one.
AIMS = {("bonded_1k", 1): 12, ("bonded_12k", 1): 12, ("bonded_12k", 2): 7, ("bonded_1m", 1): 16, ("bonded_1m", 2): 9,
        ("facets_12k", 1): 22, ("facets_12k", 2): 12, ("grains_12k", 1): 25, ("grains_12k", 2): 14,
        ("penetration", 1): 25, ("penetration", 2): 14}
SET_UP = ["assembly", "time step", "first forces", "set-up"]


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as lines:
        names = re.findall(r"^model name\s*:\s*(.*)$", lines.read(), re.MULTILINE)
    return f"{names[0] if names else platform.machine()}, {max(1, len(names))} processors"


def flags(build):
    """Flags of the file that holds the widest kernels, as it was compiled."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if entry["file"].endswith("step/lanes_8.cpp"):
            return " ".join(word for word in shlex.split(entry["command"]) if re.match(r"-(O|m|f|std)", word))
    return "unknown"


def compiler(build):
    for line in (build / "generated" / "demlua" / "version.hpp").read_text().splitlines():
        found = re.search(r'compiler = "(.*)"', line)
        if found:
            return found.group(1)
    return "unknown"


def machine(build, load):
    return {"processor": processor(), "compiler": compiler(build), "flags": flags(build),
            "system": f"{platform.system()} {platform.release()}", "load_before": f"{load:.2f}"}


def number(value):
    return "" if value is None else f"{value:.4g}"


def table(head, rows):
    """Columns padded so that it reads as text and as Markdown."""
    widths = [max(len(line[column]) for line in [head, *rows]) for column in range(len(head))]
    lines = ["| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths)) + " |" for line in [head, *rows]]
    lines.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return "\n".join(lines)


def look_up(figures, row, threads, quantity):
    return next((f for f in figures if (f.row, f.threads, f.quantity) == (row, threads, quantity)), None)


def median_of(figures, row, threads, quantity):
    found = look_up(figures, row, threads, quantity)
    return "" if found is None else number(found.median)


def step_table(figures):
    head = ["row", "threads", "elements", "median", "10 %", "least", "aim", "one lane", "one/widest", "memory", "arithmetic",
            "over floor", "speed-up", "processors"]
    rows = []
    for each in figures:
        if each.quantity != "element-step":
            continue
        rows.append([each.row, str(each.threads), str(each.elements), number(each.median), number(each.tenth),
                     number(each.least), number(AIMS.get((each.row, each.threads)))] +
                    [median_of(figures, each.row, each.threads, quantity) for quantity in
                     ("one lane", "one lane over widest", "memory floor", "arithmetic floor", "over floor", "speed-up",
                      "processors")])
    return table(head, rows) if rows else ""


def set_up_table(figures):
    rows = [[each.row, str(each.elements)] + [median_of(figures, each.row, 1, stage) for stage in SET_UP] +
            [median_of(figures, each.row, 1, "memory held"), median_of(figures, each.row, 1, "footprint counted")]
            for each in figures if each.quantity == "set-up"]
    return table(["row", "elements", "assembly s", "time step s", "first forces s", "together s", "memory B/element",
                  "touched B/element"], rows) if rows else ""


def program_table(figures):
    rows = [[each.row, str(each.threads), str(each.elements), each.quantity, number(each.median), number(each.least),
             each.unit] for each in figures if each.quantity.startswith(("start to", "writer", "run"))]
    return table(["row", "threads", "elements", "quantity", "median", "least", "unit"], rows) if rows else ""


def peer_table(figures):
    """The four figures of a comparison stand one after the other."""
    rows = []
    for at, each in enumerate(figures):
        if each.quantity == "peer":
            own, ratio, apart = figures[at + 1:at + 4]
            rows.append([each.row, each.what, number(each.median), number(each.least), number(own.median),
                         number(own.least), number(ratio.median), f"{apart.quantity} {apart.median:.1e} {apart.unit}"])
    return table(["row", "program", "median", "least", "demlua beside it", "least", "ratio", "same physics"],
                 rows) if rows else ""


def text(figures, about):
    parts = ["\n".join(f"{key}: {value}" for key, value in about.items())]
    for title, body in (("ns per element and step", step_table(figures)),
                        ("From the scene to the first step, and memory held then", set_up_table(figures)),
                        ("The program as a whole", program_table(figures)),
                        ("Other programs, one thread, ns per element and step", peer_table(figures))):
        if body:
            parts.append(f"{title}\n\n{body}")
    return "\n\n".join(parts)


def write_csv(path, figures, about):
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow(["row", "what", "threads", "elements", "quantity", "unit", "median", "tenth", "least", "samples",
                      *about])
        for each in figures:
            out.writerow([each.row, each.what, each.threads, each.elements, each.quantity, each.unit,
                          *(f"{value:.6g}" for value in (each.median, each.tenth, each.least)), len(each.samples),
                          *about.values()])
