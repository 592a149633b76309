"""Finding three joints that fourteen equations give."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.motions import CIRCLE, POINT
from dhcli.kinematics.inverse.pairings import GOAL, Loop
from dhcli.kinematics.inverse.planning_two import independent
from dhcli.kinematics.inverse.rule_all import EQUATIONS, sides, solved
from dhcli.kinematics.inverse.steps import All, Two

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array
    from dhcli.kinematics.inverse.matrices import Actions
    from dhcli.kinematics.inverse.samples import Samples

_TURN = (0.7316, -1.2173, 2.0411)
"""Where the three angles are counted from: any values that no robot's drawing would choose."""

_FEWEST = 5
_MOST = 6
"""Joints and free motions that may be unknown."""

_GOOD = 1e-8
_BAD = 1e-3
"""How near to the true values the roots have to be, in the median of the samples [rad]."""

_TRIALS = 40
"""Ways to arrange the joints that are tried until one is good."""

_ELIMINATED = 8
"""Monomials of the two joints."""


def find_all(samples: Samples, loop: Loop, unknown: Sequence[int]) -> All | None:
    """The best way to take three joints at once, if five or six are unknown."""
    best: tuple[float, All] | None = None
    if not _FEWEST <= len(unknown) <= _MOST:
        return None
    for trial, step in enumerate(_arrangements(samples.actions, unknown)):
        if trial == _TRIALS or (best is not None and best[0] < _GOOD):
            break
        ready = _rows(loop, step)
        if ready is None:
            continue
        error = _error(samples, *ready)
        if error < _BAD and (best is None or error < best[0]):
            best = error, ready[0]
    return None if best is None else best[1]


def other_three(samples: Samples, loop: Loop, unknown: Sequence[int], step: Two | All) -> Iterator[All]:
    """Ways to take three joints at once, each other three or against other two; not those of a step."""
    if not _FEWEST <= len(unknown) <= _MOST:
        return
    seen = {_parts(step)} if isinstance(step, All) else set()
    for other in _arrangements(samples.actions, unknown):
        if _parts(other) not in seen:
            seen.add(_parts(other))
            if (ready := _made_ready(samples, loop, other)) is not None:
                yield ready


def _made_ready(samples: Samples, loop: Loop, step: All) -> All | None:
    """A way to take three joints at once with its equations, if it finds them; in whichever order."""
    for a, b, c in permutations(step.joints):
        ready = _rows(loop, replace(step, joints=(a, b, c)))
        if ready is None:
            return None
        if _error(samples, *ready) < _BAD:
            return ready[0]
    return None


def _parts(step: All) -> tuple[frozenset[int], frozenset[int]]:
    return frozenset(step.joints), frozenset(step.others)


def _arrangements(actions: Actions, unknown: Sequence[int]) -> Iterator[All]:
    """Every way to choose what is carried, where the loop is cut, and which joint becomes the eigenvalue."""
    count = len(actions.arm.axes)
    carried = list(reversed(unknown)) if len(unknown) == _MOST else [count]
    for joint in carried:
        things = _things(actions, joint, count)
        walk = (*range(joint - 1, -1, -1), GOAL, *range(count - 1, joint, -1))
        met = [k for k, j in enumerate(walk) if j in unknown]
        for size in (3, 2):
            cut = met[size]
            left, right = walk[:cut], tuple(reversed(walk[cut:]))
            three, two = ((left, False), (right, True)) if size == 3 else ((right, True), (left, False))  # noqa: PLR2004
            own = [j for j in three[0] if j in unknown]
            others = [j for j in two[0] if j in unknown]
            for order in permutations(reversed(own)):
                yield All(order, (others[0], others[1]), things, three, two, (), _TURN)


def _things(actions: Actions, joint: int, count: int) -> tuple[tuple[int, tuple[tuple[float, ...], ...]], ...]:
    """What a joint leaves fixed; a point with a direction anywhere, where every joint is met."""
    if joint < count:
        return tuple((kind, tuple(map(tuple, actions.fixed(kind, (joint,)).tolist()))) for kind in (POINT, CIRCLE))
    p, along = np.array([0.31, -0.23, 0.17]), np.array([0.36, 0.48, 0.8])
    point = (1.0, *p.tolist(), float(p @ p) / 2)
    circle = (*along, p @ along, *np.cross(p, along), *(p * (p @ along) - along * (p @ p) / 2))
    return (POINT, (point,)), (CIRCLE, (tuple(map(float, circle)),))


def _rows(loop: Loop, step: All) -> tuple[All, tuple[Array, Array]] | None:
    """The step with its independent equations, and their two sides; None where they are too few."""
    three, two = sides(loop, step)
    count = max(len(three), len(two))
    flat = np.concatenate(
        [
            np.broadcast_to(side.reshape(len(side), side.shape[1], -1), (count, side.shape[1], width))
            for side, width in ((three, 27), (two, 9))
        ],
        axis=2,
    )
    alive = [k for k in range(flat.shape[1]) if np.abs(flat[:, k]).max() > 1e-7 and _meets(three, two, k)]  # noqa: PLR2004
    chosen = [alive[k] for k in independent([flat[:, k] for k in alive])]
    if len(chosen) < _ELIMINATED + EQUATIONS:
        return None
    made = All(step.joints, step.others, step.things, step.three, step.two, tuple(chosen), step.turn)
    return made, (three[:, chosen], two[:, chosen])


def _meets(three: Array, two: Array, k: int) -> bool:
    """Whether an equation holds any of the joints."""
    sides_of = (three[:, k].reshape(len(three), -1)[:, 1:], two[:, k].reshape(len(two), -1)[:, 1:])
    return bool(max(np.abs(side).max() for side in sides_of) > 1e-9)  # noqa: PLR2004


def _error(samples: Samples, step: All, both: tuple[Array, Array]) -> float:
    axes = samples.actions.arm.axes
    turning = [axes[j].turns for j in step.joints]
    at, angles = solved(*both, step.turn, turning)
    true = samples.values[:, step.joints]
    true = np.where(turning, true, 2 * np.arctan(true))
    gaps = np.array([np.abs(np.angle(np.exp(1j * (a - t)))) for a, t in zip(angles, true[at].T, strict=True)])
    nearest = np.full(len(true), np.pi)
    np.minimum.at(nearest, at, gaps.max(axis=0))
    return float(np.sort(nearest)[len(nearest) // 2])
