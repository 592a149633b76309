"""Inverse kinematics of arms whose variables share moves: solved with a variable for each move, and carried back."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.errors import RobotError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.coupling import uncoupled
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.inverse.joined import is_joined, joined
from dhcli.kinematics.inverse.solutions import Solutions, held_values, in_numbers, turning_joints
from dhcli.kinematics.inverse.turns import limits_of, outside, placed
from dhcli.kinematics.robot import Robot
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
    """

    robot: Robot
    arm: Robot
    slopes: Array
    offsets: Array

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
        return cls(robot, free.robot, np.array(slopes).reshape(len(slopes), len(robot.variables)), np.array(offsets))

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

    def there(self, q: JointInput) -> list[float] | None:
        """Values of the arm's variables for those of the robot's."""
        if q is None:
            return None
        return list((self.slopes @ in_numbers(self.robot, q) + self.offsets).tolist())

    def held(self, hold: Mapping[str, float | str | Angle] | None) -> dict[str, float | str | Angle]:
        """What is held of the arm where variables are held that make one move alone.

        Raises:
            RobotError: One makes none alone, or that is no mapping.
        """
        found: dict[str, float | str | Angle] = {}
        alone = self.alone
        for name, value in held_values(hold).items():
            if name not in self.robot.variables:
                found[name] = value  # a length, or nothing that is known: the arm says which
                continue
            if name not in alone:
                hint = f"it can be held: {', '.join(own for own in self.robot.variables if own in alone)}"
                hint = hint if alone else "leave it out"
                raise RobotError(f"{name} moves joints together with others, and is not held alone", hint)
            row = alone[name]
            given = in_floats(joint_values(self.robot, {name: value})[name])
            column = self.robot.variables.index(name)
            found[self.arm.variables[row]] = float(self.slopes[row, column] * given + self.offsets[row])
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
            gap = np.where(turning, gap - 2 * np.pi * np.round(gap / (2 * np.pi)), gap)
            if np.abs(gap).max(initial=0.0) < SAME:
                return np.asarray(q)
        return None


def through(solve: Callable[..., Solutions], carried: Carried, T: object, **asked: Any) -> Solutions:  # noqa: ANN401, N803
    """Solve for the arm with a variable for each move, and carry the solutions back.

    Args:
        solve: What solves for an arm whose variables each make one move; see `inverse`.
        carried: The robot and that arm.
        T: The pose.
        **asked: What else `inverse` takes.

    Raises:
        RobotError: As `inverse`; or a joint is held that moves with others, or the arm has more moves than the task
            determines, of which the coupling leaves some.
    """
    robot, near = carried.robot, asked["near"]
    ways = {"near": carried.there(near), "hold": carried.held(asked["hold"])}
    found = solve(carried.arm, T, **{**asked, **ways, "within_limits": False, "all_turns": False})
    if found.held and not carried.is_whole and not asked["hold"]:
        message = f"{plural(len(carried.slopes), 'move')} by {plural(len(robot.variables), 'variable')}"
        hint = "ask for more of the pose: --task pose, or all of T"
        raise RobotError(f"{message}: {robot.name} could reach this with its coupling broken in endless ways", hint)
    answer = _carried(carried, found)
    if not len(answer):
        return answer
    wish = None if near is None else in_numbers(robot, near)
    limits = {key: asked[key] for key in ("within_limits", "all_turns")}
    return placed(answer, wish, periodic=carried.periodic, **limits)


def through_many(
    solve: Callable[..., tuple[Array, NDArray[np.int64]]],
    carried: Carried,
    T: object,  # noqa: N803
    each: str,
    *,
    within_limits: bool,
    **asked: Any,  # noqa: ANN401
) -> tuple[Array, NDArray[np.int64]]:
    """The same for many poses; see `inverse_batch`."""
    robot, near = carried.robot, asked["near"]
    ways = {"near": carried.there(near), "hold": carried.held(asked["hold"])}
    values, index = solve(carried.arm, T, **{**asked, **ways}, each="all")
    rows = [(row, int(k)) for k, moves in zip(index, values, strict=True) if (row := carried.back(moves)) is not None]
    if within_limits:
        limits = limits_of(robot)
        rows = [(row, k) for row, k in rows if not outside(robot, row, limits)]
    if each != "all":
        wish = np.zeros(len(robot.variables)) if near is None else in_numbers(robot, near)
        rows.sort(key=lambda found: (found[1], float(np.linalg.norm(found[0] - wish))))
        rows = [found for n, found in enumerate(rows) if not n or rows[n - 1][1] != found[1]]
    q = np.array([row for row, _ in rows]).reshape(-1, len(robot.variables))
    return q, np.array([k for _, k in rows], dtype=np.int64)


def _carried(carried: Carried, found: Solutions) -> Solutions:
    """The solutions in the robot's variables, less those that its coupling does not allow."""
    rows = [carried.back(values) for values in found.q]
    kept = [k for k, row in enumerate(rows) if row is not None]
    q = np.array([rows[k] for k in kept]).reshape(-1, len(carried.robot.variables))
    nothing = len(found) > 0 and not kept
    why = (
        f"the arm would reach it if each of its {len(carried.slopes)} moves had a drive of its own"
        if nothing
        else found.why
    )
    closest = carried.back(found.closest) if found.closest is not None and carried.is_whole else None
    residual = None if found.residual is None else found.residual[kept]
    own = frozenset(carried.robot.variables)
    free = [found.free[k] if found.free else () for k in kept]
    if not carried.is_whole:
        free = [tuple(way for way in ways if own.issuperset(way.joints)) for ways in free]
    return replace(
        found,
        robot=carried.robot,
        q=q,
        held=carried.own(found.held),
        branches=tuple(found.branches[k] for k in kept),
        residual=residual,
        beyond=((),) * len(kept),
        free=tuple(free),
        reachable=found.reachable and not nothing,
        why=why,
        closest=closest,
    )


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
