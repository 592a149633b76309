"""How an arm stands at joint values: the measures of its Jacobian, and how far away singular poses are."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.result import Singularities
from dhcli.kinematics.values import Values, numbers
from dhcli.kinematics.velocity.form import Form
from dhcli.kinematics.velocity.jacobian import numeric_jacobian
from dhcli.kinematics.velocity.measures import Measures, measures_of
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.angle import Angle
from dhcli.notation.derivative import derivative
from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import symbols

_ASIDE = 0.8
"""How far beside the joint values the search begins besides [rad or m]."""

_LONGEST = 0.7
"""The longest step [rad or m]; a longer one leaves what was linear."""

_ROUNDS = 60

_ZERO = 1e-9
"""What is smaller, of the largest value that the expressions had, is zero."""


@frozen
class Distance:
    """How far a factor is from zero.

    Attributes:
        factor: Its place among the factors found.
        values: What its expressions are at the joint values.
        distance: How far joints have to move to make it zero [rad and m together]; infinite where no move was found.
    """

    factor: int
    values: tuple[float, ...]
    distance: float


@frozen
class Standing:
    """How an arm stands.

    Attributes:
        measures: Rank, singular values, manipulability, condition.
        determinant: The determinant, if there is one.
        distances: How far each factor is from zero, the nearest first.
    """

    measures: Measures
    determinant: float | None
    distances: tuple[Distance, ...]


def standing_at(robot: Robot, values: Values, view: MotionView, found: Singularities) -> Standing:
    """How an arm stands at values of all names that its chain has.

    Raises:
        RobotError: A value is missing.
    """
    form = Form(found.part)
    rows = [form.labels.index(label) for label in found.rows]
    measures = measures_of(numeric_jacobian(robot, values, view, form).matrix, rows)
    known = numbers(values)
    distances = [Distance(k, *_distance(factor.zeros, found.joints, known)) for k, factor in enumerate(found.factors)]
    determinant = None if found.determinant is None else Floats(known).value(found.determinant)
    return Standing(measures, determinant, tuple(sorted(distances, key=lambda one: one.distance)))


def _distance(
    zeros: tuple[Expr, ...], joints: tuple[str, ...], known: Mapping[str, Angle | float]
) -> tuple[tuple[float, ...], float]:
    """The values of expressions, and how far joints are from making all of them zero at once."""
    over = Floats(known)
    values = tuple(over.value(zero) for zero in zeros)
    match zeros:
        case (Trig(_, angle),):
            size = math.hypot(*(float(factor) for name, factor in angle.terms if name in joints))
            return values, math.asin(min(1.0, abs(values[0]))) / size
    own = [name for name in joints if any(name in symbols(zero) for zero in zeros)]
    return values, least_move(zeros, own, known)


def least_move(zeros: Sequence[Expr], joints: Sequence[str], known: Mapping[str, Angle | float]) -> float:
    """The least move of joints [rad and m together] that makes expressions zero; infinite where none was found.

    Each step goes to the point nearest to where the joints stand at which the expressions, taken as linear, are zero;
    that is done from there and from places beside it, for a stretched arm has no slope, and the nearest zero counts.
    """
    slopes = [[derivative(zero, joint) for joint in joints] for zero in zeros]
    here = [value.constant() if isinstance(value := known[joint], Angle) else value for joint in joints]

    def look(at: Sequence[float]) -> tuple[list[float], list[list[float]]]:
        over = Floats({**known, **dict(zip(joints, at, strict=True))})
        return [over.value(zero) for zero in zeros], [[over.value(slope) for slope in row] for row in slopes]

    least = math.inf
    for start in _starts(here):
        at = start
        seen = largest = 0.0
        for _ in range(_ROUNDS):
            values, rows = look(at)
            seen = max(map(abs, values))
            largest = max(largest, seen)
            gap = [x - y for x, y in zip(at, here, strict=True)]
            aims = [_dot(row, gap) - value for row, value in zip(rows, values, strict=True)]
            step = [x - y for x, y in zip(_shortest(rows, aims), gap, strict=True)]
            size = math.hypot(*step)
            if size < _ZERO:
                break
            at = [x + y * min(1.0, _LONGEST / size) for x, y in zip(at, step, strict=True)]
        if seen <= _ZERO * largest:
            least = min(least, math.dist(at, here))
    return least


def _starts(here: Sequence[float]) -> Iterator[list[float]]:
    """Where the joints stand, and beside it: by all joints, to one side or to both, and by each in turn."""
    yield list(here)
    for by in (_ASIDE, -_ASIDE):
        yield [x + by for x in here]
        yield [x + by * (-1) ** k for k, x in enumerate(here)]
        for j in range(len(here)):
            yield [x + by * (k == j) for k, x in enumerate(here)]


def _shortest(rows: Sequence[Sequence[float]], aims: Sequence[float]) -> list[float]:
    """The shortest vector that has given products with some rows; a row that depends on those before it is left out."""
    found = [0.0] * len(rows[0])
    basis: list[list[float]] = []
    for row, aim in zip(rows, aims, strict=True):
        rest = list(row)
        for unit in basis:
            part = _dot(unit, row)
            rest = [x - part * y for x, y in zip(rest, unit, strict=True)]
        size = math.hypot(*rest)
        if size <= _ZERO * max(1.0, math.hypot(*row)):
            continue
        unit = [x / size for x in rest]
        # the units before it have their shares in what was found already
        share = (aim - _dot(row, found)) / size
        found = [x + share * y for x, y in zip(found, unit, strict=True)]
        basis.append(unit)
    return found


def _dot(one: Sequence[float], other: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(one, other, strict=True))
