"""The second order test: may an instantaneous motion go on at all?

Along a motion q = q' t + ½ q" t², the loops close to second order only if the quadratic part of their equations lies in
the range of the Jacobian. Each vector w that the Jacobian cannot reach gives a quadratic form on the instantaneous
motions that must vanish. If a combination of these forms is definite, none of them can begin: the structure is shaky,
yet rigid. Source: Connelly and Whiteley 1996, prestress stability; here for loops of twists.
"""

from __future__ import annotations

import numpy as np

from dhcli.geometry.twists import Array, brackets
from dhcli.mobility.model import Model

ROUNDS = 400
ROUNDING = 1e-9
"""An eigenvalue above minus this is not negative in exact geometry."""

DRAWN, DRAWN_NEGATIVE = 10.0, 2.0
"""Entries of forms in a rounded drawing that count as zero, and negative eigenvalues that do, in tolerances."""

MOST_FORMS = 200
"""With more motions the forms are not looked at: their number of entries grows like the square."""

MOST_LOOKED_AT = 60
"""Forms that are looked at one by one."""

STEPS = 40
FINE = 1e-14
"""A form with a value below this vanishes: half the digits of the direction, where the zero is a double one."""

NEAR = 1e-8

MOST_DIRECTIONS = 4
MOST_PIECES = 4_000
FINEST = 1e-4
"""Pieces of a cube's face below this are near a common zero."""

CLEAR = 1e-6
"""A smallest eigenvalue above this, of forms scaled to 1, is no rounding."""


def quadratic_forms(model: Model, motions: Array, stresses: Array, twists: Array | None = None) -> Array:
    """The forms that must vanish, shape (c, k, k).

    Args:
        model: The linkage.
        motions: Basis of the instantaneous motions, shape (m, k).
        stresses: Basis of what the Jacobian cannot reach, shape (rows, c).
        twists: World twists in another position, shape (m, 6); those of the given one by default.
    """
    size = len(model.basis)
    found = np.zeros((stresses.shape[1], motions.shape[1], motions.shape[1]))
    for row in range(len(model.chords)):
        order, pairs = _pairs(model, row, twists)
        weights = (model.basis.T @ stresses[row * size : (row + 1) * size]).T
        mixed = np.tensordot(weights, pairs, (1, 2))
        found += motions[order].T @ mixed @ motions[order]
    return np.asarray(found + found.transpose(0, 2, 1)) / 2


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


def possible(forms: Array, least: float = CLEAR, negative: float = ROUNDING) -> Array:
    """Directions in which the forms may vanish, as orthonormal columns (k, r); the rest is stopped in second order.

    Where a combination of forms is at least nowhere negative, it vanishes on a subspace only. Each form by itself and
    the combination with the largest trace are looked at, again and again on what is left.

    Args:
        forms: Shape (c, k, k).
        least: Entries below this are zero as far as the forms are known.
        negative: An eigenvalue above minus this is not negative.
    """
    basis = np.eye(forms.shape[1])
    while basis.shape[1]:
        here = basis.T @ forms @ basis
        mixed = np.einsum("c,cab->ab", np.trace(here, axis1=1, axis2=2), here)
        for form in (*here[:MOST_LOOKED_AT], mixed / max(float(np.abs(here).max(initial=0.0)), least)):
            values, vectors = np.linalg.eigh(form)
            values, vectors = (values, vectors) if values[-1] > -values[0] else (-values[::-1], vectors[:, ::-1])
            if values[0] > -negative and values[-1] > least:
                basis = basis @ vectors[:, values <= least]
                break
        else:
            break
    return basis


def common_zero(forms: Array, start: Array) -> Array | None:
    """A direction near a given one in which all forms vanish, shape (k,); None if none is found.

    Where branches meet, each leaves along such a direction, and those who start elsewhere may all end on one branch.
    """
    found, best, least = start, start, np.inf
    for _ in range(STEPS):
        products = forms @ found
        values = products @ found
        size = float(np.abs(values).max(initial=0.0))
        if size < least:
            best, least = found, size
        if size < FINE:
            break
        step = np.linalg.lstsq(np.concatenate([2 * products, found[None, :]]), np.append(-values, 0.0), rcond=None)[0]
        found = (found + step) / np.linalg.norm(found + step)
    return best if least < NEAR else None


def cover(forms: Array) -> Array:
    """Directions near which alone all forms can vanish together, shape (n, k); none where they vanish nowhere.

    So none means that no motion begins. That is more than a definite combination can show: x² - y² and 2xy have none,
    and no common zero. The directions are the faces of a cube, halved again and again; a piece is left out when the
    forms' values in its middle exceed all by which they can change within it.
    """
    k = forms.shape[1]
    size = float(np.abs(forms).max(initial=0.0))
    centres = np.concatenate([np.insert(np.zeros((1, k - 1)), face, 1.0, axis=1) for face in range(k)])
    if size < CLEAR or k > MOST_DIRECTIONS:
        return centres
    scaled = forms / size
    largest = float(np.sqrt(np.sum(np.linalg.norm(scaled, 2, axis=(1, 2)) ** 2)))
    faces, half = np.arange(k, dtype=np.float64), 1.0
    while len(centres) and len(centres) < MOST_PIECES and half > FINEST:
        products = np.einsum("cab,nb->nca", scaled, centres)
        values = np.linalg.norm(np.einsum("nca,na->nc", products, centres), axis=1)
        reach = half * np.sqrt(k - 1)
        change = 2 * reach * np.linalg.norm(products, axis=(1, 2)) + reach**2 * largest
        maybe = values <= change + CLEAR
        half /= 2
        centres, faces = _halved(centres[maybe], faces[maybe], half)
    return np.asarray(centres / np.linalg.norm(centres, axis=1, keepdims=True))


def _halved(centres: Array, faces: Array, half: float) -> tuple[Array, Array]:
    """The pieces of half the size that some pieces of the cube's faces consist of; `faces` are the axes they face."""
    k = centres.shape[1]
    for axis, shift in enumerate(half * np.eye(k)):
        moves = faces != axis
        centres = np.concatenate([centres[~moves], centres[moves] - shift, centres[moves] + shift])
        faces = np.concatenate([faces[~moves], faces[moves], faces[moves]])
    return centres, faces


def size_of_curvature(model: Model, motions: Array, twists: Array | None) -> float:
    """The largest second order part of any loop's gap, which tells what is small for a form."""
    largest = 0.0
    for row in range(len(model.chords)):
        order, pairs = _pairs(model, row, twists)
        gaps = motions[order].T @ np.moveaxis(pairs, 2, 0) @ motions[order]
        largest = max(largest, float(np.abs(gaps).max(initial=0.0)))
    return largest


def _pairs(model: Model, row: int, twists: Array | None) -> tuple[list[int], Array]:
    """Second order part of a loop's gap, ½ Σ_{i<j} [ξ_i, ξ_j] q_i q_j in the order of the loop, shape (n, n, 6).

    Source: Baker-Campbell-Hausdorff, for a product of exponentials whose first order vanishes.
    """
    order, senses = loop_order(model, row)
    seen = senses[:, None] * (model.twists if twists is None else twists)[order]
    found = brackets(seen[:, None, :], seen[None, :, :]) / 2
    return order, np.asarray(np.triu(np.ones((len(order), len(order))), 1)[:, :, None] * found)


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
