"""tools/work_precision: limits and cheapest settings by hand, and the page in docs as its tool writes it from the figures kept."""
import os
import pathlib
import runpy
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(os.environ["DEMLUA_SOURCE_DIR"])
sys.path.insert(0, str(ROOT / "tools"))

import work_edge_crack  # noqa: E402
import work_page  # noqa: E402
import work_picture  # noqa: E402
from work_runs import Point, kept  # noqa: E402


def judged(curve, cpu, error, floor=0.0):
    return work_page.Judged(Point(curve, str(cpu), 1, 1, cpu, cpu, []), error, floor, [])


def limits():
    # 2 + 3 h^1.5 at 1, 1/2, 1/4; 5 + 0.3^k at k = 1, 2, 3.
    order, limit = work_edge_crack.richardson(*(2 + 3 * h ** 1.5 for h in (1, 0.5, 0.25)))
    yield "order", abs(order - 1.5) < 1e-12
    yield "limit of small elements", abs(limit - 2) < 1e-12
    yield "limit of slow pulls", abs(work_edge_crack.slowest(5.3, 5.09, 5.027) - 5) < 1e-12


def cheapest():
    lucky = [judged("a", 1, 0.04), judged("a", 2, 0.06), judged("a", 3, 0.005), judged("b", 4, 0.005)]
    yield "a finer point beyond the goal spoils the coarser", work_page.cheapest(lucky, 0.05) is lucky[2]
    yield "the least CPU time wins", work_page.cheapest(lucky, 0.01) is lucky[2]
    yield "none", work_page.cheapest(lucky, 0.001) is None and "none of these" in work_page.cheapest_row(lucky, 0.001)
    vague = [judged("a", 1, 0.0001, 0.02)]
    yield "no error below what the reference is known to", work_page.cheapest(vague, 0.01) is None
    yield "said so", "cannot be told" in work_page.cheapest_row(vague, 0.01) and vague[0].told == "below 2 %"


def written():
    tool = runpy.run_path(str(ROOT / "tools" / "work_precision"), run_name="tool")
    text, pictures = tool["page"](kept(tool["FIGURES"]))
    yield "the page", text == tool["PAGE"].read_text(encoding="utf-8")
    for name, picture in pictures.items():
        yield name, picture == (tool["PAGE"].parent / name).read_text(encoding="utf-8")


def drawn():
    picture = work_picture.picture("one & <two>", {"a": [(0.1, 0.05, False), (100.0, 0.0005, True)]}, (0.01,))
    marks = xml.etree.ElementTree.fromstring(picture).findall("{http://www.w3.org/2000/svg}circle")
    yield "two marks and that of the legend", len(marks) == 3
    # Three decades of CPU time and of error: the marks are at opposite corners but for log10(5) and log10(20).
    yield "along", abs(float(marks[1].get("cx")) - float(marks[0].get("cx")) - work_picture.FRAME) < 0.2
    yield "down", abs(float(marks[1].get("cy")) - float(marks[0].get("cy")) - work_picture.HEIGHT * 2 / 3) < 0.2


def main():
    wrong = [f"{group.__name__}: {what}" for group in (limits, cheapest, written, drawn) for what, right in group() if not right]
    print("\n".join(f"FAILED {what}" for what in wrong) or "work_precision: all right")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
