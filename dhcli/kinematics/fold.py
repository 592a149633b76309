"""The product of a chain, written once for every kind of number."""

from __future__ import annotations

from typing import TypeAlias, TypeVar

from dhcli.algebra.arithmetic import Arithmetic, plus, settled, times
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Rot, Trans

N = TypeVar("N")

Rows: TypeAlias = list[list[N | int]]
"""The upper three rows of a homogeneous matrix; integers 0, 1 and -1 are structural."""


def fold(chain: Chain, over: Arithmetic[N]) -> tuple[tuple[N, ...], ...]:
    """Multiply a chain out.

    Moves are applied from right to left, so that a rotation meets a finished bracket and multiplies it without
    expanding it: this alone gives the nesting `c1*(a2*c2 + a3*c23)` that textbooks print.

    Args:
        chain: Moves from left to right.
        over: The arithmetic: floats, numpy columns, terms, residues or sympy.

    Returns:
        The homogeneous matrix, shape (4, 4), of the arithmetic's numbers; translation in metres.
    """
    rows = fold_rows(chain, over)
    finished = tuple(tuple(settled(entry, over) for entry in row) for row in rows)
    zero, one = over.constant(0), over.constant(1)
    return (*finished, (zero, zero, zero, one))


def fold_rows(chain: Chain, over: Arithmetic[N]) -> Rows[N]:
    """The upper three rows of the product, structural integers kept."""
    rows: Rows[N] = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]
    for move in reversed(chain):
        match move:
            case Rot(axis, angle):
                if not angle.is_zero:
                    _rotate(rows, PLANES[axis], *over.cos_sin(angle))
            case Trans():
                for row, length in zip(rows, move.offset, strict=True):
                    row[3] = plus(over.length(length), row[3])
            case Fixed():
                rows = _multiply([[over.length(entry) for entry in row] for row in move.rows], rows)
    return rows


def _rotate(rows: Rows[N], plane: tuple[int, int], cos: N | int, sin: N | int) -> None:
    first, second = plane
    upper, lower = rows[first], rows[second]
    minus = times(-1, sin)
    rows[first] = [plus(times(cos, u), times(minus, v)) for u, v in zip(upper, lower, strict=True)]
    rows[second] = [plus(times(sin, u), times(cos, v)) for u, v in zip(upper, lower, strict=True)]


def _multiply(left: Rows[N], right: Rows[N]) -> Rows[N]:
    product: Rows[N] = []
    for row in left:
        entries: list[N | int] = []
        for column in range(4):
            entry: N | int = row[3] if column == 3 else 0  # noqa: PLR2004  the translation
            for k in range(3):
                entry = plus(entry, times(row[k], right[k][column]))
            entries.append(entry)
        product.append(entries)
    return product
