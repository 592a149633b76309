"""A robot made ready for a question of inverse kinematics: its arm, the plan for the task, what is held."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.inverse.prepared import Prepared, prepare
from dhcli.kinematics.inverse.solutions import held_values, in_numbers
from dhcli.kinematics.inverse.tasks import TaskName, task_called
from dhcli.kinematics.inverse.trying import CONFIRMED
from dhcli.kinematics.inverse.turns import at_rest
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import JointInput, joint_values, numbers, parameter_values, require, size
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

_SAME = 1e-9
"""Joint values that differ by less are the same [rad, m]."""


@frozen
class Question:
    """A robot made ready for a question.

    Attributes:
        robot: The robot.
        ready: Its arm and plan.
        order: For each joint of the arm its number among the robot's variables.
        near: Joint values that solutions should be near to, or None.
        standing: Joint values, by name, that the pose was given by.
    """

    robot: Robot
    ready: Prepared
    order: tuple[int, ...]
    near: Array | None
    standing: Mapping[str, float] = field(default_factory=dict)

    def motions(self, q: Array) -> Array:
        """Motions of the arm's joints for joint values (..., n) of the robot."""
        return np.asarray(q[..., list(self.order)] * self.ready.arm.factors)

    def values(self, motions: Array) -> Array:
        """Joint values (..., n) of the robot; a joint outside the frames asked for stands at 0, or near."""
        q = np.zeros((*motions.shape[:-1], len(self.robot.variables)))
        if self.near is not None:
            q += self.near
        q[..., list(self.order)] = motions / self.ready.arm.factors
        return q

    def best(self, spare: Sequence[int] = ()) -> Array:
        """Where a joint that may be chosen should best stand, as a motion: near, else 0 or the middle of its limits.

        Args:
            spare: Joints that the task leaves over; they best stand as in the joint values that the pose was given by.
        """
        result = self._wished()
        for j in spare:
            at = self.standing.get(self.robot.variables[self.order[j]])
            result[j] = result[j] if at is None else at * self.ready.arm.factors[j]
        return result

    def _wished(self) -> Array:
        if self.near is not None:
            return self.motions(self.near)
        return self.motions(at_rest(self.robot))


def stands(q: Mapping[str, float], names: Sequence[str], standing: Mapping[str, float]) -> str:
    """What is said of joints that are held where they stand in the joint values that a pose was given by."""
    same = all(name in standing and abs(q[name] - standing[name]) < _SAME for name in names)
    return ", as in the joint values given" if same else ""


def ask(  # noqa: PLR0913  what may be asked of a robot
    robot: Robot,
    task: TaskName,
    *,
    near: JointInput = None,
    hold: Mapping[str, float | str | Angle] | None = None,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    tolerance: float = CONFIRMED,
) -> tuple[Question, dict[int, float]]:
    """Make a robot ready for a question.

    Returns:
        The question, and the motions of the joints that are to be held by their number.

    Raises:
        RobotError: A length has no value, the task cannot be computed, or the tolerance is no size of a residual.
        UnknownNameError: The robot has no such frame, joint or length, or there is no such task.
    """
    check_robot(robot)
    task_called(task)
    size(tolerance, "tolerance")
    from dhcli.kinematics.derived import in_floats

    chain = between(robot, *ends(robot, start, end))
    lengths = parameter_values(robot, parameters)
    require(robot, chain, {**lengths, **dict.fromkeys(robot.variables, Angle())})
    given = joint_values(robot, dict(held_values(hold)))
    known = tuple(sorted(numbers(lengths).items()))
    ready = prepare(chain, robot.variables, known, task, tuple(sorted(given, key=robot.variables.index)))
    names = [axis.name for axis in ready.arm.axes[: ready.arm.joints]]
    order = tuple(robot.variables.index(name) for name in names)
    factors = ready.arm.factors
    held = {names.index(n): in_floats(v) * float(factors[names.index(n)]) for n, v in given.items() if n in names}
    return Question(robot, ready, order, None if near is None else in_numbers(robot, near)), held
