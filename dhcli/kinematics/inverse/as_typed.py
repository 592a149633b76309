"""A pose typed with few digits, which an arm of few joints takes nearly, and no pose with exactly these digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.kinematics.batch import forward_batch
from dhcli.kinematics.coupling import is_coupled
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.inverse.batch import inverse_batch
from dhcli.kinematics.inverse.choosing import rank
from dhcli.kinematics.inverse.question import ask
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.inverse.targets import EXACT, read_targets
from dhcli.kinematics.inverse.tasks import TaskName, task_called
from dhcli.kinematics.robot import Robot

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhcli.kinematics.inverse.arm import Array

_APART = 4.0
"""The nearest pose is at most so many times as far away in an entry as its digits leave open; the true one is once."""

FEW, _MANY = 3, 13
"""Decimals from which on a matrix may be meant to its digits only, and of a number that is not typed by hand."""

_WELL = 1e-3
"""A way to move the end by less than this share of the most is none by which digits say where a joint is."""

_ROUND = 1e-15
"""A number this near to one of few decimals is that one."""

_ROUNDS, _STEP = 4, 1e-5
"""Steps to the nearest pose, and by how much joints are moved to see where it is."""

_COUNTS = {
    "pose": np.s_[:, :],
    "position": np.s_[:, 3],
    "orientation": np.s_[:, :3],
    "axis": np.s_[:, 2:],
    "direction": np.s_[:, 2],
}
"""Which entries of a pose a task looks at."""


def as_typed(found: Solutions, T: ArrayLike, slack: float, asked: Mapping[str, Any]) -> Solutions:  # noqa: N803  a pose
    """The solutions of the pose nearest to one that was typed with few digits, if they leave that open.

    Args:
        found: The answer for the pose as it was typed.
        T: The pose, shape (4, 4) [m].
        slack: By how much its digits leave each entry open [m, 1]; 0 where it is exact.
        asked: What else `inverse` was asked.

    Returns:
        Those solutions, with a remark; the answer given where it has some, or where the nearest pose is another one.
    """
    there = nearest_typed(found, T, slack, asked)
    if there is None:
        return found
    pose, apart = there
    nearest = inverse(found.robot, pose, task=found.task, **asked)  # type: ignore[arg-type]  # a task's name
    said = "the arm takes no pose with exactly these digits"
    return replace(
        nearest, remarks=(f"{said}; the nearest is taken, an entry of it {apart:.2g} away", *nearest.remarks)
    )


def nearest_typed(found: Solutions, T: ArrayLike, slack: float, asked: Mapping[str, Any]) -> tuple[Array, float] | None:  # noqa: N803
    """The pose nearest to one that was typed, shape (4, 4), and how far an entry of it is at most; None if another.

    Args:
        found: The answer for the pose as it was typed.
        T: The pose, shape (4, 4) [m].
        slack: By how much its digits leave each entry open [m, 1]; 0 where it is exact.
        asked: What else `inverse` was asked.
    """
    if len(found) or found.closest is None or not slack:
        return None
    still = _still(found, asked)
    left = _left(found, T, asked)
    q = _nearer(left, found.closest, still)
    apart = float(np.abs(left(q[None])).max())
    return None if apart > _APART * slack else (_poses(found, q[None], asked)[0], apart)


def at_limits(found: Solutions, T: ArrayLike, slack: float, asked: Mapping[str, Any]) -> Solutions:  # noqa: N803
    """The solutions, those of their joints at their limits that are beyond them by less than the digits leave open.

    Args:
        found: The answer for a pose that was typed.
        T: The pose, shape (4, 4) [m].
        slack: By how much its digits leave each entry open [m, 1].
        asked: What else `inverse` was asked.
    """
    if not any(found.beyond):
        return found
    still, left, names = _still(found, asked), _left(found, T, asked), found.robot.variables
    beyond = []
    for q, outside in zip(found.q, found.beyond, strict=True):
        open_by = slack * np.abs(np.linalg.pinv(_slopes(left, q, still).T, rcond=_WELL)).sum(axis=1) if outside else []
        room = dict(zip(names, open_by, strict=False))
        beyond.append(tuple(each for each in outside if abs(each.by) > room.get(each.joint, 0.0)))
    now = {each.joint for outside in found.beyond for each in outside if all(each not in kept for kept in beyond)}
    said = (
        [f"to the digits typed {', '.join(name for name in names if name in now)} may stand at a limit"] if now else []
    )
    return replace(found, beyond=tuple(beyond), remarks=(*found.remarks, *said))


def _still(found: Solutions, asked: Mapping[str, Any]) -> list[int]:
    """The numbers of joints that are held."""
    return [found.robot.variables.index(name) for name in {*(asked.get("hold") or {}), *dict(found.held)}]


def _poses(found: Solutions, q: Array, asked: Mapping[str, Any]) -> Array:
    """Where joint values (N, n) take the end, shape (N, 4, 4)."""
    seen = {name: asked.get(name) for name in ("start", "end", "parameters")}
    return forward_batch(found.robot, q, **seen)  # type: ignore[arg-type]


def _left(found: Solutions, T: ArrayLike, asked: Mapping[str, Any]) -> Callable[[Array], Array]:  # noqa: N803
    """What each entry of a pose that counts is beside at joint values (N, n), shape (N, m)."""
    columns, wanted = _COUNTS[found.task], np.asarray(T, dtype=float)[:3]

    def left(q: Array) -> Array:
        gaps = _poses(found, q, asked)[:, :3] - wanted
        return np.asarray(gaps[:, *columns].reshape(len(q), -1))

    return left


def _slopes(left: Callable[[Array], Array], q: Array, still: list[int]) -> Array:
    """How each entry changes with each joint that is not held, shape (n, m)."""
    steps = _STEP * np.eye(len(q))
    slopes = (left(q + steps) - left(q - steps)) / (2 * _STEP)
    slopes[still] = 0
    return slopes


def batch_as_typed(
    robot: Robot, poses: Array, task: TaskName, asked: Mapping[str, Any], wish: Mapping[str, Any]
) -> tuple[Array, NDArray[np.int64], bool]:
    """Joint values for many poses; for those that an arm of few joints takes only nearly, for the nearest ones.

    Args:
        robot: The robot.
        poses: Poses, shape (N, 4, 4) [m], or positions, (N, 3), which are taken as they are.
        task: What of them counts.
        asked: What `inverse` and `inverse_batch` take alike.
        wish: What else `inverse_batch` takes.

    Returns:
        Joint values, the number of the pose of each in rising order, and whether a pose nearby was taken for any.
    """
    q, index = inverse_batch(robot, poses, task=task, **wish, **asked)
    lost = np.setdiff1d(np.arange(len(poses)), index).tolist()
    taken = poses_as_typed(robot, poses, lost, task, asked) if poses.ndim == 3 else {}  # noqa: PLR2004  matrices
    if not taken:
        return q, index, False
    more, at = inverse_batch(robot, np.array(list(taken.values())), task=task, **wish, **asked)
    both = np.concatenate([index, np.array(list(taken))[at]])
    order = np.argsort(both, kind="stable")
    return np.concatenate([q, more])[order], both[order], True


def poses_as_typed(
    robot: Robot, poses: Array, lost: Sequence[int], task: TaskName, asked: Mapping[str, Any]
) -> dict[int, Array]:
    """Of poses without a solution those that their digits leave open to an arm of few joints, as it takes them.

    Args:
        robot: The robot.
        poses: Poses, shape (N, 4, 4) [m].
        lost: Which of them have no solution.
        task: What of them counts.
        asked: What else `inverse` takes.

    Returns:
        By their numbers the nearest poses that the arm takes.
    """
    wanted = [(k, slack) for k in lost if (slack := slack_of(poses[k], task))]
    if not wanted or not _is_short(robot, task, asked):
        return {}
    found = {}
    for k, slack in wanted:
        there = nearest_typed(inverse(robot, poses[k], task=task, **asked), poses[k], slack, asked)
        if there is not None:
            found[k] = there[0]
    return found


def slack_of(pose: Array, task: TaskName) -> float:
    """By how much the decimals of a pose leave an entry open: half a unit of the last; 0 if many or few are right.

    Where its turn was given by angles or a quaternion, the position tells how many decimals the row had.
    """
    for part in (pose, pose[:3, 3]):
        for decimals in range(_MANY):
            if np.abs(np.round(part, decimals) - part).max() < _ROUND:
                is_rounded = decimals > FEW or (decimals == FEW and read_targets(pose, task_called(task))[1] > EXACT)
                return 0.5 * 10.0**-decimals if is_rounded else 0.0
    return 0.0


def _is_short(robot: Robot, task: TaskName, asked: Mapping[str, Any]) -> bool:
    """Whether a robot has not enough joints for a task, so that poses of few digits are beside those it takes."""
    if is_coupled(robot):
        return True
    seen = {name: asked.get(name) for name in ("hold", "start", "end", "parameters")}
    question, held = ask(robot, task, **seen)  # type: ignore[arg-type]  # what it takes
    ready = question.ready
    return rank(ready.arm, ready.task, tuple(held)) < ready.task.conditions


def _nearer(left: Callable[[Array], Array], q: Array, still: list[int]) -> Array:
    """Joint values from which all entries are beside by the least sum of squares, each as much as another."""
    for _ in range(_ROUNDS):
        q = q - np.linalg.lstsq(_slopes(left, q, still).T, left(q[None])[0], rcond=1e-6)[0]
    return q
