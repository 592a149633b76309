"""How full the paper is: a grid of cells of a few pixels, and sums over rectangles of them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise

from dhcli.scene.shapes import Shape, cuts, sides
from dhcli.scene.vectors import Flat

CELL = 4
"""Side of a cell [px]."""

LINE, AREA = 6, 1
"""Weight of a line and of a filled area: a label may stand on a body before it stands on a line."""

_LIGHT = frozenset({"plate", "hatch", "halo", "ground-sheet"})


class Ink:
    """What is already on paper."""

    def __init__(self, width: float, height: float) -> None:
        """An empty paper [px]."""
        self.columns, self.rows = math.ceil(width / CELL) + 1, math.ceil(height / CELL) + 1
        self.cells = [0] * (self.columns * self.rows)

    def add(self, shapes: Iterable[Shape]) -> None:
        """Put shapes on paper."""
        for shape in shapes:
            if shape.look in _LIGHT:
                continue
            if shape.closed:
                self._area(shape.points, LINE if shape.look == "grip" else AREA)
            if shape.look not in ("link", "ground-link"):
                self._line((*shape.points, shape.points[0]) if shape.closed else shape.points)

    def amount(self, left: float, top: float, right: float, bottom: float) -> int:
        """How much ink is in a rectangle."""
        wide = self.columns
        i, j = max(0, int(left / CELL)), max(0, int(top / CELL))
        k, m = min(wide, int(right / CELL) + 1), min(self.rows, int(bottom / CELL) + 1)
        if i >= k:
            return 0
        cells, total = self.cells, 0
        for row in range(j * wide, m * wide, wide):
            total += sum(cells[row + i : row + k])
        return total

    def along(self, a: Flat, b: Flat) -> int:
        """How much ink is on a line and near it."""
        steps = max(2, int(math.dist(a, b) / 6))
        total = 0
        for n in range(steps + 1):
            x, y = a[0] + (b[0] - a[0]) * n / steps, a[1] + (b[1] - a[1]) * n / steps
            total += self.amount(x - 5, y - 5, x + 5, y + 5)
        return total

    def _line(self, points: tuple[Flat, ...]) -> None:
        cells, columns, rows = self.cells, self.columns, self.rows
        for a, b in pairwise(points):
            steps = max(1, min(4000, int(math.dist(a, b) / (CELL * 0.6)) + 1))
            dx, dy = (b[0] - a[0]) / steps, (b[1] - a[1]) / steps
            for n in range(steps + 1):
                i, j = int((a[0] + n * dx) / CELL), int((a[1] + n * dy) / CELL)
                if 0 <= i < columns and 0 <= j < rows:
                    cells[j * columns + i] = LINE

    def _area(self, points: tuple[Flat, ...], weight: int) -> None:
        """Cells whose middle is inside, row by row."""
        edges = list(sides(points))
        top, bottom = min(y for _, y in points), max(y for _, y in points)
        for j in range(max(0, int(top / CELL)), min(self.rows, int(bottom / CELL) + 1)):
            y = (j + 0.5) * CELL
            for left, right in cuts(edges, y):
                start, stop = max(0, round(left / CELL)), min(self.columns, round(right / CELL))
                for at in range(j * self.columns + start, j * self.columns + stop):
                    self.cells[at] = max(self.cells[at], weight)
