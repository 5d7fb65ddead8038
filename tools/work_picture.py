"""The work-precision picture of tools/work_precision: error against CPU time, both logarithmic, as SVG that needs nothing else."""
import html
import math

WIDTH, LEFT, RIGHT, TOP, HEIGHT, BELOW, ENTRY = 760, 84, 20, 44, 400, 58, 20  # px
FRAME = WIDTH - LEFT - RIGHT
# Colours that stay apart for colour-blind readers and in print.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000", "#882255", "#808080"]


def decades(values):
    """Whole powers of ten that hold all values, as exponents."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return low, max(high, low + 1)


def text(x, y, anchor, words, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{html.escape(words)}</text>'


def line(x1, y1, x2, y2, style):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}/>'


def mark(x, y, shape, colour, hollow):
    style = f'fill="{"#ffffff" if hollow else colour}" stroke="{colour}"'
    r = 4.5
    if shape % 4 == 1:
        return f'<rect x="{x - r:.1f}" y="{y - r:.1f}" width="{2 * r}" height="{2 * r}" {style}/>'
    if shape % 4 == 0:
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" {style}/>'
    corners = [(0, -1.3), (-1.2, 1), (1.2, 1)] if shape % 4 == 2 else [(0, -1.4), (1.4, 0), (0, 1.4), (-1.4, 0)]
    return '<polygon points="' + " ".join(f"{x + a * r:.1f},{y + b * r:.1f}" for a, b in corners) + f'" {style}/>'


def axes(title, columns, lines, x, y):
    parts = [text(LEFT, 26, "start", title, ' font-size="15" font-weight="bold"')]
    for low, high, place, across in ((*columns, x, True), (*lines, y, False)):
        for exponent in range(low, high + 1):
            for digit in range(1, 10 if exponent < high else 2):
                at = place(digit * 10.0 ** exponent)
                style = 'stroke="#d8d8d8"' if digit == 1 else 'stroke="#f0f0f0"'
                parts.append(line(at, TOP, at, TOP + HEIGHT, style) if across else line(LEFT, at, LEFT + FRAME, at, style))
            label = f"{10.0 ** exponent:g}"
            at = place(10.0 ** exponent)
            parts.append(text(at, TOP + HEIGHT + 18, "middle", label) if across else text(LEFT - 8, at + 4, "end", label))
    parts.append(f'<rect x="{LEFT}" y="{TOP}" width="{FRAME}" height="{HEIGHT}" fill="none" stroke="#404040"/>')
    parts.append(text(LEFT + FRAME / 2, TOP + HEIGHT + 42, "middle", "CPU time, s"))
    middle = TOP + HEIGHT / 2
    parts.append(text(20, middle, "middle", "error, %", f' transform="rotate(-90 20 {middle})"'))
    return parts


def picture(title, curves, goals):
    """`curves`: {name: [(CPU s, error as a share, whether it is only known to lie below)]}; `goals`: shares to draw a line at."""
    spots = [spot for curve in curves.values() for spot in curve]
    columns, lines = decades([cpu for cpu, _, _ in spots]), decades([100 * error for _, error, _ in spots] + [100 * g for g in goals])

    def x(value):
        return LEFT + FRAME * (math.log10(value) - columns[0]) / (columns[1] - columns[0])

    def y(value):
        return TOP + HEIGHT * (lines[1] - math.log10(value)) / (lines[1] - lines[0])

    total = TOP + HEIGHT + BELOW + ENTRY * len(curves) + 8
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{total}" viewBox="0 0 {WIDTH} {total}" '
             'font-family="sans-serif" font-size="13" fill="#202020">', f'<rect width="{WIDTH}" height="{total}" fill="#ffffff"/>']
    parts += axes(title, columns, lines, x, y)
    for goal in goals:
        parts.append(line(LEFT, y(100 * goal), LEFT + FRAME, y(100 * goal), 'stroke="#808080" stroke-dasharray="6 4"'))
        parts.append(text(LEFT + FRAME - 4, y(100 * goal) - 4, "end", f"{100 * goal:g} %", ' fill="#606060"'))
    for index, (name, curve) in enumerate(curves.items()):
        colour, shape = COLOURS[index % len(COLOURS)], index + index // len(COLOURS)
        way = " ".join(f"{x(cpu):.1f},{y(100 * error):.1f}" for cpu, error, _ in curve)
        parts.append(f'<polyline points="{way}" fill="none" stroke="{colour}" stroke-width="1.6" stroke-opacity="0.5"/>')
        parts += [mark(x(cpu), y(100 * error), shape, colour, below) for cpu, error, below in curve]
        at = TOP + HEIGHT + BELOW + ENTRY * (index + 0.5)
        parts += [mark(LEFT + 14, at, shape, colour, False), text(LEFT + 36, at + 4, "start", name)]
    return "\n".join([*parts, "</svg>", ""])
