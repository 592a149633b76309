"""What questions about one link of the robot share."""

from __future__ import annotations

from dhcli.checking.exercise import Exercise
from dhcli.errors import NotationError, Place, Problem, RobotError
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


def found_link(robot: Robot | None, number: str) -> Link:
    """A link that is asked about.

    Raises:
        RobotError: There is no robot, or no such link.
    """
    found = [one for one in needed(robot).links if str(one.number) == number]
    if not found:
        raise RobotError(f"{needed(robot).name} has no link {number}")
    return found[0]


def link_of(exercise: Exercise, number: str) -> Link:
    """A link of the exercise's robot by its number.

    Raises:
        RobotError: There is no robot, or no such link.
    """
    robot = exercise.robot
    if robot is None:
        raise RobotError(f"{exercise.id} asks about a robot and names none")
    for link in robot.links:
        if str(link.number) == number:
            return link
    numbered = ", ".join(str(link.number) for link in robot.links)
    raise RobotError(f"{robot.name} has no link {number}", f"links: {numbered}")


def place_of(robot: Robot, number: str) -> int:
    """The place of a link in its robot."""
    return next(k for k, link in enumerate(robot.links) if str(link.number) == number)
