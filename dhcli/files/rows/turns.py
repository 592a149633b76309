"""The columns of a position and of an orientation beside it, as `fk --in --as position,quaternion` writes them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from dhcli.errors import FileError, Place, Problem, RobotError
from dhcli.files.rows import INDEX, POSITION
from dhcli.files.rows.columns import factor_of, name_and_unit
from dhcli.geometry.euler import EulerAngles, Order, RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.placement import ORIENTATIONS

if TYPE_CHECKING:
    from numpy.typing import NDArray

TURNS: Mapping[str, tuple[str, ...]] = {
    **{form: tuple(f"{form}_{k}" for k in (1, 2, 3)) for form in ORIENTATIONS},
    "rpy": ("roll", "pitch", "yaw"),
    "quaternion": ("q_w", "q_x", "q_y", "q_z"),
    "rotation-vector": ("r_x", "r_y", "r_z"),
    "axis-angle": ("axis_x", "axis_y", "axis_z", "angle"),
}
"""The columns of each way to say an orientation beside a position; angles in radians."""

LENGTHS = frozenset(POSITION)
ANGLES = frozenset(
    {"angle"}.union(*(heads for form, heads in TURNS.items() if form not in {"quaternion", "axis-angle"}))
)
"""What of a pose has a unit."""


def heads_of(cells: Sequence[str], place: Place) -> tuple[list[str], list[str]]:
    """Names and units of columns: `p_x[mm]`; a head that is not read so is the name of what nobody asks for."""
    heads, units = [], []
    for cell in cells:
        try:
            head, unit = name_and_unit(cell, place)
        except RobotError:
            head, unit = cell.strip(), ""
        heads.append(head.lower())
        units.append(unit)
    return heads, units


def factors_of(wanted: Sequence[str], units: Sequence[str], place: Place) -> NDArray[np.float64]:
    """What makes metres and radians of the numbers of a row, shape (2, n): what times they are, and then over what.

    Raises:
        FileError: A unit is none, or that of something else.
    """
    factors, problems = [], list[Problem]()
    for head, unit in zip(wanted, units, strict=True):
        if unit and head not in LENGTHS | ANGLES:
            problems.append(Problem(f"{head} has no unit, and not {unit}", place, f"write {head}"))
            continue
        try:
            factors.append(factor_of(head, unit, place, turns=head in ANGLES))
        except RobotError as error:
            problems += error.problems
    if problems:
        raise FileError(problems)
    return np.array(factors, dtype=np.float64).T


def check_alone(others: Sequence[str], place: Place) -> None:
    """Make sure that nothing beside a position says more of the pose.

    Raises:
        FileError: Something does, and it is not known what.
    """
    if unknown := [head for head in others if head not in (INDEX, "")]:
        known = f"an orientation is {','.join(TURNS['quaternion'])} or {','.join(TURNS['rpy'])} in radians"
        message = f"{', '.join(unknown)} beside a position: that says no orientation that is known"
        raise FileError(Problem(message, place, f"{known}; --task position leaves what else stands there aside"))


def posed(form: str, numbers: list[float], place: Place) -> list[float]:
    """A position and its orientation as the upper rows of a matrix; without an orientation the position alone.

    Raises:
        FileError: A quaternion or an axis has no direction.
    """
    if not form:
        return numbers
    position, turn = numbers[:3], numbers[3:]
    try:
        rows = _rotation(form, turn)
    except ZeroDivisionError:
        raise FileError(Problem(f"{', '.join(TURNS[form])} are all 0: that is no {form}", place)) from None
    return [entry for row, length in zip(rows, position, strict=True) for entry in (*row, length)]


def _rotation(form: str, turn: list[float]) -> Sequence[Sequence[float]]:
    if form == "rpy":
        roll, pitch, yaw = turn
        return RollPitchYaw(roll, pitch, yaw).rotation()
    if form == "rotation-vector":
        return RotationVector(*turn).rotation()
    if form == "quaternion":
        size = math.hypot(*turn)
        return Quaternion(*(part / size for part in turn)).rotation()
    if form == "axis-angle":
        size = math.hypot(*turn[:3])
        x, y, z = (part / size for part in turn[:3])
        return AxisAngle((x, y, z), turn[3]).rotation()
    a, b, c = turn
    return EulerAngles(cast("Order", ORIENTATIONS[form]), (a, b, c)).rotation()


def flat(value: object) -> list[object]:
    """The numbers of an orientation, nested as JSON has them: `{"axis": [x, y, z], "angle": t}` is four."""
    if isinstance(value, dict):
        value = [value[key] for key in ("w", "x", "y", "z", "roll", "pitch", "yaw", "axis", "angle") if key in value]
    return [one for part in value for one in flat(part)] if isinstance(value, list) else [value]
