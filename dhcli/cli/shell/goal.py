"""The pose that `ik` is asked for, in whatever way it was typed."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, cast

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.given import lengths_of, values_of
from dhcli.cli.shell.goal_parts import from_parts, known
from dhcli.cli.shell.typed_digits import Rows, slack_of
from dhcli.cli.shell.wishes import Goal
from dhcli.errors import DhcliError, Place, Problem
from dhcli.frozen import frozen
from dhcli.kinematics.forward import numeric_pose
from dhcli.kinematics.frames import ends
from dhcli.kinematics.inverse.answer import InverseKinematics
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.transform import Wanted, compose, read_product
from dhcli.notation.tree import Expr
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.solutions import Solutions
    from dhcli.kinematics.inverse.tasks import TaskName

_POINT = regex(
    r"\s*[\[(]?[^][(),;\n]+(?:,[^][(),;\n]+){2}[\])]?\s*"
    r"|\s*[\[(]?\s*[-+]?[.\d][^][(),;\s]*(?:\s+[-+]?[.\d][^][(),;\s]*){2}\s*[\])]?\s*"
)
"""Three values with commas, or three numbers with blanks: no move and no matrix."""

_PARTS = ("position", "rpy", "quaternion", "euler", "pointing")
"""What a pose is put together from where it is no target."""


@frozen
class Question:
    """A pose that is asked for.

    Attributes:
        robot: The robot.
        pose: The matrix, shape (4, 4) [m].
        task: What of it counts.
        start: The frame it is seen from.
        end: The frame that is placed.
        lengths: Values of lengths and constant angles.
        remarks: What was taken for something else, such as a matrix of few decimals for the nearest rotation.
        slack: By how much the decimals typed leave an entry of the pose open; 0 where they are exact.
        standing: Values of the joints, where the pose is given by them.
    """

    robot: Robot
    pose: Rows
    task: TaskName
    start: str
    end: str
    lengths: Mapping[str, Value]
    remarks: tuple[str, ...] = ()
    slack: float = 0.0
    standing: Mapping[str, Value] = field(default_factory=dict)

    def answered(self, found: Solutions, near: Sequence[float] | None, *, why: bool) -> InverseKinematics:
        """The question with its answer, and with how that came about if it is wanted."""
        from dhcli.kinematics.inverse.explained import explained

        wish = None if near is None else tuple(near)
        how = explained(found) if why else None
        return InverseKinematics(self.robot, self.lengths, self.task, self.start, self.end, found, self.pose, wish, how)


def asked(
    robot: Robot,
    goal: Goal,
    chosen: Chosen,
) -> Question:
    """The question that options ask.

    Args:
        robot: The robot.
        goal: The options about the pose.
        chosen: The frames and lengths, or joint values that stand there.

    Raises:
        DhcliError: No pose is given, or two are, or it cannot be read.
    """
    first, last = ends(robot, chosen.from_, chosen.end)
    lengths = lengths_of(robot, chosen)
    task = task_of(goal)
    rows, remarks, slack = _rows(robot, goal, chosen, (first, last))
    values = values_of(robot, chosen) if chosen.stands else {}
    standing = {name: value for name, value in values.items() if name in robot.variables}
    return Question(robot, rows, cast("TaskName", task), first, last, lengths, remarks, slack, standing)


def task_of(goal: Goal) -> str:
    """What counts: as asked for, else what the options determine."""
    if goal.task is not None:
        from dhcli.kinematics.inverse.tasks import task_called

        return task_called(goal.task).name
    turned = any(turn is not None for turn in (goal.rpy, goal.quaternion, goal.euler))
    if goal.pointing is not None:
        return "direction" if goal.position is None else "axis"
    if goal.position is not None:
        return "pose" if turned else "position"
    return "orientation" if turned else "pose"


def _rows(robot: Robot, goal: Goal, chosen: Chosen, frames: tuple[str, str]) -> tuple[Rows, tuple[str, ...], float]:
    """The matrix, what in it was taken for something else, and by how much its decimals leave an entry open."""
    parts = {name: text for name in _PARTS if (text := getattr(goal, name)) is not None}
    ways = [chosen.stands, goal.target is not None, bool(parts)]
    if sum(ways) != 1:
        said = "no pose is given" if not any(ways) else "the pose is given in two ways"
        raise DhcliError(
            said, "one of --q, --pose, --target, or --position with --rpy, --quaternion, --euler or --pointing"
        )
    if ways[0]:
        return numeric_pose(robot, values_of(robot, chosen), *frames).rows, (), 0.0
    if goal.target is not None:
        text, place = _text_of(goal.target, chosen.robot)
        rows, remarks = _target(text, place)
        slack = slack_of({"": text}, rows, lambda texts: _target(texts[""], place)[0], rough=bool(remarks))
        return rows, remarks, slack
    rows, slack = from_parts(parts, chosen.bare)
    return rows, (), slack


def _text_of(text: str, typed: str) -> tuple[str, Place]:
    """What a target says, and where that stands.

    Raises:
        DhcliError: It and the robot come from standard input both.
    """
    from dhcli.files.reading import read_text, source_of

    if text == "-" or text.startswith("@"):
        path = text.removeprefix("@")
        if path == typed == "-":
            raise DhcliError("the robot and the pose cannot both come from standard input", "save one in a file")
        return read_text(path), Place(source_of(path))
    return text, Place("--target")


def _target(text: str, place: Place) -> tuple[Rows, tuple[str, ...]]:
    """The matrix, and what in it was taken for something else."""
    if _POINT.fullmatch(text):
        message = f"'{text.strip()}' is a position, and a whole pose is wanted"
        said = ",".join(part for part in re.split(r"[\s,]+", text.strip("[]() \t\n")) if part)
        hint = f"write --position {said}, where the turn is free"
        raise DhcliError(Problem(message, place, hint))
    product = read_product(text, place)
    pose = compose(product, {}, Wanted()).pose
    if pose.is_symbolic:
        known([cast("Expr", entry) for row in pose.rows for entry in row], place)
        pose = pose.in_numbers()
    return cast("Pose[float]", pose).rows, product.remarks
