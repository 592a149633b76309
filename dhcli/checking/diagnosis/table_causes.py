"""The slip behind a wrong DH table: one in the right table that gives the motion of the one typed, or the same robot.

The motion itself is compared first. A student who has drawn other frames gets another motion for the same slip: then
a slip is looked for whose table is the same robot as the one typed, but for the freedoms that a right table has too.
What is no single slip may still be one in each of several rows, which are then compared one by one.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property, reduce

from dhcli.algebra.floats import Floats
from dhcli.checking.diagnosis.bench import Bench, product
from dhcli.checking.diagnosis.row_by_row import each_in_a_row, same_in_rows, slips_by_row
from dhcli.checking.diagnosis.search import Numbers, matches, point
from dhcli.checking.diagnosis.slips import Candidate, right_table, table_slips
from dhcli.checking.diagnosis.work import Work
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.returned import Causes
from dhcli.checking.tables.answer import ends_on_axis, robot_of
from dhcli.checking.tables.cells import given_values, own_values
from dhcli.checking.tables.comparing import SAME_ROBOT, compare_of
from dhcli.checking.tables.motions import TwoArms
from dhcli.checking.tables.right import RightArm
from dhcli.checking.tables.samples import Values, has_numbers
from dhcli.checking.tolerance import DEFAULT, Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.errors import RobotError
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, inverse, names
from dhcli.kinematics.robot import Robot

MOST_KEPT = 8
"""Sets of names for which the motions are kept: a table may bring names of its own."""

MOTION = 2e-3
"""What two tables of the same motion may differ by, at lengths and angles near 1."""

EMPTY = {Convention.STANDARD: (2, 0), Convention.MODIFIED: (0, 2)}
"""The direction cosine that is zero in the matrix of every row."""

OFF = 4 * MOTION
"""What it may be where two products agree: each entry of a rotation between two others is off three times at most."""


def table_causes(case: Case, convention: Convention, rows: tuple[Row, ...]) -> Causes:
    """Mistakes in the right table that give the rows typed, their angles settled; none where there is no such table."""
    every, right = table_slips(case.memo, convention), right_table(case.memo)
    if right is None or not every:
        return ()
    slips = case.memo.of(("slips", convention), lambda: _Slips(case.exercise, right, every))
    moves = tuple(moves_of(row, convention) for row in rows)
    chain = tuple(move for row in moves for move in row)
    compared = _Compared(slips, moves, chain)
    moving_so = compared.with_one_slip()
    if moving_so:
        to_the_cell = [one for one in moving_so if [step.row for step in one.work.steps] == list(rows)]
        return tuple(one.slips for one in to_the_cell or moving_so)
    by_row = compared.by_row()
    found = same_in_rows(by_row)
    if not found and compare_of(case) == SAME_ROBOT:
        found = slips.same_robot(chain, case.tolerance)
    return found or each_in_a_row(by_row)


class _Slips:
    """The right table, and every one with a single slip: as motions and as robots, worked out once for all answers."""

    def __init__(self, exercise: Exercise, right: Work, every: tuple[Candidate, ...]) -> None:
        """Take what was found for the exercise."""
        self.right = right
        self.every = every
        self._exercise = exercise
        self._motions: dict[frozenset[str], _Motions] = {}
        self._arms: dict[int, RightArm | None] = {}

    @cached_property
    def places(self) -> list[tuple[int, int] | None]:
        """The first and the last row that each slip changes; None where it changes more than rows."""
        return [_places(one.work, self.right) for one in self.every]

    @property
    def _robot(self) -> Robot:
        return robot_of(self._exercise)

    @cached_property
    def _values(self) -> Values:
        return Values(given_values(self._exercise), own_values(self._exercise))

    def motions(self, free: frozenset[str]) -> _Motions:
        """The motions at points that have a value for some names besides those of the right table."""
        needed = free | names(_chain(self.right))
        if needed not in self._motions:
            if len(self._motions) >= MOST_KEPT:
                self._motions.clear()
            known = {n: v for n, v in own_values(self._exercise).items() if n not in self._robot.variables}
            self._motions[needed] = _Motions(
                self.right, self._robot.convention, [point(needed, known, seed) for seed in (3, 4)]
            )
        return self._motions[needed]

    def same_robot(self, chain: Chain, tolerance: Tolerance) -> Causes:
        """The slips with the robot of a chain; as that is a wrong one, none of them gives the right robot."""
        robot = self._robot
        end_free = robot.convention is Convention.MODIFIED and not ends_on_axis(robot)
        typed = Arm.of(chain, robot.variables)
        compared_with = TwoArms(self._forth, typed, tolerance)
        found = []
        for index in self._mendable(typed):
            candidate = self.every[index]
            try:
                if (arm := self._arm(index)) is None:
                    continue
                compared = compared_with.beside(arm)
                if not compared.may_be_same(end_free=end_free):
                    continue
                outcome = compared.same_robot(end_free=end_free)
            except RobotError:  # with these values there is no robot to compare with
                continue
            if outcome.verdict is Verdict.RIGHT:
                found.append(candidate.slips)
        return tuple(found)

    def _mendable(self, typed: Arm) -> Iterable[int]:
        """The slips that can lead to a robot: before and behind their rows, its axes lie as the right ones do.

        Axes in letters alone tell it, in the order of the robot; else any slip may be the one.
        """
        right = self._forth.arm
        if typed.variables != right.variables or has_numbers(typed.chain) or has_numbers(right.chain):
            return range(len(self.every))
        before = TwoArms(self._forth, typed, DEFAULT).reach()
        behind = TwoArms(self._back, Arm.of(inverse(typed.chain), self._robot.variables), DEFAULT).reach()
        rows = [self._row_of(name) for name in self._forth.arm.variables]

        def fits(first: int, last: int) -> bool:
            return sum(row < first for row in rows) <= before and sum(row > last for row in rows) <= behind

        return (index for index, place in enumerate(self.places) if place is None or fits(*place))

    @cached_property
    def _forth(self) -> RightArm:
        return RightArm(Arm.of(_chain(self.right), self._robot.variables), self._values)

    @cached_property
    def _back(self) -> RightArm:
        return RightArm(Arm.of(inverse(_chain(self.right)), self._robot.variables), self._values)

    def _row_of(self, name: str) -> int:
        return next(k for k, step in enumerate(self.right.steps) if name in names(step.chain))

    def _arm(self, index: int) -> RightArm | None:
        """The robot that a slip leads to; None where it leaves none."""
        if index not in self._arms:
            try:
                arm = Arm.of(_chain(self.every[index].work), self._robot.variables)
            except RobotError:
                self._arms[index] = None
            else:
                self._arms[index] = RightArm(arm, self._values)
        return self._arms[index]


class _Motions:
    """The product of the right table, and of those with a slip, at two points.

    Attributes:
        overs: The values of the names at each point.
        benches: What evaluates works there.
    """

    def __init__(self, right: Work, convention: Convention, overs: list[Floats]) -> None:
        """Take the points."""
        self.overs = overs
        self.benches = [Bench(right, over) for over in overs]
        self._right = right
        self._empty = EMPTY[convention]

    def rows(self, typed: Numbers) -> frozenset[int]:
        """The rows of which some other one would give what was typed at the first point; no slip in others does."""
        row, column = self._empty
        needed = (self.benches[0].needed(k, typed) for k in range(len(self._right.steps)))
        return frozenset(k for k, matrix in enumerate(needed) if abs(matrix[row][column]) <= OFF)


class _Compared:
    """A table typed, and the right one and those with a slip, at two points."""

    def __init__(self, slips: _Slips, rows: tuple[Chain, ...], chain: Chain) -> None:
        """Take the moves of each row typed, and all of them."""
        self._slips = slips
        self._motions = slips.motions(names(chain))
        self._rows = [[fold(row, over) for row in rows] for over in self._motions.overs]
        self._typed = [reduce(product, matrices) for matrices in self._rows]
        self._slack = tuple(tuple(MOTION for _ in row) for row in self._typed[0])

    def with_one_slip(self) -> list[Candidate]:
        """The slips with just the motion typed."""
        rows, found = self._motions.rows(self._typed[0]), []
        for one, place in zip(self._slips.every, self._slips.places, strict=True):
            is_likely = place is None or place[0] != place[1] or place[0] in rows
            if is_likely and self._agrees(one.work, self._typed) and not self._agrees(one.work, self._right):
                found.append(one)
        return found

    def by_row(self) -> tuple[tuple[Candidate, ...], ...]:
        """The slips behind each wrong row."""
        return slips_by_row(self._slips.right, self._slips.every, self._motions.benches, self._rows, self._slack)

    @cached_property
    def _right(self) -> list[Numbers]:
        return [bench.matrix(self._slips.right) for bench in self._motions.benches]

    def _agrees(self, work: Work, given: list[Numbers]) -> bool:
        benches = self._motions.benches
        return all(matches(there, b.matrix(work), self._slack) for there, b in zip(given, benches, strict=True))


def _places(work: Work, right: Work) -> tuple[int, int] | None:
    """Index of the first and the last row in which a table differs from the right one."""
    if len(work.steps) != len(right.steps) or any(step.row is None for step in work.steps):
        return None
    steps = zip(work.steps, right.steps, strict=True)
    changed = [k for k, (step, own) in enumerate(steps) if step.row is not own.row]
    return (changed[0], changed[-1]) if changed else None


def _chain(work: Work) -> Chain:
    return tuple(move for step in work.steps for move in step.chain)
