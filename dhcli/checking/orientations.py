"""What is wrong with an orientation in numbers: no rotation at all, transposed, or turned by so much about an axis."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

from dhcli.kinematics.entries import rounded

Matrix: TypeAlias = Sequence[Sequence[float]]

LEAST_SLACK = 4e-3
"""What is allowed where entries were typed exactly: four times the tolerance of an entry."""

BOTTOM_IN_PLANE = (0, 0, 1)
IN_PLANE = "this looks like a pose in the plane, the position in column 3: in space a pose is 4x4, a rotation 3x3"
"""What is said of the homogeneous matrices, shape (3, 3), of courses that stay in the plane."""

AXIS_KNOWN = 1e-2
"""Sine below which a turn has no axis to speak of, and how near to a coordinate axis it is called that."""


def not_orthonormal(rotation: Matrix, slack: float = LEAST_SLACK) -> str:
    """What keeps three columns from being a rotation, in words; empty if nothing does.

    Args:
        rotation: Direction cosines, shape (3, 3).
        slack: What rounded digits may add up to.
    """
    columns = list(zip(*rotation, strict=True))
    for i, column in enumerate(columns):
        length = math.sqrt(sum(x * x for x in column))
        if abs(length - 1) > slack and i == 2 and tuple(rotation[2]) == BOTTOM_IN_PLANE:  # noqa: PLR2004  the last
            return IN_PLANE
        if abs(length - 1) > slack:
            return f"this is no rotation: column {i + 1} has length {length:.4g}, not 1"
    for i in range(3):
        for j in range(i + 1, 3):
            dot = sum(a * b for a, b in zip(columns[i], columns[j], strict=True))
            if abs(dot) > slack:
                return f"this is no rotation: columns {i + 1} and {j + 1} are not perpendicular"
    (a, b, c), (d, e, f), (p, q, r) = rotation
    if a * (e * r - f * q) - b * (d * r - f * p) + c * (d * q - e * p) < 0:
        return "this is a reflection, not a rotation: the columns are left-handed"
    return ""


def angle_between(first: Matrix, second: Matrix) -> float:
    """The angle of the rotation that leads from one orientation to another [rad], from its sine and cosine."""
    turn = [[sum(first[k][i] * second[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    sine = math.hypot(turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1])
    return math.atan2(sine, turn[0][0] + turn[1][1] + turn[2][2] - 1)


def angle_of(first: Sequence[float], second: Sequence[float]) -> float:
    """The angle between two directions of length 1 [rad], from the lengths of their difference and their sum."""
    return 2 * math.atan2(math.dist(first, second), math.hypot(*(a + b for a, b in zip(first, second, strict=True))))


def turned(typed: Matrix, truth: Matrix) -> str:
    """By what angle, and about which axis of the reference, an orientation is off."""
    off = [[sum(typed[i][k] * truth[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    axis = (off[2][1] - off[1][2], off[0][2] - off[2][0], off[1][0] - off[0][1])
    size = math.hypot(*axis)
    words = f"the orientation is off by {math.degrees(angle_between(typed, truth)):.3g}°"
    if size < AXIS_KNOWN:
        return words
    for name, share in zip("xyz", axis, strict=True):
        if abs(share) > (1 - AXIS_KNOWN) * size:
            return f"{words} about {'+' if share > 0 else '-'}{name} of the reference"
    return f"{words} about the axis ({', '.join(rounded(share / size, 2) for share in axis)}) of the reference"


def transposed(matrix: Matrix) -> Matrix:
    """Rows for columns."""
    return [list(column) for column in zip(*matrix, strict=True)]


def near(first: Matrix, second: Matrix, limit: float = 2e-3) -> bool:
    """Whether no entry of two matrices differs by more than a limit."""
    return all(abs(a - b) <= limit for r, s in zip(first, second, strict=True) for a, b in zip(r, s, strict=True))


def is_inverse(typed: Matrix, right: Matrix) -> bool:
    """Whether the position of a pose, shape (4, 4), whose rotation is transposed is that of the inverse, too."""
    size = max(1e-9, *(abs(row[3]) for row in right[:3]))
    back = [sum(typed[i][k] * right[k][3] for k in range(3)) + typed[i][3] for i in range(3)]
    return all(abs(value) <= 1e-2 * size for value in back)
