"""A table of entries that is the answer to a question about motion, with what each entry measures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import islice
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.checking.credit import only_costs
from dhcli.checking.exercise import Exercise, Memo
from dhcli.frozen import frozen
from dhcli.kinematics.entries import rounded
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Number
from dhcli.notation.walk import symbols_in
from dhcli.notation.writer import write

Rows: TypeAlias = tuple[tuple[Expr, ...], ...]
Numbers: TypeAlias = tuple[tuple[float, ...], ...]

SEED = 31
POINTS = 2

RELATIVE = 1e-3
"""Tolerance of an entry where none is declared, as a share of the largest of its kind."""

MOST_DIGITS = 9

MOST_MET = 20_000
"""Entries whose values are kept: those of all pairs of slips of six joints, and not those of a whole class."""

CLOSE = 1e-9
"""What rounding leaves of the difference of equal entries."""


class Remembering(Floats):
    """Double precision that knows the values of entries it has met: a mistake in one column leaves the others."""

    def __init__(self, values: Mapping[str, Angle | float]) -> None:
        """Begin without any."""
        super().__init__(values)
        self._met: dict[int, tuple[Expr, float]] = {}

    def value(self, expr: Expr) -> float:
        """Value of an entry; the same tree has the same value."""
        met = self._met.get(id(expr))
        if met is None:
            if len(self._met) >= MOST_MET:
                self._met.clear()
            met = self._met[id(expr)] = expr, super().value(expr)
        return met[1]


@frozen
class Grid:
    """Entries, and what they measure.

    Attributes:
        rows: The entries.
        powers: For each entry the power of a length that it is: 1 for a length, or a velocity.
        cosines: Whether entries of power 0 are direction cosines, with a tolerance of their own.
    """

    rows: Rows
    powers: tuple[tuple[int, ...], ...]
    cosines: bool = False

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return len(self.rows), len(self.rows[0])

    @property
    def names(self) -> frozenset[str]:
        """Every name in it."""
        return symbols_in(entry for row in self.rows for entry in row)

    def numbers(self, exercise: Exercise) -> Numbers:
        """The entries at the values of an exercise, lengths in metres."""
        return over(self.rows, Floats(numbers(exercise.values)))

    def numbers_in(self, memo: Memo) -> Numbers:
        """The same, for one of many tables that have entries in common."""
        return over(self.rows, floats_in(memo))

    def on_sheet(self, exercise: Exercise) -> Rows:
        """The entries in symbols as a sheet has them: bare numbers of lengths in its unit."""
        return tuple(
            tuple(exercise.on_sheet(entry) if power == 1 else entry for entry, power in zip(row, powers, strict=True))
            for row, powers in zip(self.rows, self.powers, strict=True)
        )

    def only_costs(self, row: int, column: int) -> bool:
        """Whether an entry in symbols earns nothing where it is right."""
        is_cosine = self.cosines and not self.powers[row][column]
        return only_costs(self.rows[row][column], is_cosine=is_cosine, is_constant=not self.names)

    def limits(self, found: Numbers, position: float | None, rotation: float) -> Numbers:
        """The largest errors that count as right: declared ones, or a share of the largest entry of its power.

        Args:
            found: The entries at the values of the exercise.
            position: The tolerance declared for lengths [m], if one is.
            rotation: That of a direction cosine.
        """
        largest: dict[int, float] = {}
        for powers, row in zip(self.powers, found, strict=True):
            for power, value in zip(powers, row, strict=True):
                largest[power] = max(largest.get(power, 0.0), abs(value))

        def limit(power: int) -> float:
            if power == 0 and self.cosines:
                return rotation
            if power == 1 and position is not None:
                return position
            return RELATIVE * (largest[power] or 1.0)

        return tuple(tuple(map(limit, row)) for row in self.powers)

    def text(self, exercise: Exercise, position: float | None, rotation: float, style: str = "short") -> Sequence[str]:
        """The entries row by row as a person types them; numbers with as many digits as the tolerance needs."""
        if not exercise.numeric:
            return [write(entry, style, exercise.writing) for row in self.on_sheet(exercise) for entry in row]
        found = self.numbers(exercise)
        triples = zip(found, self.powers, self.limits(found, position, rotation), strict=True)
        return [
            typed(value, scale_of(exercise, power), limit)
            for values, powers, bounds in triples
            for value, power, limit in zip(values, powers, bounds, strict=True)
        ]


def floats_in(memo: Memo) -> Remembering:
    """Double precision at the values of an exercise, for all tables that are worked out for it."""
    return memo.of("floats for entries", lambda: Remembering(numbers(memo.exercise.values)))


def general_floats_in(memo: Memo, names: frozenset[str]) -> tuple[Remembering, ...]:
    """Double precision at two points that have nothing special about them, for all tables of an exercise.

    Args:
        memo: What was worked out for the exercise: in symbols the points have the values that it gives.
        names: The names that need a value.
    """

    def made() -> tuple[Remembering, ...]:
        known = {} if memo.exercise.numeric else numbers(memo.exercise.values)
        return tuple(Remembering(point | known) for point in islice(general(names, SEED), POINTS))

    return memo.of(("general floats for entries", names), made)


def over(rows: Iterable[Iterable[Expr]], arithmetic: Floats) -> Numbers:
    """Entries in floats."""
    return tuple(tuple(arithmetic.value(entry) for entry in row) for row in rows)


def alike(first: Sequence[Numbers], second: Sequence[Numbers]) -> bool:
    """Whether entries are the same at every point, but for rounding."""
    pairs = [
        (a, b)
        for one, other in zip(first, second, strict=True)
        for row, line in zip(one, other, strict=True)
        for a, b in zip(row, line, strict=True)
    ]
    return all(abs(a - b) <= CLOSE * max(1.0, abs(a), abs(b)) for a, b in pairs)


def within(first: Numbers, second: Numbers, limits: Sequence[Sequence[float]]) -> bool:
    """Whether entries are near enough."""
    rows = zip(first, second, limits, strict=True)
    return all(abs(a - b) <= limit for row in rows for a, b, limit in zip(*row, strict=True))


def scale_of(exercise: Exercise, power: int) -> float:
    """How many metres, to a power, the unit of the sheet is."""
    return float(exercise.metres**power)


def typed(value: float, scale: float, limit: float) -> str:
    """A number in the unit of a sheet, with at least four decimals and an error far below its limit."""
    shown = value / scale
    for digits in range(4, MOST_DIGITS):
        text = rounded(shown, digits)
        if abs(float(text) - shown) * scale <= limit / 10:
            return text
    return repr(shown)


def exact(value: float) -> Number:
    """A float as a number of a tree."""
    return Number(Fraction(value))
