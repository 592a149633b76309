"""The slip behind a wrong DH table: one in the right table that gives the motion of the one typed, or the same robot.

The motion itself is compared first. A student who has drawn other frames gets another motion for the same slip: then
a slip is looked for whose table is the same robot as the one typed, but for the freedoms that a right table has too.
"""

from __future__ import annotations

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.search import matches, point
from dhcli.checking.diagnosis.slips import Candidate, table_candidates, table_work
from dhcli.checking.diagnosis.work import Bench
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.questions import TableQuestion
from dhcli.checking.tables.answer import ends_on_axis
from dhcli.checking.tables.cells import given_values, own_values, settled
from dhcli.checking.tables.motions import Values, may_be_same, same_robot
from dhcli.checking.tables.reading import read_table
from dhcli.checking.tables.screws import Arm
from dhcli.checking.verdicts import Verdict
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import Convention, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot

Causes = tuple[tuple[Slip, ...], ...]

MOTION = 2e-3
"""What two tables of the same motion may differ by, at lengths and angles near 1."""


def table_causes(exercise: Exercise, part: Part, question: TableQuestion, answer: str) -> Causes:
    """Mistakes in one row of the right table that give the table typed; none where the robot has no such table.

    Raises:
        UnreadableError: The table cannot be read.
    """
    robot = exercise.robot
    if robot is None:
        return ()
    tolerance = part.tolerance or exercise.tolerance
    rows = [settled(r.row, tolerance) for r in read_table(answer, robot, exercise.scope, robot.columns, exercise.unit)]
    chain = tuple(move for row in rows for move in moves_of(row, question.convention))
    every = table_candidates(exercise, question)
    found = _same_motion(exercise, robot, chain, every)
    if not found and part.compare == "same-robot":
        found = _same_robot(exercise, part, robot, chain, every)
    return found


def _same_motion(exercise: Exercise, robot: Robot, chain: Chain, every: tuple[Candidate, ...]) -> Causes:
    """The slips with just the motion typed, at two points."""
    right = table_work(robot)
    free = names(chain) | names(tuple(move for step in right.steps for move in step.chain))
    known = {name: v for name, v in own_values(exercise).items() if name not in robot.variables}
    overs = [point(free, known, seed) for seed in (3, 4)]
    benches = [Bench(right, over) for over in overs]
    typed = [fold(chain, over) for over in overs]
    slack = tuple(tuple(MOTION for _ in row) for row in typed[0])
    found = []
    for candidate in every:
        given = [bench.matrix(candidate.work) for bench in benches]
        is_right = all(matches(b.matrix(right), m, slack) for b, m in zip(benches, given, strict=True))
        if not is_right and all(matches(t, m, slack) for t, m in zip(typed, given, strict=True)):
            found.append(candidate.slips)
    return tuple(found)


def _same_robot(exercise: Exercise, part: Part, robot: Robot, chain: Chain, every: tuple[Candidate, ...]) -> Causes:
    """The slips with the robot typed; as that is a wrong one, none of them gives the right robot."""
    values = Values(given_values(exercise), own_values(exercise))
    tolerance = part.tolerance or exercise.tolerance
    end_free = robot.convention is Convention.MODIFIED and not ends_on_axis(robot)
    typed = Arm.of(chain, robot.variables)
    found = []
    for candidate in every:
        try:
            other = Arm.of(tuple(move for step in candidate.work.steps for move in step.chain), robot.variables)
            if not may_be_same(other, typed, values, end_free=end_free):
                continue
            outcome = same_robot(other, typed, values, tolerance, end_free=end_free)
        except RobotError:  # the slip leaves no robot to compare with
            continue
        if outcome.verdict is Verdict.RIGHT:
            found.append(candidate.slips)
    return tuple(found)
