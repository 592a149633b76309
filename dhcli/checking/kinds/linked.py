"""What questions about one link of the robot share."""

from __future__ import annotations

from dhcli.errors import NotationError, Place, Problem, RobotError
from dhcli.kinematics.frames import place_of
from dhcli.kinematics.robot import Link, Robot

MOST_DIGITS = 4


def read_number(text: str, place: Place | None) -> str:
    """The number of a link.

    Raises:
        NotationError: It is none.
    """
    if not text.strip().isdecimal() or len(text.strip()) > MOST_DIGITS:
        raise NotationError(Problem(f"'{text.strip():.60}' is not the number of a link", place, "write link 1"))
    return text.strip()


def needed(robot: Robot | None) -> Robot:
    """A robot that must be there.

    Raises:
        RobotError: It is not.
    """
    if robot is None:
        raise RobotError("this question needs a robot", "name one under robot:")
    return robot


def link_of(robot: Robot | None, number: str) -> Link:
    """A link that is asked about.

    Raises:
        RobotError: There is no robot.
        UnknownNameError: It has no such link.
    """
    robot = needed(robot)
    return robot.links[place_of(robot, number)]
