"""Which joint stands in which column, and in which unit: `theta1[deg], d3 [mm]`, in any order."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import FileError, Place, Problem, RobotError, did_you_mean
from dhcli.kinematics.robot import Joint, Robot
from dhcli.kinematics.values import joint_called
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS

if TYPE_CHECKING:
    from numpy.typing import NDArray

_HEAD = re.compile(r"\s*(?P<name>[^\[(]*?)\s*(?:[\[(]\s*(?P<unit>[^\])]*?)\s*[\])])?\s*")
_RADIANS = ("rad", "radian", "radians")


@dataclass(frozen=True, slots=True)
class Columns:
    """How a table holds the joint values of a robot.

    Attributes:
        order: For each joint, its column.
        factors: For each joint, what makes radians or metres of a number: a numerator and a denominator.
    """

    order: tuple[int, ...]
    factors: tuple[tuple[float, float], ...]

    @property
    def in_radians(self) -> tuple[bool, ...]:
        """Whether each joint's numbers are taken as they are."""
        return tuple(factor == (1.0, 1.0) for factor in self.factors)

    def values(self, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Joint values in joint order, radians and metres.

        Args:
            table: Numbers as they stand in the columns, shape (N, n).
        """
        if self.order != tuple(range(len(self.order))):
            table = table[:, self.order]
        if all(self.in_radians):
            return table
        numerators, denominators = np.array(self.factors).T
        values: NDArray[np.float64] = table * numerators / denominators
        return values


def in_joint_order(robot: Robot, *, degrees: bool) -> Columns:
    """The columns of a table without a header."""
    return Columns(
        tuple(range(len(robot.joints))), tuple(_factor(joint, "", degrees=degrees) for joint in robot.joints)
    )


def columns_of(robot: Robot, heads: Sequence[str], places: Iterable[Place], *, whole: Place, degrees: bool) -> Columns:
    """The columns of a table with a header.

    Args:
        robot: The robot.
        heads: The head of each column: a name, and a unit in brackets if need be.
        places: Where each of them stands.
        whole: Where all of them stand, for what is missing.
        degrees: Whether bare columns of revolute joints are in degrees; else they are in radians.

    Raises:
        FileError: With every column that is unknown, doubled or missing.
    """
    joints = {joint.name: joint for joint in robot.joints}
    found: dict[str, int] = {}
    factors: dict[str, tuple[float, float]] = {}
    problems: list[Problem] = []
    for k, (head, place) in enumerate(zip(heads, places, strict=True)):
        try:
            name, unit = _parts(head, place)
            joint = joint_called(robot, name, place)
            if joint in found:
                problems.append(Problem(f"{joint} has two columns", place, "keep one of them"))
                continue
            found[joint] = k  # a column in the wrong unit is not missing
            factors[joint] = _factor(joints[joint], unit, degrees=degrees, place=place)
        except RobotError as error:
            problems += error.problems
    if missing := [name for name in joints if name not in found]:
        problems.append(Problem(f"no column for {', '.join(missing)}", whole, _wanted(robot)))
    if problems:
        raise FileError(problems)
    return Columns(tuple(found[name] for name in joints), tuple(factors[name] for name in joints))


def _wanted(robot: Robot) -> str:
    """The columns there should be."""
    units = {"revolute": "rad", "prismatic": "m"}
    return "wanted: " + ", ".join(f"{joint.name}[{units[joint.kind]}]" for joint in robot.joints)


def _parts(head: str, place: Place) -> tuple[str, str]:
    """Name and unit of a head."""
    match = _HEAD.fullmatch(head)
    if match is None:
        raise RobotError(Problem(f"'{head.strip()}' is not read as a column", place, "write theta1 or theta1[deg]"))
    if not match["name"]:
        hint = "a column of row numbers? pandas leaves it out with index=False"
        raise RobotError(Problem("a column has no name", place, hint))
    return match["name"], match["unit"] or ""


def _factor(joint: Joint, unit: str, *, degrees: bool, place: Place | None = None) -> tuple[float, float]:
    """What makes radians or metres of a number in a unit; two numbers, because a thousandth is no float."""
    turns = joint.kind == "revolute"
    if not unit:
        unit = "m" if not turns else "deg" if degrees else "rad"
    if turns and unit in ANGLE_UNITS:
        return (1.0, 1.0) if unit in _RADIANS else (np.pi, 180.0)
    if not turns and unit in LENGTH_UNITS:
        return float(LENGTH_UNITS[unit].numerator), float(LENGTH_UNITS[unit].denominator)
    known = ("deg", "rad") if turns else tuple(LENGTH_UNITS)
    if unit in ANGLE_UNITS or unit in LENGTH_UNITS:
        kind = "length" if turns else "angle"
        message, hint = f"{unit} is a unit of {kind}, and {joint.name} {'turns' if turns else 'slides'}", ""
    else:
        message, hint = f"{unit} is no unit", did_you_mean(unit, known)
    raise RobotError(Problem(message, place, hint or f"write {joint.name}[{known[0]}]"))
