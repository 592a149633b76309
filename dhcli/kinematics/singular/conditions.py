"""Where all of several determinants vanish at once: the conditions of an arm whose Jacobian is not square."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from itertools import product as every
from math import comb
from typing import TypeAlias

from dhcli.algebra.equality import equal
from dhcli.kinematics.singular.arm import Arm, Point
from dhcli.kinematics.singular.blocks import blocks_of
from dhcli.kinematics.singular.forms import shortest
from dhcli.kinematics.singular.modular import determinant
from dhcli.kinematics.singular.polynomial import TooLongError
from dhcli.kinematics.singular.square import Choice, Writing, best_places, choices_of_rows, differences, factored
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Symbol, Trig
from dhcli.notation.walk import operations, substitute, symbols

Zeros: TypeAlias = frozenset[Expr]
"""Factors of one determinant: it vanishes where one of them does. Or expressions that are zero at once."""

Put: TypeAlias = tuple[dict[str, Expr], dict[str, Angle]]
"""A value of a slide, or of an angle, to be put in."""

MOST_MINORS = 40
MOST_STEPS = 400
MOST_CONDITIONS = 12
LONGEST_CONDITION = 20
"""Operations of a condition that is still read."""


class UnreadableError(ArithmeticError):
    """There is no list of conditions that anybody would read."""


def conditions(arm: Arm, point: Point, kept: Sequence[int]) -> tuple[tuple[Expr, ...], ...]:
    """The conditions, each of one or more expressions, under which the rank falls; none if it never does.

    Raises:
        UnreadableError: They are too many or too long.
    """
    minors = list(_by_columns(arm, point, kept) if len(arm.joints) > len(kept) else _by_rows(arm, point, kept))
    splitting = _Splitting(arm)
    try:
        splitting.split(minors, frozenset())
    except TooLongError:
        raise UnreadableError from None
    found = {_trimmed(one, arm.joints) for one in splitting.found}
    least = [one for one in found if not any(other < one for other in found)]
    if len(least) > MOST_CONDITIONS or any(sum(map(operations, one)) > LONGEST_CONDITION for one in least):
        raise UnreadableError
    order = {joint: k for k, joint in enumerate(arm.joints)}
    written = [tuple(sorted(one, key=lambda zero: (operations(zero), _first(zero, order)))) for one in least]
    return tuple(sorted(written, key=lambda one: (len(one), [_first(zero, order) for zero in one])))


def _first(zero: Expr, order: dict[str, int]) -> tuple[int, str]:
    return min((order[name] for name in symbols(zero) if name in order), default=0), str(zero)


def _by_columns(arm: Arm, point: Point, kept: Sequence[int]) -> Iterator[Zeros]:
    """The determinants of as many columns as there are rows."""
    if comb(len(arm.joints), len(kept)) > MOST_MINORS:
        raise UnreadableError
    rows = point.rows()
    for joints in combinations(range(len(arm.joints)), len(kept)):
        if determinant([[rows[k][j] for j in joints] for k in kept], point.field):
            found = factored(arm, point, joints, kept)
            if found is None:
                raise UnreadableError
            yield moving(found[1], arm)


def _by_rows(arm: Arm, point: Point, kept: Sequence[int]) -> Iterator[Zeros]:
    """The determinants of as many rows as there are columns, along the axes with the most zeros."""
    joints = range(len(arm.joints))
    columns = differences(point, joints)
    places = best_places(point, joints) if kept[-1] > 2 else (len(arm.chain),)  # noqa: PLR2004  a row of ω
    axes, place, patterns = min(
        choices_of_rows(point, columns, places, kept), key=lambda one: sum(bits.bit_count() for bits in one[2])
    )
    rows = [k for k, bits in enumerate(patterns) if bits]
    if comb(len(rows), len(columns)) > MOST_MINORS:
        raise UnreadableError
    writing = Writing(arm)
    for some in combinations(rows, len(columns)):
        blocks = blocks_of([patterns[k] for k in some], len(columns))
        if blocks is not None:
            value, factors = writing.factors(Choice(axes, place, columns, some, blocks))
            if value:
                yield moving(factors, arm)


def moving(factors: Iterable[Expr], arm: Arm) -> Zeros:
    """The factors that joints can make zero."""
    joints = set(arm.joints)
    return frozenset(factor for factor in factors if joints & symbols(factor))


class _Splitting:
    """All ways to make every determinant zero, a factor of each at a time."""

    def __init__(self, arm: Arm) -> None:
        self.arm = arm
        self.found: set[Zeros] = set()
        self.steps = 0

    def split(self, minors: Sequence[Zeros], zeros: Zeros) -> None:
        """Go on until nothing is left to vanish.

        Args:
            minors: Determinants that do not vanish yet, as their factors.
            zeros: What is zero already.
        """
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise UnreadableError
        if any(known <= zeros for known in self.found):
            return
        least = [one for one in minors if not any(other < one for other in minors)]
        if not least:
            self.found.add(zeros)
            return
        if frozenset() in least:
            return
        common = frozenset.intersection(*least)
        for factor in sorted(common, key=str):
            self.found.add(zeros | {factor})
        if common:
            self.split([one - common for one in least], zeros)
            return
        fewest: Zeros = min(least, key=_fewest)
        for factor in sorted(fewest, key=_plainness):
            rest = (self.given(one, factor) for one in least if factor not in one)
            self.split([one for one in rest if one is not None], zeros | {factor})

    def given(self, minor: Zeros, zero: Expr) -> Zeros | None:
        """A determinant where something is zero: simpler factors, none that can vanish, or None if it vanishes too."""
        ways = zeroing(zero, self.arm.joints)
        if not ways:
            return minor
        kept: set[Expr] = set()
        for factor in minor:
            branches = [self.simpler(factor, values) for values in ways]
            if all(branch is None for branch in branches):
                return None
            if branches[0] is None or any(branch != branches[0] for branch in branches):
                kept.add(factor)  # another one on each branch: it stays as it is
            else:
                kept |= branches[0]
        return frozenset(kept)

    def simpler(self, factor: Expr, values: Put) -> Zeros | None:
        """The factors that are left of one when a joint has a value; itself if it is no shorter, None if it is 0."""
        put = substitute(factor, *values)
        if put == factor:
            return frozenset({factor})
        value, factors = shortest(put)
        if not value:
            return None
        left = moving(factors, self.arm)
        shorter = not left or sum(map(operations, left)) < operations(factor)
        return left if shorter else frozenset({factor})


def zeroing(zero: Expr, joints: Sequence[str]) -> list[Put]:
    """The values of one joint for which a cosine or sine, or a slide by itself, is zero; none for what else is."""
    if isinstance(zero, Symbol):
        return [({zero.name: ZERO}, {})]
    if not isinstance(zero, Trig):
        return []
    terms = dict(zero.angle.terms)
    name = next(name for name in reversed(joints) if name in terms)
    start = 0 if zero.function == "sin" else 90
    rest = zero.angle - Angle.of(name) * terms[name]
    share = Fraction(1) / terms[name]
    return [({}, {name: (Angle.in_degrees(start + half) - rest) * share}) for half in (0, 180)]


def _trimmed(zeros: Zeros, joints: Sequence[str]) -> Zeros:
    """Zeros without those that follow from the others."""
    for zero in sorted(zeros, key=_plainness, reverse=True):
        ways = [zeroing(other, joints) for other in zeros if other != zero]
        settled = [way for way in ways if way]
        if settled and all(equal(_put(zero, puts), ZERO) for puts in every(*settled)):
            return _trimmed(zeros - {zero}, joints)
    return zeros


def _put(expr: Expr, puts: Iterable[Put]) -> Expr:
    for put in puts:
        expr = substitute(expr, *put)
    return expr


def _plainness(factor: Expr) -> tuple[int, str]:
    return operations(factor), str(factor)


def _fewest(minor: Zeros) -> tuple[int, int]:
    return len(minor), sum(map(operations, minor))
