"""The process that ends up with a table that is known: every free choice as that table has made it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from dhcli.errors import RobotError
from dhcli.geometry.vectors import dot
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.describe.choices import Choices
from dhcli.kinematics.describe.description import known_values
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, drawing_of
from dhcli.kinematics.describe.process import Walk, walk
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Link, Robot, Value


def retold(robot: Robot, pose: Mapping[str, Value] | None = None) -> Walk:
    """The way from frame 0 to the last numbered frame that gives a robot's own table.

    Args:
        robot: A robot with a table, a joint in each row.
        pose: The pose in which it is drawn; zero by default.

    Raises:
        RobotError: It has no such table, or a direction depends on a letter.
    """
    if robot.convention is Convention.PRODUCT or any(not _moving(robot, link) for link in robot.links):
        raise RobotError(f"{robot.name} has no table with a joint in each row")
    frames = _frames(robot, pose or {})
    chain = tuple(move for link in robot.links for move in link.moves)
    drawing = drawing_of(chain, robot.variables, known_values(robot), pose)
    behind = 1 if robot.convention is Convention.MODIFIED else 0
    lines = tuple(_on_frame(line, frames[k + behind]) for k, line in enumerate(drawing.lines))
    return walk(Drawing(lines, drawing.end, drawing.values), Choices(like=frames))


def _frames(robot: Robot, pose: Mapping[str, Value]) -> tuple[Frame, ...]:
    """Frame 0 and that of each link in a pose, seen from frame 0."""
    values = known_values(robot)
    chains = [
        tuple(move for link in robot.links[:count] for move in link.moves) for count in range(len(robot.links) + 1)
    ]
    return tuple(drawing_of(chain, robot.variables, values, pose).end for chain in chains)


def _moving(robot: Robot, link: Link) -> bool:
    return link.row is not None and sum(name in names(link.moves) for name in robot.variables) == 1


def _on_frame(line: Line, frame: Frame) -> Line:
    """The line of a joint as the z axis of its frame; a joint that moves against it has a negative rate."""
    through = frame.origin if line.through is None else line.through
    along = line if dot(line.direction, frame.z) > 0 else line.reversed()
    return replace(along, through=through)
