"""A robot as a URDF: a joint for each variable, all frames as the base stands with the joints at zero."""

from __future__ import annotations

import re
from collections.abc import Iterator

from dhcli.errors import RobotError
from dhcli.geometry.euler import RollPitchYaw
from dhcli.geometry.vectors import ORIGIN, Vector, plus
from dhcli.kinematics.describe.description import in_numbers
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, drawing_of
from dhcli.kinematics.describe.exact import exact_length
from dhcli.kinematics.describe.linear import Point
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.validity import in_floats
from dhcli.notation.tree import ONE
from dhcli.safe import xml_attribute, xml_comment

_EFFORT = 'effort="100" velocity="1"'
"""A URDF wants both; a robot file has neither."""

_SLIDE = ("-1", "1")
"""Limits of a slide that has none [m]."""


def urdf_text(robot: Robot) -> str:
    """The text of a URDF with the same motion from frame base to frame tool.

    Raises:
        RobotError: A length has no value, or a variable counts in other units than its joint moves.
    """
    valued = in_numbers(robot)
    drawing = drawing_of(valued.chain, valued.variables, {})
    for line in drawing.lines:
        if line.pitch:
            raise RobotError(f"{line.name} turns and slides", "a URDF has no screws")
        if line.rate != 1:
            message = f"{line.name} moves its joint by {line.rate} of its own value"
            raise RobotError(message, "a URDF has no joint like that: give the joint a variable of its own")
    return "\n".join(_lines(robot, drawing)) + "\n"


def _lines(robot: Robot, drawing: Drawing) -> Iterator[str]:
    yield '<?xml version="1.0"?>'
    yield xml_comment(f"Made by dhcli from {robot.name}: {robot.title}. Effort and velocity stand in.")
    yield f"<robot name={xml_attribute(re.sub(r'[^A-Za-z0-9_-]', '_', robot.name) or 'robot')}>"
    links = ["base_link", *(f"link_{i}" for i in range(1, len(drawing.lines) + 1)), "tool0"]
    yield from (f'  <link name="{link}"/>' for link in links)
    here = ORIGIN
    for i, line in enumerate(drawing.lines):
        there = _at(line.through) if line.through is not None else here
        yield from _joint(robot, line, links[i : i + 2], plus(there, here, -1))
        here = there
    yield f'  <joint name="tool0_joint" type="fixed">\n    <parent link="{links[-2]}"/>\n    <child link="tool0"/>'
    yield f"    {_origin(plus(_at(drawing.end.origin), here, -1), drawing.end)}\n  </joint>"
    yield "</robot>"


def _joint(robot: Robot, line: Line, links: list[str], offset: Vector) -> Iterator[str]:
    limits = robot.limits.get(line.name)
    kind = "prismatic" if not line.turns else "revolute" if limits else "continuous"
    yield f'  <joint name={xml_attribute(line.name)} type="{kind}">'
    yield f'    <parent link="{links[0]}"/>'
    yield f'    <child link="{links[1]}"/>'
    yield f"    {_origin(offset)}"
    yield f'    <axis xyz="{_three(line.direction)}"/>'
    if kind != "continuous":
        low, high = (_number(in_floats(limit)) for limit in limits) if limits else _SLIDE
        yield f'    <limit lower="{low}" upper="{high}" {_EFFORT}/>'
    yield "  </joint>"


def _origin(offset: Vector, frame: Frame | None = None) -> str:
    turned = ""
    if frame is not None:
        rows = tuple(zip(frame.x, frame.y, frame.z, strict=True))
        turned = f' rpy="{_three(RollPitchYaw.of(rows).numbers)}"'
    return f'<origin xyz="{_three(offset)}"{turned}/>'


def _at(point: Point | None) -> Vector:
    return (point or {}).get(ONE, ORIGIN)


def _three(vector: tuple[float, ...]) -> str:
    return " ".join(_number(part) for part in vector)


def _number(value: float) -> str:
    """As few digits as say it, and no minus zero."""
    return repr(float(exact_length(value).value) + 0.0).removesuffix(".0")
