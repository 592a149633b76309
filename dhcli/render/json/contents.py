"""What stands under `data` in JSON for each kind of result. The keys are a contract with those who read them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from dhcli.geometry.euler import EulerAngles, RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.placement import Matrix, Placement, Position
from dhcli.kinematics.question import AnyPose, ForwardKinematics
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Number
from dhcli.notation.writer import write
from dhcli.render.code.matrices import exact
from dhcli.render.look import Look
from dhcli.render.text.quantities import in_units


def forward_content(result: ForwardKinematics, look: Look) -> dict[str, Any]:
    """The answer of `dhcli fk`: always the matrix, its frames and the values; listings where asked for."""
    robot, question = result.robot, result.question
    found: dict[str, Any] = {
        "robot": robot.name,
        "convention": robot.convention.value,
        "values": {name: in_units(value) for name, value in result.values.items()},
        "symbolic": question.symbolic,
        **pose_content(result.pose, look),
    }
    if question.let:
        found["definitions"] = [
            {"name": one.name, "value": number(one.expr, robot.writing, look)} for one in result.definitions
        ]
    if question.listing:
        found[question.listing] = [{"name": pose.name, **pose_content(pose, look)} for pose in result.poses]
    if result.point is not None:
        found["point"] = {
            "given": [plain_number(value, robot.writing, look) for value in result.point.given],
            "seen": [number(value, robot.writing, look) for value in result.point.seen],
        }
    if result.placements:
        found["as"] = placements_content(result.placements, robot.writing, look)
    return found


def pose_content(pose: AnyPose, look: Look) -> dict[str, Any]:
    """A matrix and its two frames."""
    return {
        "reference": pose.reference,
        "frame": pose.frame,
        "matrix": [[number(entry, pose.joints, look) for entry in row] for row in pose.rows],
    }


def placements_content(placements: Mapping[str, Placement], joints: Joints, look: Look) -> dict[str, Any]:
    """Other ways to say a pose; angles in radians."""
    return {form: _placement(placement, joints, look) for form, placement in placements.items()}


def number(value: Expr | float, joints: Joints, look: Look) -> float | str:
    """A number, or a formula as sympy reads it."""
    return write(value, look.style or "sympy", joints) if isinstance(value, Expr) else exact(value)


def plain_number(value: Expr, joints: Joints, look: Look) -> float | str:
    """A number where the expression is one, else a formula."""
    return exact(float(value.value)) if isinstance(value, Number) else number(value, joints, look)


def _placement(placement: Placement, joints: Joints, look: Look) -> list[Any] | dict[str, Any]:
    match placement:
        case Matrix(rows):
            return [[number(value, joints, look) for value in row] for row in rows]
        case Position(coordinates):
            return [number(value, joints, look) for value in coordinates]
        case RollPitchYaw(roll, pitch, yaw):
            return {"roll": exact(roll), "pitch": exact(pitch), "yaw": exact(yaw)}
        case AxisAngle(axis, angle):
            return {"axis": [exact(value) for value in axis], "angle": exact(angle)}
        case Quaternion(w, x, y, z):
            return {key: exact(value) for key, value in zip("wxyz", (w, x, y, z), strict=True)}
        case RotationVector():
            return [exact(value) for value in placement.numbers]
        case EulerAngles():
            return {
                "angles": [exact(value) for value in placement.angles],
                "other": [exact(value) for value in placement.other.angles],
                "locked": bool(placement.locked),
            }
