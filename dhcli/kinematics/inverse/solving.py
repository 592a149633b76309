"""All solutions of one pose: found, families told from single solutions, each once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import nearest_turn
from dhcli.kinematics.inverse.found import Found
from dhcli.kinematics.inverse.polishing import SINGULAR, jacobian, product, residuals
from dhcli.kinematics.inverse.prepared import Prepared
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.trying import CONFIRMED, confirmed

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags, Ints
    from dhcli.kinematics.inverse.families import Freedom

TRIED = np.array([0.0, 0.5, -0.5, 1.0, 0.25, -0.25, 0.75, -0.75])
"""Where a free joint is tried: half turns from where it should best be, or reaches."""

_SAME = 1e-7


@frozen
class Solved:
    """Solutions of one pose.

    Attributes:
        motions: Motions of the joints, shape (K, n).
        residual: How far each is from the pose, shape (K,).
        freedoms: For each the ways in which the arm can move without moving its end.
    """

    motions: Array
    residual: Array
    freedoms: tuple[tuple[Freedom, ...], ...]
    index: Ints
    """Which of the values of the joints held each is for, shape (K,)."""

    def taken(self, at: Flags) -> Solved:
        """Some of them."""
        ways = tuple(self.freedoms[k] for k in np.flatnonzero(at).tolist())
        return Solved(self.motions[at], self.residual[at], ways, self.index[at])


def solve(
    ready: Prepared,
    goal: Array,
    best: Array,
    held: Mapping[int, Array] | None = None,
    tolerance: float = CONFIRMED,
    begun: Array | None = None,
) -> Solved:
    """All solutions of one pose.

    Args:
        ready: The robot made ready.
        goal: What the product of the joint motions has to be, shape (4, 4).
        best: Where a joint that is free should best stand, shape (n,).
        held: Motions of the joints that are held: one value, or several of which each gives solutions.
        tolerance: Residual up to which a candidate is a solution.
        begun: Motions to begin with in the place of what the plan finds, shape (n,); joints held stand there.
    """
    plan, task, arm = ready.plan, ready.task, ready.arm
    held = held or {}
    if begun is None:
        count = len(next(iter(held.values()))) if held else 1
        found = run(plan, task, np.repeat(goal[None], count, axis=0), tries(ready, best), held, tolerance)
    else:
        found = confirmed(plan, task, Rows.start(plan.actions, goal[None], {}), tolerance, begun[None])
    if not len(found.index):
        return Solved(np.empty((0, arm.joints)), np.empty(0), (), np.empty(0, dtype=int))
    kept, families = representatives(ready, found, least_singular(ready, found.motions))
    found = found.take(kept)
    rows: list[tuple[int, Array, tuple[Freedom, ...]]] = []
    for index, motions, ways in zip(found.index.tolist(), found.motions, families, strict=True):
        placed = _at_best(ready, motions, goal, best, ways) if ways else motions
        same = _same(arm.turning, rows, index, placed)
        if same is not None and not _covers(ways, rows[same][2]) and not _covers(rows[same][2], ways):
            placed = motions  # two families cross where both would be shown
            same = _same(arm.turning, rows, index, placed)
        if same is None:
            rows.append((index, placed, ways))
        elif not _covers(rows[same][2], ways):  # as one that is beside a family by rounding alone
            rows[same] = index, placed, ways
    order = sorted(range(len(rows)), key=lambda k: (rows[k][0], *np.round(rows[k][1], 7).tolist()))
    wrapped = np.array([_wrapped(rows[k][1], arm.turning) for k in order])
    left = residuals(task, arm.home, product(arm, wrapped), np.repeat(goal[None], len(wrapped), axis=0))
    return Solved(wrapped, left, tuple(rows[k][2] for k in order), np.array([rows[k][0] for k in order]))


def _same(turning: Flags, rows: list[tuple[int, Array, tuple[Freedom, ...]]], index: int, motions: Array) -> int | None:
    """The place of a solution in a list, None where it is not there."""
    return next((k for k, (of, row, _) in enumerate(rows) if of == index and _gap(turning, motions, row) < _SAME), None)


def _covers(ways: tuple[Freedom, ...], others: tuple[Freedom, ...]) -> bool:
    """Whether the same joints move in each of some ways to move as in one of these."""
    return {way.joints for way in others} <= {way.joints for way in ways}


def _at_best(ready: Prepared, motions: Array, goal: Array, best: Array, ways: tuple[Freedom, ...]) -> Array:
    """The member of a family whose free joints stand where they should best be."""
    from dhcli.kinematics.inverse.families import moved_to  # ordinary poses have no families

    for way in ways:
        there = moved_to(ready.arm, ready.task, motions, goal, way, float(best[way.parameter]), ready.plan.held)
        motions = motions if there is None else there
    return motions


def tries(ready: Prepared, best: Array) -> Array:
    """Motions to try for a joint that is free, shape (n, 8)."""
    turning = ready.arm.turning
    return np.asarray(best[:, None] + np.where(turning[:, None], np.pi * TRIED, TRIED))


def _gap(turning: Flags, one: Array, other: Array) -> float:
    gap = one - other
    gap = nearest_turn(turning, gap)
    return float(np.abs(gap).max(initial=0.0))


def _wrapped(motions: Array, turning: Flags) -> Array:
    """The same angles above -π, up to π."""
    turns = np.ceil((motions - np.pi) / (2 * np.pi) - _SAME)
    return np.where(turning, motions - 2 * np.pi * turns, motions)


def least_singular(ready: Prepared, motions: Array) -> Array:
    """The least singular value of the Jacobian at each solution, joints held left out, shape (K,)."""
    _, slope = jacobian(ready.arm, ready.task, motions)
    slope = np.delete(slope, list(ready.plan.held), axis=2)
    if not slope.shape[2]:
        return np.ones(len(motions))
    if slope.shape[1] < slope.shape[2]:
        return np.zeros(len(motions))
    return np.asarray(np.linalg.svd(slope, compute_uv=False)[:, -1])


def representatives(ready: Prepared, found: Found, least: Array) -> tuple[Ints, list[tuple[Freedom, ...]]]:
    """Of the members of a family the first; all else.

    One choice of roots may lead into several families, which a pose at right angles has: in each some joints stand.

    Returns:
        Which are kept, in their order, and the ways in which the arm can move at each.
    """
    loose = np.flatnonzero(least < SINGULAR)
    if not len(loose):
        return np.arange(len(found.index)), [()] * len(found.index)
    from dhcli.kinematics.inverse.families import one_of_each, standing_still

    rates = standing_still(ready.arm, ready.task, found.motions[loose], ready.plan.held)
    rates_of = dict(zip(loose.tolist(), rates, strict=True))
    groups: dict[int, list[int]] = {}
    for k in loose[np.lexsort((found.draw[loose], found.free[loose] != 0))].tolist():
        groups.setdefault(int(found.index[k]), []).append(k)
    ways: dict[int, tuple[Freedom, ...]] = {}
    for group in groups.values():
        motions, path = found.motions[group], found.path[group]
        shown = one_of_each(ready.arm, ready.task, motions, path, [rates_of[k] for k in group], ready.plan.held)
        ways |= {group[i]: way for i, way in shown.items()}
    kept = [k for k in range(len(found.index)) if k not in rates_of or k in ways]
    return np.array(kept, dtype=int), [ways.get(k, ()) for k in kept]
