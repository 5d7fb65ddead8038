#!/usr/bin/env python3
"""Verifies the layers of the program, and that no file names a path of some machine.

- A room includes only headers of its own and of rooms below it (ORDER; LIMITS narrows it further).
- Includes in quotes are written from the repository root.
- VTK is included in engine/output only, Lua nowhere in engine.

Prints file:line for each offence; exit code 1 if there was any.
"""
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# From the bottom up, as in engine/CMakeLists.txt.
ORDER = ["base", "law", "model", "packing", "bonding", "state", "step", "observe", "output", "study", "scripting"]
LIMITS = {"law": {"base"}, "study": {"base"}}
GENERATED = {"demlua/version.hpp": "base"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
VTK = re.compile(r"vtk", re.IGNORECASE)
LUA = re.compile(r"(lua|lauxlib|lualib|luaconf|sol)\d*(\.\d+)?(/|\.|$)")

# Directories below which every installation is different; /usr, /etc, /dev and the like may be named.
# What stands before the slash tells a path's beginning from its middle ("a/work/b", "$dir/tmp/").
MACHINE_PATH = re.compile(
    r"(?<![\w./}$)~>*-])/(?:home|root|Users|work|workspace|workspaces|mnt|media|srv|scratch|builds|tmp)/[\w.~-]"
    r"|\b[A-Za-z]:\\+Users\\"
)


def files():
    """The files of the tree, relative to its root: tracked ones and new ones git does not ignore."""
    try:
        listed = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=ROOT, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        ).stdout.decode().split("\0")
        names = {name for name in listed if name}
    except (OSError, subprocess.CalledProcessError):
        names = set()
        for folder, folders, found in os.walk(ROOT):
            folders[:] = [f for f in folders if f not in ("build", ".git") and not f.endswith(".out")]
            names.update(os.path.relpath(os.path.join(folder, f), ROOT) for f in found)
    return sorted(n for n in names if os.path.isfile(os.path.join(ROOT, n)))


def room_of(path):
    """The room a file belongs to; None outside the engine and the scripting layer."""
    if path in GENERATED:
        return GENERATED[path]
    parts = path.split("/")
    if parts[0] == "engine" and len(parts) > 2:
        return parts[1]
    return "scripting" if parts[0] == "scripting" else None


def allowed(room):
    """The rooms whose headers a file of this room may include."""
    return LIMITS.get(room, set(ORDER[: ORDER.index(room)])) | {room}


def offence(name, room, quoted, system):
    """What is wrong with an include in the file of that name, or None."""
    header = quoted or system
    if VTK.match(header) and room != "output":
        return "VTK is included in engine/output only"
    if LUA.match(header) and name.startswith("engine/"):
        return "no Lua in the engine"
    if quoted and quoted not in GENERATED and not os.path.isfile(os.path.join(ROOT, quoted)):
        return f'"{quoted}": not found; write it from the repository root'
    target = room_of(header)
    if room is None or target is None:
        if room is not None and header.startswith("tests/"):
            return f"{room} includes a header of the tests"
        return None
    if target not in ORDER:
        return f"unknown room {target}"
    if target not in allowed(room):
        return f"{room} may not include {target}"
    return None


def main():
    offences = []
    for name in files():
        with open(os.path.join(ROOT, name), "rb") as handle:
            data = handle.read()
        if b"\0" in data:
            continue
        code = name.endswith((".cpp", ".hpp", ".in"))
        room = room_of(name)
        if code and room is not None and room not in ORDER:
            offences.append(f"{name}:1: unknown room {room}: add it to tools/check_layers.py")
            continue
        for number, line in enumerate(data.decode("utf-8", "replace").splitlines(), 1):
            path = MACHINE_PATH.search(line)
            if path:
                offences.append(f"{name}:{number}: absolute path of a machine: {path.group().strip()}...")
            include = INCLUDE.match(line) if code else None
            if include:
                problem = offence(name, room, include.group(1), include.group(2))
                if problem:
                    offences.append(f"{name}:{number}: {problem}")
    for line in offences:
        print(line)
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
