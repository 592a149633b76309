"""Matrices in brackets, aligned by the decimal point; or one entry a line where that would not fit."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from dhcli.notation.let import Definition
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write
from dhcli.regex import regex
from dhcli.render.look import Look

ENTRIES = (
    ("r11", "r12", "r13", "p_x"),
    ("r21", "r22", "r23", "p_y"),
    ("r31", "r32", "r33", "p_z"),
)
"""What the entries of the upper three rows are called."""

_LEFT, _RIGHT = "⎡⎢⎣", "⎤⎥⎦"
_GAP = 2
_WHOLE = regex(r"-?[0-9]*")
_NUMBER = regex(r"-?[0-9.]+(e[-+]?[0-9]+)?")


def cell(entry: Expr | float, joints: Joints, look: Look) -> str:
    """One entry for people: a formula, or a number rounded."""
    if isinstance(entry, Expr):
        return look.shown(write(entry, look.style or "short", joints))
    return look.number(entry)


def matrix_lines(rows: Sequence[Sequence[Expr | float]], joints: Joints, look: Look) -> list[str]:
    """A matrix in brackets, or, if its lines would be wider than the paper, one entry a line."""
    paper = look.paper
    cells = [[paper.spell(cell(entry, joints, look)) for entry in row] for row in rows]
    position = [row[-1] for row in rows[: len(ENTRIES)]]
    if len(rows) == len(ENTRIES) + 1 and not any(isinstance(entry, Expr) for entry in position):
        for row, text in zip(cells, look.numbers(map(float, position)), strict=False):  # type: ignore[arg-type]
            row[-1] = text
    numeric = all(_NUMBER.fullmatch(text) for row in cells for text in row)
    columns = [aligned(column) if numeric else _centred(column) for column in zip(*cells, strict=True)]
    if _width(columns) > paper.width and len(rows) == len(ENTRIES) + 1:
        return entry_lines(cells, look)
    lines = []
    for i, padded in enumerate(zip(*columns, strict=True)):
        inked = [paper.ink(text, "dim") if text.strip() in ("0", "1") else text for text in padded]
        kind = 0 if i == 0 else 2 if i == len(rows) - 1 else 1
        left, right = (paper.ink(paper.spell(side[kind]), "dim") for side in (_LEFT, _RIGHT))
        lines.append(f"{left} {(' ' * _GAP).join(inked)} {right}")
    return lines


def let_lines(definitions: Sequence[Definition], joints: Joints, look: Look) -> list[str]:
    """Names that stand in a matrix for brackets, one a line: `let k1 = a1 + a2*c2`."""
    paper = look.paper
    texts = ((one.name, paper.spell(cell(one.expr, joints, look))) for one in definitions)
    return [f"{paper.ink('let', 'dim')} {paper.ink(name, 'cyan')} = {text}" for name, text in texts]


def entry_lines(cells: Sequence[Sequence[str]], look: Look) -> list[str]:
    """The entries of the upper three rows, one a line: `r11 = c12`; never folded."""
    return [
        f"{look.paper.ink(name, 'cyan')} = {text}"
        for names, row in zip(ENTRIES, cells, strict=False)
        for name, text in zip(names, row, strict=True)
    ]


def vector_lines(names: Sequence[str], entries: Iterable[Expr | float], joints: Joints, look: Look) -> list[str]:
    """Named values, one a line, their equals signs in one column; numbers aligned by the decimal point."""
    values = list(entries)
    if any(isinstance(value, Expr) for value in values):
        cells = [look.paper.spell(cell(entry, joints, look)) for entry in values]
    else:
        cells = [text.rstrip() for text in aligned(look.numbers(map(float, values)))]  # type: ignore[arg-type]
    width = max(map(len, names))
    return [f"{look.paper.ink(n.ljust(width), 'cyan')} = {text}" for n, text in zip(names, cells, strict=True)]


def _width(columns: Sequence[Sequence[str]]) -> int:
    return sum(len(column[0]) + _GAP for column in columns) - _GAP + 4


def aligned(column: Sequence[str]) -> list[str]:
    """Numbers, with units or without, with their decimal points below each other."""
    whole = [_WHOLE.match(text)[0] for text in column]  # type: ignore[index]  # it matches nothing too
    left = max(map(len, whole))
    padded = [" " * (left - len(part)) + text for part, text in zip(whole, column, strict=True)]
    width = max(map(len, padded))
    return [text.ljust(width) for text in padded]


def _centred(column: Sequence[str]) -> list[str]:
    width = max(map(len, column))
    return [text.center(width) for text in column]
