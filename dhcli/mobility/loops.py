"""λ of each loop: in which space it really moves, by the Lie closure of its twists.

All motions that a loop can reach are products of its joints' motions; their twists span the smallest space that is
closed under the bracket. It has 1, 2, 3, 4 or 6 dimensions: a planar loop in space has three equations, not six.

Source: Hervé 1978; Rico, Gallardo and Ravani 2003.
"""

from __future__ import annotations

import numpy as np

from dhcli.geometry.rank import TIGHT, orthonormal
from dhcli.geometry.twists import Array, brackets
from dhcli.mobility.model import Model

MOST_LINKS = 150
"""With more links the loops of the spanning tree are taken as they are."""


def closure(twists: Array, tolerance: float = TIGHT) -> int:
    """The dimension of the Lie closure of some twists, shape (k, 6)."""
    span = orthonormal(twists.T, tolerance).T
    while 0 < len(span) < 6:  # noqa: PLR2004  a closed space has 1, 2, 3, 4 or 6 dimensions
        pairs = brackets(span[:, None, :], span[None, :, :]).reshape(-1, 6)
        wider = orthonormal(np.concatenate([span, pairs]).T, tolerance).T
        if len(wider) == len(span):
            break
        span = wider
    return len(span)


def lambdas(model: Model, tolerance: float = TIGHT) -> tuple[int, ...]:
    """λ of each loop of the spanning tree."""
    return tuple(closure(model.twists[row != 0], tolerance) for row in model.signs)


def shortest_lambdas(model: Model, tolerance: float) -> tuple[int, ...]:
    """λ of each loop of a basis of short loops, which a person would choose; see `short_loops`."""
    if len(model.linkage.links) > MOST_LINKS:
        return lambdas(model, tolerance)
    found = []
    for loop in short_loops(model):
        inside = [k for i in loop for k in range(model.steps[i].first, model.steps[i].last)]
        found.append(closure(model.twists[inside], tolerance))
    return tuple(found)


def short_loops(model: Model) -> list[tuple[int, ...]]:
    """A basis of the loops of the joint graph, the shortest first, each as indices into `model.steps`.

    Source: Horton 1987, a minimum cycle basis: one candidate for each link and each joint, chosen greedily.
    """
    wanted = len(model.chords)
    candidates: dict[int, int] = {}
    for link in range(len(model.linkage.links)):
        masks = _paths(model, link)
        for i, step in enumerate(model.steps):
            mask = masks[step.tail] ^ masks[step.head] ^ (1 << i)
            if mask:
                candidates[mask] = mask.bit_count()
    chosen: list[int] = []
    reduced: dict[int, int] = {}
    for mask in sorted(candidates, key=lambda m: (candidates[m], m)):
        rest = mask
        while rest and (top := rest.bit_length()) in reduced:
            rest ^= reduced[top]
        if rest:
            reduced[rest.bit_length()] = rest
            chosen.append(mask)
        if len(chosen) == wanted:
            break
    return [tuple(i for i in range(len(model.steps)) if mask >> i & 1) for mask in chosen]


def _paths(model: Model, root: int) -> list[int]:
    """The joints on a shortest path from one link to every other, as bits."""
    touching: list[list[tuple[int, int]]] = [[] for _ in model.linkage.links]
    for i, step in enumerate(model.steps):
        touching[step.tail].append((i, step.head))
        touching[step.head].append((i, step.tail))
    masks = {root: 0}
    waiting = [root]
    for link in waiting:
        for i, other in touching[link]:
            if other not in masks:
                masks[other] = masks[link] | 1 << i
                waiting.append(other)
    return [masks[link] for link in range(len(model.linkage.links))]
