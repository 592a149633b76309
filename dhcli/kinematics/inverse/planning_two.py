"""Finding two joints that two equations hold and nothing else."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, permutations
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.matrices import PARALLEL
from dhcli.kinematics.inverse.pairings import Cut, Loop, cuts
from dhcli.kinematics.inverse.rule_two import HALVES, roots
from dhcli.kinematics.inverse.steps import Two

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.arm import Array
    from dhcli.kinematics.inverse.samples import Samples

_VANISHES = 10 * PARALLEL
_MOST = 6
"""Equations of a pair of joints that are tried with each other."""

_FIRST = 4
"""Samples that are looked at first."""

_HITS = 1e-5
"""How near the true angle has to be to a root at the samples [rad]."""


def find_two(samples: Samples, loop: Loop, unknown: Sequence[int], missing: Sequence[int]) -> Two | None:
    """The best two equations in two joints, if there are two."""
    best: tuple[float, Two] | None = None
    for step, pairs in _pairs_of(samples, loop, unknown, missing):
        bar = _HITS if best is None else best[0] / 10
        error = _error(samples, step.joint, step.other, pairs, bar)
        if error < bar:
            best = error, step
    return None if best is None else best[1]


def other_two(samples: Samples, loop: Loop, unknown: Sequence[int], step: Two) -> Iterator[Two]:
    """Every two equations in two joints but those of a step."""
    missing = [j for j in unknown if j < samples.actions.arm.joints]
    for other, pairs in _pairs_of(samples, loop, unknown, missing):
        if other != step and _error(samples, other.joint, other.other, pairs, _HITS) < _HITS:
            yield other


def _pairs_of(
    samples: Samples, loop: Loop, unknown: Sequence[int], missing: Sequence[int]
) -> Iterator[tuple[Two, Array]]:
    """Two joints and two equations in them, with their coefficients at the samples, shape (N, 2, 3, 3)."""
    for joint, other in permutations(missing, 2):
        wanted = tuple(sorted((joint, other)))
        equations = list[tuple[Cut, int]]()
        rows = list["Array"]()
        for cut in cuts(len(samples.actions.arm.axes), unknown, wanted):
            tensor = loop.tensor(cut, (joint, other))
            sizes = np.abs(tensor).max(axis=(0, 2, 3))
            kept = [k for k in range(tensor.shape[1]) if sizes[k] > _VANISHES]
            equations += [(cut, k) for k in kept]
            rows += [tensor[:, k] for k in kept]
        for i, k in combinations(independent(rows)[:_MOST], 2):
            yield Two(joint, other, (equations[i], equations[k])), np.stack([rows[i], rows[k]], axis=1)


def independent(rows: Sequence[Array]) -> list[int]:
    """Which of some equations are no sums of the others, the plainest first."""
    if not rows:
        return []
    flat = np.array([row.reshape(-1) for row in rows])
    flat /= np.linalg.norm(flat, axis=1, keepdims=True)
    chosen = []
    for _ in range(min(flat.shape)):
        norms = np.linalg.norm(flat, axis=1)
        k = int(np.argmax(norms > norms.max() * 0.7))  # the first that is nearly the largest
        if norms[k] < _VANISHES:
            break
        chosen.append(k)
        unit = flat[k] / norms[k]
        flat -= np.outer(flat @ unit, unit)
    return chosen


def _error(samples: Samples, joint: int, other: int, pairs: Array, bar: float) -> float:
    """How far the true angle is from the nearest root, in the worst of the samples but one.

    A few samples that are no better than the bar are enough, for more of them only make it worse.
    """
    axes = samples.actions.arm.axes
    true = samples.values[:, joint]
    if not axes[joint].turns:
        pairs = np.einsum("nekj,ki->neij", pairs, HALVES)
        true = 2 * np.arctan(true)
    turns = axes[other].turns
    few, _ = _missed(pairs[:_FIRST], true[:_FIRST], turns=turns)
    if few >= bar:
        return few
    error, spread = _missed(pairs, true, turns=turns)
    # every root on the circle: the resultant vanishes
    return np.pi if np.sort(spread)[len(spread) // 2] >= 8 else error  # noqa: PLR2004


def _missed(pairs: Array, true: Array, *, turns: bool) -> tuple[float, NDArray[np.intp]]:
    """How far true angles are from the nearest root, in the worst case but one; how many roots each has."""
    at, angles = roots(pairs, turns=turns)
    gaps = np.abs(np.angle(np.exp(1j * (angles - true[at]))))
    nearest = np.full(len(true), np.pi)
    np.minimum.at(nearest, at, gaps)
    return float(np.sort(nearest)[-2]), np.bincount(at, minlength=len(true))
