"""What tools/work_precision makes of points: tables, the cheapest settings, pictures."""
import dataclasses

import work_picture

GOALS = (0.05, 0.01, 0.001)


@dataclasses.dataclass
class Judged:
    """A point and how far it is off, as a share; no error below `floor` is told. `shown` are the cells of its row."""
    point: object
    error: float
    floor: float
    shown: list

    @property
    def bound(self):
        return max(self.error, self.floor)

    @property
    def told(self):
        return f"below {share(self.floor)}" if self.error <= self.floor else share(self.error)


@dataclasses.dataclass
class Section:
    """One picture with its points. `headings` are those of Judged.shown; without them the points stand in another section."""
    title: str
    text: str
    picture: str
    headings: list
    judged: list


def share(value):
    return f"{100 * value:.2g} %"


def signed(value, floor=0.0):
    return f"below {share(floor)}" if abs(value) <= floor else f"{100 * value:+.2g} %"


def seconds(value):
    return f"{value:.3g} s"


def curves_of(judged):
    curves = {}
    for one in judged:
        curves.setdefault(one.point.curve, []).append(one)
    return curves


def cheapest(judged, goal):
    """The point of least CPU time from which on all of its curve are within the goal; None if there is none."""
    good = []
    for curve in curves_of(judged).values():
        for one in reversed(curve):
            if one.bound > goal:
                break
            good.append(one)
    return min(good, key=lambda one: one.point.cpu, default=None)


def cheapest_row(judged, goal):
    one = cheapest(judged, goal)
    if one:
        at = one.point
        return f"| {100 * goal:g} % | {at.curve} | {at.level} | {at.elements} | {at.steps} | {one.told} | {seconds(at.cpu)} | {seconds(at.wall)} |"
    floor = min(one.floor for one in judged)
    why = f"cannot be told: the reference is known to {share(floor)}" if floor > goal else "none of these"
    return f"| {100 * goal:g} % | {why} | | | | | | |"


def row(one):
    at = one.point
    return f"| {at.curve} | {at.level} | {at.elements} | {at.steps} | " + " | ".join(one.shown) + f" | {seconds(at.cpu)} | {seconds(at.wall)} |"


def lines_of(section):
    """The section in Markdown."""
    lines = [f"### {section.title}", "", section.text, "", f"![error against CPU time]({section.picture})", "",
             "| error at most | method | setting | elements | steps | error | CPU | wall |", "|---" * 8 + "|",
             *(cheapest_row(section.judged, goal) for goal in GOALS), ""]
    if section.headings:
        headings = ["method", "setting", "elements", "steps", *section.headings, "CPU", "wall"]
        lines += ["| " + " | ".join(headings) + " |", "|---" * len(headings) + "|", *(row(one) for one in section.judged), ""]
    return lines


def drawn(title, section):
    curves = {name: [(one.point.cpu, one.bound, one.error <= one.floor) for one in curve]
              for name, curve in curves_of(section.judged).items()}
    return work_picture.picture(f"{title}: {section.title[0].lower()}{section.title[1:]}", curves, GOALS)
