"""The second order test: may an instantaneous motion go on at all?

Along a motion q = q' t + ½ q" t², the loops close to second order only if the quadratic part of their equations lies in
the range of the Jacobian. Each vector w that the Jacobian cannot reach gives a quadratic form on the instantaneous
motions that must vanish. If a combination of these forms is definite, none of them can begin: the structure is shaky,
yet rigid. Source: Connelly and Whiteley 1996, prestress stability; here for loops of twists.
"""

from __future__ import annotations

import numpy as np

from dhcli.geometry import twists
from dhcli.geometry.twists import Array
from dhcli.mobility.model import Model

ROUNDS = 400
CLEAR = 1e-6
"""A smallest eigenvalue above this, of forms scaled to 1, is no rounding."""


def quadratic_forms(model: Model, motions: Array, stresses: Array) -> Array:
    """The forms that must vanish, shape (c, k, k).

    Args:
        model: The linkage.
        motions: Basis of the instantaneous motions, shape (m, k).
        stresses: Basis of what the Jacobian cannot reach, shape (rows, c).
    """
    size = len(model.basis)
    found = np.zeros((stresses.shape[1], motions.shape[1], motions.shape[1]))
    for row in range(len(model.chords)):
        curvature = _curvature(model, row, motions) @ model.basis.T
        found += np.einsum("abi,ic->cab", curvature, stresses[row * size : (row + 1) * size])
    return found


def proves_rigid(forms: Array) -> bool:
    """Whether a combination of the forms is definite.

    The search is a perceptron: while some direction makes the combination zero or less, its values are added.
    """
    size = float(np.abs(forms).max(initial=0.0))
    if size < CLEAR:
        return False
    scaled = forms / size
    weights = np.trace(scaled, axis1=1, axis2=2)
    for _ in range(ROUNDS):
        norm = float(np.linalg.norm(weights))
        mixed = np.einsum("c,cab->ab", weights / norm, scaled) if norm > 0 else np.zeros(forms.shape[1:])
        values, vectors = np.linalg.eigh(mixed)
        if values[0] > CLEAR or values[-1] < -CLEAR:
            return True
        values_there = np.einsum("a,cab,b->c", vectors[:, 0], scaled, vectors[:, 0])
        if float(np.linalg.norm(values_there)) < CLEAR:
            return False  # here all forms vanish: no combination can be definite
        weights = weights / max(norm, 1.0) + values_there
    return False


def _curvature(model: Model, row: int, motions: Array) -> Array:
    """Second order part of a loop's gap, ½ Σ_{i<j} [ξ_i, ξ_j] q_i q_j in the order of the loop, shape (k, k, 6).

    Source: Baker-Campbell-Hausdorff, for a product of exponentials whose first order vanishes.
    """
    order, senses = loop_order(model, row)
    moving = (senses[:, None] * model.twists[order])[:, None, :] * motions[order][:, :, None]
    before = np.cumsum(moving, axis=0) - moving
    found = twists.brackets(before[:, :, None, :], moving[:, None, :, :]).sum(axis=0) / 2
    return np.asarray(found + found.transpose(1, 0, 2)) / 2


def loop_order(model: Model, row: int) -> tuple[list[int], Array]:
    """The motions that a loop runs through, in order, with their senses."""
    chord, signs = model.chords[row], model.signs[row]
    there = [k for k in _path(model, chord.tail) if signs[k]]
    back = [k for k in reversed(_path(model, chord.head)) if signs[k]]
    order = [*there, *range(chord.first, chord.last), *back]
    return order, signs[order]


def _path(model: Model, link: int) -> list[int]:
    """The motions from the ground to a link, in order."""
    found: list[int] = []
    for step, backwards in reversed(model.tree):
        if (step.tail if backwards else step.head) == link:
            inside = range(step.first, step.last)
            found += inside if backwards else reversed(inside)
            link = step.head if backwards else step.tail
    return found[::-1]
