"""A DH table that has been read, beside the robot it is about: its cells, its motion, and the freedom it has used."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial

from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.other_unit import RADIANS, WrongUnitError, refuse_right_in
from dhcli.checking.tables.cells import given_values, mark_cells, own_values, settled
from dhcli.checking.tables.comparing import LITERAL, SAME_MOTION
from dhcli.checking.tables.freedoms import Drawn, Slack, end_freedoms, frame_freedoms, joint_freedoms
from dhcli.checking.tables.motions import LARGEST, Outcome, TwoArms, is_but_for_end
from dhcli.checking.tables.right import RightArm
from dhcli.checking.tables.samples import Values
from dhcli.checking.tables.typed_rows import TypedRow, misplaced, variable_of
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import CellMark, Verdict, worst
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.frames import between
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.same_robot import Match
from dhcli.notation.angle import magnitude
from dhcli.notation.tree import ZERO
from dhcli.notation.walk import decimals

FULL_TURN = 7
"""Above this many radians a bare number was meant in degrees."""

FINER = 3
"""How often what counts as no difference is made smaller, until the freedom that was used is seen."""


@frozen
class TableAnswer:
    """A table and everything it is judged by.

    Attributes:
        rows: The rows as read.
        memo: The exercise, for its robot and its values, and what was worked out for it; or that of a second truth.
        convention: The convention that was asked for.
        tolerance: Largest errors that count as right.
        compare: `literal`, `same-motion` or `same-robot`.
        end_free: Whether the end frame may be any.
    """

    rows: tuple[TypedRow, ...]
    memo: Memo
    convention: Convention
    tolerance: Tolerance
    compare: str
    end_free: bool

    @property
    def exercise(self) -> Exercise:
        """The exercise, or its second truth."""
        return self.memo.exercise

    @property
    def robot(self) -> Robot:
        """The right robot.

        Raises:
            RobotError: There is none.
        """
        return robot_of(self.memo.exercise)

    @property
    def asker(self) -> str:
        """Who fixes what is compared."""
        return "this task" if self.exercise.task.strip() else "this comparison"

    @property
    def plain(self) -> tuple[Row, ...]:
        """The rows alone."""
        return tuple(typed.row for typed in self.rows)

    @property
    def table(self) -> tuple[Row, ...]:
        """The robot's own table in this convention; nothing if it has none."""
        if self.robot.convention is not self.convention:
            return ()
        return own_rows(self.robot)

    @property
    def truth(self) -> Arm:
        """The right chain, from the first numbered frame to the last."""
        return self._right.arm

    @property
    def _right(self) -> RightArm:
        return self.memo.of("right arm", lambda: _right_arm(self.robot, self.exercise))

    @property
    def cells(self) -> tuple[CellMark, ...]:
        """The cells one by one; nothing where the robot's table has not as many rows."""
        if len(self.table) != len(self.rows):
            return ()
        return mark_cells(self.rows, self.table, self.robot.columns, self.exercise, self.tolerance)

    @property
    def misfit(self) -> str:
        """Why this cannot be the robot at all, before any motion is compared; nothing if it can."""
        fault = misplaced(self.rows, self.robot)
        if fault:
            return fault
        right = self.truth.variables
        typed = self.arm(self.plain, self.convention).variables
        if typed != right:
            return f"your joints come as {', '.join(typed)}; this robot has {', '.join(right)}"
        return ""

    def arm(self, rows: Iterable[Row], convention: Convention) -> Arm:
        """The chain of some rows; angles near a multiple of 15° are meant as that."""
        chain = tuple(move for row in rows for move in moves_of(settled(row, self.tolerance), convention))
        return Arm.of(chain, self.robot.variables)

    def judged(
        self, rows: Iterable[Row] | None = None, convention: Convention | None = None, *, end_free: bool = False
    ) -> Outcome:
        """Compare the rows, or others in their place, with the robot."""
        compared = self._compared(self.plain if rows is None else tuple(rows), convention or self.convention)
        if self.compare == SAME_MOTION and not end_free:
            same = compared.same_motion
            if same.verdict is Verdict.RIGHT or not self.end_free:
                return same
            ended = compared.same_robot(end_free=True)
            return ended if ended.match is not None and is_but_for_end(ended.match) else same
        return compared.same_robot(end_free=self.end_free or end_free)

    def _compared(self, rows: tuple[Row, ...], convention: Convention) -> TwoArms:
        """Some rows beside the right robot; what is judged is asked for again when it is explained."""
        made = partial(self._two_arms, rows, convention)
        places = tuple([decimals(expr) for row in rows for expr in (row.a, row.d)])
        return self.memo.recent("compared", (convention, self.tolerance, rows, places), made)

    def _two_arms(self, rows: tuple[Row, ...], convention: Convention) -> TwoArms:
        return TwoArms(self._right, self.arm(rows, convention), self.tolerance)

    def agreeing(self, rows: Iterable[Row], outcome: Outcome) -> int:
        """How many joints agree from the first one with other rows in their place, where an outcome was decided."""
        return self._two_arms(tuple(rows), self.convention).agreeing(outcome)

    def is_oversized(self, outcome: Outcome) -> bool:
        """Whether lengths were typed that no robot of this size has."""
        arm = self.arm(self.plain, self.convention)
        return not arm.size(outcome.point) <= LARGEST * outcome.size

    def is_right(self, rows: tuple[Row, ...]) -> bool:
        """Whether other rows in the place of these would be right."""
        if self.compare == LITERAL:
            typed = tuple(replace(old, row=row) for old, row in zip(self.rows, rows, strict=True))
            cells = replace(self, rows=typed).cells
            return bool(cells) and worst(cell.verdict for cell in cells) is Verdict.RIGHT
        return self.judged(rows).verdict is Verdict.RIGHT

    def freedoms(self, outcome: Outcome) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """What is drawn otherwise than in the solution, and what is counted otherwise; a freedom used is named."""
        if outcome.match is None:
            return (), ()
        slack = self.slack(outcome)
        found = self._freedoms(outcome, outcome.match, slack)
        for _ in range(FINER if outcome.is_free else 0):
            if any(found):
                break
            slack = slack.finer()
            found = self._freedoms(outcome, outcome.match, slack)
        return found if any(found) or not outcome.is_free else (("your frames are others by a hair",), ())

    def _freedoms(self, outcome: Outcome, match: Match, slack: Slack) -> tuple[tuple[str, ...], tuple[str, ...]]:
        truth = self.truth
        movers = [variable_of(row, self.robot.variables) for row in self.table]
        if movers and movers == [variable_of(row, self.robot.variables) for row in self.plain]:
            own = tuple(moves_of(row, self.convention) for row in self.table)
            typed = tuple(moves_of(settled(row, self.tolerance), self.convention) for row in self.plain)
            drawn = Drawn(own, typed, self.convention, self.robot.first)
            frames = frame_freedoms(drawn, match, truth.variables, outcome.point, slack)
        else:
            base = end_freedoms("base", match.base.inverse(), slack)
            frames = (*base, *end_freedoms("end", match.tool, slack))
        kinds = [screw.turns for screw in truth.screws(outcome.point)[0]]
        return frames, joint_freedoms(match, truth.variables, kinds, slack, " ".join(frames))

    def slack(self, outcome: Outcome) -> Slack:
        """What counts as no difference between two frames."""
        if outcome.rounded:
            told = partial(self.exercise.distance, signed=True)
            return Slack(self.tolerance.rotation, self.tolerance.rotation * outcome.size, told)
        return Slack(1e-5, 1e-6 * outcome.size)

    def check_units(self) -> None:
        """Refuse a table that is right but for the unit of its angles or lengths.

        Raises:
            UnreadableError: Naming the unit that makes it right.
        """
        if self.misfit:
            return
        swapped = tuple(typed.swapped for typed in self.rows)
        angles = [angle for row in swapped for angle in (row.alpha, row.theta)]
        plausible = all(magnitude(angle.radians) <= FULL_TURN for angle in angles)
        if swapped != self.plain and plausible and self.is_right(swapped):
            here, there = ("degrees", RADIANS) if any(angle.radians for angle in angles) else (RADIANS, "degrees")
            wanted = f"the angles of this sheet are in {here}: write -90° or -pi/2"
            raise WrongUnitError(there, self.exercise.unit, wanted=wanted)

        def is_right(unit: str) -> bool:
            rows = tuple(typed.in_unit(unit) for typed in self.rows)
            return rows != self.plain and self.is_right(rows)

        refuse_right_in(self.exercise.other_units, self.exercise.unit, is_right)


def robot_of(exercise: Exercise) -> Robot:
    """The robot whose table is asked for.

    Raises:
        RobotError: There is none.
    """
    if exercise.robot is None:
        raise RobotError(f"{exercise.id} asks for a table and names no robot")
    return exercise.robot


def _right_arm(robot: Robot, exercise: Exercise) -> RightArm:
    arm = Arm.of(between(robot, robot.frames[1], robot.frames[-2]), robot.variables)
    return RightArm(arm, Values(given_values(exercise), own_values(exercise)))


def own_rows(robot: Robot) -> tuple[Row, ...]:
    """The rows of a robot's table."""
    return tuple(link.row for link in robot.links if link.row is not None)


def ends_on_axis(robot: Robot) -> bool:
    """Whether behind the last joint there are only moves about and along its axis, as in a modified table."""
    if robot.convention is not Convention.STANDARD:
        return robot.convention is Convention.MODIFIED
    rows = own_rows(robot)
    last = max((i for i, row in enumerate(rows) if variable_of(row, robot.variables)), default=0)
    return all(row.a == ZERO and row.alpha.is_zero for row in rows[last:])
