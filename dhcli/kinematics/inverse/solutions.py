"""What inverse kinematics answers: the solutions with their names, and what else a reader should know."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import nearest_turn
from dhcli.kinematics.limits import far_limits
from dhcli.kinematics.robot import Robot, Value, check_robot
from dhcli.kinematics.values import JointInput, joint_values

if TYPE_CHECKING:
    from numpy.typing import DTypeLike, NDArray

    from dhcli.kinematics.inverse.arm import Array
    from dhcli.kinematics.inverse.prepared import Prepared


@frozen
class Free:
    """A way in which the arm can move at a solution without moving its end.

    Attributes:
        joint: The joint that may be chosen.
        joints: All joints that move.
        relation: What stays the same, in words, such as `theta4 + theta6 = 30°, any theta4`.
    """

    joint: str
    joints: tuple[str, ...]
    relation: str


@frozen
class Beyond:
    """A joint outside its limits.

    Attributes:
        joint: The joint.
        by: By how much [rad or m], positive above the upper limit.
    """

    joint: str
    by: float


@frozen
class Solutions:
    """Every joint vector that reaches a pose.

    An array to numpy: `np.asarray(solutions)` has the shape (K, n), and so have indices and slices.

    Attributes:
        robot: The robot.
        task: What of the pose was asked for.
        q: Joint values, shape (K, n), in joint order; radians and metres.
        branches: A name for each, such as `shoulder left, elbow up, wrist flip`.
        residual: How far each is from the pose, in reaches and direction cosines, shape (K,).
        beyond: For each the joints outside their limits.
        free: For each the ways to move without moving the end; a solution that has any stands for a family.
        held: Values of joints that were held, and not computed.
        reachable: Whether the robot reaches the pose at all, limits aside.
        why: Why it does not, or why nothing is left; empty where there is a solution.
        closest: Joint values that come nearest to the pose where nothing reaches it, shape (n,); else None.
        remarks: What else a reader should know.
        factors: What the number of solutions is a product of, as names and counts, such as (`theta1`, 2); empty where
            it is none.
        left_out: Solutions outside the limits that were not wanted.
        ready: The arm with its plan.
        shared: Of an arm whose variables share moves, what those of the plan are that are none of the robot's.
    """

    robot: Robot
    task: str
    q: Array
    branches: tuple[str, ...] = ()
    residual: Array | None = None
    beyond: tuple[tuple[Beyond, ...], ...] = ()
    free: tuple[tuple[Free, ...], ...] = ()
    held: tuple[tuple[str, float], ...] = ()
    reachable: bool = True
    why: str = ""
    closest: Array | None = None
    remarks: tuple[str, ...] = ()
    factors: tuple[tuple[str, int], ...] = ()
    left_out: Solutions | None = None
    ready: Prepared | None = None
    shared: Mapping[str, Value] = field(default_factory=dict)

    __eq__ = object.__eq__  # each equals itself only
    __hash__ = object.__hash__

    def __len__(self) -> int:
        return len(self.q)

    def __iter__(self) -> Iterator[Array]:
        return iter(self.q)

    def __getitem__(self, at: Any) -> NDArray[np.float64]:  # noqa: ANN401  whatever numpy takes
        return np.asarray(self.q[at])

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:  # noqa: FBT001
        """Let numpy read the joint values as an array of the shape (K, n)."""
        return np.array(self.q, dtype=dtype)

    def take(self, at: Sequence[int]) -> Solutions:
        """Some of them."""
        whole = self.factors if len(at) == len(self) else ()
        return replace(
            self,
            q=self.q[list(at)],
            branches=tuple(self.branches[k] for k in at),
            residual=None if self.residual is None else self.residual[list(at)],
            beyond=tuple(self.beyond[k] for k in at),
            free=tuple(self.free[k] for k in at),
            factors=whole,
        )

    @property
    def within_limits(self) -> NDArray[np.bool_]:
        """Which of them keep the limits of the joints, shape (K,)."""
        return np.array([not outside for outside in self.beyond], dtype=bool)

    def named(self, k: int, *, limits: bool) -> str:
        """What tells a solution from the others: its branch and, where limits count, by how much it is outside them."""
        outside = self._outside(k) if limits else ""
        return "; ".join(filter(None, (self.branches[k], outside and f"outside the limits: {outside}")))

    def distances(self, q: JointInput) -> Array:
        """How far each is from some joint values: the root of the sum of squares [rad, m], angles modulo a turn."""
        gap = self.q - in_numbers(self.robot, q)
        turning = turning_joints(self.robot)
        gap = nearest_turn(turning, gap)
        return np.asarray(np.sqrt((gap**2).sum(axis=1)))

    def travels(self, q: JointInput) -> Array:
        """How far the joints have to move from some joint values to each as it stands, turns and all [rad, m]."""
        return np.asarray(np.linalg.norm(self.q - in_numbers(self.robot, q), axis=1))

    def nearest(self, q: JointInput) -> Array:
        """The solution nearest to some joint values, shape (n,).

        Raises:
            RobotError: There is no solution.
        """
        if not len(self):
            raise RobotError(f"no solution: {self.why}")
        return np.asarray(self.q[int(np.argmin(self.distances(q)))])

    def __repr__(self) -> str:
        """A table: the number, the joint values, the branch, the limits."""
        if not len(self):
            return f"no solution: {self.why}"
        heads = ["#", *self.robot.variables, "branch", "limits"]
        rows = [[str(k + 1), *self._shown(k), self.branches[k], self._outside(k) or "ok"] for k in range(len(self))]
        widths = [max(len(line[i]) for line in (heads, *rows)) for i in range(len(heads))]
        numeric = len(self.robot.variables) + 1
        lines = []
        for line in (heads, *rows):
            cells = [
                c.rjust(w) if i < numeric else c.ljust(w) for i, (c, w) in enumerate(zip(line, widths, strict=True))
            ]
            lines.append("  ".join(cells).rstrip())
        told = dict.fromkeys(way.relation for ways in self.free for way in ways)
        return "\n".join((*lines, *told, *self.remarks))

    def _repr_latex_(self) -> str:
        """The joint values as an array, angles in degrees."""
        body = r" \\ ".join(
            " & ".join(cell.replace("°", r"^\circ") for cell in self._shown(k)) for k in range(len(self))
        )
        return rf"$\begin{{array}}{{{'r' * len(self.robot.variables)}}} {body} \end{{array}}$"

    def _shown(self, k: int) -> list[str]:
        turning = turning_joints(self.robot)
        return [
            f"{round(float(np.degrees(x)), 4) + 0.0:g}°" if turns else f"{round(float(x), 6) + 0.0:g}"
            for x, turns in zip(self.q[k], turning, strict=True)
        ]

    def _outside(self, k: int) -> str:
        return ", ".join(shown_beyond(self.robot, outside) for outside in self.beyond[k])


def shown_beyond(robot: Robot, outside: Beyond) -> str:
    """A joint outside its limits in words, such as `theta2 12° above`."""
    far = far_limits(robot)
    turning = {joint.name for joint in robot.joints if joint.kind == "revolute"} | (far.turning if far else set())
    size = abs(outside.by)
    shown = f"{np.degrees(size):.4g}°" if outside.joint in turning else f"{size:.4g} m"
    return f"{outside.joint} {shown} {'above' if outside.by > 0 else 'below'}"


def shown_value(robot: Robot, joint: int, value: float) -> str:
    """A joint value as `theta7 = 45°`."""
    shown = f"{round(float(np.degrees(value)), 4) + 0.0:g}°" if turning_joints(robot)[joint] else f"{value + 0.0:.6g} m"
    return f"{robot.variables[joint]} = {shown}"


def turning_joints(robot: Robot) -> NDArray[np.bool_]:
    """Which joints of a robot turn, shape (n,)."""
    kinds = {joint.name: joint.kind for joint in robot.joints}
    return np.array([kinds[name] == "revolute" for name in robot.variables], dtype=bool)


def held_values(hold: object) -> Mapping[str, Any]:
    """What is held, by name.

    Raises:
        RobotError: That is no mapping.
    """
    if hold is None:
        return {}
    if not isinstance(hold, Mapping):
        raise RobotError(f"hold says what a joint is held at, by its name, and {hold!r:.60} does not", HOLD)
    return hold


HOLD = "{'theta1': '30°'}"
"""How a joint is held."""


def in_numbers(robot: Robot, q: JointInput) -> Array:
    """Joint values in radians and metres, from whatever `forward` takes.

    >>> from dhcli import in_numbers, load_robot
    >>> in_numbers(load_robot("ur5e"), "up").round(4).tolist()
    [0.0, -1.5708, 0.0, -1.5708, 0.0, 0.0]

    Args:
        robot: The robot.
        q: The name of a pose, text with units, a mapping by name, or numbers.

    Returns:
        One for each variable of the robot, shape (n,) [rad, or m of a slide].

    Raises:
        RobotError: They are no joint values of this robot.
    """
    from dhcli.kinematics.derived import in_floats

    check_robot(robot)
    values = joint_values(robot, q)
    if missing := [name for name in robot.variables if name not in values]:
        raise RobotError(f"no value for {', '.join(missing)}", "give a value for each joint")
    return np.array([in_floats(values[name]) for name in robot.variables])


def relation(names: tuple[str, ...], turning: NDArray[np.bool_], q: Array, rates: dict[int, float], at: int) -> str:
    """What stays the same while the arm moves at constant rates, in words."""
    others = [j for j in rates if j != at]
    parts = []
    for j in others:
        if not turning[j] or not turning[at] or abs(rates[j]) != 1:
            return f"{', '.join(names[k] for k in sorted(rates))} move together, any {names[at]}"
        sign = "-" if rates[j] > 0 else "+"
        total = q[at] - q[j] if rates[j] > 0 else q[at] + q[j]
        degrees = float(np.degrees(total - 2 * np.pi * np.round(total / (2 * np.pi))))
        parts.append(f"{names[at]} {sign} {names[j]} = {round(degrees, 4) + 0.0:g}°")
    return ", ".join((*parts, f"any {names[at]}"))
