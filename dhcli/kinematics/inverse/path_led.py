"""A path of poses followed by an arm whose variables are led: on from the pose before by Newton's steps."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.inverse.leading import Leading
from dhcli.kinematics.inverse.led import Driven
from dhcli.kinematics.inverse.solutions import held_values, in_numbers
from dhcli.kinematics.inverse.targets import read_targets
from dhcli.kinematics.values import joint_values

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhcli.kinematics.inverse.arm import Array, Ints

STEADY = 4.0
"""A step at most this many times as long as the one before goes on along the branch; beyond it all solutions count."""

SHORT = 0.05
"""So does a step of this length [rad, reaches], whatever the one before was."""


def led_along(
    solve: Callable[..., tuple[Array, Ints]],
    leading: Leading,
    T: ArrayLike,  # noqa: N803  the field's name for poses
    asked: Mapping[str, Any],
) -> tuple[Array, Array]:
    """Values of the variables along a path of poses, each the nearest to those before it.

    Variables that the task does not need are held where the path begins.

    Args:
        solve: What finds the solutions of many poses; see `inverse_batch`.
        leading: The robot.
        T: The poses in order, shape (N, 4, 4) [m].
        asked: What else `inverse_batch` takes; `near` is where the path begins.

    Returns:
        The values, shape (N, n), NaN where a pose is out of reach; and the least singular value of the Jacobian at
        each, shape (N,).
    """
    robot, driven, at = leading.carried.robot, leading.driven, list(leading.columns)
    poses, _ = read_targets(T, driven.task)
    start = in_numbers(robot, asked["near"])
    given = joint_values(robot, dict(held_values(asked["hold"])))
    held = {name: in_floats(value) for name, value in given.items()}
    chosen = driven.to_hold(tuple(k for k, j in enumerate(at) if robot.variables[j] in held))
    held |= {robot.variables[at[k]]: float(start[at[k]]) for k in chosen}
    for name, value in held.items():
        start[robot.variables.index(name)] = value
    still = tuple(k for k, j in enumerate(at) if robot.variables[j] in held)
    q = np.full((len(poses), len(start)), np.nan)
    last, stride = start[at] / leading.units, 0.0
    for k, goal in enumerate(driven.arm.goal(poses)):
        x, _, there = driven.led(last[None], goal, still, asked["tolerance"])
        on = x[0]
        if not there[0] or np.linalg.norm(on - last) > max(SHORT, STEADY * stride):
            whole = start.copy()
            whole[at] = last * leading.units
            found, _ = solve(robot, poses[k : k + 1], **{**asked, "near": whole.tolist(), "hold": held})
            if not len(found):
                continue
            ways = driven.nearest_turn(found[:, at] / leading.units, last)
            on = ways[int(np.argmin(np.linalg.norm(ways - last, axis=1)))]
        stride = float(np.linalg.norm(on - last))
        q[k] = start
        q[k, at] = on * leading.units
        last = on
    return q, _least(driven, q[:, at] / leading.units, still)


def _least(driven: Driven, x: Array, still: tuple[int, ...]) -> Array:
    """The least singular value of the Jacobian by the variables that are not held; infinite where there are none."""
    sizes = np.full(len(x), np.inf)
    there = ~np.isnan(x).any(axis=1)
    slopes = np.delete(driven.slopes(x[there]), list(still), axis=2)
    if slopes.shape[2]:
        sizes[there] = np.linalg.svd(slopes, compute_uv=False)[:, slopes.shape[2] - 1]
    return sizes
