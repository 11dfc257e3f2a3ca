"""Curves in a terminal, in braille characters: two by four dots in each. Needs nothing but Python."""

import math

DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))  # of a character, [row][column]


class Canvas:
    """Dots on width x height characters; x and y count dots from the lower left."""

    def __init__(self, width, height):
        self.width, self.height = 2 * width, 4 * height
        self.cells = [[0] * width for _ in range(height)]

    def dot(self, x, y):
        if 0 <= x < self.width and 0 <= y < self.height:
            row = self.height - 1 - y
            self.cells[row // 4][x // 2] |= DOTS[row % 4][x % 2]

    def line(self, x0, y0, x1, y1):
        steps = max(abs(x1 - x0), abs(y1 - y0), 1)
        for i in range(steps + 1):
            self.dot(round(x0 + (x1 - x0) * i / steps), round(y0 + (y1 - y0) * i / steps))

    def lines(self):
        return ["".join(chr(0x2800 + cell) for cell in row) for row in self.cells]


SPIKE = 0.02  # the part of the time shown that counts as its start


def limits(points, settle):
    """Lowest and highest value. @param settle  values of the start that exceed all later ones do not count"""
    values = [y for _, y in points]
    start, end = min(x for x, _ in points), max(x for x, _ in points)
    later = [y for x, y in points if x > start + SPIKE * (end - start)]
    if settle and len(later) > 1 and max(map(abs, values)) > 1.5 * max(map(abs, later)):
        values = later
    low, high = min(values), max(values)
    if high - low <= 1e-12 * max(abs(low), abs(high), 1e-300):  # a constant
        reach = 0.5 * abs(high) or 1.0
        return low - reach, high + reach
    return low, high


def draw(title, t, curves, width, height, settle=False):
    """Lines of text: a title, the curves over t, and their limits.
    @param curves  lists of numbers as long as t; nan leaves a gap
    @param settle  the start may run off the picture"""
    points = [[(x, y) for x, y in zip(t, curve) if math.isfinite(y)] for curve in curves]
    known = [point for curve in points for point in curve]
    if not known or t[-1] <= t[0]:
        return []
    low, high = limits(known, settle)
    labels = [f"{high:.4g}", f"{low:.4g}"]
    margin = max(map(len, labels)) + 1
    canvas = Canvas(max(8, width - margin), height)

    def place(x, y):
        part = min(2.0, max(-1.0, (y - low) / (high - low)))
        return round((x - t[0]) / (t[-1] - t[0]) * (canvas.width - 1)), round(part * (canvas.height - 1))

    for curve in points:
        for a, b in zip(curve, curve[1:] or curve):
            canvas.line(*place(*a), *place(*b))
    rows = canvas.lines()
    names = [labels[0]] + [""] * (len(rows) - 2) + [labels[1]]
    return [" " * margin + title, *(f"{name:>{margin - 1}} {row}" for name, row in zip(names, rows))]


def side_by_side(left, right, width):
    """Two blocks of lines as one; the left one padded to width."""
    rows = max(len(left), len(right))
    left, right = (block + [""] * (rows - len(block)) for block in (left, right))
    return [f"{a:<{width}}{b}".rstrip() for a, b in zip(left, right)]
