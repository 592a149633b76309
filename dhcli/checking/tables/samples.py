"""Where two chains are compared: at values drawn for their letters, or at those of the robot for answers in numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import islice

from dhcli.algebra.points import GENERAL, draws, general
from dhcli.checking.symbolic import has_decimals
from dhcli.frozen import frozen
from dhcli.kinematics.axes import Arm, Point
from dhcli.kinematics.moves import Chain, Rot, angle_names, expressions, names
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers, symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number, Sum
from dhcli.notation.walk import symbols, walk

SEED = 5
POINTS = 40
STRETCH = (1.5, 2.5)
"""By how much letters are longer at the second point: a wrong one of two equal lengths is then seen."""


@frozen
class Values:
    """What is known of the names.

    Attributes:
        given: Values that the task states; they may stand for their names.
        own: Values of the robot, for answers in numbers.
    """

    given: Mapping[str, Value]
    own: Mapping[str, Value]


def general_points(free: frozenset[str], values: Values) -> Iterator[Point]:
    """Seeded values of some names, of the sign that they have; what is given stays as given."""
    given, own = numbers(values.given), _known(values)
    return ({name: _signed(x, own.get(name)) for name, x in drawn.items()} | given for drawn in general(free, SEED))


def points_of_values(truth: Arm, other: Arm, values: Values, drawn: Point) -> tuple[Point, ...]:
    """Where an answer in numbers is judged: at the values that the robot has; a name without one is as it was drawn.

    A letter that the answer keeps, and that the right table has once, has another length at a second point: so the
    wrong one of two lengths that happen to be equal is still found.
    """
    if not has_lengths(other.chain):
        return (drawn,)
    own = {name: value for name, value in _known(values).items() if name in drawn}
    first = {**drawn, **own, **numbers(values.given)}
    cells = [symbols(expr) for expr in expressions(truth.chain)]
    kept = other.names & {name for name, value in own.items() if not isinstance(value, Angle)}
    letters = sorted(name for name in kept - values.given.keys() if sum(name in cell for cell in cells) == 1)
    if not letters:
        return (first,)
    longer = next(draws(dict.fromkeys(letters, STRETCH), SEED))
    return first, {**first, **{name: _float(own[name]) * by for name, by in longer.items()}}


def points_all_round(chains: tuple[Chain, Chain], truth: Arm, values: Values) -> Iterator[Point]:
    """Where chains of which no proof is known are compared: angles all round the circle, slides of both signs."""
    own = _known(values)
    turning = angle_names(chains[0]) | angle_names(chains[1])
    ranges: dict[str, tuple[float, float]] = {}
    for name in sorted(names(chains[0]) | names(chains[1])):
        if name in turning:
            ranges[name] = (-math.pi, math.pi)
        elif name in truth.variables:
            ranges[name] = (-GENERAL[1], GENERAL[1])
        else:
            low, high = (_signed(x, own.get(name)) for x in GENERAL)
            ranges[name] = (low, high)
    return islice(draws(ranges, SEED), POINTS)


def has_numbers(chain: Chain) -> bool:
    """Whether lengths in numbers, or decimals and angles that may be rounded, stand in a chain."""
    if any(has_decimals(expr) for expr in expressions(chain)):
        return True
    return has_lengths(chain) or any(
        isinstance(move, Rot) and (move.angle.radians or move.angle.degrees.denominator != 1) for move in chain
    )


def has_lengths(chain: Chain) -> bool:
    """Whether lengths in numbers stand in a chain."""
    return any(
        not symbols(term) and any(isinstance(node, Number) and node.value for node in walk(term))
        for move in chain
        if not isinstance(move, Rot)
        for expr in expressions((move,))
        for term in (expr.terms if isinstance(expr, Sum) else (expr,))
    )


def _known(values: Values) -> dict[str, Angle | float]:
    """The values of the robot that are plain numbers."""
    return dict(numbers({name: value for name, value in values.own.items() if not symbols_of(value)}))


def _signed(drawn: float, own: Angle | float | None) -> float:
    """A length of the sign that it has: the square root of its square is not the same length."""
    return drawn if own is None or isinstance(own, Angle) else math.copysign(drawn, own)


def _float(value: Angle | float) -> float:
    return 0.0 if isinstance(value, Angle) else value
