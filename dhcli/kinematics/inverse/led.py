"""Arms whose coupling leaves fewer ways to move than moves: their variables led to a pose by Newton's steps.

No rule reads such variables off one by one. They are led from many places at once, which may miss a solution.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.polishing import ROUNDING, SINGULAR, extent, jacobian, polished, spread

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array, Flags, Ints
    from dhcli.kinematics.inverse.tasks import Task

STARTS = 48
"""Places to begin at, for each variable."""

_ROUNDS = 4
"""How many times those that have not arrived are led on."""

_SAME = 1e-6
"""Values that differ by less are the same [rad, reaches]."""

_BLURRED = 1e-5
"""So are those at a double root that differ by less."""

_APART = 0.05
"""How far a variable moves where it is looked whether others make up for it [rad, reaches]."""

_STEPS = 16
"""Steps in which a variable that is free is moved to where it should stand."""

_RANK = 1e-8


@frozen
class Driven:
    """An arm whose motions are sums of multiples of variables.

    Attributes:
        arm: The arm.
        task: What is wanted.
        mix: Motions for each unit of the variables, shape (m, n); lengths in reaches.
        zero: Motions where the variables are 0, shape (m,).
        low: Where a variable is begun with at least, shape (n,).
        high: At most.
        period: After how much a variable comes to the same pose, 0 for never, shape (n,).
    """

    arm: Arm
    task: Task
    mix: Array
    zero: Array
    low: Array
    high: Array
    period: Array

    def rank(self, still: tuple[int, ...] = ()) -> int:
        """How many conditions the variables can meet in an ordinary pose, some held."""
        slopes = self.slopes(2.6 * spread(3, self.mix.shape[1], 7) - 1.3)
        slopes[:, :, list(still)] = 0
        return int((np.linalg.svd(slopes, compute_uv=False) > _RANK).sum(axis=1).max())

    def slopes(self, x: Array) -> Array:
        """The Jacobian by the variables (N, n)."""
        return np.asarray(jacobian(self.arm, self.task, x @ self.mix.T + self.zero)[1] @ self.mix)

    def to_hold(self, asked: tuple[int, ...]) -> tuple[int, ...]:
        """Variables to hold besides those asked for, where there are more than the task needs; the last ones if any."""
        left = [j for j in range(self.mix.shape[1]) if j not in asked][::-1]
        wanted = self.rank(asked)
        for more in combinations(left, len(left) - wanted):
            if self.rank((*asked, *more)) == wanted:
                return more
        return ()

    def begun(self, held: dict[int, float]) -> Array:
        """Places to begin at."""
        width = self.mix.shape[1]
        x = self.low + (self.high - self.low) * spread(STARTS * max(width - len(held), 1), width, 3)
        for j, value in held.items():
            x[:, j] = value
        return np.asarray(x)

    def led(self, x: Array, goal: Array, still: tuple[int, ...], tolerance: float) -> tuple[Array, Array, Flags]:
        """Variables (N, n) led to a pose, how far they are from it, and whether they are there."""
        motions, left = x @ self.mix.T + self.zero, np.full(len(x), np.inf)
        back = np.linalg.pinv(self.mix)
        going = np.arange(len(x))
        for _ in range(_ROUNDS):
            goals = np.repeat(goal[None], len(going), axis=0)
            motions[going], now = polished(self.arm, self.task, motions[going], goals, still, self.mix)
            better = now < 0.9 * left[going]
            left[going] = now
            going = going[better & (now > tolerance)]
            if not len(going):
                break
        there = left <= np.maximum(tolerance, ROUNDING * extent(self.arm, motions))
        found = (motions - self.zero) @ back.T
        found[:, list(still)] = x[:, list(still)]
        return found, left, there

    def nearest_turn(self, x: Array, to: Array) -> Array:
        """The same pose by variables less than half a period from some."""
        whole = np.where(self.period > 0, self.period, np.inf)
        return np.asarray(x - np.where(self.period > 0, self.period, 0) * np.round((x - to) / whole))

    def gap(self, one: Array, other: Array) -> Array:
        """How far variables are apart, whole periods left out."""
        return np.asarray(np.abs(self.nearest_turn(one, other) - other))

    def wrapped(self, x: Array) -> Array:
        """The same pose by variables in the middle period."""
        whole = np.where(self.period > 0, self.period, np.inf)
        return np.asarray(x - np.where(self.period > 0, self.period, 0) * np.ceil(x / whole - 0.5 - 1e-9))


@frozen
class Arrived:
    """What was found.

    Attributes:
        x: The variables, shape (K, n).
        residual: How far each is from the pose.
        free: For each the variables that may take any value.
        moving: For each the variables that then move.
    """

    x: Array
    residual: Array
    free: tuple[tuple[int, ...], ...]
    moving: tuple[tuple[int, ...], ...]


def arrive(driven: Driven, goal: Array, best: Array, held: dict[int, float], more: Array, tolerance: float) -> Arrived:
    """All that Newton's steps from many places lead to, of each family one.

    Args:
        driven: The arm.
        goal: What the product of the motions has to be, shape (4, 4).
        best: Where a variable that is free should stand, shape (n,).
        held: Values of variables that are held.
        more: Further places to begin at, shape (K, n).
        tolerance: Residual up to which a pose is reached.
    """
    still = tuple(held)
    starts = np.vstack([more, driven.begun(held)])
    for j, value in held.items():
        starts[:, j] = value
    x, left, there = driven.led(starts, goal, still, tolerance)
    x, left = driven.wrapped(x[there]), left[there]
    kept = _once(driven, x, left, np.full(len(x), _SAME))
    x, left = x[kept], left[kept]
    ways: list[tuple[tuple[int, ...], tuple[int, ...]]] = [((), ())] * len(x)
    slopes = driven.slopes(x)
    slopes[:, :, list(still)] = 0
    width = np.full(len(x), _SAME)
    _, sizes, rows = np.linalg.svd(slopes)
    rank = (sizes > SINGULAR).sum(axis=1)
    loose = [k for k in range(len(x)) if rank[k] < driven.mix.shape[1] - len(still)]
    for k in loose:
        width[k] = _BLURRED
        null = rows[k, rank[k] :].copy()
        null = null[np.abs(null[:, list(still)]).max(axis=1, initial=0.0) < 0.5]  # noqa: PLR2004  those held are null
        ways[k] = _ways(driven, goal, x[k], null, still, tolerance)
    lost = _at_best(driven, goal, x, left, best, [free for free, _ in ways], still, tolerance)
    kept = [k for k in _once(driven, x, left, width) if k not in lost]
    return Arrived(x[kept], left[kept], tuple(ways[k][0] for k in kept), tuple(ways[k][1] for k in kept))


def where_reached(
    driven: Driven, goal: Array, best: Array, held: dict[int, float], chosen: tuple[int, ...], tolerance: float
) -> dict[int, float]:
    """Values of variables to hold with which a pose is reached, near to where they should best stand; none if none."""
    x, _, there = driven.led(driven.begun(held), goal, tuple(held), tolerance)
    if not there.any():
        return {}
    x = driven.wrapped(x[there])[:, list(chosen)]
    nearest = x[int(np.argmin(np.abs(x - best[list(chosen)]).sum(axis=1)))]
    return dict(zip(chosen, nearest.tolist(), strict=True))


def _once(driven: Driven, x: Array, left: Array, width: Array) -> list[int]:
    """Each solution once, the best of those that are one."""
    kept = list[int]()
    for k in np.argsort(left, kind="stable").tolist():
        if all(driven.gap(x[k], x[other]).max(initial=0.0) > max(width[k], width[other]) for other in kept):
            kept.append(k)
    return sorted(kept, key=lambda k: np.round(x[k], 7).tolist())


def _ways(
    driven: Driven, goal: Array, x: Array, null: Array, still: tuple[int, ...], tolerance: float
) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The variables that others make up for at a solution, and those that move then."""
    pivots, rest = list[int](), null.copy()
    for _ in range(len(null)):
        size = np.linalg.norm(rest, axis=0)
        j = int(np.argmax(np.round(size, 6)))
        pivots.append(j)
        along = rest[:, j] / size[j]
        rest -= np.outer(along, along @ rest)
    for chosen in dict.fromkeys([tuple(pivots), *((j,) for j in pivots)]):
        trial = x.copy()
        trial[list(chosen)] += _APART
        found, _, there = driven.led(trial[None], goal, (*still, *chosen), tolerance)
        if there[0]:
            return chosen, tuple(np.flatnonzero(np.abs(found[0] - x) > _SAME).tolist())
    return (), ()


def _at_best(  # noqa: PLR0913, PLR0917  what variables are led with
    driven: Driven,
    goal: Array,
    x: Array,
    left: Array,
    best: Array,
    free: list[tuple[int, ...]],
    still: tuple[int, ...],
    tolerance: float,
) -> set[int]:
    """Move the variables that are free to where they should stand, in place.

    Returns:
        Those that could not get there, and are not the nearest of their family.
    """
    lost = set[int]()
    for chosen in dict.fromkeys(way for way in free if way):
        rows: Ints = np.array([k for k, way in enumerate(free) if way == chosen])
        at, off = list(chosen), np.zeros(len(rows), dtype=bool)
        begin = x[rows][:, at]
        for share in np.linspace(0, 1, _STEPS + 1)[1:]:
            trial = x[rows].copy()
            trial[:, at] = begin + share * (best[at] - begin)
            found, now, there = driven.led(trial, goal, (*still, *chosen), tolerance)
            off |= ~there
            x[rows[~off]], left[rows[~off]] = driven.wrapped(found[~off]), now[~off]
        stuck = rows[off]
        if len(stuck):
            first = stuck[int(np.argmin(np.abs(x[stuck][:, at] - best[at]).sum(axis=1)))]
            lost |= set(stuck.tolist()) - ({int(first)} if off.all() else set())
    return lost
