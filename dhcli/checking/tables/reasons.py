"""Why a table is wrong, as far as its motion tells: the other convention, the end frame, or the first wrong joint."""

from __future__ import annotations

import math
from dataclasses import replace

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.tables.answer import TableAnswer
from dhcli.checking.tables.comparing import SAME_MOTION, SAME_ROBOT
from dhcli.checking.tables.differences import Off, end_rows, first_difference
from dhcli.checking.tables.freedoms import end_freedoms
from dhcli.checking.tables.motions import Outcome, oddity
from dhcli.checking.verdicts import Verdict
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import NAMES, OTHER, Convention
from dhcli.kinematics.same_robot import Match
from dhcli.notation.tree import ZERO

FIXES = "fixes base, end frame, zeros and senses"


@frozen
class Reason:
    """Why a table is wrong.

    Attributes:
        remarks: What is said, most important first.
        slip: The mistake, where the motion alone tells it.
    """

    remarks: tuple[str, ...] = ()
    slip: Slip | None = None


def reason_of(answer: TableAnswer, outcome: Outcome | None = None) -> Reason:
    """What can be said of a wrong table."""
    outcome = outcome or answer.judged()
    if answer.is_oversized(outcome):
        return Reason(("your lengths are a million times those of the robot: look for a digit or a unit too many",))
    if is_of_other_convention(answer):
        return _other_convention(answer)
    robot = replace(answer, compare=SAME_ROBOT)
    free = robot.judged(end_free=True)
    if answer.compare == SAME_MOTION:
        outcome = robot.judged()
        if outcome.verdict is Verdict.RIGHT and not _is_plainer(free, outcome):
            frames, joints = robot.freedoms(outcome)
            return _freely(f"the same robot, but {answer.asker} {FIXES}", (*frames, *joints))
    if outcome.verdict is Verdict.CLOSE:  # where there are cells, these show which length it is
        said = "right to within ten times the tolerance: look at the digits of its lengths"
        return Reason(() if answer.cells else (said,))
    if free.verdict is Verdict.RIGHT and free.match is not None:
        return _at_the_end(answer, free, free.match)
    return Reason(first_difference(robot, outcome))


def is_of_other_convention(answer: TableAnswer) -> bool:
    """Whether a table is right in the other convention.

    It is if it ends where the robot ends. It may also end with the last axis, where the other convention drops what
    lies behind; but then a and alpha must be zero where there is nothing before or behind, or any last length would
    do. One joint alone would be right by accident.
    """
    convention = OTHER[answer.convention]
    if answer.misfit or len(answer.robot.variables) <= 1:
        return False
    robot = replace(answer, compare=SAME_ROBOT, end_free=False)
    if robot.judged(None, convention).verdict is Verdict.RIGHT:
        return True
    outer = answer.plain[0 if convention is Convention.MODIFIED else -1]
    starts_so = outer.a == ZERO and outer.alpha.is_zero
    return starts_so and robot.judged(None, convention, end_free=True).verdict is Verdict.RIGHT


def _other_convention(answer: TableAnswer) -> Reason:
    other, asked = OTHER[answer.convention], answer.convention
    hint = "which convention has this table, standard or modified?"
    slip = Slip("convention", f"the rows are those of {NAMES[other]}, and {asked.value} was asked", hint)
    return Reason((f"right for {NAMES[other]}; this exercise uses {asked.value}",), slip)


def _freely(said: str, used: tuple[str, ...]) -> Reason:
    """The right robot, but not as the task fixes it."""
    hint = "compare base, end frame, zeros and senses with those that are fixed"
    return Reason((said, *used), Slip("freedom", "; ".join(used) or said, hint))


def _is_plainer(free: Outcome, outcome: Outcome) -> bool:
    """Whether a table is the robot in a plainer way if its end frame may be another."""
    if free.verdict is not Verdict.RIGHT or free.match is None or outcome.match is None:
        return False
    return oddity(free.match) < oddity(outcome.match)


def _at_the_end(answer: TableAnswer, free: Outcome, match: Match) -> Reason:
    """What is said where all axes are right; where the task fixes more than them, that too."""
    slack = answer.slack(free)
    shifted, along = (max(map(abs, offset)) > slack.length for offset in (match.tool.offset, match.tool.offset[2:]))
    turned, over = match.tool.tilt() > slack.angle, match.tool.rows[2][2] < math.cos(slack.angle)
    off = Off(shifted=shifted, along=along, turned=turned, turned_over=over)
    rows = f"look at {end_rows(answer, free, off)}"
    end = (end_freedoms("end", match.tool, slack) or ("your end frame is another",))[0]
    if answer.compare == SAME_MOTION:
        base = end_freedoms("base", match.base.inverse(), slack)
        used = (*base, *answer.freedoms(free)[1])
        if used:
            return _freely(f"all axes are right, but {answer.asker} {FIXES}", (*used, end))
    return Reason((f"all joints are right; {end}", rows))
