"""The pose asked for, in whatever form, as a rigid motion; what is not quite a rotation is put right and told."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import RobotError
from dhcli.geometry.real_arrays import real_numbers
from dhcli.kinematics.pose import Pose

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhcli.kinematics.inverse.arm import Array
    from dhcli.kinematics.inverse.tasks import Task

LOOSE = 5e-3
"""By how much a typed direction cosine may miss a rotation before it is refused."""

EXACT = 1e-9
"""Below this a matrix is a rotation, and nothing is said."""

FARTHEST = 1e12
"""A place farther away than this [m] is a slip, not a place."""


def read_targets(given: ArrayLike | Pose[float], task: Task) -> tuple[Array, float]:
    """Poses as matrices.

    Args:
        given: A pose, or an array: (4, 4) or (N, 4, 4); for a position also (3,) or (N, 3), for an orientation also
            (3, 3) or (N, 3, 3), for a direction also (3,) or (N, 3).
        task: What of it counts.

    Returns:
        The poses, shape (N, 4, 4), and by how much at most an entry was changed to make a rotation of it.

    Raises:
        RobotError: It is none of these, has an entry that is no number, or its nine cosines are no rotation.
    """
    none = RobotError(f"{type(given).__name__} is no pose", "wanted: a pose, or numbers of the shape (4, 4)")
    poses = _as_poses(real_numbers(given.matrix if isinstance(given, Pose) else given, none), task)
    if not np.isfinite(poses).all():
        raise RobotError("the pose has an entry that is not a number", "every entry must be finite")
    if np.abs(poses[:, :3, 3]).max(initial=0) > FARTHEST:
        raise RobotError("the pose is farther away than any robot reaches", "lengths are in metres")
    if np.abs(poses[:, 3] - (0, 0, 0, 1)).max(initial=0) > EXACT:
        raise RobotError("the last row of a pose is 0 0 0 1", "see that rows and columns are not exchanged")
    return _orthonormal(poses) if task.directions else (_without_turn(poses), 0.0)


def read_target(given: ArrayLike | Pose[float], task: Task) -> tuple[Array, tuple[str, ...]]:
    """One pose as a matrix, shape (4, 4), and what has to be said of how it was taken.

    Raises:
        RobotError: It is none, or several.
    """
    poses, changed = read_targets(given, task)
    if len(poses) != 1:
        raise RobotError(f"one pose is wanted, not {len(poses)}", "inverse_batch takes many")
    said = f"the direction cosines were no rotation; the nearest one was taken, {changed:.2g} away"
    return poses[0], (said,) if changed > EXACT else ()


def _as_poses(array: Array, task: Task) -> Array:
    shape = array.shape
    if shape[-2:] == (4, 4) and array.ndim in {2, 3}:
        return array.reshape(-1, 4, 4)
    count = len(array) if array.ndim > 1 else 1
    poses = np.tile(np.eye(4), (count, 1, 1))
    if not task.directions and shape[-1:] == (3,) and array.ndim in {1, 2}:
        poses[:, :3, 3] = array
        return poses
    if task.name == "direction" and shape[-1:] == (3,) and array.ndim in {1, 2}:
        poses[:, :3, :3] = _frames_along(array.reshape(-1, 3))
        return poses
    if not task.place and shape[-2:] == (3, 3) and array.ndim in {2, 3}:
        poses = np.tile(np.eye(4), (len(array.reshape(-1, 3, 3)), 1, 1))
        poses[:, :3, :3] = array.reshape(-1, 3, 3)
        return poses
    other = {(3,): 'task="position"', (3, 3): 'task="orientation"'}.get(shape)
    hint = "wanted: numbers of the shape (4, 4)" + (f"; for this one {other}" if other else "")
    raise RobotError(f"an array of the shape {shape} is no {task.name}", hint)


def _without_turn(poses: Array) -> Array:
    poses = poses.copy()
    poses[:, :3, :3] = np.eye(3)
    return poses


def _frames_along(directions: Array) -> Array:
    """Rotations whose z axis is along given directions, shape (N, 3, 3).

    Raises:
        RobotError: A direction has no length.
    """
    sizes = np.linalg.norm(directions, axis=1, keepdims=True)
    if not (sizes > 0).all():
        raise RobotError("a direction has no length", "give a vector such as 0, 0, -1")
    z = directions / sizes
    helper = np.eye(3)[np.abs(z).argmin(axis=1)]
    x = np.cross(helper, z)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    return np.stack([x, np.cross(z, x), z], axis=2)


def _orthonormal(poses: Array) -> tuple[Array, float]:
    """The poses with the nearest rotations, and by how much an entry changed at most.

    Raises:
        RobotError: An entry would change by more than what rounding explains.
    """
    left, _, right = np.linalg.svd(poses[:, :3, :3])
    turn = left @ right
    changed = np.abs(turn - poses[:, :3, :3]).max(axis=(1, 2))
    worst = int(np.argmax(changed)) if len(changed) else 0
    if len(changed) and changed[worst] > LOOSE:
        nearest = "; ".join(" ".join(f"{entry + 0.0:.4g}" for entry in row) for row in turn[worst])
        message = f"the nine direction cosines are no rotation: the nearest one differs by {changed[worst]:.2g}"
        which = f" (pose {worst + 1})" if len(changed) > 1 else ""
        raise RobotError(message + which, f"nearest: {nearest}")
    mirrored = np.flatnonzero(np.linalg.det(turn) < 0)
    if len(mirrored):
        raise RobotError("the axes of the pose are left-handed", "exchange two columns, or turn one around")
    poses = poses.copy()
    keep = changed <= 4 * np.finfo(float).eps
    poses[~keep, :3, :3] = turn[~keep]
    return poses, float(changed.max(initial=0))
