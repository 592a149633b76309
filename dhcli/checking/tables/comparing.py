"""How a table is compared: what the task fixes of a robot, and which freedom it therefore gives."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhcli.checking.exercise import Case
    from dhcli.checking.tables.freedoms import Slack
    from dhcli.geometry.rigid import Rigid
    from dhcli.kinematics.same_robot import Match

LITERAL, SAME_MOTION, SAME_ROBOT = "literal", "same-motion", "same-robot"
COMPARED = (LITERAL, SAME_MOTION, SAME_ROBOT)

BASE, END, ZERO, SENSE = "base frame", "end frame", "joint zero", "positive sense"
STATED = (BASE, END, ZERO, SENSE)
"""What a task says where only one motion can be right."""


def compare_of(case: Case) -> str:
    """How a part compares a table: as it says, else the same motion where the task fixes all that it depends on."""
    if case.part.compare:
        return case.part.compare
    return SAME_ROBOT if unstated(case.exercise.task) else SAME_MOTION


def unstated(task: str) -> tuple[str, ...]:
    """What a task leaves open; a question that is made on the spot has no task, and gives no freedom by it."""
    words = " ".join(task.lower().split())
    return tuple(one for one in STATED if one not in words)


def gives(task: str, match: Match, slack: Slack) -> bool:
    """Whether a task leaves open all that a robot differs by."""
    used = {
        BASE: _moved(match.base, slack),
        END: _moved(match.tool, slack),
        ZERO: any(abs(zero) > min(slack.angle, slack.length) for zero in match.zeros),
        SENSE: any(sense < 0 for sense in match.senses),
    }
    return bool(task.strip()) and all(one in unstated(task) for one, is_used in used.items() if is_used)


def _moved(frame: Rigid, slack: Slack) -> bool:
    return frame.tilt() > slack.angle or any(abs(x) > slack.length for x in frame.offset)
