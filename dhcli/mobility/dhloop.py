"""A closed loop given as rows of a DH table: its joints in space, and whether it closes at all."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.geometry.vectors import Vector
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.mobility.linkage import Joint
from dhcli.mobility.pairs import LinkageError, Pair
from dhcli.notation.angle import Angle

Matrix: TypeAlias = tuple[tuple[float, ...], ...]

CLOSED = 1e-7
"""Gap that rounding in a dozen digits may leave, relative to the size of the loop."""


def joints_of_loop(
    rows: Sequence[tuple[Row, Pair]],
    convention: Convention,
    values: Mapping[str, Angle | float],
    tolerance: float,
) -> tuple[Joint, ...]:
    """The joints of a loop in the position that its table gives.

    Args:
        rows: The table with the kind of each joint; all angles and lengths have values. The axis of joint i is z_{i-1}
            in the standard convention and z_i in the modified one.
        convention: Standard or modified.
        values: Values of the names in it.
        tolerance: Relative error of rounded values.

    Returns:
        One joint for each row, from `ground` over `1`, `2`, ... back to `ground`.

    Raises:
        LinkageError: The product of all rows is not the identity, so that the loop does not close.
    """
    over, modified = Floats(values), convention is Convention.MODIFIED
    links = ("ground", *map(str, range(1, len(rows))), "ground")
    joints = []
    frame = fold((), over)
    for i, (row, pair) in enumerate(rows):
        after = _times(frame, fold(moves_of(row, convention), over))
        axes = after if modified else frame
        joints.append(Joint(pair, (links[i], links[i + 1]), str(i + 1), _column(axes, 3), _column(axes, 2)))
        frame = after
    _check_closed(frame, [joint.point or (0.0, 0.0, 0.0) for joint in joints], tolerance)
    return tuple(joints)


def _times(left: Matrix, right: Matrix) -> Matrix:
    """The product of two homogeneous matrices; a loop of a thousand rows is multiplied once, frame by frame."""
    return tuple(tuple(sum(a * row[k] for a, row in zip(line, right, strict=True)) for k in range(4)) for line in left)


def _check_closed(whole: Matrix, points: Sequence[Vector], tolerance: float) -> None:
    gap = math.hypot(*_column(whole, 3))
    cosine = (whole[0][0] + whole[1][1] + whole[2][2] - 1) / 2
    sine = math.hypot(whole[2][1] - whole[1][2], whole[0][2] - whole[2][0], whole[1][0] - whole[0][1]) / 2
    turn = math.atan2(sine, cosine)
    size = max((math.dist(a, b) for a in points for b in points), default=0.0) or 1.0
    allowed = max(CLOSED, 10 * tolerance)  # each of some rows adds its own error
    if gap > allowed * size or turn > allowed:
        raise LinkageError(
            f"the loop does not close: the last frame is {gap:.3g} m and {math.degrees(turn):.3g}° away from the first",
            "check the angles theta of this position; for rounded values say --tol 0.001",
        )


def _column(frame: Matrix, column: int) -> Vector:
    return frame[0][column], frame[1][column], frame[2][column]
