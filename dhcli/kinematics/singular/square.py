"""The determinant of a square Jacobian in factors: columns and frames are chosen so that it falls apart by itself.

Neighbours about parallel axes are subtracted, which leaves z×(o_j - o_i) of the first; the velocities are taken at the
point where the fewest joints move, and written along the axes, and the turning rates along others, for which the zeros
give the finest blocks on the diagonal. Where the zeros are is read off one evaluation in residues, and so is the proof.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import product as pairs

from dhcli.algebra.sizes import SIZES
from dhcli.frozen import frozen
from dhcli.kinematics.singular.arm import Arm, Point, Triple
from dhcli.kinematics.singular.blocks import Block, blocks_of
from dhcli.kinematics.singular.forms import determinant, shortest
from dhcli.kinematics.singular.modular import minus
from dhcli.kinematics.singular.polynomial import TooLongError, product
from dhcli.notation.angle import Rational
from dhcli.notation.tree import Expr, number
from dhcli.notation.walk import operations

LONGEST_BLOCK = 600
"""Symbols of the longest block that is multiplied out; the one of the PUMA 200 as printed has under 100."""

MOST_TRIED = 4
"""Choices of frames, alike in their blocks, whose determinants are all written, for the shortest."""


@frozen
class Difference:
    """The column of a joint, or how it differs from that of another about a parallel axis, with the sign of that."""

    joint: int
    less: int | None = None
    sign: int = 1


@frozen
class Choice:
    """Where a determinant falls apart.

    Attributes:
        axes: Places of the axes of v and of those of ω.
        place: The place whose point the velocities are of.
        columns: The columns.
        rows: The rows that are kept, of the six.
        blocks: The blocks, rows and columns by their places among those.
    """

    axes: tuple[int, int]
    place: int
    columns: tuple[Difference, ...]
    rows: tuple[int, ...]
    blocks: tuple[Block, ...]

    @property
    def cost(self) -> tuple[int, ...]:
        """The largest block first: what has to be expanded."""
        return tuple(sorted((len(columns) for _, columns in self.blocks), reverse=True))


def differences(point: Point, joints: Sequence[int]) -> tuple[Difference, ...]:
    """The columns of some joints, each less the next one about a parallel axis."""
    found = []
    hinges = point.arm.is_hinge
    for k, joint in enumerate(joints):
        less = None
        if hinges[joint]:
            less = next((j for j in joints[k + 1 :] if hinges[j] and point.parallel(joint, j)), None)
        found.append(Difference(joint) if less is None else Difference(joint, less, point.parallel(joint, less)))
    return tuple(found)


def best_places(point: Point, joints: Sequence[int]) -> tuple[int, ...]:
    """The places whose point the fewest of the joints move; of several with one point, the last."""
    origins = {origin: place for place, origin in ((k, point.origins[k]) for k in point.arm.places)}
    moving = {place: sum(any(point.velocity(joint, origin)) for joint in joints) for origin, place in origins.items()}
    fewest = min(moving.values())
    return tuple(place for place, count in moving.items() if count == fewest)


def choices(
    point: Point, columns: tuple[Difference, ...], places: Sequence[int], kept: Sequence[int], count: int
) -> Iterator[Choice]:
    """Choices of a point and of axes, with the blocks that they give; see `Choice`.

    Args:
        point: The arm at a random point.
        columns: The columns.
        places: Places of points to try.
        kept: The rows that the task has, of the six, along the axes of the start.
        count: How many rows of v the task has.
    """
    linear = [k for k in kept if k < 3]  # noqa: PLR2004  rows of v
    patterns_v: dict[tuple[int, ...], tuple[int, int]] = {}
    for place, axes in pairs(places, point.arm.turning) if linear else [(places[0], 0)]:
        pattern = _pattern([point.along(_velocity(point, c, place), axes) for c in columns], len(linear))
        if pattern is not None:
            patterns_v.setdefault(pattern, (place, axes))
    patterns_w: dict[tuple[int, ...], int] = {}
    for axes in point.arm.turning if len(linear) < len(kept) else [0]:
        pattern = _pattern([point.along(_spin(point, c), axes) for c in columns], len(kept) - len(linear))
        if pattern is not None:
            patterns_w.setdefault(pattern, axes)
    for (upper, (place, axes)), (lower, other) in pairs(patterns_v.items(), patterns_w.items()):
        rows = [(k, bits) for k, bits in enumerate(upper) if bits and linear]
        rows += [(k + 3, bits) for k, bits in enumerate(lower) if bits and len(linear) < len(kept)]
        if len(rows) != count:
            continue
        blocks = blocks_of([bits for _, bits in rows], len(columns))
        if blocks is not None:
            yield Choice((axes, other), place, columns, tuple(k for k, _ in rows), blocks)


def choices_of_rows(
    point: Point, columns: tuple[Difference, ...], places: Sequence[int], kept: Sequence[int]
) -> Iterator[tuple[tuple[int, int], int, tuple[int, ...]]]:
    """Axes of v and of ω, a place, and for each of the six rows the columns that are not zero there, as bits."""
    linear, turning = kept[0] < 3, kept[-1] > 2  # noqa: PLR2004  whether there are rows of v, and of ω
    for place, axes, other in pairs(places, point.arm.turning, point.arm.turning if turning else [0]):
        upper = _bits([point.along(_velocity(point, c, place), axes) for c in columns]) if linear else (0, 0, 0)
        lower = _bits([point.along(_spin(point, c), other) for c in columns]) if turning else (0, 0, 0)
        yield (axes, other), place, (*upper, *lower)


def _spin(point: Point, column: Difference) -> Triple:
    return (0, 0, 0) if column.less is not None else point.angular[column.joint]


def _bits(vectors: Sequence[Triple]) -> tuple[int, ...]:
    """For each of three rows the columns that are not zero, as bits."""
    return tuple(sum(bool(vector[k]) << c for c, vector in enumerate(vectors)) for k in range(3))


def _pattern(vectors: Sequence[Triple], wanted: int) -> tuple[int, ...] | None:
    """For each of three rows the columns that are not zero, as bits; None if more rows are filled than wanted."""
    pattern = _bits(vectors)
    return pattern if sum(map(bool, pattern)) <= wanted or not wanted else None


def _velocity(point: Point, column: Difference, place: int) -> Triple:
    if column.less is None:
        return point.velocity(column.joint, point.origins[place])
    # of a point on the axis of the other one, by this joint alone
    prime = point.field.prime
    here = point.velocity(column.joint, point.origins[place])
    there = tuple(column.sign * v for v in point.velocity(column.less, point.origins[place]))
    return minus(here, there, prime)


class Writing:
    """Determinants in terms; each column is folded once."""

    def __init__(self, arm: Arm) -> None:
        """Fold nothing yet."""
        self.arm = arm
        self.column = cache(self._column)

    def _column(self, column: Difference, axes: int, place: int | None) -> tuple[Expr | int, ...]:
        """Three entries: v at a place, or ω if there is none."""
        arm, joint = self.arm, column.joint
        if place is None:
            if column.less is not None:
                return (0, 0, 0)
            return tuple(arm.column(joint, axes, 0, until=arm.homes[joint][-1] + 1).angular[0])
        until = None if column.less is None else arm.homes[column.less][0]
        return tuple(arm.column(joint, axes, place, until).linear[0])

    def entry(self, choice: Choice, row: int, column: Difference) -> Expr:
        """One entry of the matrix."""
        linear = row < 3  # noqa: PLR2004  rows of v
        entries = self.column(column, choice.axes[0 if linear else 1], choice.place if linear else None)
        entry = entries[row % 3]
        return number(entry) if isinstance(entry, int) else entry

    def block(self, choice: Choice, block: Block) -> list[list[Expr]]:
        """One block on the diagonal.

        Raises:
            TooLongError: Its determinant would be longer than anybody reads.
        """
        rows = [[self.entry(choice, choice.rows[r], choice.columns[c]) for c in block[1]] for r in block[0]]
        if size_of(rows) > LONGEST_BLOCK:
            raise TooLongError
        return rows

    def factors(self, choice: Choice) -> tuple[Rational, dict[Expr, int]]:
        """The determinant up to sign, in factors."""
        value: Rational = 1
        found = dict[Expr, int]()
        for block in choice.blocks:
            own, factors = shortest(determinant(self.block(choice, block)))
            value *= own
            for base, exponent in factors.items():
                found[base] = found.get(base, 0) + exponent
        return value, {base: exponent for base, exponent in found.items() if exponent}


def factored(
    arm: Arm, point: Point, joints: Sequence[int], kept: Sequence[int]
) -> tuple[Rational, dict[Expr, int], Choice] | None:
    """The determinant of the chosen columns and rows up to sign, in factors, by the choice that gives the shortest.

    Returns:
        A number, the factors with their exponents, and the choice; None if no axes leave as many rows as are kept.
    """
    columns = differences(point, joints)
    # without ω the determinant is that of one point; with it, of any that the body carries
    places = best_places(point, joints) if kept[-1] > 2 else (len(arm.chain),)  # noqa: PLR2004  a row of ω
    found = sorted(choices(point, columns, places, kept, len(joints)), key=lambda choice: choice.cost)
    if not found:
        return None
    writing = Writing(arm)
    alike = [choice for choice in found if choice.cost == found[0].cost][:MOST_TRIED]
    tried = [(*writing.factors(choice), choice) for choice in alike]
    return min(tried, key=lambda one: operations(product(one[0], one[1])))


def size_of(rows: Sequence[Sequence[Expr]]) -> int:
    """The symbols of a determinant that is multiplied out over its rows, counted before it is."""
    over = [[SIZES.length(entry) for entry in row] for row in rows]
    counts = [[0 if entry == 0 else 1 if isinstance(entry, int) else entry.count for entry in row] for row in over]

    @cache
    def below(row: int, taken: frozenset[int]) -> tuple[int, int]:
        """How many products the rows from one on have, and how many symbols."""
        if row == len(counts):
            return 1, 0
        products, symbols = 0, 0
        for column, count in enumerate(counts[row]):
            if count and column not in taken:
                many, long = below(row + 1, taken | {column})
                products, symbols = products + many, symbols + long + many * count
        return products, symbols

    return below(0, frozenset())[1]
