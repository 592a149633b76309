"""Solutions of many poses, each once: those that rounding has split, or at which roots meet, are put together."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import Arm, nearest_turn
from dhcli.kinematics.inverse.polishing import POLISH, ROUNDING, SINGULAR, extent, jacobian, product, residuals
from dhcli.kinematics.inverse.steps import Plan
from dhcli.kinematics.inverse.tasks import Task

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags, Ints

_CLOSE = 1e-3
"""Solutions closer than this may be one that rounding has split [rad, reaches]."""

_SAME = 1e-9
"""Solutions closer than this are one; so are closer ones whose middle is a solution as good as they are,
or where roots meet."""


@frozen
class Found:
    """Solutions of many poses, sorted by pose.

    Attributes:
        index: The pose of each solution, shape (M,).
        motions: Motions of the joints, shape (M, n).
        residual: How far each is from its pose.
        path: The choices among roots that led to it.
        free: The joints that may take any value, as bits.
        draw: Which of the values tried for them.
    """

    index: Ints
    motions: Array
    residual: Array
    path: Ints
    free: Ints
    draw: Ints

    def take(self, at: Ints | Flags) -> Found:
        """Some of them."""
        path, free, draw = self.path[at], self.free[at], self.draw[at]
        return Found(self.index[at], self.motions[at], self.residual[at], path, free, draw)

    def joined(self, other: Found) -> Found:
        """These and others, sorted by pose."""
        index = np.concatenate([self.index, other.index])
        both = Found(
            index,
            np.concatenate([self.motions, other.motions]),
            np.concatenate([self.residual, other.residual]),
            np.concatenate([self.path, other.path]),
            np.concatenate([self.free, other.free]),
            np.concatenate([self.draw, other.draw]),
        )
        return both.take(np.argsort(index, kind="stable"))


def once(plan: Plan, task: Task, goal: Array, found: Found) -> Found:
    """Each solution once: those that rounding has split are put together."""
    arm = plan.actions.arm
    close = {k for first, second, _, _ in _pairs(arm, found) for k in (*first.tolist(), *second.tolist())}
    if plan.rules != ("ONE",):  # roots of several joints at once are exact to few digits where they meet
        close |= set(np.flatnonzero(~regular(plan, task, found.motions)).tolist())
    if not close:
        return found
    from dhcli.kinematics.inverse.multiple import sharpened  # few poses have roots that meet

    at = np.array(sorted(close))
    goals = goal[found.index[at]]
    alone = np.full(len(found.index), np.inf)
    motions, residual = found.motions.copy(), found.residual.copy()
    motions[at], alone[at] = sharpened(arm, task, motions[at], goals, plan.held)
    residual[at] = residuals(task, arm.home, product(arm, motions[at]), goals)
    found = replace(found, motions=motions, residual=residual)
    dropped = np.zeros(len(found.index), dtype=bool)
    for first, second, gap, distance in _pairs(arm, found):
        left = ~dropped[first] & ~dropped[second]
        one, other = first[left], second[left]
        middle = found.motions[one] + gap[left] / 2
        between = residuals(task, arm.home, product(arm, middle), goal[found.index[one]])
        best = np.maximum(found.residual[one], found.residual[other])
        rounded = np.maximum(POLISH, ROUNDING * extent(arm, middle))
        meet = np.isfinite(alone[one] + alone[other])
        same = (distance[left] < _SAME) | meet | (between <= np.maximum(best, rounded))
        worse = np.where(meet, alone[one] > alone[other], found.residual[one] > found.residual[other])
        dropped[one[same & worse]] = True
        dropped[other[same & ~worse]] = True
    return found.take(~dropped)


def _pairs(arm: Arm, found: Found) -> Iterator[tuple[Ints, Ints, Array, Array]]:
    """Pairs of solutions of a pose that are close to each other, each solution at most twice at a time.

    Yields:
        The two of each pair, the way from one to the other, shape (K, n), and how far that is, shape (K,).
    """
    turning, out = arm.turning, extent(arm, found.motions)
    for apart in range(1, int(np.bincount(found.index).max(initial=1))):
        first = np.flatnonzero(found.index[:-apart] == found.index[apart:])
        gap = nearest_turn(turning, found.motions[first + apart] - found.motions[first])
        distance = np.abs(np.where(turning, gap, gap / out[first, None])).max(axis=1, initial=0.0)
        close = distance < _CLOSE
        if close.any():
            yield first[close], first[close] + apart, gap[close], distance[close]


def regular(plan: Plan, task: Task, motions: Array) -> Flags:
    """Where an arm, motions (M, n), cannot move without moving its end, shape (M,)."""
    slope = np.delete(jacobian(plan.actions.arm, task, motions)[1], list(plan.held), axis=2)
    if slope.shape[1] < slope.shape[2] or not slope.shape[2]:
        return np.zeros(len(motions), dtype=bool)
    return np.asarray(np.linalg.svd(slope, compute_uv=False)[:, -1] > SINGULAR)
