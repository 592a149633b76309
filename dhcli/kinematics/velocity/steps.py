"""A chain whose moves know which joint moves them, and the fold that carries a column for each joint besides the pose.

One fold serves every kind of number, as that of the pose does: it runs over floats, terms, residues, sizes and a tape.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Generic, TypeAlias, TypeVar

from dhcli.algebra.arithmetic import Arithmetic, plus, times
from dhcli.frozen import frozen
from dhcli.geometry.motion import Rows, dot, rotate
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Move, Rot, Trans, expressions
from dhcli.notation.angle import Rational
from dhcli.notation.derivative import derivative
from dhcli.notation.factors import AXES, Axis
from dhcli.notation.tree import ZERO, Expr, Number, number
from dhcli.notation.walk import symbols

N = TypeVar("N")
Vector: TypeAlias = list[N | int]
"""Three numbers; integers 0, 1 and -1 are structural."""

Offset: TypeAlias = tuple[Expr, Expr, Expr]


@frozen
class Step:
    """A move, and how joints change it.

    Attributes:
        move: The move.
        turning: Columns of the joints in its angle, with the factor each has there.
        sliding: Columns of the joints in its offset, with the derivative of the offset by each.
    """

    move: Move
    turning: tuple[tuple[int, Rational], ...] = ()
    sliding: tuple[tuple[int, Offset], ...] = ()


@frozen
class Columns(Generic[N]):
    """What the fold gives.

    Attributes:
        position: Where the last origin is, seen from the first frame [m].
        linear: For each joint the velocity of that origin [m/rad, or 1 for a slide].
        angular: For each joint the angular velocity of the last frame [rad/rad, or 0].
    """

    position: Vector[N]
    linear: list[Vector[N]]
    angular: list[Vector[N]]


def steps_of(chain: Chain, columns: Mapping[str, int]) -> tuple[Step, ...]:
    """The steps of a chain.

    Args:
        chain: The moves; in one that is not merged a joint stands in rotations or, by itself, in offsets.
        columns: The column of each joint that moves.
    """
    steps = []
    for move in chain:
        if isinstance(move, Rot):
            if not move.angle.is_zero:
                steps.append(Step(move, tuple((columns[n], f) for n, f in move.angle.terms if n in columns)))
            continue
        moving = {name for expr in expressions((move,)) if type(expr) is not Number for name in symbols(expr)}
        sliding = ((columns[n], _rate(move, n)) for n in sorted(moving & columns.keys(), key=columns.__getitem__))
        steps.append(Step(move, (), tuple(sliding)))
    return tuple(steps)


def _rate(move: Move, name: str) -> Offset:
    """How an offset changes with a joint; the cosines of a literal matrix hold none."""
    offset = move.offset if isinstance(move, Trans) else tuple(row[3] for row in move.rows)  # type: ignore[union-attr]
    x, y, z = (derivative(length, name) for length in offset)
    return x, y, z


def fold_columns(steps: Sequence[Step], count: int, over: Arithmetic[N]) -> Columns[N]:
    """Multiply a chain out, from right to left, with the columns of its Jacobian.

    At a rotation that holds a joint, whose factor there is k, the joint's column gains k·(e×p) and k·e; at a
    translation it gains the derivative of the offset, in front of what it has. So every column is the derivative of the
    position in the form that the position itself has.

    Source: z_i × (p - o_i) of Spong, Hutchinson and Vidyasagar, eq. 4.57, in the frame where z_i is an axis.
    """
    rows: Rows[N] = [[0], [0], [0]]  # the position, then v and ω of each joint that has been met
    places: dict[int, int] = {}
    for step in reversed(steps):
        move = step.move
        if isinstance(move, Rot):
            rotate(rows, PLANES[move.axis], *over.cos_sin(move.angle))
        elif isinstance(move, Trans):
            _shift(rows, 0, move.offset, over)
        else:
            rows = _transformed(rows, move, over)
            _shift(rows, 0, tuple(row[3] for row in move.rows), over)
        for column in [c for c, _ in (*step.turning, *step.sliding) if c not in places]:
            places[column] = len(rows[0])
            for row in rows:
                row.extend((0, 0))
        for column, factor in step.turning:
            rate: N | int = int(factor) if factor in (1, -1) else over.length(number(factor))
            _turn(rows, places[column], step.move.axis, rate)  # type: ignore[union-attr]  # a joint turns in a rotation
        for column, offset in step.sliding:
            _shift(rows, places[column], offset, over)
    linear, angular = (
        [[row[places[c] + k] if c in places else 0 for row in rows] for c in range(count)] for k in (0, 1)
    )
    return Columns([row[0] for row in rows], linear, angular)


def _turn(rows: Rows[N], place: int, axis: Axis, rate: N | int) -> None:
    """A turn of the position about an axis, in front of the columns that a joint has."""
    first, second = PLANES[axis]
    rows[first][place] = plus(times(-1, times(rate, rows[second][0])), rows[first][place])
    rows[second][place] = plus(times(rate, rows[first][0]), rows[second][place])
    k = AXES.index(axis)
    rows[k][place + 1] = plus(rate, rows[k][place + 1])


def _shift(rows: Rows[N], place: int, offset: Sequence[Expr], over: Arithmetic[N]) -> None:
    for row, length in zip(rows, offset, strict=True):
        if length is not ZERO:
            row[place] = plus(over.length(length), row[place])


def _transformed(rows: Rows[N], move: Fixed, over: Arithmetic[N]) -> Rows[N]:
    """The columns turned by the cosines of a literal matrix."""
    columns = list(zip(*rows, strict=True))
    cosines = [[over.length(entry) for entry in row[:3]] for row in move.rows]
    return [[dot(row, column) for column in columns] for row in cosines]
