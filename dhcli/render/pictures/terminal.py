"""A figure in letters: braille where the paper knows them, plain characters where it does not."""

from __future__ import annotations

import math
from itertools import pairwise

from dhcli.render.paper import Paper, in_ascii
from dhcli.render.pictures.looks import LOOKS
from dhcli.scene.labels import Lettering
from dhcli.scene.shapes import Figure, Shape, Text, cuts, sides
from dhcli.scene.staging import Paper as Sheet
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Words, plain

WIDE, HIGH = 8.0, 16.0
"""Width and height of a letter, in the pixels of a figure."""

RAIL = 1.0
"""How far the sides of a wide line are from its middle, in dots."""

COLON = ":"
"""What a wide line is made of where there are only plain characters."""

LEAST = (16, 8)
"""The fewest columns and rows that show anything."""

_LOWERED = str.maketrans("0123456789+−-ijnxaehklmopst", "₀₁₂₃₄₅₆₇₈₉₊₋₋ᵢⱼₙₓₐₑₕₖₗₘₒₚₛₜ")
_LOWER_ALL = frozenset("0123456789+−-ijn")
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
_INKS = {
    "x": "red",
    "y": "green",
    "z": "cyan",
    "turn": "yellow",
    "theirs": "yellow",
    "theirs-pale": "yellow",
    "dim": "dim",
    "thin": "dim",
    "hatch": "dim",
}
_LEFT_OUT = frozenset({"halo", "hatch", "extension"})
_WIDE = frozenset({"theirs-axis"})
_SPARSE = frozenset({"dim", "slide", "leader", "axis"})


def sheet_of(columns: int, rows: int, paper: Paper) -> Sheet:
    """What a figure is drawn on that becomes so many columns and rows of letters."""
    spell = spelled if paper.unicode else _in_ascii
    letters = Lettering(size=11.0, wide=WIDE / 11.0, below=1.0, height=HIGH / 11.0, spell=spell, pad=WIDE)
    margin = min(44.0, columns * WIDE * 0.1)
    return Sheet(columns * WIDE, rows * HIGH, letters, margin=margin, foot=0.0)


def terminal(figure: Figure, paper: Paper) -> str:
    """The text of a figure that was drawn on a sheet of letters, and its caption under it."""
    columns, rows = round(figure.width / WIDE), round(figure.height / HIGH)
    canvas = _Braille(columns, rows) if paper.unicode else _Plain(columns, rows)
    for shape in figure.shapes:
        if shape.look not in _LEFT_OUT:
            canvas.draw(shape)
    cells = canvas.letters()
    inks = canvas.inks
    for text in figure.texts:
        _write(text, cells, inks, paper)
    lines = [_line(cells[j], inks[j], paper) for j in range(rows)]
    while lines and not lines[0]:
        lines.pop(0)
    while lines and not lines[-1]:
        lines.pop()
    caption = paper.spell(" · ".join(part for part in (figure.title, figure.caption) if part))
    return "".join(f"{line}\n" for line in (*lines, *_folded(caption, columns, paper)))


def spelled(words: Words) -> str:
    """A label with its indices below the line, where there are letters for them."""
    return "".join(
        run.text.translate(_LOWERED) if run.below and set(run.text) <= _LOWER_ALL else run.text for run in words
    )


def _in_ascii(words: Words) -> str:
    return in_ascii(plain(words))


class _Canvas:
    """A grid of cells, each with the colour of what was last drawn there."""

    def __init__(self, columns: int, rows: int, fine: tuple[int, int]) -> None:
        self.columns, self.rows = columns, rows
        self.fine = fine
        self.wide, self.high = columns * fine[0], rows * fine[1]
        self.inks = [[""] * columns for _ in range(rows)]

    def draw(self, shape: Shape) -> None:
        """Put a shape over what is there: areas hide, lines show."""
        look = LOOKS[shape.look]
        points = [self.scaled(point) for point in shape.points]
        if shape.closed:
            self.area(points, set_=shape.look.endswith("head"), ink=_INKS.get(look.fill, ""))
        if look.stroke:
            ends = [*points, points[0]] if shape.closed else points
            for a, b in pairwise(ends):
                for c, d in self.rails(a, b) if shape.look in _WIDE else ((a, b),):
                    self.line(c, d, _INKS.get(look.stroke, ""), sparse=shape.look in _SPARSE)

    def rails(self, a: Flat, b: Flat) -> tuple[tuple[Flat, Flat], ...]:
        """A wide line as its two sides, between which there is room for a line of one dot."""
        length = math.dist(a, b) or 1.0
        nx, ny = (a[1] - b[1]) / length * RAIL, (b[0] - a[0]) / length * RAIL
        return tuple(((a[0] + s * nx, a[1] + s * ny), (b[0] + s * nx, b[1] + s * ny)) for s in (1, -1))

    def scaled(self, point: Flat) -> Flat:
        """A point in dots."""
        return point[0] / WIDE * self.fine[0], point[1] / HIGH * self.fine[1]

    def area(self, points: list[Flat], *, set_: bool, ink: str) -> None:
        """Set or clear every dot inside."""
        edges = list(sides(points))
        top, bottom = min(y for _, y in points), max(y for _, y in points)
        for j in range(max(0, math.floor(top)), min(self.high, math.ceil(bottom) + 1)):
            y = j + 0.5
            for left, right in cuts(edges, y):
                for i in range(max(0, round(left)), min(self.wide, round(right))):
                    self.dot(i, j, set_=set_, ink=ink)

    def line(self, a: Flat, b: Flat, ink: str, *, sparse: bool) -> None:
        """Set the dots of a line, every other pair of them where it is a thin one."""
        steps = max(1, min(10_000, math.ceil(max(abs(b[0] - a[0]), abs(b[1] - a[1])))))
        self.slope(a, b)
        for n in range(steps + 1):
            if sparse and n % 4 > 1:
                continue
            i, j = a[0] + (b[0] - a[0]) * n / steps, a[1] + (b[1] - a[1]) * n / steps
            self.dot(math.floor(i), math.floor(j), set_=True, ink=ink)

    def slope(self, a: Flat, b: Flat) -> None:
        """Take note of the direction of the line that comes next."""

    def dot(self, i: int, j: int, *, set_: bool, ink: str) -> None:
        """Set or clear one dot."""
        raise NotImplementedError

    def letters(self) -> list[list[str]]:
        """A letter for each cell."""
        raise NotImplementedError


class _Braille(_Canvas):
    """Two by four dots in a cell."""

    def __init__(self, columns: int, rows: int) -> None:
        super().__init__(columns, rows, (2, 4))
        self.cells = [[0] * columns for _ in range(rows)]

    def dot(self, i: int, j: int, *, set_: bool, ink: str) -> None:
        """Set or clear one dot."""
        if not (0 <= i < self.wide and 0 <= j < self.high):
            return
        column, row, bit = i // 2, j // 4, _DOTS[j % 4][i % 2]
        if set_:
            self.cells[row][column] |= bit
            self.inks[row][column] = ink
        else:
            self.cells[row][column] &= ~bit

    def letters(self) -> list[list[str]]:
        """A letter for each cell."""
        return [[chr(0x2800 + bits) if bits else " " for bits in row] for row in self.cells]


class _Plain(_Canvas):
    """One character in a cell, chosen by the direction of the line."""

    def __init__(self, columns: int, rows: int) -> None:
        super().__init__(columns, rows, (1, 1))
        self.cells = [[" "] * columns for _ in range(rows)]
        self.letter = "-"
        self.is_wide = False

    def rails(self, a: Flat, b: Flat) -> tuple[tuple[Flat, Flat], ...]:
        """A wide line is one of colons."""
        return ((a, b),)

    def slope(self, a: Flat, b: Flat) -> None:
        """Take note of the direction of the line that comes next."""
        dx, dy = b[0] - a[0], b[1] - a[1]
        if abs(dy) < 0.4 * abs(dx):
            self.letter = "-"
        elif abs(dx) < 0.4 * abs(dy):
            self.letter = "|"
        else:
            self.letter = "\\" if dx * dy > 0 else "/"

    def draw(self, shape: Shape) -> None:
        """As ever, but the head of an arrow is one letter at its tip."""
        self.is_wide = shape.look in _WIDE
        if not shape.look.endswith("head"):
            super().draw(shape)
            return
        points = [self.scaled(point) for point in shape.points]
        (x, y), (a, b), (c, d) = points[0], points[1], points[-1]
        dx, dy = x - (a + c) / 2, y - (b + d) / 2
        self.letter = (">" if dx > 0 else "<") if abs(dx) > abs(dy) else ("v" if dy > 0 else "^")
        self.dot(math.floor(x), math.floor(y), set_=True, ink=_INKS.get(LOOKS[shape.look].fill, ""))

    def dot(self, i: int, j: int, *, set_: bool, ink: str) -> None:
        """Write or clear one letter; of a wide line every second one stays where another runs along it."""
        if not (0 <= i < self.columns and 0 <= j < self.rows):
            return
        if set_ and not self.is_wide and self.cells[j][i] == COLON and (i + j) % 2:
            return
        self.cells[j][i] = (COLON if self.is_wide else self.letter) if set_ else " "
        self.inks[j][i] = ink

    def letters(self) -> list[list[str]]:
        """A letter for each cell."""
        return self.cells


def _write(text: Text, cells: list[list[str]], inks: list[list[str]], paper: Paper) -> None:
    """A label over the picture, inside its line."""
    letters = paper.spell(spelled(text.words) if paper.unicode else _in_ascii(text.words))
    row = math.floor((text.at[1] - 0.26 * text.size) / HIGH)
    column = math.floor(text.at[0] / WIDE - len(letters) / 2 + 0.5)
    if not (0 <= row < len(cells) and column >= 0 and column + len(letters) <= len(cells[row])):
        return
    ink = {"mark": "bold", "number": "bold", "slide": "yellow", "head": "bold"}.get(text.look, _INKS.get(text.look, ""))
    for offset, letter in enumerate(letters):
        cells[row][column + offset] = letter
        inks[row][column + offset] = ink


def _line(letters: list[str], inks: list[str], paper: Paper) -> str:
    """One line, its runs of one colour inked together, without blanks at its end."""
    end = len("".join(letters).rstrip())
    found, start = [], 0
    for i in range(1, end + 1):
        if i == end or inks[i] != inks[start]:
            run = "".join(letters[start:i])
            found.append(paper.ink(run, inks[start]) if inks[start] and run.strip() else run)
            start = i
    return "".join(found) if end else ""


def _folded(text: str, columns: int, paper: Paper) -> list[str]:
    import textwrap

    return [paper.ink(line, "dim") for line in textwrap.wrap(text, max(columns, 1), break_on_hyphens=False)]
