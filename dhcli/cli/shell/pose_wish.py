"""What `dhcli ik --in` wants of each pose of a file, and which of its rows are poses."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from dhcli.cli.shell.options import workers
from dhcli.errors import Place, Problem, RobotError
from dhcli.files.reading import source_of
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName

_BYTES = 1 << 22
"""Bytes of a file that are worth one more process: some ten thousand poses."""


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
        jobs: How many share the work; by default as many as a file of its size is worth.
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
    jobs: int | None = None

    def workers(self, path: str) -> int:
        """How many share the poses of a file; of standard input nobody knows how many there are."""
        size = 0
        with suppress(OSError):  # told when it is opened
            size = Path(path).stat().st_size
        return workers(self.jobs, 1 + size // _BYTES)

    def blocks(self, path: str, bad: list[Problem] | None) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
        """The poses of a file, block by block, and where each stands; those that are none are noted, where they may be.

        Raises:
            FileError: The file cannot be read, or a row is no pose.
        """
        from dhcli.files.rows.poses import pose_blocks

        for poses, places in pose_blocks(path, bad, whole=self.task is None):
            yield (poses, places) if bad is None else rotations(poses, places, path, bad)

    def task_of(self, poses: NDArray[np.float64]) -> TaskName:
        """What of the poses of a file counts."""
        return self.task or ("pose" if poses.ndim == 3 else "position")  # noqa: PLR2004  matrices

    def solutions(self, poses: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Joint values for poses, and the number of the pose of each.

        Raises:
            RobotError: One is no pose, or nothing of the kind can be computed.
        """
        from dhcli.kinematics.inverse.batch import inverse_batch

        return inverse_batch(
            self.robot,
            poses,
            task=self.task_of(poses),
            each=self.each,
            near=self.near,
            hold=self.hold,
            within_limits=self.within_limits,
            start=self.start,
            end=self.end,
            parameters=self.lengths,
        )

    def said(self, poses: NDArray[np.float64]) -> str:
        """What a reader should know of their solutions, if anything."""
        from dhcli.kinematics.coupling import is_coupled

        if not is_coupled(self.robot):
            return ""
        from dhcli.kinematics.inverse.coupled import said_of_many  # few robots are

        seen = {"start": self.start, "end": self.end}
        return said_of_many(self.robot, task=self.task_of(poses), hold=self.hold, parameters=self.lengths, **seen)


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
