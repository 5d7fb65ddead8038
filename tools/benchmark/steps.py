"""Rows that time steps, through demlua_bench."""
import json
import subprocess

from figures import Figure

# Their packs come from the store, as in the second run of a scene; a first run fills it.
IRREGULAR = ("facets", "cohesive")


def names(binaries):
    return subprocess.run([binaries / "demlua_bench", "--list"], check=True, stdout=subprocess.PIPE,
                          text=True).stdout.split()


def run(name, binaries, threads, seconds):
    done = subprocess.run(
        [binaries / "demlua_bench", name, "--threads", ",".join(map(str, threads)), "--seconds", str(seconds),
         "--packs", binaries.parent / "packs"], check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)


def floors(cost, rounds):
    """Seconds per element and step that moving the memory and doing the arithmetic would take at the rates of each round."""
    memory = [cost["bytes"] / rate for rate in rounds["bytes_per_second"]]
    # A multiply-add does two operations at best; divisions and roots are done by a unit of the same port.
    arithmetic = [0.5 * cost["operations"] / add + cost["divisions"] / division for add, division in
                  zip(rounds["multiply_adds_per_second"], rounds["divisions_per_second"])]
    return memory, arithmetic


def of_rounds(found, rounds, figure):
    elements = found["elements"]
    widest = [time / elements for time in rounds["widest"]]
    one = [time / elements for time in rounds["one_lane"]]
    memory, arithmetic = floors(found["cost"], rounds)
    floor = [max(pair) for pair in zip(memory, arithmetic)]

    def ns(times):
        return [1e9 * time for time in times]
    yield figure("element-step", "ns", ns(widest))
    yield figure("one lane", "ns", ns(one))
    yield figure("one lane over widest", "", [a / b for a, b in zip(one, widest)])
    yield figure("memory floor", "ns", ns(memory))
    yield figure("arithmetic floor", "ns", ns(arithmetic))
    yield figure("over floor", "", [a / b for a, b in zip(widest, floor)])
    yield figure("bandwidth", "GB/s", [1e-9 * rate for rate in rounds["bytes_per_second"]])
    yield figure("multiply-adds", "1e9/s", [1e-9 * rate for rate in rounds["multiply_adds_per_second"]])


def of_threads(found, figure):
    """How much faster each thread count is than the first, round by round."""
    first = found["rounds"][0]
    for rounds in found["rounds"][1:]:
        yield figure(rounds["threads"], "speed-up", "",
                     [a / b for a, b in zip(first["widest"], rounds["widest"])])
        yield figure(rounds["threads"], "processors", "",
                     [a / b for a, b in zip(rounds["multiply_adds_per_second"], first["multiply_adds_per_second"])])


def of_set_up(found, figure):
    for stage, seconds in found["set_up"].items():
        yield figure(1, stage.replace("_", " "), "s", [seconds])
    yield figure(1, "set-up", "s", [sum(found["set_up"].values())])
    yield figure(1, "memory held", "B/element", [found["bytes_per_element"]])
    for name in ("bytes", "footprint", "operations", "divisions"):
        yield figure(1, f"{name} counted", "1/element-step", [found["cost"][name]])
    for name in ("bonds", "touching", "broken"):
        yield figure(1, name, "", [found[name]])


def measured(name, binaries, threads, seconds):
    if name.startswith(IRREGULAR):
        run(name, binaries, [1], 0.001)
    found = run(name, binaries, threads, seconds)

    def figure(count, quantity, unit, samples):
        return Figure(name, found["what"], count, found["elements"], quantity, unit, samples)
    figures = []
    for rounds in found["rounds"]:
        figures += of_rounds(found, rounds, lambda *rest, count=rounds["threads"]: figure(count, *rest))
    return figures + list(of_threads(found, figure)) + list(of_set_up(found, figure))
