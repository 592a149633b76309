"""The product of a chain, written once for every kind of number."""

from __future__ import annotations

from typing import TypeVar

from dhcli.algebra.arithmetic import Arithmetic, plus, settled
from dhcli.geometry.motion import Rows, identity, product, rotate
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Rot, Trans

N = TypeVar("N")


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
    finished = tuple([tuple([settled(entry, over) for entry in row]) for row in rows])
    zero, one = over.constant(0), over.constant(1)
    return (*finished, (zero, zero, zero, one))


def fold_rows(chain: Chain, over: Arithmetic[N]) -> Rows[N]:
    """The upper three rows of the product, structural integers kept."""
    rows: Rows[N] = identity()
    for move in reversed(chain):
        if type(move) is Rot:  # a match takes twice as long as all else that is done for a move
            if not move.angle.is_zero:
                rotate(rows, PLANES[move.axis], *over.cos_sin(move.angle))
        elif type(move) is Trans:
            for row, length in zip(rows, move.offset, strict=True):
                row[3] = plus(over.length(length), row[3])
        elif type(move) is Fixed:
            rows = product([[over.length(entry) for entry in row] for row in move.rows], rows)
    return rows
