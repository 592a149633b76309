"""A robot: links, joints, lengths, frames. One that exists is valid."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from importlib import import_module
from pathlib import Path
from typing import Any

from dhcli.errors import RobotError, plural
from dhcli.kinematics.derived import Value
from dhcli.kinematics.description import Description, Joint, Kind, Link
from dhcli.kinematics.given import text_of
from dhcli.kinematics.validity import check

__all__ = ["Joint", "Kind", "Link", "Robot", "Value", "check_robot", "read_from"]


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
        remarks: What was taken for something else when it was read, such as 1.5708 rad for 90°; what is so near that
            no result shows it is told where a robot is shown, and not at each use.
        called: What joints are called where the robot comes from, by variable, such as in a URDF; joint values may
            have these names too.
        path: The file it was read from; None if it was made in Python or came from standard input. Two robots are equal
            wherever they were read.

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
        parameters: Mapping[str, float | str | Value | None] | None = None,
        name: str = "robot",
    ) -> Robot:
        """A robot from the rows of its table.

        >>> Robot.from_dh([("a1", 0, 0, "q1"), (0.3, "90°", 0, "q2")], variables=["q1", "q2"], parameters={"a1": 0.4})
        <Robot robot: robot, 2 joints RR>

        Args:
            rows: Each a mapping with a, alpha, d and theta, or these four in this order. A number is in metres or
                radians; a text may have units, names and offsets: `"theta1 - 90°"`.
            convention: standard or modified.
            variables: The joint variables in order.
            parameters: Values of the other names, in metres and radians or as text; None for one that stays open.
            name: What it is called.

        Raises:
            RobotError: It is no robot; with every reason.
            NotationError: A cell cannot be read.
        """
        from dhcli.kinematics.building import from_dh

        return from_dh(cls, rows, variables=variables, convention=convention, parameters=parameters, name=name)

    @classmethod
    def from_screws(
        cls,
        screws: Iterable[Sequence[float]],
        home: object,
        *,
        frame: str = "space",
        variables: Sequence[str] = (),
        name: str = "robot",
    ) -> Robot:
        """A robot from its screws and its home pose.

        >>> Robot.from_screws([(0, 0, 1, 0, 0, 0), (0, 0, 1, 0, -0.4, 0)], "Trans(0.7, 0, 0)")
        <Robot robot: robot, 2 joints RR>

        Args:
            screws: Each six numbers, ω then v [m], or a direction of length 1 behind three zeros where the joint
                slides; an array of shape (n, 6).
            home: The end frame with all variables at zero: moves as text, or a matrix of shape (4, 4).
            frame: `space` for screws in the base, `body` for screws in the end frame.
            variables: The joint variables in order; by default theta1, d2, ... by what each joint does.
            name: What it is called.

        Raises:
            RobotError: Some of it is no screw, or no pose.
            NotationError: The moves of the home pose cannot be read.

        Source: Lynch and Park, Modern Robotics, chapter 4.
        """
        from dhcli.kinematics.describe.making import from_screws

        return from_screws(cls, screws, home, frame=frame, variables=variables, name=name)

    @staticmethod
    def from_text(text: str, *, name: str = "robot") -> Robot:
        """A robot from the text of a robot file, or of a URDF with one tip.

        >>> head = "{format: 1, title: t, source: s, convention: product, variables: [q1], links: "
        >>> Robot.from_text(head + "['Rot(z, q1) Trans(0.4, 0, 0)']}").pattern
        'R'

        Args:
            text: What a file would hold.
            name: What the robot is called.

        Raises:
            FileError: With every problem, each with line and column.
        """
        read = _above("files.yaml.robots", "robot_of")
        found: Robot = read(text_of(text, "text"), "text", text_of(name, "name"))
        return found

    @staticmethod
    def from_urdf(
        text: str, *, base: str | None = None, tip: str | None = None, as_typed: bool = False, name: str = "robot"
    ) -> Robot:
        """A robot from the text of a URDF, one serial chain of it; a file is read by `load_robot("arm.urdf")`.

        Args:
            text: The XML.
            base: The link that is frame 0; by default the root.
            tip: The link that is the last frame; by default the only one at the end of a chain that moves.
            as_typed: Whether 1.5708 stays what it is, and is not taken as 90°.
            name: What the robot is called.

        Raises:
            FileError: It is no URDF, or has no such chain.
            UnknownNameError: There is no such link; the nearest are listed.
        """
        read = _above("files.urdf.robots", "read_urdf")
        given, called = text_of(text, "text"), text_of(name, "name")
        if "<" not in given:
            raise RobotError(f"{given!r:.60} is no XML", f"a file is read by load_robot({given.strip()!r:.60})")
        found: Robot = read(given, "text", called, base=base, tip=tip, as_typed=as_typed)
        return found

    def save(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write a file that `load_robot` reads: YAML, or a URDF where the name of the file ends so.

        Args:
            path: Where to.
            overwrite: Whether a file that stands there may be replaced.

        Raises:
            FileError: The file exists already, or cannot be written.
            RobotError: It cannot be a URDF.
        """
        if not isinstance(path, str | Path):
            raise RobotError(f"{path!r:.60} is no path", "write robot.save('arm.yaml')")
        _above("files.yaml.writing", "save_robot")(self, path, overwrite=overwrite)

    @property
    def typed(self) -> str:
        """What is typed behind a command to mean it: its name, or its path where no name leads there."""
        words: str = _above("files.library.lookup", "typed")(self.name, self.path)
        return words

    def copy(
        self,
        *,
        tool: object = None,
        base: object = None,
        parameters: Mapping[str, float | str | Value] | None = None,
        name: str | None = None,
    ) -> Robot:
        """The same robot with another tool, base or other lengths.

        Args:
            tool: One of its tools by name, or where the tool is seen from its last frame: moves as text, such as
                `"Trans(0, 0, 0.1)"`, empty for none, or a pose, or a matrix of shape (4, 4).
            base: Likewise where its first frame is seen from the base.
            parameters: Lengths and angles instead of its own, in metres and radians or as text.
            name: What the copy is called.

        Raises:
            UnknownNameError: It has no such length.
            NotationError: The moves cannot be read.
            RobotError: A matrix is no pose.
        """
        from dhcli.kinematics.building import copy

        return copy(self, tool=tool, base=base, parameters=parameters, name=name)

    def __repr__(self) -> str:
        """One line, as the prompt shows it; `dhcli show` and the attributes have the rest."""
        return f"<Robot {self.name}: {self.title}, {plural(len(self.variables), 'joint')} {self.pattern}>"

    def __hash__(self) -> int:
        """By the fields that tell robots apart; it is asked for often."""
        return hash((self.name, self.convention, self.variables, self.links, self.base, self.tool, self.first))


def _above(module: str, name: str) -> Any:  # noqa: ANN401  each caller says what it is
    """A function of a floor above, which reads and writes files and is imported when it is asked for."""
    return getattr(import_module(f"dhcli.{module}"), name)


def read_from(robot: Robot, path: Path) -> Robot:
    """The same robot, which was read from a file. It is valid, so that nothing of it is looked at again."""
    found: Robot = object.__new__(Robot)
    for each in fields(robot):
        object.__setattr__(found, each.name, path if each.name == "path" else getattr(robot, each.name))
    return found


def check_robot(robot: object) -> None:
    """Make sure that a caller has given a robot, and not its name.

    Raises:
        RobotError: It is something else.
    """
    if not isinstance(robot, Robot):
        hint = f"load_robot({robot!r}) loads one" if isinstance(robot, str) else "load_robot loads one"
        raise RobotError(f"a Robot is wanted, not {robot!r:.60}", hint)
