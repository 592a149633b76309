"""Rotations by three turns about coordinate axes: 12 orders about the current axes, 12 about the fixed ones.

Each is one class for one rotation, whose angles are floats, and for many, whose angles are columns, shape (N,).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Generic, Literal, TypeAlias, cast

from dhcli.errors import UnknownNameError
from dhcli.frozen import frozen
from dhcli.geometry.motion import identity, rotate
from dhcli.geometry.reals import R, reals_of

if TYPE_CHECKING:
    from dhcli.geometry.motion import Rows
    from dhcli.geometry.reals import Mask
    from dhcli.geometry.rotations import Rotation

SINGULAR = 1e-13
"""Below this the sine (of two different axes the cosine) of the middle angle counts as zero: roundings of a product.

Nearer to it only the sum or the difference of the other two can be told. Before it both are as exact as their matrix
lets them be, which may be little; but the second follows from the first, so that the three give the matrix back.
"""

AXES = ("xyx", "xyz", "xzx", "xzy", "yxy", "yxz", "yzx", "yzy", "zxy", "zxz", "zyx", "zyz")
"""Every order of three axes of which no two that are neighbours are the same."""

Side: TypeAlias = Literal["left", "right"]


@frozen
class Order:
    """About which axes one turns, in which order.

    Attributes:
        axes: The axes, such as `zyz`.
        fixed: Whether they stay where they are; else each turn carries the axes of those after it along.
    """

    axes: str
    fixed: bool = False

    @property
    def is_proper(self) -> bool:
        """Whether the first axis is the last one too: Euler angles in the narrow sense."""
        return self.axes[0] == self.axes[2]

    @property
    def product(self) -> str:
        """The axes as the rotations are multiplied, from left to right: about fixed axes the last one stands first."""
        return self.axes[::-1] if self.fixed else self.axes

    def of(self, rotation: Rotation[R], free: Side = "right") -> EulerAngles[R]:
        """The angles of a rotation; of two triples the one whose middle angle is in [-90°, 90°], or in [0°, 180°].

        Args:
            rotation: Direction cosines, shape (3, 3).
            free: Which turn of the product is none where only the sum or the difference of the outer two counts.
        """
        i, j, k, sign = _frame(self.product)
        r = rotation
        over = reals_of(r[0][0])
        if self.is_proper:  # R_i(a) R_j(b) R_i(c): column i holds a and b
            up, along = r[j][i], -sign * r[k][i]
            reach = over.hypot(up, along)
            middle = over.atan2(reach, r[i][i])
        else:  # R_i(a) R_j(b) R_k(c): column k holds a and b
            up, along = -sign * r[j][k], r[k][k]
            reach = over.hypot(up, along)
            middle = over.atan2(sign * r[i][k], reach)
        locked = reach < SINGULAR
        size = over.where(locked, 1.0, reach)
        sin, cos = over.where(locked, 0.0, up / size), over.where(locked, 1.0, along / size)
        left = over.where(locked, 0.0, over.atan2(up, along))
        # Row j of R_i(a)^T R is that of the last turn, whatever a is: what a has too much, c has too little.
        first, second, third = (cos * r[j][m] + sign * sin * r[k][m] for m in (i, j, k))
        right = over.atan2(-sign * third if self.is_proper else sign * first, second)
        if free == "right":
            left = over.where(locked, over.atan2(sign * r[k][j], r[j][j]), left)
            right = over.where(locked, 0.0, right)
        a, c = (over.where(angle <= -math.pi, math.pi, angle) + 0.0 for angle in (left, right))  # nor minus zero
        b = middle + 0.0
        return EulerAngles(self, (c, b, a) if self.fixed else (a, b, c), locked)

    def __str__(self) -> str:
        """`zyz`, or `xyz about fixed axes`."""
        return f"{self.axes} about fixed axes" if self.fixed else self.axes


ORDERS = tuple(Order(axes, fixed) for fixed in (False, True) for axes in AXES)


def euler(axes: str, *, fixed: bool = False) -> Order:
    """An order of three turns by its axes.

    >>> euler("zyz").of(((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))).degrees
    (-90.0, 90.0, 180.0)

    Args:
        axes: Three of x, y and z, such as `zyz`; no axis twice in a row.
        fixed: Whether the axes stay where they are.

    Raises:
        UnknownNameError: There is no such order.
    """
    order = Order(axes.strip().lower(), fixed)
    if order not in ORDERS:
        raise UnknownNameError(f"there is no order {axes} of three axes", "orders: " + ", ".join(AXES))
    return order


@frozen
class EulerAngles(Generic[R]):
    """Three turns.

    Attributes:
        order: About which axes.
        angles: By how much, in the order of the axes [rad].
        locked: Whether only the sum or the difference of the outer two counts, so that one of them was chosen as 0.
    """

    order: Order
    angles: tuple[R, R, R]
    locked: Mask = False

    @property
    def numbers(self) -> tuple[R, ...]:
        """The angles."""
        return self.angles

    @property
    def degrees(self) -> tuple[R, ...]:
        """The angles in degrees."""
        return tuple(angle * (180 / math.pi) for angle in self.angles)

    @property
    def other(self) -> EulerAngles[R]:
        """The other triple that is the same rotation, its outer angles half a turn further."""
        a, b, c = self.angles
        over = reals_of(a)
        back = -b if self.order.is_proper else over.where(b < 0, -math.pi, math.pi) - b
        turned = [over.where(angle > 0, angle - math.pi, angle + math.pi) for angle in (a, c)]
        return EulerAngles(self.order, (turned[0], back, turned[1]), self.locked)

    def rotation(self) -> Rotation[R]:
        """The matrix."""
        over = reals_of(self.angles[0])
        rows: Rows[R] = identity()
        turns = list(zip(self.order.axes, self.angles, strict=True))
        for axis, angle in turns if self.order.fixed else reversed(turns):
            k = "xyz".index(axis)
            rotate(rows, ((k + 1) % 3, (k + 2) % 3), over.cos(angle), over.sin(angle))
        return cast("Rotation[R]", [row[:3] for row in rows])  # three turns leave no entry structural


@frozen
class RollPitchYaw(Generic[R]):
    """R = Rz(yaw) Ry(pitch) Rx(roll) [rad], pitch in [-π/2, π/2].

    Attributes:
        roll: About x.
        pitch: About y.
        yaw: About z.
        locked: Whether pitch is ±90°, where only one of roll and yaw can be told; roll is then 0.
    """

    roll: R
    pitch: R
    yaw: R
    locked: Mask = False

    @classmethod
    def of(cls, rotation: Rotation[R]) -> RollPitchYaw[R]:
        """Of a matrix, about the fixed axes x, y, z of the reference, in this order.

        Source: Craig, eqs. 2.64 to 2.68; roll follows from yaw.
        """
        found = _RPY.of(rotation)
        return cls(*found.angles, found.locked)

    @property
    def numbers(self) -> tuple[R, ...]:
        """Roll, pitch, yaw."""
        return self.roll, self.pitch, self.yaw

    def rotation(self) -> Rotation[R]:
        """The matrix."""
        return EulerAngles(_RPY, (self.roll, self.pitch, self.yaw)).rotation()


_RPY = Order("xyz", fixed=True)


def _frame(product: str) -> tuple[int, int, int, int]:
    """The axes of the first two turns, the third axis, and whether the three are right-handed, 1 or -1."""
    i, j = ("xyz".index(axis) for axis in product[:2])
    return i, j, 3 - i - j, 1 if (j - i) % 3 == 1 else -1
