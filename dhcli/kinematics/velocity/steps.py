"""A chain whose moves know which joint moves them, and the fold that carries a column for each joint besides the pose.

One fold serves every kind of number, as that of the pose does: it runs over floats, terms, residues, sizes and a tape.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Generic, TypeAlias, TypeVar

from dhcli.algebra.arithmetic import Arithmetic, plus, times
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Move, Rot, Trans, expressions
from dhcli.notation.derivative import derivative
from dhcli.notation.factors import AXES, Axis
from dhcli.notation.tree import ZERO, Expr, Number, number
from dhcli.notation.walk import symbols

N = TypeVar("N")
Vector: TypeAlias = list[N | int]
"""Three numbers; integers 0, 1 and -1 are structural."""

Offset: TypeAlias = tuple[Expr, Expr, Expr]


@dataclass(frozen=True, slots=True)
class Step:
    """A move, and how joints change it.

    Attributes:
        move: The move.
        turning: Columns of the joints in its angle, with the factor each has there.
        sliding: Columns of the joints in its offset, with the derivative of the offset by each.
    """

    move: Move
    turning: tuple[tuple[int, Fraction], ...] = ()
    sliding: tuple[tuple[int, Offset], ...] = ()


@dataclass(slots=True)
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

    Args:
        steps: The moves from left to right.
        count: How many joints have a column.
        over: The arithmetic.

    Source: z_i × (p - o_i) of Spong, Hutchinson and Vidyasagar, eq. 4.57, in the frame where z_i is an axis.
    """
    position: Vector[N] = [0, 0, 0]
    linear: list[Vector[N]] = [[0, 0, 0] for _ in range(count)]
    angular: list[Vector[N]] = [[0, 0, 0] for _ in range(count)]
    moving: list[Vector[N]] = [position]
    seen: set[int] = set()
    for step in reversed(steps):
        move = step.move
        if isinstance(move, Rot):
            _rotate(moving, PLANES[move.axis], *over.cos_sin(move.angle))
            for column, factor in step.turning:
                rate: N | int = int(factor) if factor in (1, -1) else over.length(number(factor))
                _turn(position, linear[column], angular[column], move.axis, rate)
        elif isinstance(move, Trans):
            _shift(position, move.offset, over)
        else:
            _transform(moving, move, over)
            _shift(position, tuple(row[3] for row in move.rows), over)
        for column, offset in step.sliding:
            _shift(linear[column], offset, over)
        for column in [c for c, _ in (*step.turning, *step.sliding) if c not in seen]:
            seen.add(column)
            moving += (linear[column], angular[column])
    return Columns(position, linear, angular)


def _rotate(vectors: list[Vector[N]], plane: tuple[int, int], cos: N | int, sin: N | int) -> None:
    first, second = plane
    minus = times(-1, sin)
    for vector in vectors:
        u, v = vector[first], vector[second]
        if type(u) is int and type(v) is int and not u and not v:
            continue
        vector[first] = plus(times(cos, u), times(minus, v))
        vector[second] = plus(times(sin, u), times(cos, v))


def _turn(position: Vector[N], linear: Vector[N], angular: Vector[N], axis: Axis, rate: N | int) -> None:
    first, second = PLANES[axis]
    linear[first] = plus(times(-1, times(rate, position[second])), linear[first])
    linear[second] = plus(times(rate, position[first]), linear[second])
    k = AXES.index(axis)
    angular[k] = plus(rate, angular[k])


def _shift(vector: Vector[N], offset: Sequence[Expr], over: Arithmetic[N]) -> None:
    for k, length in enumerate(offset):
        if length is not ZERO:
            vector[k] = plus(over.length(length), vector[k])


def _transform(vectors: list[Vector[N]], move: Fixed, over: Arithmetic[N]) -> None:
    rows = [[over.length(entry) for entry in row[:3]] for row in move.rows]
    for vector in vectors:
        old = list(vector)
        for k, row in enumerate(rows):
            vector[k] = plus(plus(times(row[0], old[0]), times(row[1], old[1])), times(row[2], old[2]))
