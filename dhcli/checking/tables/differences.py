"""Where a wrong table first leaves the robot: at which axis, and in which rows of the table that axis is placed.

The axis of joint k + 1 is placed by row k of a standard table, by row k + 1 of a modified one; how far along the axis
of joint k it lies is the d of row k in both. What is said comes from the motion, so that right rows drawn with other
frames are never blamed.
"""

from __future__ import annotations

from dataclasses import replace

from dhcli.checking.tables.answer import TableAnswer
from dhcli.checking.tables.comparing import SAME_ROBOT
from dhcli.checking.tables.motions import Outcome, oddity
from dhcli.checking.tables.typed_rows import variable_of
from dhcli.checking.verdicts import Verdict
from dhcli.errors import are, joined
from dhcli.frozen import frozen
from dhcli.geometry.vectors import cross, length
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.same_robot import Miss
from dhcli.notation.angle import Angle
from dhcli.notation.tree import negate
from dhcli.notation.walk import symbols

HALF_TURN = Angle.in_degrees(180)
PARALLEL = 1e-6
"""Sine below which two axes of the right robot count as parallel."""


@frozen
class Off:
    """How an end frame is off, where all axes are right.

    Attributes:
        shifted: Whether it lies elsewhere.
        along: Whether it is off along the last axis, so that shifts along axes parallel to that count.
        turned: Whether it is turned.
        turned_over: Whether its z axis points another way.
    """

    shifted: bool
    along: bool
    turned: bool
    turned_over: bool


ELSEWHERE = Off(shifted=True, along=True, turned=False, turned_over=False)


def first_difference(answer: TableAnswer, outcome: Outcome) -> tuple[str, ...]:
    """Which joints are right and how the next axis differs; then the rows that place it."""
    agreed, variables = outcome.joints, answer.robot.variables
    right = _agreed([str(answer.robot.first + k) for k in range(min(agreed, len(variables)))])
    if agreed >= len(variables):
        return f"{right}the end frame lies elsewhere", f"look at {end_rows(answer, outcome, ELSEWHERE)}"
    number = answer.robot.first + agreed
    if outcome.miss is Miss.MOTION or not agreed:
        row = _named([_row_of(answer, agreed)], answer)
        return f"{right}joint {number} does not move by {variables[agreed]} as it should", f"look at {row}"
    if outcome.miss is Miss.DIRECTION:
        return f"{right}the axis of joint {number} points another way", f"look at {_turning_rows(answer, outcome)}"
    return f"{right}the axis of joint {number} lies elsewhere", f"look at {_placing_rows(answer, outcome)}"


def end_rows(answer: TableAnswer, outcome: Outcome, off: Off) -> str:
    """The rows that place the end frame on the last axis, behind which it stands."""
    joints, last = len(answer.robot.variables), len(answer.plain)
    start = _row_of(answer, _last_placed(answer, outcome, joints) if off.shifted else joints - 1)
    said = [_named(list(range(start, last)), answer)]
    if answer.convention is Convention.MODIFIED and last == start + 1:
        said = [] if off.turned_over and not off.shifted else [f"d and theta in {said[0]}"]  # z is that of the axis
    if off.along:
        said += _along_parallels(answer, outcome, joints)
    if off.turned:
        said += _mending_twists(answer)
    return ", and at ".join(said or [_named([start], answer)])


def _mending_twists(answer: TableAnswer) -> list[str]:
    """The twists before the last axis of which half a turn turns the end frame back, in the plainest way."""
    last = _row_of(answer, len(answer.robot.variables) - 1)
    last += answer.convention is Convention.MODIFIED  # where the twist of a row comes before its joint
    robot, found = replace(answer, compare=SAME_ROBOT), dict[int, tuple[int, int]]()
    for index, row in enumerate(answer.plain[:last]):
        turned = replace(row, alpha=row.alpha + HALF_TURN)
        outcome = robot.judged((*answer.plain[:index], turned, *answer.plain[index + 1 :]))
        if outcome.verdict is Verdict.RIGHT and outcome.match is not None:
            found[index] = oddity(outcome.match)
    plainest = [index for index, odd in found.items() if odd == min(found.values())]
    return [f"alpha in {_named(plainest, answer)}"] if plainest else []


def _agreed(names: list[str]) -> str:
    if not names:
        return ""
    one = len(names) == 1
    return f"the {'axis of joint' if one else 'axes of joints'} {joined(names)} {are(len(names))} right; "


def _turning_rows(answer: TableAnswer, outcome: Outcome) -> str:
    """The rows that set the angle between an axis and the one before it."""
    before, here = _row_of(answer, outcome.joints - 1), _row_of(answer, outcome.joints)
    turns = answer.truth.screws(outcome.point)[0][outcome.joints - 1].turns
    rows = _between(answer, before, here)
    if turns and len(rows) == 1:  # the zero of a turning joint is free, so that only the twist is left
        return f"alpha in {_named(rows, answer)}"
    if not turns and before not in rows:  # where the axis is turned about a slide is a constant theta
        return f"{_named(rows, answer)}, and at theta in {_named([before], answer)}"
    return _named(rows, answer)


def _placing_rows(answer: TableAnswer, outcome: Outcome) -> str:
    """The rows that set how far an axis is from the last one whose place matters, and where along it."""
    last = _last_placed(answer, outcome, outcome.joints)
    before, here = _row_of(answer, last), _row_of(answer, outcome.joints)
    signs = _mending_signs(answer, outcome, here)
    if signs:
        return f"the signs of alpha, a and d in {_named(signs, answer)}"
    rows = _between(answer, before, here)
    if before not in rows:
        return f"{_named(rows, answer)}, and at d in {_named([*_parallels(answer, outcome, last + 1), before], answer)}"
    return ", and at ".join((_named(rows, answer), *_along_parallels(answer, outcome, last + 1)))


def _last_placed(answer: TableAnswer, outcome: Outcome, joints: int) -> int:
    """The last of so many joints whose axis has a place: of a slide only the direction counts."""
    screws = answer.truth.screws(outcome.point)[0]
    return max((k for k in range(joints) if screws[k].turns), default=0)


def _between(answer: TableAnswer, before: int, here: int) -> list[int]:
    """The rows whose a and alpha lie between two joints."""
    return list(range(before, here)) if answer.convention is Convention.STANDARD else list(range(before + 1, here + 1))


def _mending_signs(answer: TableAnswer, outcome: Outcome, here: int) -> list[int]:
    """The rows in which the next axis comes right by turning round one sign."""
    rows = answer.plain
    found = []
    for index in range(here + 1):
        row = rows[index]
        changed = (replace(row, alpha=-row.alpha), replace(row, a=negate(row.a)), replace(row, d=negate(row.d)))
        moved = variable_of(row, answer.robot.variables) in symbols(row.d)
        for other in changed[: 2 if moved else 3]:
            mended = (*rows[:index], other, *rows[index + 1 :])
            if other != row and answer.agreeing(mended, outcome) > outcome.joints:
                found.append(index)
                break
    return found


def _along_parallels(answer: TableAnswer, outcome: Outcome, joints: int) -> list[str]:
    """Where d adds to the same shift further up, if anywhere."""
    rows = _parallels(answer, outcome, joints)
    return [f"d in {_named(rows, answer)}"] if rows else []


def _parallels(answer: TableAnswer, outcome: Outcome, joints: int) -> list[int]:
    """The rows before that of the last of so many joints whose axes, one behind the other, are parallel to its axis."""
    screws = answer.truth.screws(outcome.point)[0]
    start = joints - 1
    while start > 0 and length(cross(screws[start - 1].direction, screws[start].direction)) <= PARALLEL:
        start -= 1
    return [_row_of(answer, k) for k in range(start, joints - 1)]


def _row_of(answer: TableAnswer, joint: int) -> int:
    """Index of the row that a joint moves, in the student's table."""
    name = answer.robot.variables[joint]
    return next(k for k, row in enumerate(answer.plain) if variable_of(row, answer.robot.variables) == name)


def _named(rows: list[int], answer: TableAnswer) -> str:
    numbers = [str(answer.robot.first + k) for k in rows]
    return f"{'row' if len(numbers) == 1 else 'rows'} {joined(numbers)}"
