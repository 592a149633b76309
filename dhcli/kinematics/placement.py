"""A pose said in other ways: its position, and its orientation without a matrix."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, TypeAlias, cast

from dhcli.errors import RobotError, UnknownNameError, nearest
from dhcli.frozen import frozen
from dhcli.geometry.euler import AXES, ORDERS, EulerAngles, Order, RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.pose import Pose
from dhcli.notation.tree import Expr


@frozen
class Position:
    """Where the origin of a frame is.

    Attributes:
        coordinates: x, y and z in the reference [m].
    """

    coordinates: tuple[float, ...] | tuple[Expr, ...]


@frozen
class Matrix:
    """The homogeneous matrix itself.

    Attributes:
        rows: Entries, shape (4, 4); translation in metres.
    """

    rows: tuple[tuple[float, ...], ...] | tuple[tuple[Expr, ...], ...]


Orientation: TypeAlias = (
    type[RollPitchYaw[Any]] | type[AxisAngle[Any]] | type[Quaternion[Any]] | type[RotationVector[Any]] | Order
)
"""What makes one of these of a rotation, by its `of`."""

Placement: TypeAlias = (
    Matrix
    | Position
    | RollPitchYaw[float]
    | AxisAngle[float]
    | Quaternion[float]
    | RotationVector[float]
    | EulerAngles[float]
)

ORIENTATIONS: dict[str, Orientation] = {
    "rpy": RollPitchYaw,
    "axis-angle": AxisAngle,
    "quaternion": Quaternion,
    "rotation-vector": RotationVector,
    **{f"{'fixed-' * order.fixed}{order.axes}": order for order in ORDERS},
}
"""The ways to say an orientation without a matrix, by the names a user gives them."""

FORMS = (*ORIENTATIONS, "position", "matrix")
"""All ways to say where a frame is."""

LISTED = "rpy, axis-angle, quaternion, rotation-vector, position, matrix, zyz and all orders of axes, fixed-xyz"
"""The same for people."""


def placements(pose: Pose[float] | Pose[Expr], forms: Iterable[str]) -> dict[str, Placement]:
    """A pose said in each of several ways, which are names among `FORMS`.

    Raises:
        UnknownNameError: There is no such form.
        RobotError: An orientation in symbols is wanted.
    """
    said: dict[str, Placement] = {}
    for form in check_forms(forms):
        if pose.is_symbolic and form not in ("position", "matrix"):
            raise RobotError(
                f"{form} needs numbers, and this pose is symbolic", "give every value, or --as position,matrix"
            )
        said[form] = _placement(pose, form)
    return said


def check_forms(forms: Iterable[str]) -> Iterator[str]:
    """Forms, once it is sure of each that there is one.

    Raises:
        UnknownNameError: There is no such form.
    """
    for form in forms:
        if form not in FORMS:
            near = nearest(form, [known for known in FORMS if known[-3:] not in AXES])
            hint = f"did you mean {' or '.join(near)}?" if near else f"known: {LISTED}"
            raise UnknownNameError(f"there is no way to say a pose as {form}", hint)
        yield form


def _placement(pose: Pose[float] | Pose[Expr], form: str) -> Placement:
    if form == "matrix":
        return Matrix(pose.rows)
    if form == "position":
        return Position(pose.position)
    return ORIENTATIONS[form].of(cast("Pose[float]", pose).rotation)


def locked_warnings(said: Mapping[str, Placement]) -> tuple[str, ...]:
    """What a person should know of three angles of which only two can be told."""
    return tuple(
        locked_words(form)
        for form, placement in said.items()
        if isinstance(placement, RollPitchYaw | EulerAngles) and placement.locked
    )


def locked_words(form: str, where: str = "") -> str:
    """That of three angles only two can be told, and which was chosen.

    Args:
        form: The form of the orientation.
        where: In which rows, empty for the only one.
    """
    order = ORIENTATIONS[form]
    if not isinstance(order, Order):
        told = f"pitch is ±90°{where}, where roll and yaw turn about one axis"
        return f"{told}: only their sum or difference counts, roll is 0"
    middle = "0° or 180°" if order.is_proper else "±90°"
    which = "first" if order.fixed else "last"
    told = f"{form}: the middle angle is {middle}{where}, where the other two turn about one axis"
    return f"{told}: only their sum or difference counts, the {which} was chosen as 0"
