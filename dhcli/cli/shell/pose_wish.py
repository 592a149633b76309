"""What `dhcli ik --rows` wants of each pose of a file, and which of its rows are poses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from dhcli.cli.shell.options import workers
from dhcli.errors import Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.cli.shell.batch import BadRows
    from dhcli.files.rows.blocks import Block
    from dhcli.files.rows.source import Source
    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName

_NEARLY = "the arm takes no pose with exactly the digits of some rows; for those the nearest is taken"

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

    def workers(self, source: Source) -> int:
        """How many share the poses of a file; of standard input nobody knows how many there are."""
        return workers(self.jobs, 1 + (source.size or 0) // _BYTES)

    def poses(self, source: Source, bad: BadRows) -> Iterator[tuple[NDArray[np.float64], Sequence[int]]]:
        """The poses of a file, block by block, and where each stands.

        Raises:
            FileError: The file cannot be read, or a row is no pose and may not be left out.
        """
        from dhcli.files.rows.poses import pose_rows

        found = pose_rows(source, whole=self.task is None)
        for block in found.blocks():
            bad.take(block.bad, block.bad_rows)
            poses, rows, others = self._rotations(block, found.place_of)
            bad.take(others, len(others))
            if len(poses):
                yield poses, rows

    def _rotations(
        self, block: Block, place_of: Callable[[int], Place]
    ) -> tuple[NDArray[np.float64], Sequence[int], list[Problem]]:
        """The rows of a block that are poses, and what is wrong with the others."""
        from dhcli.kinematics.inverse.targets import read_targets
        from dhcli.kinematics.inverse.tasks import task_called

        poses, rows, task = block.values, block.rows, task_called(self.task_of(block.values))
        with suppress(RobotError):
            read_targets(poses, task)
            return poses, rows, []
        kept, problems = [], list[Problem]()
        for k, row in enumerate(rows):
            try:
                read_targets(poses[k], task)
            except RobotError as error:
                problems += [Problem(p.message, place_of(row), p.hint) for p in error.problems[:1]]
            else:
                kept.append(k)
        return poses[kept], [rows[k] for k in kept], problems

    def task_of(self, poses: NDArray[np.float64]) -> TaskName:
        """What of the poses of a file counts."""
        return self.task or ("pose" if poses.ndim == 3 else "position")  # noqa: PLR2004  matrices

    def solutions(self, poses: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64], str]:
        """Joint values for poses, the number of the pose of each, and what a reader should know of them, if anything.

        Raises:
            RobotError: One is no pose, or nothing of the kind can be computed.
        """
        from dhcli.kinematics.inverse.as_typed import batch_as_typed

        seen = {"start": self.start, "end": self.end, "parameters": self.lengths}
        asked: dict[str, Any] = {"near": self.near, "hold": self.hold, **seen}
        wish: dict[str, Any] = {"each": self.each, "within_limits": self.within_limits}
        q, index, is_nearly = batch_as_typed(self.robot, poses, self.task_of(poses), asked, wish)
        return q, index, "; ".join(filter(None, (_NEARLY if is_nearly else "", self.said(poses))))

    def said(self, poses: NDArray[np.float64]) -> str:
        """What a reader should know of their solutions, if anything."""
        from dhcli.kinematics.coupling import is_coupled

        if not is_coupled(self.robot):
            return ""
        from dhcli.kinematics.inverse.coupled import said_of_many  # few robots are

        seen = {"start": self.start, "end": self.end}
        return said_of_many(self.robot, task=self.task_of(poses), hold=self.hold, parameters=self.lengths, **seen)
