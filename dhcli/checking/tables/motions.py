"""Whether an answer moves as the right robot does: exactly for symbols, within tolerances for numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.algebra.residues import Residues
from dhcli.checking.symbolic import has_decimals
from dhcli.checking.tolerance import CLOSE_FACTOR, SLACK, Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.kinematics.axes import Arm, Point
from dhcli.kinematics.fits import Limits
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import put_in
from dhcli.kinematics.moves import Chain, Fixed, Rot, expressions, names
from dhcli.kinematics.robot import Value
from dhcli.kinematics.same_robot import MOST_LEAVES, Match, Miss, Registration, error_of, identity
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number, Sum
from dhcli.notation.walk import symbols, walk

DRAWS = 3
EXACT = 1e-7
TRIED = 6


@dataclass(frozen=True, slots=True)
class Values:
    """What is known of the names.

    Attributes:
        given: Values that the task states; they may stand for their names.
        own: Values of the robot, for answers in numbers.
    """

    given: Mapping[str, Value]
    own: Mapping[str, Value]


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came out of a comparison.

    Attributes:
        verdict: RIGHT, CLOSE or WRONG.
        match: How the answer is the right robot, if it is one.
        joints: How many joints from the first one agree.
        point: Values at which the match was found.
        size: Sum of all lengths there [m].
        rounded: Whether tolerances were needed.
        miss: What keeps the next joint from agreeing.
    """

    verdict: Verdict
    match: Match | None
    joints: int
    point: Point
    size: float
    rounded: bool = False
    miss: Miss = Miss.MOTION


def same_motion(truth: Arm, other: Arm, values: Values, tolerance: Tolerance) -> Outcome:
    """Compare T(q) itself, with the same base and end frame."""
    claim = identity(truth)
    if truth.variables == other.variables and _equal_chains(truth.chain, other.chain, values):
        point = next(_points(truth, other, values))
        return Outcome(Verdict.RIGHT, claim, len(claim.senses), point, _size(truth, point))
    point = next(_points(truth, other, values))
    if truth.variables == other.variables and has_numbers(other.chain):
        point = _rounded_point(truth, other, values)
        verdict = _verdict(claim, truth, other, point, tolerance)
        if verdict is not Verdict.WRONG:
            return Outcome(verdict, claim, len(claim.senses), point, _size(truth, point), rounded=True)
    return Outcome(Verdict.WRONG, None, 0, point, _size(truth, point))


def same_robot(truth: Arm, other: Arm, values: Values, tolerance: Tolerance, *, end_free: bool = False) -> Outcome:
    """Look for B, E, σ and q0 with `T'(q) = B · T(σq + q0) · E`.

    Args:
        truth: The right robot.
        other: The answer.
        values: Values of names.
        tolerance: Largest errors for numbers.
        end_free: Whether E may be anything; else it is nothing.
    """
    same = same_motion(truth, other, values, tolerance)
    if same.verdict is Verdict.RIGHT:
        return same
    first: Outcome | None = None
    for point in islice(_points(truth, other, values), DRAWS):
        outcome = _exact(truth, other, point, 1 if first else MOST_LEAVES, end_free=end_free)
        if outcome.match is None:
            break
        first = first or outcome
    else:
        assert first is not None  # noqa: S101  there are points
        return first
    if not has_numbers(other.chain):
        return outcome
    about = _about(truth, other, _rounded_point(truth, other, values), tolerance, end_free=end_free)
    if about.verdict is Verdict.RIGHT or same.verdict is not Verdict.CLOSE:
        return about
    return same


def may_be_same(truth: Arm, other: Arm, values: Values, *, end_free: bool = False) -> bool:
    """A first look at one point, cheap enough for many candidates: whether `same_robot` could come out RIGHT at all."""
    if has_numbers(other.chain) or has_numbers(truth.chain):
        return True
    point = next(_points(truth, other, values))
    limits = Limits.exact(_size(truth, point) + _size(other, point))
    return next(Registration(truth, other, point, limits, end_free=end_free).matches(), None) is not None


def has_numbers(chain: Chain) -> bool:
    """Whether lengths in numbers, or decimals and angles that may be rounded, stand in a chain."""
    if any(has_decimals(expr) for expr in expressions(chain)):
        return True
    return _has_lengths(chain) or any(
        isinstance(move, Rot) and (move.angle.radians or move.angle.degrees.denominator != 1) for move in chain
    )


def _exact(truth: Arm, other: Arm, point: Point, most: int, *, end_free: bool) -> Outcome:
    """Decide at one point; among so many matches the plainest is taken, and checked on the chains themselves."""
    size = _size(truth, point) + _size(other, point)
    search = Registration(truth, other, point, Limits.exact(size), end_free=end_free)
    for match in sorted(islice(search.matches(), most), key=oddity)[:TRIED]:
        turn, shift = error_of(match, truth, other, point, size)
        if turn <= EXACT and shift <= EXACT * size:
            return Outcome(Verdict.RIGHT, match, len(truth.variables), point, size)
    return Outcome(Verdict.WRONG, None, search.deepest, point, size, miss=search.miss)


def _about(truth: Arm, other: Arm, point: Point, tolerance: Tolerance, *, end_free: bool) -> Outcome:
    size = _size(truth, point)
    shift = tolerance.position if tolerance.position is not None else tolerance.rotation * size
    best: tuple[Verdict, Match | None] = (Verdict.WRONG, None)
    search = Registration(truth, other, point, Limits.rounded(tolerance.rotation, shift, 20), end_free=end_free)
    for match in sorted(islice(search.matches(), MOST_LEAVES), key=oddity)[:TRIED]:
        verdict = _verdict(match, truth, other, point, tolerance)
        if verdict is Verdict.RIGHT:
            return Outcome(verdict, match, len(truth.variables), point, size, rounded=True)
        if verdict is Verdict.CLOSE and best[1] is None:
            best = verdict, match
    strict = Registration(truth, other, point, Limits.rounded(tolerance.rotation, shift, 2), end_free=end_free)
    list(islice(strict.matches(), 1))
    return Outcome(*best, strict.deepest, point, size, rounded=True, miss=strict.miss)


def _verdict(match: Match, truth: Arm, other: Arm, point: Point, tolerance: Tolerance) -> Verdict:
    size = _size(truth, point)
    turn, shift = error_of(match, truth, other, point, size)
    limit = tolerance.position if tolerance.position is not None else tolerance.rotation * size
    worst = max(turn / tolerance.rotation, shift / max(limit, 1e-12 * size))
    if worst <= 1 + SLACK:
        return Verdict.RIGHT
    return Verdict.CLOSE if worst <= CLOSE_FACTOR * (1 + SLACK) else Verdict.WRONG


def oddity(match: Match) -> tuple[int, int]:
    """How much a match has to explain; the plainest is told to the student."""
    senses = sum(sense < 0 for sense in match.senses)
    zeros = sum(abs(zero) > 1e-6 for zero in match.zeros)  # noqa: PLR2004
    ends = sum(end.tilt() > 1e-6 or any(abs(x) > 1e-6 for x in end.offset) for end in (match.base, match.tool))  # noqa: PLR2004
    return senses + zeros + ends, senses


def _equal_chains(first: Chain, second: Chain, values: Values) -> bool:
    """Whether two products are equal for all values of their names, decided in residues; else at points."""
    first, second = put_in(first, values.given), put_in(second, values.given)
    both = (*first, *second)
    angles = [move.angle for move in both if isinstance(move, Rot)]
    try:
        over = Residues(tuple(expressions(both)), angles)
        return all(
            over.value(a) == over.value(b)
            for one, two in zip(fold(first, over), fold(second, over), strict=True)
            for a, b in zip(one, two, strict=True)
        )
    except (CannotHoldError, ZeroDivisionError):
        for drawn in islice(general(names(both), 23), DRAWS):
            floats = Floats(drawn)
            one_at, two_at = fold(first, floats), fold(second, floats)
            if not all(
                abs(a - b) <= EXACT for r, s in zip(one_at, two_at, strict=True) for a, b in zip(r, s, strict=True)
            ):
                return False
        return True


def _points(truth: Arm, other: Arm, values: Values) -> Iterator[Point]:
    """Seeded values of all names but the variables; what is given stays as given."""
    free = (names(truth.chain) | names(other.chain)) - set(truth.variables) - set(other.variables)
    given = numbers(values.given)
    return ({**drawn, **given} for drawn in general(free, 5))


def _rounded_point(truth: Arm, other: Arm, values: Values) -> Point:
    """Values for an answer in numbers: the robot's own, where the answer does not keep the letter.

    A letter that the answer uses is drawn, if the right table has it once: so the wrong one of two lengths that
    happen to be equal is still found.
    """
    drawn = dict(next(_points(truth, other, values)))
    if not _has_lengths(other.chain):
        return drawn
    used = names(other.chain)
    cells = [symbols(expr) for expr in expressions(truth.chain)] + [
        move.angle.names for move in truth.chain if isinstance(move, Rot)
    ]
    known = numbers({name: value for name, value in values.own.items() if not _names_in(value)})
    for name, value in known.items():
        if name in drawn and not (name in used and sum(name in cell for cell in cells) == 1):
            drawn[name] = value
    return {**drawn, **numbers(values.given)}


def _has_lengths(chain: Chain) -> bool:
    return any(
        not symbols(term) and any(isinstance(node, Number) and node.value for node in walk(term))
        for move in chain
        if not isinstance(move, Rot)
        for expr in expressions((move,))
        for term in (expr.terms if isinstance(expr, Sum) else (expr,))
    )


def _names_in(value: Value) -> frozenset[str]:
    return value.names if isinstance(value, Angle) else symbols(value)


def _size(arm: Arm, point: Point) -> float:
    """Sum of all lengths in the zero pose, or one metre where there is none."""
    over = Floats({**point, **dict.fromkeys(arm.variables, 0.0)})
    total = 0.0
    for move in arm.chain:
        if isinstance(move, Fixed):
            total += sum(abs(over.value(row[3])) for row in move.rows)
        elif not isinstance(move, Rot):
            total += sum(abs(over.value(expr)) for expr in move.offset)
    return total or 1.0
