"""Whether an answer is one that somebody has worked out, so that one may go on from it.

Zeros, the identity and what is no number can be typed without a look at the task: they show no work, and nor does what
follows from them. Numbers of which nothing is right may be those of another variant, copied; then nothing follows from
them either, unless a known slip leads to them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.checking.entries import Entries
from dhcli.checking.orientations import not_orthonormal
from dhcli.checking.verdicts import Mark
from dhcli.kinematics.conventions import Row
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers
from dhcli.notation.walk import symbols, symbols_in

Values: TypeAlias = Sequence[Sequence[float]]
"""The entries of an answer at one point."""

SEED = 5
NOTHING = 1e-9
"""What counts as zero: less than any length or cosine that somebody types."""

ROUGH = 2e-2
"""What the lengths of the columns of a rotation may be off: it may be typed to two decimals."""

HALF = 0.5


def at_a_point(entries: Entries, given: Mapping[str, Value]) -> Values:
    """The entries in numbers, at the values given and at some that are not special for all other names."""
    names = symbols_in(entry.expr for row in entries for entry in row)
    over = Floats({**next(general(names, SEED)), **numbers(given)})
    return [[over.value(entry.expr) for entry in row] for row in entries]


def is_trivial(values: Values) -> bool:
    """Whether an answer can be typed blindly: zeros, a matrix of zeros above its bottom row, or the identity."""
    if not all(math.isfinite(value) for row in values for value in row):
        return True
    rows = values[:3]
    is_zero = all(abs(value) <= NOTHING for row in rows for value in row)
    is_square = len(values) == len(values[0]) > 1
    return is_zero or (
        is_square and all(abs(v - (r == c)) <= NOTHING for r, row in enumerate(rows) for c, v in enumerate(row))
    )


def is_motion(values: Values) -> bool:
    """Whether a matrix, shape (4, 4), is a rigid motion that moves something."""
    return not is_trivial(values) and not not_orthonormal([row[:3] for row in values[:3]], ROUGH)


def has_right_joints(rows: Sequence[Row], right: Sequence[Row], variables: Sequence[str]) -> bool:
    """Whether each row of a table moves with the joint of the right one, and in the same way."""

    def joints(row: Row) -> tuple[frozenset[str], frozenset[str]]:
        return row.theta.names & set(variables), symbols(row.d) & set(variables)

    return len(rows) == len(right) and all(joints(one) == joints(two) for one, two in zip(rows, right, strict=True))


def has_name(mark: Mark) -> bool:
    """Whether it is known where an answer comes from: a slip, or an earlier answer."""
    return mark.diagnosis is not None and bool(mark.diagnosis.causes or mark.diagnosis.follows)
