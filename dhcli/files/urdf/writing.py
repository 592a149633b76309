"""A robot as a URDF: a joint for each variable, all frames as the base stands with the joints at zero."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.euler import RollPitchYaw
from dhcli.geometry.vectors import ORIGIN, Vector, minus
from dhcli.kinematics.coupling import Uncoupled, is_coupled, uncoupled
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, drawing_of
from dhcli.kinematics.describe.exact import exact_length
from dhcli.kinematics.describe.linear import Point
from dhcli.kinematics.forward import with_own_values
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import magnitude
from dhcli.notation.tree import ONE
from dhcli.safe import xml_attribute, xml_comment

_EFFORT = 'effort="100" velocity="1"'
"""A URDF wants both; a robot file has neither."""

_END = "tool0_joint"
"""The joint that holds the end frame."""

_SLIDE = 1.0
"""How far a slide goes that has no limits [m]."""


@frozen
class _Part:
    """One joint of a URDF.

    Attributes:
        name: Its variable, unless another joint has that.
        line: Its axis, in the sense in which its variable grows.
        leader: The variable that it follows; empty where it has its own.
        multiplier: How far it moves for each unit of that [rad or m for a rad or m].
    """

    name: str
    line: Line
    leader: str = ""
    multiplier: float = 1.0


def urdf_text(robot: Robot) -> str:
    """The text of a URDF with the same motion from frame base to frame tool.

    A move that shares its variable is a joint that follows another (`<mimic>`); one that several variables make is a
    joint for each of them, one behind the other.

    Raises:
        RobotError: A length has no value, or no joint moves by a variable itself.
    """
    valued = with_own_values(robot)
    free = uncoupled(valued, singly=True) if is_coupled(valued) else None
    arm = valued if free is None else free.robot
    drawing = drawing_of(arm.chain, arm.variables, {})
    parts = [_Part(line.name, line) for line in drawing.lines] if free is None else list(_followed(free, drawing))
    for part in parts:
        if part.line.rate != 1:
            message = f"{part.name} moves its joint by {part.line.rate} of its own value"
            raise RobotError(message, "a URDF has no joint like that: give the joint a variable of its own")
    return "\n".join(_lines(robot, parts, drawing.end)) + "\n"


def _followed(free: Uncoupled, drawing: Drawing) -> Iterator[_Part]:
    """The joints of an arm that has one for each move by each variable: of those by one variable, the first leads.

    Raises:
        RobotError: None of them moves by the variable itself, so that none can lead.
    """
    slopes = {
        joint: (name, slope)
        for joint, row in zip(free.formulas, free.linear({})[0], strict=True)
        for name, slope in zip(free.given.variables, row, strict=True)
        if slope
    }
    leading: dict[str, str] = {}
    for line in drawing.lines:  # the first, for joints that are read again have the order in which they lead
        name, slope = slopes[line.name]
        if abs(slope) == 1 and line.turns == (name in free.given.turning):
            leading.setdefault(name, line.name)
    for line in drawing.lines:
        if line.name in free.given.variables:
            leading.setdefault(line.name, line.name)
    if lacking := [name for name in free.given.variables if name not in leading]:
        message = f"no joint moves by {lacking[0]} itself, for others of a URDF to follow"
        raise RobotError(
            message, f"a row in which {lacking[0]} stands alone would be one; --as product has no such need"
        )
    for line in drawing.lines:
        name, slope = slopes[line.name]
        along = line if slope > 0 else line.reversed()
        if leading[name] == line.name:
            yield _Part(name, replace(along, rate=magnitude(along.rate)))
        else:
            own = leading[name] if line.name == name else line.name  # its leader has the name of the variable
            yield _Part(own, replace(along, rate=magnitude(along.rate)), name, abs(slope))


def _lines(robot: Robot, parts: Sequence[_Part], end: Frame) -> Iterator[str]:
    yield '<?xml version="1.0"?>'
    yield xml_comment(f"Made by dhcli from {robot.name}: {robot.title}. Effort and velocity stand in.")
    yield f"<robot name={xml_attribute(re.sub(r'[^A-Za-z0-9_-]', '_', robot.name) or 'robot')}>"
    links = ["base_link", *(f"link_{i}" for i in range(1, len(parts) + 1)), "tool0"]
    yield from (f'  <link name="{link}"/>' for link in links)
    here = ORIGIN
    joints = _names(robot, parts)
    for i, part in enumerate(parts):
        there = _at(part.line.through) if part.line.through is not None else here
        yield from _joint(robot, part, joints, links[i : i + 2], minus(there, here))
        here = there
    yield f'  <joint name="{_END}" type="fixed">\n    <parent link="{links[-2]}"/>\n    <child link="tool0"/>'
    yield f"    {_origin(minus(_at(end.origin), here), end)}\n  </joint>"
    yield "</robot>"


def _names(robot: Robot, parts: Sequence[_Part]) -> dict[str, str]:
    """What the joints are called: as elsewhere, where no other joint has that name."""
    taken = {_END, *(part.name for part in parts)}
    elsewhere = {part.name: robot.called.get(part.name, part.name) for part in parts}
    return {name: name if called in taken else called for name, called in elsewhere.items()}


def _joint(robot: Robot, part: _Part, joints: Mapping[str, str], links: list[str], offset: Vector) -> Iterator[str]:
    limits = _limits(robot, part)
    kind = "prismatic" if not part.line.turns else "revolute" if limits else "continuous"
    yield f'  <joint name={xml_attribute(joints[part.name])} type="{kind}">'
    yield f'    <parent link="{links[0]}"/>'
    yield f'    <child link="{links[1]}"/>'
    yield f"    {_origin(offset)}"
    yield f'    <axis xyz="{_three(part.line.direction)}"/>'
    if part.leader:
        leader = xml_attribute(joints[part.leader])
        yield f'    <mimic joint={leader} multiplier="{_number(part.multiplier)}" offset="0"/>'
    if kind != "continuous":
        low, high = limits or _stand_in(robot, part)
        yield f'    <limit lower="{_number(low)}" upper="{_number(high)}" {_EFFORT}/>'
    yield "  </joint>"


def _limits(robot: Robot, part: _Part) -> tuple[float, float] | None:
    """The limits of a joint: those of its variable, as far as it follows that, or the widest that motors leave it."""
    name = part.leader or part.name
    own = [tuple(map(in_floats, robot.limits[name]))] if name in robot.limits else []
    left = [robot.actuators.reach(name)] if robot.actuators is not None and name in robot.actuators.joints else []
    bounds = [pair for pair in (*own, *left) if pair is not None]
    if not bounds:
        return None
    lows, highs = zip(*bounds, strict=True)
    return part.multiplier * max(lows), part.multiplier * min(highs)


def _stand_in(robot: Robot, part: _Part) -> tuple[float, float]:
    """Limits of a slide that has none; one that follows another goes as far as that."""
    far = part.multiplier * _SLIDE if part.leader and part.leader not in robot.turning else _SLIDE
    return -far, far


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
