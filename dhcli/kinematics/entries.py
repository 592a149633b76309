"""The entries of a matrix as people are shown them: a pose and a Jacobian, in numbers or expressions."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write

DIGITS = 4
"""Decimals that a person is shown unless they ask for more."""


def rounded(value: float, digits: int = DIGITS) -> str:
    """A number for people: rounded, no trailing zeros, no minus zero."""
    if value != value or value in (float("inf"), float("-inf")):  # noqa: PLR0124  NaN
        return str(value)
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def small_length(value: float) -> str:
    """A length [m] in the unit in which it is told best: `11 µm`, `160 µm`, `1.2 mm`, `0.3 m`."""
    for unit, size in (("µm", 1e-6), ("mm", 1e-3)):
        if value < 1000 * size:
            return f"{value / size:.3g} {unit}"
    return f"{value:.3g} m"


def cells_of(
    rows: Sequence[Sequence[object]], joints: Joints, style: str = "short", digits: int = DIGITS
) -> tuple[tuple[str, ...], ...]:
    """Entries as text: expressions in a notation, numbers rounded for people."""
    return tuple(
        tuple(write(e, style, joints) if isinstance(e, Expr) else rounded(float(e), digits) for e in row)  # type: ignore[arg-type]
        for row in rows
    )


def latex_of(cells: Sequence[Sequence[str]]) -> str:
    """A matrix for a paper, of cells in LaTeX, without dollar signs."""
    body = " \\\\ ".join(" & ".join(row) for row in cells)
    return f"\\begin{{bmatrix}} {body} \\end{{bmatrix}}"


def in_columns(cells: Sequence[Sequence[str]]) -> str:
    """A matrix in columns, each as wide as its widest cell."""
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return "\n".join("  ".join(c.rjust(w) for c, w in zip(row, widths, strict=True)) for row in cells)
