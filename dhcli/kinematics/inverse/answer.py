"""A question about a pose with its answer, as it is shown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.explained import Explanation
    from dhcli.kinematics.inverse.solutions import Solutions


@frozen
class InverseKinematics:
    """What is shown of a question and its answer.

    Attributes:
        robot: The robot.
        lengths: Values of lengths and constant angles.
        task: What of the pose counts.
        start: The frame it is seen from.
        end: The frame that is placed.
        solutions: The answer.
        pose: The pose as it was read, shape (4, 4) [m]; what the task does not count says nothing.
        near: Joint values that solutions should be near to, in joint order [rad, m]; or None.
        how: How the answer came about, where that is wanted.
    """

    robot: Robot
    lengths: Mapping[str, Value]
    task: str
    start: str
    end: str
    solutions: Solutions
    pose: tuple[tuple[float, ...], ...]
    near: tuple[float, ...] | None = None
    how: Explanation | None = None
