"""How far joint values are from a singular pose: the least move to where some expressions are zero at once."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from dhcli.algebra.floats import Floats
from dhcli.notation.angle import Angle
from dhcli.notation.derivative import derivative
from dhcli.notation.tree import Expr

_ASIDE = 0.8
"""How far beside the joint values the search begins besides [rad or m]."""

_LONGEST = 0.7
"""The longest step [rad or m]; a longer one leaves what was linear."""

_ROUNDS = 60

_ZERO = 1e-9
"""What is smaller, of the largest value that the expressions had, is zero."""


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
