"""Finite motion: where the loops stand for given joint values, and how they change.

Joint values q are zero in the given position; a link's displacement is the product of exponentials along the tree.
Source: Brockett's product of exponentials; Lynch and Park, chapter 4.
"""

from __future__ import annotations

import numpy as np

from dhcli.geometry import twists
from dhcli.geometry.twists import Array
from dhcli.mobility.model import Model, Step


def residual(model: Model, q: Array) -> tuple[Array, Array]:
    """How far the loops are from closing, and the world twists there.

    Args:
        model: The linkage.
        q: Joint values from the given position, shape (m,).

    Returns:
        The gaps of loops and ties, shape (rows,), and the twists of the motions, shape (m, 6).
    """
    moves = twists.displacements(model.twists, q)
    poses = np.empty((len(model.linkage.links), 4, 4))
    poses[0] = np.eye(4)
    before = np.empty_like(moves)
    for step, backwards in model.tree:
        if backwards:
            poses[step.tail] = poses[step.head] @ twists.inverse(_product(moves, step))
        else:
            poses[step.head] = poses[step.tail] @ _product(moves, step)
    for step in model.steps:
        pose = poses[step.tail]
        for k in range(step.first, step.last):
            before[k] = pose
            pose = pose @ moves[k]
    gaps = np.empty((len(model.chords), 6))
    for row, chord in enumerate(model.chords):
        gaps[row] = twists.deviation(poses[chord.tail] @ _product(moves, chord) @ twists.inverse(poses[chord.head]))
    return np.concatenate([(gaps @ model.basis.T).ravel(), model.ties @ q]), twists.carried(before, model.twists)


def _product(moves: Array, step: Step) -> Array:
    pose = np.eye(4)
    for k in range(step.first, step.last):
        pose = pose @ moves[k]
    return pose
