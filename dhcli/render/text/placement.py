"""A pose said in other ways: roll, pitch and yaw; axis and angle; quaternion; position."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from dhcli.geometry.euler import EulerAngles, RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.placement import Matrix, Placement, Position
from dhcli.kinematics.question import ForwardKinematics
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.render.code.matrices import csv_line, entry
from dhcli.render.look import Look
from dhcli.render.text.forward import context_lines, heading
from dhcli.render.text.matrix import matrix_lines, vector_lines

_CONVENTIONS = {
    RollPitchYaw: "R = Rz(yaw) Ry(pitch) Rx(roll), pitch from -90° to 90°",
    AxisAngle: "rotation about a unit vector, angle from 0° to 180°",
    Quaternion: "unit quaternion, w >= 0",
    Matrix: "homogeneous matrix, lengths in m",
    Position: "position of the origin, in m",
    RotationVector: "unit axis times angle, in degrees; the length is the angle",
}


def placement_table(result: ForwardKinematics, look: Look) -> str:
    """The pose in each way that was asked for."""
    lines = [heading(result.pose, result.robot.name, look), *context_lines(result, look)]
    return "\n".join([*lines, *placement_lines(result.placements, result.robot.writing, look)]) + "\n"


def placement_lines(placements: Mapping[str, Placement], joints: Joints, look: Look) -> Iterator[str]:
    """Each way with its convention above it."""
    paper = look.paper
    for form, placement in placements.items():
        title = paper.ink(paper.spell(form), "bold")
        yield ""
        yield f"{title}  {paper.ink(paper.spell(_convention(placement)), 'dim')}"
        yield from _lines(placement, joints, look)


def _convention(placement: Placement) -> str:
    if not isinstance(placement, EulerAngles):
        return _CONVENTIONS[type(placement)]
    order = placement.order
    product = " ".join(
        f"R{axis}({number})" for axis, number in zip(order.product, "321" if order.fixed else "123", strict=True)
    )
    middle = "0° to 180°" if order.is_proper else "-90° to 90°"
    about = "fixed" if order.fixed else "current"
    return f"R = {product}: about {about} axes, the second angle from {middle}"


def placement_csv(result: ForwardKinematics, look: Look) -> str:
    """One line for each way: its name, then its numbers, angles in radians."""
    joints = result.robot.writing
    return "".join(
        csv_line([form, *(entry(value, joints, look) for value in _values(placement))])
        for form, placement in result.placements.items()
    )


def _lines(placement: Placement, joints: Joints, look: Look) -> Iterator[str]:
    degree = look.paper.spell("°")
    match placement:
        case Matrix(rows):
            yield from matrix_lines(rows, joints, look)
        case Position(coordinates):
            yield from vector_lines(("p_x", "p_y", "p_z"), coordinates, joints, look)
        case RollPitchYaw(roll, pitch, yaw):
            for line in vector_lines(
                ("roll", "pitch", "yaw"), [math.degrees(a) for a in (roll, pitch, yaw)], joints, look
            ):
                yield line + degree
        case AxisAngle(axis, angle):
            yield from vector_lines(("axis_x", "axis_y", "axis_z"), axis, joints, look)
            yield vector_lines(("angle ",), [math.degrees(angle)], joints, look)[0] + degree
        case Quaternion(w, x, y, z):
            yield from vector_lines("wxyz", (w, x, y, z), joints, look)
        case RotationVector():
            shown = [math.degrees(part) for part in placement.numbers]
            yield from (line + degree for line in vector_lines(("r_x", "r_y", "r_z"), shown, joints, look))
        case EulerAngles():
            names = [f"{number} about {axis}" for number, axis in enumerate(placement.order.axes, 1)]
            yield from (line + degree for line in vector_lines(names, placement.degrees, joints, look))
            if not placement.locked:
                other = ", ".join(f"{look.number(angle)}{degree}" for angle in placement.other.degrees)
                yield look.paper.ink(f"the same rotation: {other}", "dim")


def _values(placement: Placement) -> tuple[Expr | float, ...]:
    match placement:
        case Matrix(rows):
            return tuple(value for row in rows[:3] for value in row)
        case Position(coordinates):
            return coordinates
        case RollPitchYaw(roll, pitch, yaw):
            return (roll, pitch, yaw)
        case AxisAngle(axis, angle):
            return (*axis, angle)
        case Quaternion(w, x, y, z):
            return (w, x, y, z)
        case RotationVector() | EulerAngles():
            return placement.numbers
