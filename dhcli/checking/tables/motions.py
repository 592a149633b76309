"""Whether an answer moves as the right robot does: exactly for symbols, within tolerances for numbers."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from itertools import islice

from dhcli.checking.tables.right import EXACT, RightArm
from dhcli.checking.tables.samples import has_numbers, points_of_values
from dhcli.checking.tolerance import CLOSE_FACTOR, SLACK, Tolerance
from dhcli.checking.verdicts import Verdict, worst
from dhcli.frozen import frozen
from dhcli.geometry.rigid import Rigid
from dhcli.kinematics.axes import Arm, Point
from dhcli.kinematics.fits import Limits, may_be_alike
from dhcli.kinematics.same_robot import MOST_LEAVES, Match, Miss, Registration, error_of, identity

DRAWS = 3
TRIED = 6
FAR, NEAR = 20, 2
"""How many tolerances two axes may be apart: where a match is looked for, and where one is told to agree."""

LARGEST = 1e6
"""Lengths that add up to more than so many times those of the robot are not its lengths, and floats drown in them."""


@frozen
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
        is_free: Whether base, end, zeros or senses differ from those of the robot.
    """

    verdict: Verdict
    match: Match | None
    joints: int
    point: Point
    size: float
    rounded: bool = False
    miss: Miss = Miss.MOTION
    is_free: bool = False


class TwoArms:
    """A table beside the right arm: each thing that is asked of the two is worked out once."""

    def __init__(self, right: RightArm, other: Arm, tolerance: Tolerance) -> None:
        """Compare an arm with the right one; the tolerance says what errors numbers may have."""
        self._right = right
        self._truth = right.arm
        self._other = other
        self._tolerance = tolerance
        self._found: dict[bool, Outcome] = {}
        self._exact: dict[tuple[int, bool], Outcome] = {}

    @cached_property
    def same_motion(self) -> Outcome:
        """What comes out for T(q) itself, with the same base and end frame."""
        truth, other = self._truth, self._other
        claim, joints = identity(truth), len(truth.variables)
        point = self._point
        size = truth.size(point)
        if truth.variables != other.variables:
            return Outcome(Verdict.WRONG, None, 0, point, size)
        if self._right.equals(other.chain):
            return Outcome(Verdict.RIGHT, claim, joints, point, size)
        if self._is_numeric:
            points = self._points
            verdict = worst(_verdict(claim, truth, other, at, self._tolerance) for at in points)
            if verdict is not Verdict.WRONG:
                return Outcome(verdict, claim, joints, points[0], truth.size(points[0]), rounded=True)
        return Outcome(Verdict.WRONG, None, 0, point, size)

    def same_robot(self, *, end_free: bool = False) -> Outcome:
        """Look for B, E, σ and q0 with `T'(q) = B · T(σq + q0) · E`.

        Args:
            end_free: Whether E may be anything; else it is nothing.
        """
        if end_free not in self._found:
            self._found[end_free] = self._same_robot(end_free=end_free)
        return self._found[end_free]

    def may_be_same(self, *, end_free: bool) -> bool:
        """A first look at one point, cheap enough for many arms: whether `same_robot` could come out RIGHT at all."""
        truth, other = self._truth, self._other
        if self._is_numeric or has_numbers(truth.chain):
            point = self._points[0]
            limits = _rounded(self._tolerance, truth.size(point), FAR)
        else:
            point = self._point
            limits = Limits.exact(truth.size(point) + other.size(point))
            if not may_be_alike(truth.screws(point)[0], other.screws(point)[0], limits):
                return False
        return next(Registration(truth, other, point, limits, end_free=end_free).matches(), None) is not None

    def agreeing(self, outcome: Outcome) -> int:
        """How many joints agree from the first one, where an outcome was decided; what else must agree is not asked."""
        limits = _rounded(self._tolerance, outcome.size, NEAR) if outcome.rounded else Limits.exact(outcome.size)
        search = Registration(self._truth, self._other, outcome.point, limits, end_free=True)
        next(search.matches(), None)
        return search.deepest

    def beside(self, right: RightArm) -> TwoArms:
        """The same arm compared with another right one."""
        other = TwoArms(right, self._other, self._tolerance)
        other._is_numeric = self._is_numeric
        return other

    def reach(self) -> int:
        """How many joints agree from the first one, letters alone, whatever the end frame is."""
        limits = Limits.exact(self._truth.size(self._point) + self._other.size(self._point))
        search = Registration(self._truth, self._other, self._point, limits, end_free=True)
        next(search.matches(), None)
        return search.deepest

    @cached_property
    def _is_numeric(self) -> bool:
        return has_numbers(self._other.chain)

    @cached_property
    def _point(self) -> Point:
        return next(self._right.points(self._other))

    @cached_property
    def _points(self) -> tuple[Point, ...]:
        """Where an answer in numbers is judged."""
        return points_of_values(self._truth, self._other, self._right.values, self._point)

    def _same_robot(self, *, end_free: bool) -> Outcome:
        truth, other, same = self._truth, self._other, self.same_motion
        if same.verdict is Verdict.RIGHT:
            return same
        points = self._points if self._is_numeric else (same.point,)
        if any(not other.size(at) <= LARGEST * truth.size(at) for at in points):
            return same
        about = self._about(points, end_free=end_free) if self._is_numeric else same
        if about.verdict is Verdict.RIGHT:
            return about
        exact = self._everywhere(end_free=end_free)
        if exact.verdict is Verdict.RIGHT or not self._is_numeric:
            return exact
        return about if same.verdict is not Verdict.CLOSE else same

    def _everywhere(self, *, end_free: bool) -> Outcome:
        """Decide at several points of the letters: the first match if there is one at each, else the point without."""
        first: Outcome | None = None
        for index, point in enumerate(islice(self._right.points(self._other), DRAWS)):
            outcome = self._exactly(index, point, end_free=end_free)
            if outcome.match is None:
                return outcome
            first = first or outcome
        assert first is not None  # noqa: S101  there are points
        return first

    def _exactly(self, index: int, point: Point, *, end_free: bool) -> Outcome:
        """Decide at one point; where not all joints agree, it is the same whatever the end frame may be."""
        if (index, end_free) not in self._exact:
            found = self._exact.get((index, not end_free))
            if found is None or found.match is not None or found.joints == len(self._truth.variables):
                most = 1 if index else MOST_LEAVES
                found = _exact(self._truth, self._other, point, most, end_free=end_free)
            self._exact[index, end_free] = found
        return self._exact[index, end_free]

    def _about(self, points: tuple[Point, ...], *, end_free: bool) -> Outcome:
        """Decide within tolerances at the robot's values, and see that it is so for other lengths of its letters."""
        truth, other, tolerance = self._truth, self._other, self._tolerance
        first = _about_at(truth, other, points[0], tolerance, end_free=end_free)
        for point in points[1:] if first.match is not None else ():
            again = _about_at(truth, other, point, tolerance, end_free=end_free)
            if again.match is None:
                return again
            first = replace(first, verdict=worst((first.verdict, again.verdict)))
        return first


def _rounded(tolerance: Tolerance, size: float, times: float) -> Limits:
    shift = tolerance.position if tolerance.position is not None else tolerance.rotation * size
    return Limits.rounded(tolerance.rotation, shift, times)


def _exact(truth: Arm, other: Arm, point: Point, most: int, *, end_free: bool) -> Outcome:
    """Decide at one point; among so many matches the plainest is taken, and checked on the chains themselves."""
    size = truth.size(point)
    search = Registration(truth, other, point, Limits.exact(size), end_free=end_free)
    for match in sorted(islice(search.matches(), most), key=oddity)[:TRIED]:
        turn, shift = error_of(match, truth, other, point, size, (EXACT, EXACT * size))
        if turn <= EXACT and shift <= EXACT * size:
            return Outcome(Verdict.RIGHT, match, len(truth.variables), point, size, is_free=True)
    return Outcome(Verdict.WRONG, None, search.deepest, point, size, miss=search.miss)


def _about_at(truth: Arm, other: Arm, point: Point, tolerance: Tolerance, *, end_free: bool) -> Outcome:
    size = truth.size(point)
    best: tuple[Verdict, Match | None] = (Verdict.WRONG, None)
    search = Registration(truth, other, point, _rounded(tolerance, size, FAR), end_free=end_free)
    for found in sorted(islice(search.matches(), MOST_LEAVES), key=oddity)[:TRIED]:
        match = found if end_free else replace(found, tool=Rigid())  # what is left there is an error, no freedom
        verdict = _verdict(match, truth, other, point, tolerance)
        if verdict is Verdict.RIGHT:
            return Outcome(verdict, match, len(truth.variables), point, size, rounded=True, is_free=True)
        if verdict is Verdict.CLOSE and best[1] is None:
            best = verdict, match
    strict = Registration(truth, other, point, _rounded(tolerance, size, NEAR), end_free=end_free)
    list(islice(strict.matches(), 1))
    return Outcome(*best, strict.deepest, point, size, rounded=True, miss=strict.miss, is_free=True)


def _verdict(match: Match, truth: Arm, other: Arm, point: Point, tolerance: Tolerance) -> Verdict:
    size = truth.size(point)
    turn = max(tolerance.rotation, 1e-12)
    shift = max(tolerance.rotation * size if tolerance.position is None else tolerance.position, 1e-12 * size)
    far = CLOSE_FACTOR * (1 + SLACK)
    errors = error_of(match, truth, other, point, size, (far * turn, far * shift))
    off = max(errors[0] / turn, errors[1] / shift)
    if off <= 1 + SLACK:
        return Verdict.RIGHT
    return Verdict.CLOSE if off <= far else Verdict.WRONG


def oddity(match: Match) -> tuple[int, int]:
    """How much a match has to explain; the plainest is told to the student."""
    senses = sum(sense < 0 for sense in match.senses)
    zeros = sum(abs(zero) > 1e-6 for zero in match.zeros)  # noqa: PLR2004
    ends = sum(end.tilt() > 1e-6 or any(abs(x) > 1e-6 for x in end.offset) for end in (match.base, match.tool))  # noqa: PLR2004
    return senses + zeros + ends, senses


def is_but_for_end(match: Match) -> bool:
    """Whether nothing but the end frame is another."""
    return oddity(replace(match, tool=Rigid())) == (0, 0)
