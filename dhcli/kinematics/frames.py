"""Which frame is meant, seen from where, and the part of a robot's chain that leads from one to the other."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeAlias

from dhcli.errors import RobotError, UnknownNameError
from dhcli.frozen import frozen
from dhcli.kinematics.moves import Chain, Trans, inverse
from dhcli.kinematics.robot import Robot
from dhcli.notation.tree import ZERO, Expr

Point: TypeAlias = tuple[Expr, Expr, Expr]
"""Coordinates of a point, or of a vector [m]."""

ORIGIN: Point = (ZERO, ZERO, ZERO)


@frozen
class View:
    """Which frame of a robot is described, seen from where.

    Attributes:
        start: The frame it is seen from.
        end: The frame described.
        inverse: Whether the two change places.
        point: A point of the frame described that is meant instead of its origin [m]; None where none was given.
    """

    start: str
    end: str
    inverse: bool = False
    point: Point | None = None

    @classmethod
    def of(
        cls,
        robot: Robot,
        start: str | int | None = None,
        end: str | int | None = None,
        *,
        inverse: bool = False,
        point: Point | None = None,
    ) -> View:
        """A view by the frames that a person names, by default the first and the last of the numbered ones.

        Raises:
            UnknownNameError: The robot has no such frame; the hint lists those it has.
        """
        return cls(*ends(robot, start, end), inverse, point)

    @property
    def reference(self) -> str:
        """The frame that it is seen from in the end."""
        return self.end if self.inverse else self.start

    @property
    def frame(self) -> str:
        """The frame that is described in the end."""
        return self.start if self.inverse else self.end

    @property
    def coordinates(self) -> Point:
        """The point meant, the origin where none was given."""
        return ORIGIN if self.point is None else self.point

    def chain(self, robot: Robot) -> Chain:
        """The moves from the reference to the frame."""
        return between(robot, self.reference, self.frame)

    def chain_to_point(self, robot: Robot) -> Chain:
        """The same, and on to the point: the last translation, so that its brackets nest as in a textbook."""
        return self.chain(robot) if self.coordinates == ORIGIN else (*self.chain(robot), Trans(*self.coordinates))

    def on_the_way(self, robot: Robot) -> tuple[View, ...]:
        """A view of each frame that one comes by: not of the reference, unless it is all there is."""
        names = path(robot, self.reference, self.frame) or (self.frame,)
        return tuple(replace(self, start=self.reference, end=name, inverse=False) for name in names)


def frame(robot: Robot, name: str | int) -> str:
    """The frame a person means.

    Raises:
        UnknownNameError: The robot has no such frame; the hint lists those it has.
    """
    text = str(name).strip().lower()
    if text not in robot.frames:
        hint = f"frames: {', '.join(robot.frames)}"
        if robot.path is not None and robot.path.suffix.lower() == ".urdf":
            hint += f"; a link of the URDF is the last frame with --tip {name}, and frame 0 with --base {name}"
        raise UnknownNameError(f"{robot.name} has no frame {name}", hint)
    return text


def place_of(robot: Robot, number: str) -> int:
    """The place of a link in its robot.

    Raises:
        UnknownNameError: The robot has no link of this number; the hint lists those it has.
    """
    numbered = [str(link.number) for link in robot.links]
    if number not in numbered:
        raise UnknownNameError(f"{robot.name} has no link {number}", f"links: {', '.join(numbered)}")
    return numbered.index(number)


def span_of(robot: Robot, view: View) -> tuple[int, int]:
    """The places of two frames in the order of the robot."""
    first, last = (robot.frames.index(frame(robot, name)) for name in (view.start, view.end))
    return first, last


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


def check_moves(joints: int) -> None:
    """Make sure that a joint moves the end.

    Raises:
        RobotError: None does.
    """
    if not joints:
        raise RobotError("no joint moves the end", "there is nothing to compute; fk says where it is")
