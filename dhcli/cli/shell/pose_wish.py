"""What `dhcli ik --in` wants of each pose of a file, and which of its rows are poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from dhcli.errors import Place, Problem, RobotError
from dhcli.files.reading import source_of
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName


@frozen
class PoseWish:
    """What is wanted of each pose.

    Attributes:
        robot: The robot.
        task: What of it counts; None for all that a row has.
        each: Which solutions.
        near: Joint values that they should be near to.
        hold: Joints that are not computed.
        within_limits: Whether only solutions inside the limits are wanted.
        start: The frame they are seen from.
        end: The frame that is placed.
        lengths: Values of lengths and constant angles.
    """

    robot: Robot
    task: TaskName | None
    each: Each
    near: Sequence[float] | None
    hold: Mapping[str, float]
    within_limits: bool
    start: str
    end: str
    lengths: Mapping[str, Value]


def rotations(
    poses: NDArray[np.float64], places: list[int], path: str, bad: list[Problem]
) -> tuple[NDArray[np.float64], list[int]]:
    """The rows of a block that are poses; the others are noted."""
    from dhcli.kinematics.inverse.targets import read_targets
    from dhcli.kinematics.inverse.tasks import task_called

    task = task_called("pose" if poses.ndim == 3 else "position")  # noqa: PLR2004  matrices
    kept = []
    for k in range(len(poses)):
        try:
            read_targets(poses[k], task)
        except RobotError as error:
            bad += [Problem(p.message, Place(source_of(path), places[k]), p.hint) for p in error.problems]
        else:
            kept.append(k)
    return poses[kept], [places[k] for k in kept]
