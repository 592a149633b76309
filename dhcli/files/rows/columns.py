"""Which joint stands in which column, and in which unit: `theta1[deg], d3 [mm]`, in any order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import FileError, Place, Problem, RobotError
from dhcli.files.rows import INDEX, POSITION
from dhcli.files.rows.heads import factor_of, name_and_unit
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Joint, Robot
from dhcli.kinematics.values import joint_called

if TYPE_CHECKING:
    from numpy.typing import NDArray

MOST_COLUMNS = 1000
_ASIDE = "--ignore-columns leaves aside what is no joint"


@frozen
class JointColumns:
    """How a table holds the joint values of a robot.

    Attributes:
        joints: The joints of the robot.
        order: For each of them, its column; None for one that has none and stands still.
        factors: For each joint, what makes radians or metres of a number: a numerator and a denominator.
        width: How many columns there are, also of what is no joint.
        held: For each joint, where it stands if it has no column; radians or metres.
    """

    joints: tuple[str, ...]
    order: tuple[int | None, ...]
    factors: tuple[tuple[float, float], ...]
    width: int
    held: tuple[float, ...]

    @property
    def in_radians(self) -> tuple[bool, ...]:
        """Whether each joint's numbers are taken as they are."""
        return tuple(factor == (1.0, 1.0) for factor in self.factors)

    @property
    def names(self) -> dict[int, str]:
        """The joint of each column that is one's."""
        return {k: joint for k, joint in zip(self.order, self.joints, strict=True) if k is not None}

    def void(self, table: NDArray[np.float64]) -> tuple[Sequence[int], str]:
        """No row."""
        return (), ""

    def values(self, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Joint values in joint order, radians and metres.

        Args:
            table: Numbers as they stand in the columns, shape (N, width).
        """
        if self.order != tuple(range(self.width)):
            places = [self.width + joint if k is None else k for joint, k in enumerate(self.order)]
            still = np.broadcast_to(self.held, (len(table), len(self.held)))
            table = np.concatenate((table, still), axis=1)[:, places]
        if all(self.in_radians):
            return table
        numerators, denominators = np.array(self.factors).T
        values: NDArray[np.float64] = table * numerators / denominators
        return values


@frozen
class JointTable:
    """What a table is read for.

    Attributes:
        robot: The robot whose joint values it holds.
        degrees: Whether numbers of revolute joints without a unit are degrees; else they are radians.
        held: Where joints stand that have no column; radians and metres.
        ignores: Whether columns of something else are left aside; the numbers of rows, and the whole positions that
            `sweep` writes beside joint values, are in any case.
    """

    robot: Robot
    degrees: bool = False
    held: Mapping[str, float] = field(default_factory=dict)
    ignores: bool = False

    @property
    def open(self) -> tuple[Joint, ...]:
        """The joints that want a column."""
        return tuple(joint for joint in self.robot.joints if joint.name not in self.held)

    @property
    def wanted(self) -> tuple[str, ...]:
        """Their names."""
        return tuple(joint.name for joint in self.open)

    def in_order(self, width: int = 0, _: Place | None = None) -> JointColumns:
        """The columns of a table without a header: the joints in their order, and then what is left aside, if it is.

        Args:
            width: How many cells its rows have.
        """
        factors = {joint.name: self._factor(joint, "") for joint in self.open}
        found = {joint.name: k for k, joint in enumerate(self.open)}
        return self._columns(found, factors, max(width, len(found)) if self.ignores else len(found))

    def columns(self, heads: Sequence[str], places: Sequence[Place], whole: Place) -> JointColumns:
        """The columns of a table with a header.

        Args:
            heads: The head of each column: a name, and a unit in brackets if need be.
            places: Where each of them stands.
            whole: Where all of them stand, for what is missing.

        Raises:
            FileError: With every column that is unknown, doubled or missing.
        """
        if len(heads) > MOST_COLUMNS:
            raise FileError(Problem(f"{len(heads):,} columns are more than the {MOST_COLUMNS:,} that are read", whole))
        found, factors, problems = self._found(heads, places)
        if missing := [joint.name for joint in self.open if joint.name not in found]:
            hint = _wanted(self.robot)
            if problems and not found and all(problem.hint == _ASIDE for problem in problems):
                raise FileError(Problem(f"names no joint of {self.robot.name}", whole, hint))
            if len(missing) == 1 and not problems:
                hint += f"; --q {missing[0]}=0 if it stands still"
            problems.append(Problem(f"no column for {', '.join(missing)}", whole, hint))
        if problems:
            raise FileError(problems)
        return self._columns(found, factors, len(heads))

    def _found(
        self, heads: Sequence[str], places: Sequence[Place]
    ) -> tuple[dict[str, int], dict[str, tuple[float, float]], list[Problem]]:
        """The column of each joint and what makes radians or metres of it, and what is wrong with the others."""
        joints = {joint.name: joint for joint in self.robot.joints}
        found: dict[str, int] = {}
        factors: dict[str, tuple[float, float]] = {}
        problems: list[Problem] = []
        names = {head.strip() for head in heads}
        aside = names & {INDEX, *(POSITION if names.issuperset(POSITION) else ())}
        for k, (head, place) in enumerate(zip(heads, places, strict=True)):
            if (self.ignores or head.strip() in aside) and not self.is_known(head):
                continue
            try:
                name, unit = name_and_unit(head, place)
                joint = self._joint(name, place)
                if joint in found:
                    problems.append(Problem(f"{joint} has two columns", place, "keep one of them"))
                    continue
                if joint in self.held:
                    problems.append(Problem(f"{joint} has a column, and --q gives it too", place, "keep one of them"))
                found[joint] = k  # a column in the wrong unit is not missing
                factors[joint] = self._factor(joints[joint], unit, place)
            except RobotError as error:
                problems += error.problems
        return found, factors, problems

    def is_known(self, head: str) -> bool:
        """Whether the head of a column names a joint; with or without a unit."""
        try:
            return bool(self._joint(name_and_unit(head)[0], None))
        except RobotError:
            return False

    def _factor(self, joint: Joint, unit: str, place: Place | None = None) -> tuple[float, float]:
        """What makes radians or metres of the numbers of a joint."""
        turns = joint.kind == "revolute"
        return factor_of(joint.name, unit or ("deg" if turns and self.degrees else ""), place, turns=turns)

    def _joint(self, name: str, place: Place | None) -> str:
        """The joint that a head means; a spreadsheet may have made a capital of its first letter."""
        try:
            return joint_called(self.robot, name, place)
        except RobotError as error:
            try:
                return joint_called(self.robot, name.lower(), place)
            except RobotError:
                raise RobotError(replace(each, hint=_aside(each.hint)) for each in error.problems) from None

    def _columns(
        self, found: Mapping[str, int], factors: Mapping[str, tuple[float, float]], width: int
    ) -> JointColumns:
        names = self.robot.variables
        return JointColumns(
            names,
            tuple(found.get(name) for name in names),
            tuple(factors.get(name, (1.0, 1.0)) for name in names),
            width,
            tuple(self.held.get(name, 0.0) for name in names),
        )


def _aside(hint: str) -> str:
    """A hint for a column that is unknown: what it may be meant for, or how to go on without it."""
    return hint if hint.startswith("did") else _ASIDE


def _wanted(robot: Robot) -> str:
    """The columns there should be."""
    units = {"revolute": "rad", "prismatic": "m"}
    return "wanted: " + ", ".join(
        f"{robot.called.get(joint.name, joint.name)}[{units[joint.kind]}]" for joint in robot.joints
    )
