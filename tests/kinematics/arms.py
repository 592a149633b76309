"""Arms that are in no document, for rules that need more or fewer joints than those have."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from dhcli import load_robot
from dhcli.files.library.entries import Kind, entries
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Symbol

DH = tuple[str, int, str]
"""a, alpha in degrees and d of a row; names of lengths, or nothing for 0."""


@cache
def robot_once(name: str) -> Robot:
    """A robot, read once for all tests of a process; what is found for it is found once as well."""
    return load_robot(name)


def hinges(name: str, *rows: DH) -> Robot:
    """An arm of hinges in standard DH."""
    links, lengths = [], {}
    for number, (a, alpha, d) in enumerate(rows, 1):
        row = Row(_length(a), Angle.in_degrees(alpha), _length(d), Angle.of(f"theta{number}"))
        links.append(Link(number, moves_of(row, Convention.STANDARD), row))
        lengths |= {length: None for length in (a, d) if length}
    variables = tuple(f"theta{number}" for number in range(1, len(rows) + 1))
    return Robot(name, name, "of this test", Convention.STANDARD, variables, tuple(links), lengths)


def numbered_hinges(table: str) -> Robot:
    """An arm of hinges in standard DH whose rows are written `a,alpha,d`, with blanks between them."""
    rows = [row.split(",") for row in table.split()]
    names = [f"q{k}" for k in range(1, len(rows) + 1)]
    written = [(float(a), f"{alpha}°", float(d), name) for (a, alpha, d), name in zip(rows, names, strict=True)]
    return Robot.from_dh(written, variables=names, convention="standard")


def _length(name: str) -> Expr:
    return Symbol(name) if name else ZERO


IIWA = hinges(
    "iiwa", ("", -90, "d1"), ("", 90, ""), ("", 90, "d3"), ("", -90, ""), ("", -90, "d5"), ("", 90, ""), ("", 0, "d7")
)
"""Seven axes: a spherical shoulder, an elbow, a spherical wrist."""

FIVE = hinges("five", ("a1", 90, "d1"), ("a2", 0, ""), ("a3", 0, ""), ("", 90, ""), ("", 0, "d5"))
"""Five axes: a column, three parallel ones, a roll."""

PLANAR_4R = hinges("planar-4r", ("a1", 0, ""), ("a2", 0, ""), ("a3", 0, ""), ("a4", 0, ""))
"""One joint more than a plane needs."""

COBOT = Robot.from_dh(
    [
        *((0, 0, 0.245, "q1"), (0.075, "-90°", 0, "q2 - 90°"), (0.54, 0, 0, "q3")),
        *((0, "-90°", 0.54, "q4"), (0, "90°", -0.15, "q5"), (0, "-90°", 0.16, "q6")),
    ],
    variables=[f"q{i}" for i in range(1, 7)],
    convention="modified",
)
"""A wrist with an offset: three of its joints are found at once, and its determinant has one factor."""

PAN_TILT = hinges("pan-tilt", ("a1", 90, ""), ("a2", 0, ""))
"""Two axes at right angles."""


@cache
def moving_robots() -> Sequence[str]:
    """Every robot of the library that has a joint."""
    names = [entry.name for entry in entries(Kind.ROBOTS)]
    return tuple(name for name in names if load_robot(name).variables)


def with_values(robot: Robot) -> dict[str, str | float]:
    """Values for the lengths and constant angles that have none."""
    return {
        name: "20°" if name in robot.angles else 0.3 + 0.07 * k
        for k, (name, value) in enumerate(robot.parameters.items())
        if value is None
    }


def joint_point(robot: Robot, seed: int) -> list[float]:
    """Joint values with nothing special about them [rad and m]."""
    return [0.3 + 0.41 * ((seed * 7 + 3 * k) % 5) - 0.13 * k for k in range(len(robot.variables))]


def all_values(robot: Robot, seed: int) -> dict[str, Value | float | str]:
    """The same by name, with lengths."""
    return {**with_values(robot), **dict(zip(robot.variables, joint_point(robot, seed), strict=True))}
