"""The slip behind a wrong DH table: one in the right table that gives the motion of the one typed, or the same robot.

The motion itself is compared first. A student who has drawn other frames gets another motion for the same slip: then
a slip is looked for whose table is the same robot as the one typed, but for the freedoms that a right table has too.
What is no single slip may still be one in each of several rows, which are then compared one by one.
"""

from __future__ import annotations

from functools import cached_property, reduce

from dhcli.algebra.floats import Floats
from dhcli.checking.diagnosis.bench import Bench, product
from dhcli.checking.diagnosis.row_by_row import each_in_a_row, same_in_rows, slips_by_row
from dhcli.checking.diagnosis.search import Numbers, matches, point
from dhcli.checking.diagnosis.slips import Candidate, table_candidates, table_work
from dhcli.checking.diagnosis.work import Work
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.returned import Causes
from dhcli.checking.tables.answer import ends_on_axis, robot_of
from dhcli.checking.tables.cells import given_values, own_values
from dhcli.checking.tables.comparing import SAME_ROBOT, compare_of
from dhcli.checking.tables.motions import Comparison
from dhcli.checking.tables.right import RightArm
from dhcli.checking.tables.samples import Values
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.errors import RobotError
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot

MOST_KEPT = 8
"""Sets of names for which the motions are kept: a table may bring names of its own."""

MOTION = 2e-3
"""What two tables of the same motion may differ by, at lengths and angles near 1."""


def table_causes(case: Case, convention: Convention, rows: tuple[Row, ...]) -> Causes:
    """Mistakes in rows of the right table that give the table typed; none where the robot has no such table.

    Args:
        case: The part that asks for a table.
        convention: The convention that was asked for.
        rows: The rows typed, their angles settled.
    """
    slips = case.memo.of(("slips", convention), lambda: _Slips(case.exercise, convention))
    if not slips.every:
        return ()
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
    """The right table, and every one with a single slip: as motions and as robots, worked out once for all answers.

    Attributes:
        every: The slips; none where the robot has no table in this convention.
    """

    def __init__(self, exercise: Exercise, convention: Convention) -> None:
        """Find them."""
        self._exercise = exercise
        self.every = table_candidates(exercise, convention)
        self._motions: dict[frozenset[str], _Motions] = {}
        self._arms: dict[int, RightArm | None] = {}

    @cached_property
    def right(self) -> Work:
        """The right table."""
        return table_work(self._robot)

    @property
    def _robot(self) -> Robot:
        return robot_of(self._exercise)

    def motions(self, free: frozenset[str]) -> _Motions:
        """The motions at points that have a value for some names besides those of the right table."""
        needed = free | names(_chain(self.right))
        if needed not in self._motions:
            if len(self._motions) >= MOST_KEPT:
                self._motions.clear()
            known = {n: v for n, v in own_values(self._exercise).items() if n not in self._robot.variables}
            self._motions[needed] = _Motions(self.right, self.every, [point(needed, known, seed) for seed in (3, 4)])
        return self._motions[needed]

    def same_robot(self, chain: Chain, tolerance: Tolerance) -> Causes:
        """The slips with the robot of a chain; as that is a wrong one, none of them gives the right robot."""
        robot = self._robot
        end_free = robot.convention is Convention.MODIFIED and not ends_on_axis(robot)
        typed = Arm.of(chain, robot.variables)
        found = []
        for index, candidate in enumerate(self.every):
            try:
                if (arm := self._arm(index)) is None:
                    continue
                compared = Comparison(arm, typed, tolerance)
                if not compared.may_be_same(end_free=end_free):
                    continue
                outcome = compared.same_robot(end_free=end_free)
            except RobotError:  # with these values there is no robot to compare with
                continue
            if outcome.verdict is Verdict.RIGHT:
                found.append(candidate.slips)
        return tuple(found)

    def _arm(self, index: int) -> RightArm | None:
        """The robot that a slip leads to; None where it leaves none."""
        if index not in self._arms:
            values = Values(given_values(self._exercise), own_values(self._exercise))
            try:
                arm = Arm.of(_chain(self.every[index].work), self._robot.variables)
            except RobotError:
                self._arms[index] = None
            else:
                self._arms[index] = RightArm(arm, values)
        return self._arms[index]


class _Motions:
    """The product of the right table, and of every one with a slip, at two points.

    Attributes:
        right: The right table.
        every: The slips.
        overs: The values of the names at each point.
        benches: What evaluates works there.
    """

    def __init__(self, right: Work, every: tuple[Candidate, ...], overs: list[Floats]) -> None:
        """Take the points."""
        self.right = right
        self.every = every
        self.overs = overs
        self.benches = [Bench(right, over) for over in overs]

    @cached_property
    def first(self) -> list[Numbers]:
        """What each slip gives at the first point, where nearly all of them are told from what was typed."""
        return [self.benches[0].matrix(one.work) for one in self.every]


class _Compared:
    """A table typed, and the right one and those with a slip, at two points."""

    def __init__(self, slips: _Slips, rows: tuple[Chain, ...], chain: Chain) -> None:
        """Take the moves of each row typed, and all of them."""
        self._motions = slips.motions(names(chain))
        self._rows = [[fold(row, over) for row in rows] for over in self._motions.overs]
        self._typed = [reduce(product, matrices) for matrices in self._rows]
        self._slack = tuple(tuple(MOTION for _ in row) for row in self._typed[0])

    def with_one_slip(self) -> list[Candidate]:
        """The slips with just the motion typed."""
        first, every = self._motions.first, self._motions.every
        likely = [one for one, there in zip(every, first, strict=True) if matches(self._typed[0], there, self._slack)]
        right = self._given(self._motions.right) if likely else []
        given = ((one, self._given(one.work)) for one in likely)
        return [one for one, there in given if self._agree(self._typed, there) and not self._agree(right, there)]

    def by_row(self) -> tuple[tuple[Candidate, ...], ...]:
        """The slips behind each wrong row."""
        return slips_by_row(self._motions.right, self._motions.every, self._motions.benches, self._rows, self._slack)

    def _given(self, work: Work) -> list[Numbers]:
        return [bench.matrix(work) for bench in self._motions.benches]

    def _agree(self, first: list[Numbers], second: list[Numbers]) -> bool:
        return all(matches(a, b, self._slack) for a, b in zip(first, second, strict=True))


def _chain(work: Work) -> Chain:
    return tuple(move for step in work.steps for move in step.chain)
