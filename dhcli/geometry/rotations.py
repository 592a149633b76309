"""Rotations by their axis: unit quaternions, an axis with an angle, and rotation vectors.

Each is one class for one rotation, whose numbers are floats, and for many, whose numbers are columns, shape (N,).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Generic, TypeAlias

from dhcli.frozen import frozen
from dhcli.geometry.reals import R, reals_of

if TYPE_CHECKING:
    Rotation: TypeAlias = Sequence[Sequence[R]]
    """Direction cosines, shape (3, 3)."""

TINY = 1e-9
"""Below this a sine counts as zero, and an axis that depends on its direction is free."""

HALF_TURN = 1e-13
"""Below this w counts as zero: roundings of a product."""


@frozen
class Quaternion(Generic[R]):
    """A unit quaternion with w >= 0; of the two of half a turn, the first part that is not zero is positive."""

    w: R
    x: R
    y: R
    z: R

    @classmethod
    def of(cls, rotation: Rotation[R]) -> Quaternion[R]:
        """Of a matrix, from the largest of its four parts.

        Source: S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and Control 1, 1978.
        """
        (r11, r12, r13), (r21, r22, r23), (r31, r32, r33) = rotation
        over = reals_of(r11)
        squares = (1 + r11 + r22 + r33, 1 + r11 - r22 - r33, 1 - r11 + r22 - r33, 1 - r11 - r22 + r33)
        a, b, c, d = over.largest(
            squares,
            (
                (squares[0], r32 - r23, r13 - r31, r21 - r12),
                (r32 - r23, squares[1], r12 + r21, r31 + r13),
                (r13 - r31, r12 + r21, squares[2], r23 + r32),
                (r21 - r12, r31 + r13, r23 + r32, squares[3]),
            ),
        )
        length = over.sqrt(a * a + b * b + c * c + d * d)
        leading = over.where(abs(b) > TINY, b, over.where(abs(c) > TINY, c, d))
        length = over.copysign(length, over.where(abs(a) < HALF_TURN * length, leading, a))
        return cls(abs(a / length), b / length + 0.0, c / length + 0.0, d / length + 0.0)  # no minus zero

    @property
    def numbers(self) -> tuple[R, ...]:
        """w, x, y, z."""
        return self.w, self.x, self.y, self.z

    def rotation(self) -> Rotation[R]:
        """The matrix."""
        w, x, y, z = self.w, self.x, self.y, self.z
        return (
            (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        )


@frozen
class AxisAngle(Generic[R]):
    """Rotation by an angle in [0, π] [rad] about a unit vector; the axis of no rotation is z."""

    axis: tuple[R, R, R]
    angle: R

    @classmethod
    def of(cls, rotation: Rotation[R]) -> AxisAngle[R]:
        """Of a matrix, by its quaternion."""
        turn = Quaternion.of(rotation)
        over = reals_of(turn.w)
        sine = over.sqrt(turn.x**2 + turn.y**2 + turn.z**2)
        still = sine < TINY
        size = over.where(still, 1.0, sine)
        x, y = (over.where(still, 0.0, part / size) for part in (turn.x, turn.y))
        z = over.where(still, 1.0, turn.z / size)
        return cls((x, y, z), over.where(still, 0.0, 2 * over.atan2(sine, turn.w)))

    @property
    def numbers(self) -> tuple[R, ...]:
        """x, y, z, angle."""
        x, y, z = self.axis
        return x, y, z, self.angle

    def rotation(self) -> Rotation[R]:
        """The matrix.

        Source: Rodrigues' formula.
        """
        over = reals_of(self.angle)
        (x, y, z), cos, sin = self.axis, over.cos(self.angle), over.sin(self.angle)
        rest = 1 - cos
        return (
            (cos + x * x * rest, x * y * rest - z * sin, x * z * rest + y * sin),
            (x * y * rest + z * sin, cos + y * y * rest, y * z * rest - x * sin),
            (x * z * rest - y * sin, y * z * rest + x * sin, cos + z * z * rest),
        )


@frozen
class RotationVector(Generic[R]):
    """The unit axis times the angle in [0, π] [rad]: the exponential coordinates of a rotation."""

    x: R
    y: R
    z: R

    @classmethod
    def of(cls, rotation: Rotation[R]) -> RotationVector[R]:
        """Of a matrix, by its quaternion; exact for the smallest turns, whose axis nobody could tell."""
        turn = Quaternion.of(rotation)
        over = reals_of(turn.w)
        sine = over.sqrt(turn.x**2 + turn.y**2 + turn.z**2)
        still = sine < TINY
        share = over.where(still, 2.0, 2 * over.atan2(sine, turn.w) / over.where(still, 1.0, sine))
        return cls(turn.x * share, turn.y * share, turn.z * share)

    @property
    def numbers(self) -> tuple[R, ...]:
        """x, y, z."""
        return self.x, self.y, self.z

    def rotation(self) -> Rotation[R]:
        """The matrix."""
        over = reals_of(self.x)
        angle = over.sqrt(self.x**2 + self.y**2 + self.z**2)
        still = angle < TINY
        size = over.where(still, 1.0, angle)
        half = over.where(still, 0.5, over.sin(angle / 2) / size)
        return Quaternion(over.cos(angle / 2), self.x * half, self.y * half, self.z * half).rotation()
