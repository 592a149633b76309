"""An arm whose variables share moves, and the same with a variable for each move that is not one with another."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.coupling import uncoupled
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.inverse.arm import Axis, axis_of_move, nearest_turn, parallel, same_axis
from dhcli.kinematics.inverse.branches import Told
from dhcli.kinematics.inverse.solutions import held_values, in_numbers, turning_joints
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import JointInput, joint_values, numbers, parameter_values, require
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.arm import Array

SAME = 1e-6
"""Moves that differ by less than this from what the variables give are those that they give [rad, m]."""


@frozen
class Carried:
    """A robot whose variables share moves, and the arm with one for each.

    Attributes:
        robot: The robot.
        arm: The arm.
        slopes: How fast the arm's variables go with the robot's, shape (m, n).
        offsets: Where the arm's variables stand when the robot's are 0, shape (m,).
        shared: What those of the arm's variables are that the robot has not got, as formulas.
    """

    robot: Robot
    arm: Robot
    slopes: Array
    offsets: Array
    shared: Mapping[str, Value]

    @classmethod
    def of(
        cls, robot: Robot, parameters: Given | None, start: str | int | None, end: str | int | None
    ) -> Carried | None:
        """The arm for the values of lengths; None where each variable makes one motion between the frames.

        Raises:
            RobotError: A variable stands in a matrix, or a length has no value.
            UnknownNameError: The robot has no such frame or length.
        """
        chain = between(robot, *ends(robot, start, end))
        lengths = parameter_values(robot, parameters)
        require(robot, chain, {**lengths, **dict.fromkeys(robot.variables, Angle())})
        values = numbers(lengths)
        if robot.drives is None and is_joined(chain, robot.variables, values):
            return None
        free = uncoupled(robot, joined=frozenset() if robot.drives else joined(chain, robot.variables, values))
        slopes, offsets = free.linear(values)
        table = np.array(slopes).reshape(len(slopes), len(robot.variables))
        return cls(robot, free.robot, table, np.array(offsets), free.shared)

    @property
    def is_whole(self) -> bool:
        """Whether the arm reaches no pose that the robot does not."""
        return len(self.slopes) == len(self.robot.variables)

    @property
    def periodic(self) -> NDArray[np.bool_]:
        """Which variables of the robot come to the same pose after a turn, shape (n,)."""
        turning = turning_joints(self.arm)
        whole = np.abs(self.slopes - np.round(self.slopes)) < SAME
        same = (np.where(turning[:, None], whole, self.slopes == 0)).all(axis=0)
        return np.asarray(turning_joints(self.robot) & same)

    @property
    def alone(self) -> dict[str, int]:
        """Variables that make one move alone, and the first move that each makes so."""
        rows = [(k, np.flatnonzero(row)) for k, row in enumerate(self.slopes)]
        return {self.robot.variables[int(one[0])]: k for k, one in reversed(rows) if len(one) == 1}

    def told(self, q: Array) -> Told:
        """The robot's variables as those to name its solutions by, for values of theirs (K, n)."""
        names, signs = self.robot.variables, {}
        for move, row in zip(self.arm.variables, self.slopes, strict=True):
            (by,) = np.nonzero(row)
            if len(by) == 1:
                signs[move] = (names[int(by[0])], 1 if row[by[0]] > 0 else -1)
        return Told(names, turning_joints(self.robot), q, signs)

    def own(self, held: Iterable[tuple[str, float]]) -> tuple[tuple[str, float], ...]:
        """What is held of the arm, in the robot's variables where those make that move alone."""
        names = {self.arm.variables[k]: (name, k) for name, k in self.alone.items()}
        found = []
        for move, value in held:
            name, k = names.get(move, (move, None))
            if k is not None:
                slope = self.slopes[k, self.robot.variables.index(name)]
                value = float((value - self.offsets[k]) / slope)  # noqa: PLW2901
            found.append((name, value))
        return tuple(found)

    def nearly(self, values: Array) -> Array:
        """Values of the robot's variables whose moves are nearest to those of the arm's, shape (K, n)."""
        return np.asarray((values - self.offsets) @ np.linalg.pinv(self.slopes).T)

    def there(self, q: JointInput) -> list[float] | None:
        """Values of the arm's variables for those of the robot's."""
        if q is None:
            return None
        return list((self.slopes @ in_numbers(self.robot, q) + self.offsets).tolist())

    def held(self, hold: Mapping[str, float | str | Angle] | None) -> dict[str, float | str | Angle]:
        """What is held of the arm where variables are held: the moves that no other variables make.

        Raises:
            RobotError: That is no mapping.
        """
        given = held_values(hold)
        found = {name: value for name, value in given.items() if name not in self.robot.variables}  # the arm says which
        own = joint_values(self.robot, {name: value for name, value in given.items() if name not in found})
        q = np.array([in_floats(own[name]) if name in own else np.nan for name in self.robot.variables])
        for name, row, offset in zip(self.arm.variables, self.slopes, self.offsets.tolist(), strict=True):
            moving = row != 0
            if moving.any() and not np.isnan(q[moving]).any():
                found[name] = float(row[moving] @ q[moving]) + offset
        return found

    def back(self, values: Array) -> Array | None:
        """Values of the robot's variables for those of the arm's, None where the coupling does not let them be."""
        goal = values - self.offsets
        turning = turning_joints(self.arm)
        rows = _independent(self.slopes)
        part = self.slopes[rows]
        for turns in _turns(turning[rows], whole=bool(self.periodic.all())):
            q = np.linalg.solve(part, goal[rows] + turns)
            gap = self.slopes @ q - goal
            gap = nearest_turn(turning, gap)
            if np.abs(gap).max(initial=0.0) < SAME:
                return np.asarray(q)
        return None


def _independent(slopes: Array) -> list[int]:
    """Rows by which all variables are determined, the first that do."""
    rows = list[int]()
    for k in range(len(slopes)):
        if np.linalg.matrix_rank(slopes[[*rows, k]]) > len(rows):
            rows.append(k)
    if len(rows) < slopes.shape[1]:
        raise RobotError("some variables move nothing by themselves", "leave out those that others make up for")
    return rows


def _turns(turning: NDArray[np.bool_], *, whole: bool) -> Iterator[Array]:
    """Turns to add to moves; where ratios are whole numbers, one is as good as another."""
    yield np.zeros(len(turning))
    if not whole:
        for turns in product(*((0, 1, -1) if turns else (0,) for turns in turning)):
            yield 2 * np.pi * np.array(turns, dtype=float)


def is_joined(chain: Chain, variables: tuple[str, ...], values: Mapping[str, Angle | float]) -> bool:
    """Whether every move is made by one variable, and those by one variable are one motion."""
    together = joined(chain, variables, values)
    seen = set[str]()
    for move in chain:
        inside = names((move,)).intersection(variables)
        if len(inside) > 1 or inside & seen - together:
            return False
        seen |= inside
    return True


def joined(chain: Chain, variables: tuple[str, ...], values: Mapping[str, Angle | float]) -> frozenset[str]:
    """The variables that make several moves which are one motion, because nothing that moves between them minds.

    A slide commutes with every other slide and with a turn about its own direction; a turn with whatever goes along
    or about its own axis.

    Args:
        chain: The moves from the start frame to the end frame.
        variables: The joint variables.
        values: Value of each length [m] and constant angle.

    Raises:
        RobotError: A variable stands in a matrix.
    """
    inside = [(k, sorted(names((move,)).intersection(variables))) for k, move in enumerate(chain)]
    moving = [(k, own) for k, own in inside if own]
    places = {name: [k for k, own in moving if name in own] for name in variables}
    alone = {name for name, at in places.items() if len(at) > 1 and all([name] == own for k, own in moving if k in at)}
    if not alone:
        return frozenset()
    still = {**values, **dict.fromkeys(variables, 0.0)}
    axes = {(k, name): axis_of_move(chain, name, k, still, moving[0][0]) for k, own in moving for name in own}
    found = set()
    for name in alone:
        first, last = places[name][0], places[name][-1]
        head = axes[first, name]
        others = [axis for (k, other), axis in axes.items() if first < k < last and other != name]
        if all(same_axis(head, axes[k, name]) for k in places[name]) and all(_commute(head, axis) for axis in others):
            found.add(name)
    return frozenset(found)


def _commute(one: Axis, other: Axis) -> bool:
    """Whether two motions come to the same in either order."""
    if not (one.turns or other.turns):
        return True
    if one.turns and other.turns:
        return same_axis(one, other)
    return parallel(one, other)
