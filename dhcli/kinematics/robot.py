"""A robot: links, joints, lengths, frames. One that exists is valid."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from types import MappingProxyType

from dhcli.errors import RobotError, plural
from dhcli.kinematics.derived import Value
from dhcli.kinematics.description import Description, Joint, Kind, Link
from dhcli.kinematics.validity import check

__all__ = ["Joint", "Kind", "Link", "Robot", "Value", "check_robot"]


class Robot(Description):
    """A serial robot.

    Attributes:
        name: The name it is asked for by.
        title: What it is called.
        source: Where its numbers come from.
        convention: How its links are described.
        variables: Joint variables in order.
        links: The links in order.
        parameters: Value of each length and constant angle; None where it has none.
        base: Moves from frame `base` to the first frame.
        tool: Moves from the last frame to frame `tool`.
        first: Number of the first link.
        limits: Lowest and highest value of joint variables.
        poses: Named poses, a value for each variable.
        columns: Order of the columns in which the table was written.
        notes: What else a reader should know.
        derived: Formulas of those parameters that follow from others; their values stand among the parameters.
        tools: Tools by name, each with the moves from the last frame to its own, to take in the place of `tool`.
        actuators: The motors, where they drive joints together; `in_motors` gives the robot by their values.
        drives: Of a robot by motor values, the robot by joint values.
        remarks: What was taken for something else when it was read, such as 1.5708 rad for 90°.

    Raises:
        InvalidRobotError: With every finding, if it is not a robot.
    """

    def __post_init__(self) -> None:
        """Refuse to exist with anything wrong."""
        super().__post_init__()
        check(self)

    @classmethod
    def from_dh(
        cls,
        rows: Iterable[Mapping[str, float | str] | Sequence[float | str]],
        *,
        variables: Sequence[str],
        convention: str = "standard",
        parameters: Mapping[str, float | str | Value] | None = None,
        name: str = "robot",
    ) -> Robot:
        """A robot from the rows of its table; see `dhcli.kinematics.building.from_dh`."""
        from dhcli.kinematics.building import from_dh

        return from_dh(cls, rows, variables=variables, convention=convention, parameters=parameters, name=name)

    def copy(
        self,
        *,
        tool: str | None = None,
        base: str | None = None,
        parameters: Mapping[str, float | str | Value] | None = None,
        name: str | None = None,
    ) -> Robot:
        """The same robot with another tool, base or other lengths; see `dhcli.kinematics.building.copy`."""
        from dhcli.kinematics.building import copy

        return copy(self, tool=tool, base=base, parameters=parameters, name=name)

    def __reduce__(self) -> tuple[type[Robot], tuple[object, ...]]:
        """Copied and sent to other processes by its fields, which a read-only view of a mapping could not be."""
        values = (getattr(self, each.name) for each in fields(self))
        return Robot, tuple(dict(value) if isinstance(value, MappingProxyType) else value for value in values)

    def __repr__(self) -> str:
        """One line, as the prompt shows it; `dhcli show` and the attributes have the rest."""
        return f"<Robot {self.name}: {self.title}, {plural(len(self.variables), 'joint')} {self.pattern}>"

    def __hash__(self) -> int:
        """By the fields that cannot change in place; equal robots have equal ones."""
        return hash((self.name, self.convention, self.variables, self.links, self.base, self.tool, self.first))


def check_robot(robot: object) -> None:
    """Make sure that a caller has given a robot, and not its name.

    Raises:
        RobotError: It is something else.
    """
    if not isinstance(robot, Robot):
        hint = f"load_robot({robot!r}) loads one" if isinstance(robot, str) else "load_robot loads one"
        raise RobotError(f"a Robot is wanted, not {robot!r:.60}", hint)
