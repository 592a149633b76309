"""A pose said in other ways: its position, and its orientation without a matrix."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias, cast

from dhcli.errors import RobotError, UnknownNameError, did_you_mean
from dhcli.geometry.euler import RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion
from dhcli.kinematics.pose import Pose
from dhcli.notation.tree import Expr


@dataclass(frozen=True, slots=True)
class Position:
    """Where the origin of a frame is.

    Attributes:
        coordinates: x, y and z in the reference [m].
    """

    coordinates: tuple[float, ...] | tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Matrix:
    """The homogeneous matrix itself.

    Attributes:
        rows: Entries, shape (4, 4); translation in metres.
    """

    rows: tuple[tuple[float, ...], ...] | tuple[tuple[Expr, ...], ...]


Orientation: TypeAlias = RollPitchYaw[Any] | AxisAngle[Any] | Quaternion[Any]
Placement: TypeAlias = Matrix | Position | RollPitchYaw[float] | AxisAngle[float] | Quaternion[float]

ORIENTATIONS: dict[str, type[Orientation]] = {"rpy": RollPitchYaw, "axis-angle": AxisAngle, "quaternion": Quaternion}
"""The ways to say an orientation without a matrix, by the names a user gives them."""

FORMS = (*ORIENTATIONS, "position", "matrix")
"""All ways to say where a frame is."""


def placements(pose: Pose[float] | Pose[Expr], forms: Iterable[str]) -> dict[str, Placement]:
    """A pose said in each of several ways.

    Args:
        pose: The pose.
        forms: Names among `FORMS`.

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
            hint = did_you_mean(form, FORMS)
            raise UnknownNameError(f"there is no way to say a pose as {form}", hint or "known: " + ", ".join(FORMS))
        yield form


def _placement(pose: Pose[float] | Pose[Expr], form: str) -> Placement:
    if form == "matrix":
        return Matrix(pose.rows)
    if form == "position":
        return Position(pose.position)
    return ORIENTATIONS[form].of(cast("Pose[float]", pose).rotation)


def locked_warnings(said: Mapping[str, Placement]) -> tuple[str, ...]:
    """What a person should know of an orientation at the pole of roll, pitch and yaw."""
    if any(isinstance(placement, RollPitchYaw) and placement.locked for placement in said.values()):
        return (
            "pitch is ±90°, where roll and yaw turn about one axis: only their sum or difference counts, roll is 0",
        )
    return ()
