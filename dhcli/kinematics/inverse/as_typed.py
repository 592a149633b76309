"""A pose typed with few digits, which an arm of few joints takes nearly, and no pose with exactly these digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.kinematics.batch import forward_batch
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.inverse.solutions import Solutions

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhcli.kinematics.inverse.arm import Array

_APART = 4.0
"""The nearest pose is at most so many times as far away in an entry as its digits leave open; the true one is once."""

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
    if len(found) or found.closest is None or not slack:
        return found
    seen = {name: asked.get(name) for name in ("start", "end", "parameters")}
    columns, wanted = _COUNTS[found.task], np.asarray(T, dtype=float)[:3]
    still = [found.robot.variables.index(name) for name in {*(asked.get("hold") or {}), *dict(found.held)}]

    def left(q: Array) -> Array:
        """What each entry of poses is beside, shape (N, m)."""
        gaps = forward_batch(found.robot, q, **seen)[:, :3] - wanted  # type: ignore[arg-type]
        return np.asarray(gaps[:, *columns].reshape(len(q), -1))

    q = _nearer(left, found.closest, still)
    apart = float(np.abs(left(q[None])).max())
    if apart > _APART * slack:
        return found
    there = forward_batch(found.robot, q[None], **seen)[0]  # type: ignore[arg-type]
    nearest = inverse(found.robot, there, task=found.task, **asked)  # type: ignore[arg-type]  # a task's name
    said = "the arm takes no pose with exactly these digits"
    return replace(
        nearest, remarks=(f"{said}; the nearest is taken, an entry of it {apart:.2g} away", *nearest.remarks)
    )


def _nearer(left: Callable[[Array], Array], q: Array, still: list[int]) -> Array:
    """Joint values from which all entries are beside by the least sum of squares, each as much as another."""
    steps = _STEP * np.eye(len(q))
    for _ in range(_ROUNDS):
        slopes = (left(q + steps) - left(q - steps)) / (2 * _STEP)
        slopes[still] = 0
        q = q - np.linalg.lstsq(slopes.T, left(q[None])[0], rcond=1e-6)[0]
    return q
