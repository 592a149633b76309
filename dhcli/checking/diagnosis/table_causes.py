"""The slip behind a wrong DH table: one in the right table that gives the motion of the one typed, or the same robot.

The motion itself is compared first. A student who has drawn other frames gets another motion for the same slip: then
a slip is looked for whose table is the same robot as the one typed, but for the freedoms that a right table has too.
What is no single slip may still be one in each of several rows, which are then compared one by one.
"""

from __future__ import annotations

from functools import reduce

from dhcli.checking.diagnosis.bench import Bench, product
from dhcli.checking.diagnosis.row_by_row import each_in_a_row, same_in_rows, slips_by_row
from dhcli.checking.diagnosis.search import Numbers, matches, point
from dhcli.checking.diagnosis.slips import Candidate, table_candidates, table_work
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.returned import Causes
from dhcli.checking.tables.answer import ends_on_axis
from dhcli.checking.tables.cells import given_values, own_values
from dhcli.checking.tables.comparing import SAME_ROBOT, compare_of
from dhcli.checking.tables.motions import may_be_same, same_robot
from dhcli.checking.tables.samples import Values
from dhcli.checking.verdicts import Verdict
from dhcli.errors import RobotError
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot

MOTION = 2e-3
"""What two tables of the same motion may differ by, at lengths and angles near 1."""


def table_causes(case: Case, convention: Convention, rows: tuple[Row, ...]) -> Causes:
    """Mistakes in rows of the right table that give the table typed; none where the robot has no such table.

    Args:
        case: The part that asks for a table.
        convention: The convention that was asked for.
        rows: The rows typed, their angles settled.
    """
    exercise, robot = case.exercise, case.exercise.robot
    every = case.memo.of(("slips", convention), lambda: table_candidates(exercise, convention))
    if robot is None or not every:
        return ()
    moves = tuple(moves_of(row, convention) for row in rows)
    chain = tuple(move for row in moves for move in row)
    compared = _Compared(exercise, robot, moves)
    moving_so = compared.with_one_slip(every)
    if moving_so:
        to_the_cell = [one for one in moving_so if [step.row for step in one.work.steps] == list(rows)]
        return tuple(one.slips for one in to_the_cell or moving_so)
    by_row = compared.by_row(every)
    found = same_in_rows(by_row)
    if not found and compare_of(case) == SAME_ROBOT:
        found = _same_robot(case, robot, chain, every)
    return found or each_in_a_row(by_row)


class _Compared:
    """A table typed and the right one, at two points."""

    def __init__(self, exercise: Exercise, robot: Robot, rows: tuple[Chain, ...]) -> None:
        """Take the moves of each row typed."""
        self._right = table_work(robot)
        own = tuple(move for step in self._right.steps for move in step.chain)
        free = names(own) | names(tuple(move for row in rows for move in row))
        known = {name: v for name, v in own_values(exercise).items() if name not in robot.variables}
        overs = [point(free, known, seed) for seed in (3, 4)]
        self._benches = [Bench(self._right, over) for over in overs]
        self._rows = [[fold(row, over) for row in rows] for over in overs]
        self._typed = [reduce(product, matrices) for matrices in self._rows]
        self._slack = tuple(tuple(MOTION for _ in row) for row in self._typed[0])

    def with_one_slip(self, every: tuple[Candidate, ...]) -> list[Candidate]:
        """The slips with just the motion typed."""
        found = []
        for candidate in every:
            given = [bench.matrix(candidate.work) for bench in self._benches]
            is_right = self._agree([bench.matrix(self._right) for bench in self._benches], given)
            if not is_right and self._agree(self._typed, given):
                found.append(candidate)
        return found

    def by_row(self, every: tuple[Candidate, ...]) -> tuple[tuple[Candidate, ...], ...]:
        """The slips behind each wrong row."""
        return slips_by_row(self._right, every, self._benches, self._rows, self._slack)

    def _agree(self, first: list[Numbers], second: list[Numbers]) -> bool:
        return all(matches(a, b, self._slack) for a, b in zip(first, second, strict=True))


def _same_robot(case: Case, robot: Robot, chain: Chain, every: tuple[Candidate, ...]) -> Causes:
    """The slips with the robot typed; as that is a wrong one, none of them gives the right robot."""
    values = Values(given_values(case.exercise), own_values(case.exercise))
    tolerance = case.tolerance
    end_free = robot.convention is Convention.MODIFIED and not ends_on_axis(robot)
    typed = Arm.of(chain, robot.variables)
    found = []
    for candidate in every:
        try:
            other = Arm.of(tuple(move for step in candidate.work.steps for move in step.chain), robot.variables)
            if not may_be_same(other, typed, values, tolerance, end_free=end_free):
                continue
            outcome = same_robot(other, typed, values, tolerance, end_free=end_free)
        except RobotError:  # the slip leaves no robot to compare with
            continue
        if outcome.verdict is Verdict.RIGHT:
            found.append(candidate.slips)
    return tuple(found)
