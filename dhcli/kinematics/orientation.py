"""Other ways to say an orientation: roll, pitch, yaw; axis and angle; quaternion; and plain words."""

from __future__ import annotations

import math
from dataclasses import dataclass

from dhcli.kinematics.pose import Pose
from dhcli.kinematics.words import in_words

__all__ = ["AxisAngle", "Quaternion", "RollPitchYaw", "axis_angle", "in_words", "quaternion", "roll_pitch_yaw"]

TINY = 1e-9
"""Below this a sine counts as zero, and an angle that depends on its direction is free."""


@dataclass(frozen=True, slots=True)
class RollPitchYaw:
    """R = Rz(yaw) Ry(pitch) Rx(roll) [rad], pitch in [-π/2, π/2].

    Attributes:
        roll: About x.
        pitch: About y.
        yaw: About z.
        locked: Whether pitch is ±90°, where only one of roll and yaw can be told; roll is then 0.
    """

    roll: float
    pitch: float
    yaw: float
    locked: bool = False


@dataclass(frozen=True, slots=True)
class AxisAngle:
    """Rotation by an angle in [0, π] [rad] about a unit vector; the axis of no rotation is z."""

    axis: tuple[float, float, float]
    angle: float


@dataclass(frozen=True, slots=True)
class Quaternion:
    """A unit quaternion with w >= 0."""

    w: float
    x: float
    y: float
    z: float


def roll_pitch_yaw(pose: Pose[float]) -> RollPitchYaw:
    """Orientation as roll, pitch and yaw about the fixed axes x, y, z of the reference, in this order.

    Source: Craig, eqs. 2.64 to 2.68.
    """
    (r11, r12, _), (r21, r22, _), (r31, r32, r33) = pose.rotation
    pitch = math.atan2(-r31, math.hypot(r11, r21)) + 0.0  # no minus zero
    if math.hypot(r11, r21) < TINY:
        return RollPitchYaw(0.0, pitch, math.atan2(-r12, r22) + 0.0, locked=True)
    return RollPitchYaw(math.atan2(r32, r33) + 0.0, pitch, math.atan2(r21, r11) + 0.0)


def quaternion(pose: Pose[float]) -> Quaternion:
    """Orientation as a quaternion, from the largest of its four components.

    Source: S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and Control 1, 1978.
    """
    (r11, r12, r13), (r21, r22, r23), (r31, r32, r33) = pose.rotation
    squares = (1 + r11 + r22 + r33, 1 + r11 - r22 - r33, 1 - r11 + r22 - r33, 1 - r11 - r22 + r33)
    largest = squares.index(max(squares))
    candidates = (
        (squares[0], r32 - r23, r13 - r31, r21 - r12),
        (r32 - r23, squares[1], r12 + r21, r31 + r13),
        (r13 - r31, r12 + r21, squares[2], r23 + r32),
        (r21 - r12, r31 + r13, r23 + r32, squares[3]),
    )[largest]
    length = math.copysign(math.sqrt(sum(part * part for part in candidates)), candidates[0])
    if abs(candidates[0]) < TINY * abs(length):  # half a turn: the first component that is not zero is positive
        length = math.copysign(length, next(part for part in candidates[1:] if abs(part) > TINY))
    w, x, y, z = (part / length + 0.0 for part in candidates)
    return Quaternion(abs(w), x, y, z)


def axis_angle(pose: Pose[float]) -> AxisAngle:
    """Orientation as one rotation about one axis."""
    turn = quaternion(pose)
    sine = math.sqrt(turn.x**2 + turn.y**2 + turn.z**2)
    if sine < TINY:
        return AxisAngle((0.0, 0.0, 1.0), 0.0)
    return AxisAngle((turn.x / sine, turn.y / sine, turn.z / sine), 2 * math.atan2(sine, turn.w))
