"""Jacobians for many joint values, as rows of numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.velocity.form import Form
from dhcli.kinematics.velocity.jacobian import moving_joints
from dhcli.kinematics.velocity.many import jacobians
from dhcli.kinematics.velocity.view import MotionView

if TYPE_CHECKING:
    from numpy.typing import NDArray


@frozen
class JacobianRows:
    """What is wanted of each row of joint values.

    Attributes:
        robot: The robot.
        view: Of which frame and point, along which axes.
        form: Which rows a Jacobian has.
        parameters: Values of all lengths and constant angles that have one.
    """

    robot: Robot
    view: MotionView
    form: Form
    parameters: Mapping[str, Value]

    def __post_init__(self) -> None:
        """Refuse what cannot be computed for any row, before there are any.

        Raises:
            RobotError: Nothing moves, or a length has no value.
        """
        self.jacobians(np.empty((0, len(self.robot.variables))))

    @property
    def layout(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """What the rows and the columns are called."""
        return self.form.labels, moving_joints(self.robot, self.view)

    def jacobians(self, q: NDArray[np.float64], threads: int = 1) -> NDArray[np.float64]:
        """The Jacobians, shape (N, rows, joints), NaN where one is not real; threads share the work."""
        return jacobians(self.robot, q, self.view, self.form, self.parameters, threads=threads)
