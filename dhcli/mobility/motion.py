"""Finite motion: where the loops stand for given joint values, and how they change.

Joint values q are zero in the given position; a link's displacement is the product of exponentials along the tree.
Source: Brockett's product of exponentials; Lynch and Park, chapter 4.
"""

from __future__ import annotations

import numpy as np

from dhcli.geometry import twists
from dhcli.geometry.twists import Array
from dhcli.mobility.model import Model


def residual(model: Model, q: Array) -> tuple[Array, Array]:
    """How far the loops are from closing, and the world twists there.

    Args:
        model: The linkage.
        q: Joint values from the given position, shape (m,).

    Returns:
        The gaps of loops and ties, shape (rows,), and the twists of the motions, shape (m, 6).
    """
    moves = twists.displacements(model.twists, q)
    before, across = _within(model, moves)
    back = twists.inverse(across)
    poses = np.empty((len(model.linkage.links), 4, 4))
    poses[0] = np.eye(4)
    for step, backwards in model.tree:
        place = model.places[step.joint]
        if backwards:
            poses[step.tail] = poses[step.head] @ back[place]
        else:
            poses[step.head] = poses[step.tail] @ across[place]
    closing = [model.places[chord.joint] for chord in model.chords]
    tails, heads = model.ends[closing, 0], model.ends[closing, 1]
    gaps = twists.deviations(poses[tails] @ across[closing] @ twists.inverse(poses[heads]))
    carriers = np.repeat(poses[model.ends[:, 0]], model.ends[:, 3], axis=0)
    return np.concatenate([(gaps @ model.basis.T).ravel(), model.ties @ q]), twists.carried(
        carriers @ before, model.twists
    )


def _within(model: Model, moves: Array) -> tuple[Array, Array]:
    """Displacements within each joint: those before each of its motions, (m, 4, 4), and the whole, (steps, 4, 4)."""
    before = np.empty_like(moves)
    across = np.tile(np.eye(4), (len(model.steps), 1, 1))
    firsts, counts = model.ends[:, 2], model.ends[:, 3]
    for k in range(int(counts.max(initial=0))):
        (longer,) = np.nonzero(counts > k)
        before[firsts[longer] + k] = across[longer]
        across[longer] = across[longer] @ moves[firsts[longer] + k]
    return before, across
