"""Rigid motions in floats, without numpy: where a few are compared, this is faster and costs no import."""

from __future__ import annotations

import math
from collections.abc import Sequence

from dhcli.frozen import frozen
from dhcli.geometry.motion import inverse
from dhcli.geometry.vectors import ORIGIN, UNITS, Vector, dot, minus, plus, scaled


@frozen
class Rigid:
    """A rigid motion: rows of its rotation, and its translation [m]."""

    rows: tuple[Vector, Vector, Vector] = UNITS
    offset: Vector = ORIGIN

    @classmethod
    def of(cls, matrix: Sequence[Sequence[float]]) -> Rigid:
        """A homogeneous matrix, shape (3, 4) or (4, 4), as a rigid motion."""
        (a, b, c, x), (d, e, f, y), (g, h, i, z) = matrix[:3]
        return cls(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))

    @classmethod
    def shift(cls, offset: Vector) -> Rigid:
        """A translation."""
        return cls(UNITS, offset)

    @classmethod
    def turn(cls, axis: Vector, angle: float, through: Vector = ORIGIN) -> Rigid:
        """The rotation about a line.

        Source: Rodrigues' formula.
        """
        cos, sin = math.cos(angle), math.sin(angle)
        x, y, z = axis
        u, v, w = scaled(axis, 1 - cos)
        rotation = cls(
            (
                (cos + u * x, v * x - sin * z, w * x + sin * y),
                (u * y + sin * z, cos + v * y, w * y - sin * x),
                (u * z - sin * y, v * z + sin * x, cos + w * z),
            )
        )
        return rotation if through is ORIGIN else cls(rotation.rows, minus(through, rotation.turned(through)))

    @property
    def motion(self) -> tuple[tuple[float, float, float, float], ...]:
        """The upper three rows of its homogeneous matrix."""
        (a, b, c), (d, e, f), (g, h, i) = self.rows
        x, y, z = self.offset
        return (a, b, c, x), (d, e, f, y), (g, h, i, z)

    def turned(self, vector: Vector) -> Vector:
        """A direction after the motion."""
        (a, b, c), (d, e, f), (g, h, i) = self.rows
        x, y, z = vector
        return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z

    def moved(self, point: Vector) -> Vector:
        """A point after the motion."""
        return plus(self.turned(point), self.offset)

    def column(self, index: int) -> Vector:
        """Where an axis of the reference points after the motion."""
        return self.rows[0][index], self.rows[1][index], self.rows[2][index]

    def __matmul__(self, other: Rigid) -> Rigid:
        """`motion.product` written out: it is most of what comparing robots costs."""
        (a, b, c), (d, e, f), (g, h, i) = other.rows
        (k, l, m), (n, o, p), (q, r, s) = self.rows  # noqa: E741  in alphabetical order
        return Rigid(
            (
                (k * a + l * d + m * g, k * b + l * e + m * h, k * c + l * f + m * i),
                (n * a + o * d + p * g, n * b + o * e + p * h, n * c + o * f + p * i),
                (q * a + r * d + s * g, q * b + r * e + s * h, q * c + r * f + s * i),
            ),
            self.moved(other.offset),
        )

    def then_turned(self, plane: tuple[int, int], cos: float, sin: float) -> Rigid:
        """The motion with a turn behind it, in its own frame.

        Args:
            plane: The two coordinates that the turn mixes, in the order of its positive sense.
            cos: Cosine of the angle.
            sin: Sine of the angle.
        """
        first, second = plane
        rows = [list(row) for row in self.rows]
        for row in rows:
            u, v = row[first], row[second]
            row[first], row[second] = u * cos + v * sin, v * cos - u * sin
        (a, b, c), (d, e, f), (g, h, i) = rows
        return Rigid(((a, b, c), (d, e, f), (g, h, i)), self.offset)

    def then_shifted(self, by: Vector) -> Rigid:
        """The motion with a translation behind it, in its own frame."""
        return Rigid(self.rows, self.moved(by))

    def inverse(self) -> Rigid:
        """The motion that undoes this one."""
        return Rigid.of(inverse(self.motion, dot))

    def angle_about(self, axis: Vector) -> float:
        """Angle of the rotation about a unit axis that comes nearest."""
        (_, b, c), (d, _, f), (g, h, _) = self.rows
        trace = self.rows[0][0] + self.rows[1][1] + self.rows[2][2]
        return math.atan2(dot(axis, (h - f, c - g, d - b)), trace - dot(axis, self.turned(axis)))

    def tilt(self) -> float:
        """How far the rotation is from none: the largest difference of a direction cosine."""
        return max(
            abs(x - y) for row, unit in zip(self.rows, UNITS, strict=True) for x, y in zip(row, unit, strict=True)
        )
