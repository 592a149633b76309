"""Poses of one or more frames for many joint values, as rows of numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.euler import Order
from dhcli.geometry.many import rotations, table
from dhcli.kinematics.frames import View
from dhcli.kinematics.placement import ORIENTATIONS, check_forms
from dhcli.kinematics.playing import play
from dhcli.kinematics.recorded import Recording, recorded_pose
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import numbers, parameter_values

if TYPE_CHECKING:
    from numpy.typing import NDArray


@frozen
class PoseRows:
    """What is wanted of each row of joint values.

    Attributes:
        robot: The robot.
        views: Each pose in a row: which frame, seen from where; and a point followed instead of its origin.
        parameters: Values of all lengths and constant angles that have one.
        forms: The ways in which each pose is said, names of `placement.FORMS`.
        every: Whether they are all the frames on a way, were it only one.
    """

    robot: Robot
    views: tuple[View, ...]
    parameters: Mapping[str, Value]
    forms: tuple[str, ...] = ("matrix",)
    every: bool = False
    _made: tuple[tuple[Recording, list[float]], ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Refuse what cannot be computed for any row, before there are any; record the rest, once for all rows.

        Raises:
            RobotError: The robot has no joint, or a length has no value.
            UnknownNameError: There is no such form.
        """
        list(check_forms(self.forms))
        if not self.robot.variables:
            raise RobotError(f"{self.robot.name} has no joint, so all its poses are one", "leave --rows out")
        values = numbers(parameter_values(self.robot, self.parameters))
        floats = Floats(values)
        recordings = (recorded_pose(self.robot, view.reference, view.frame, values) for view in self.views)
        points = ([floats.value(length) for length in view.coordinates] for view in self.views)
        object.__setattr__(self, "_made", tuple(zip(recordings, points, strict=True)))

    def poses(self, q: NDArray[np.float64], threads: int = 1) -> NDArray[np.float64]:
        """The poses, shape (N, F, 4, 4), NaN where one is not a real number.

        Args:
            q: Joint values, shape (N, n); radians and metres.
            threads: How many threads share the work.
        """
        poses = np.empty((len(q), len(self.views), 4, 4))
        for k, (recording, point) in enumerate(self._made):
            out = poses[:, k]
            play(recording, q, out, threads)
            if any(point):
                out[:, :3, 3] += out[:, :3, :3] @ np.array(point)
        return poses

    def said(self, poses: NDArray[np.float64]) -> NDArray[np.float64]:
        """The numbers of each row, shape (N, width): frame by frame, form by form."""
        pieces = [_said(poses[:, k], form) for k in range(len(self.views)) for form in self.forms]
        return pieces[0] if len(pieces) == 1 else np.concatenate(pieces, axis=1)

    def locked(self, poses: NDArray[np.float64]) -> dict[str, int]:
        """For each form of three angles that is asked for, in how many rows only two of them can be told."""
        named = {form: ORIENTATIONS.get("fixed-xyz" if form == "rpy" else form) for form in self.forms}
        asked = {form: order for form, order in named.items() if isinstance(order, Order)}
        if not asked:
            return {}
        flat = rotations(poses.reshape(-1, 4, 4))
        found = {form: np.asarray(order.of(flat).locked) for form, order in asked.items()}
        return {form: int(rows.reshape(len(poses), -1).any(axis=1).sum()) for form, rows in found.items()}


def _said(poses: NDArray[np.float64], form: str) -> NDArray[np.float64]:
    """Poses, shape (N, 4, 4), as rows of the numbers of one form; the last row of a matrix is always 0 0 0 1."""
    if form == "matrix":
        return poses[:, :3, :].reshape(len(poses), 12)
    return poses[:, :3, 3] if form == "position" else table(ORIENTATIONS[form], poses)


def are_finite(numbers: NDArray[np.float64]) -> bool:
    """Whether it is seen at a glance that all numbers are finite: those whose squares have a sum are.

    Larger ones than their squares can be may be finite, too; whoever is told that they are not looks at each.
    """
    flat = numbers.ravel(order="K")
    with np.errstate(all="ignore"):
        return math.isfinite(flat @ flat)


def is_real(results: NDArray[np.float64]) -> NDArray[np.bool_]:
    """In which rows of poses or Jacobians, shape (N, ...), every entry is a real number; shape (N,)."""
    if are_finite(results):
        return np.ones(len(results), dtype=np.bool_)
    where = tuple(range(1, results.ndim))
    return np.all(np.isfinite(results), axis=where)  # type: ignore[no-any-return]  # numpy: or one bool


def numbered(rows: Sequence[int], kept: NDArray[np.bool_] | slice, said: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows of numbers, shape (N, width), with where each of them stands as the first number."""
    return np.column_stack((np.array(rows)[kept], said))
