"""Between which frames: the part of a robot's chain that leads from one to the other."""

from __future__ import annotations

from dhcli.errors import UnknownNameError
from dhcli.kinematics.moves import Chain, inverse
from dhcli.kinematics.robot import Robot


def frame(robot: Robot, name: str | int) -> str:
    """The frame a person means.

    Raises:
        UnknownNameError: The robot has no such frame; the hint lists those it has.
    """
    text = str(name).strip().lower()
    if text not in robot.frames:
        frames = ", ".join(robot.frames)
        raise UnknownNameError(f"{robot.name} has no frame {name}", f"frames: {frames}")
    return text


def ends(robot: Robot, start: str | int | None, end: str | int | None) -> tuple[str, str]:
    """The two frames meant, by default the first and the last of the numbered ones."""
    return (
        robot.frames[1] if start is None else frame(robot, start),
        robot.frames[-2] if end is None else frame(robot, end),
    )


def between(robot: Robot, start: str, end: str) -> Chain:
    """The moves from one frame to another, backwards if need be."""
    first, last = robot.frames.index(start), robot.frames.index(end)
    if first > last:
        return inverse(between(robot, end, start))
    segments = (robot.base, *(link.moves for link in robot.links), robot.tool)
    return tuple(move for segment in segments[first:last] for move in segment)


def path(robot: Robot, start: str, end: str) -> tuple[str, ...]:
    """The frames that one comes by on the way from one to another: not the first, but the last."""
    first, last = robot.frames.index(start), robot.frames.index(end)
    return robot.frames[first + 1 : last + 1] if first <= last else robot.frames[last:first][::-1]
