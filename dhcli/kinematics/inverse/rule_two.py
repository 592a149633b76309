"""The rule TWO: a joint from two equations that hold one other joint, which a resultant eliminates."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.steps import Two

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.arm import Array, Flags, Ints

DEGREE = 4
"""Of the resultant in cosine and sine."""

_POINTS = 16
"""Where the resultant is evaluated: more than it has coefficients, a power of two."""

_NEAR_CIRCLE = 1e-2
"""Roots this close to the unit circle are tried; Newton's steps and the robot decide."""

_SPLIT = 1e-5
"""Two roots that are closer than this may be one that rounding has split."""

_SPLIT_WIDE = ((3, 2e-3), (5, 2e-2))
"""So may as many roots or more that are closer than this."""

_VANISHED = 1e-12
"""A resultant below this everywhere says nothing."""

_FAR = 1e6
"""A length beyond this many reaches is none."""

HALVES = np.array([[0.5, 0.5, 0.0], [0.0, 0.0, 0.5], [0.25, -0.25, 0.0]])
"""1, d and d²/2 by 1, c and s where d = tan(phi/2), all times (1 + c)/2."""

_LINEAR = 1e-9
"""A square of a length with a coefficient below this share of the largest does not occur."""


def eliminated(rows: Rows, step: Two) -> Rows:
    """Candidates with one joint more; the other joint of the equations follows by ONE."""
    axes = rows.actions.arm.axes
    if not len(rows):
        rows.known[step.joint] = np.empty(0), np.empty(0)
        return rows
    pairs = two_equations(rows, step)
    turns = axes[step.joint].turns
    pairs = pairs if turns else np.einsum("nekj,ki->neij", pairs, HALVES)
    at, angles = roots(pairs, turns=axes[step.other].turns)
    digit = np.arange(len(at)) - np.searchsorted(at, at)
    found = rows.take(at)
    found.path = found.path * 8 + digit
    found.loss = np.maximum(found.loss, 1e-12)
    c, s = np.cos(angles), np.sin(angles)
    if turns:
        found.known[step.joint] = c, s
        return found
    with np.errstate(divide="ignore", over="ignore"):
        length = s / (1 + c)
    usable = np.abs(length) < _FAR
    found, length = found.take(usable), length[usable]
    found.known[step.joint] = length, 0.5 * length * length
    return found


def silent(rows: Rows, step: Two) -> Flags:
    """Where the resultant vanishes whatever the joint, so that the equations say nothing of it."""
    pairs = two_equations(rows, step)
    axes = rows.actions.arm.axes
    pairs = pairs if axes[step.joint].turns else np.einsum("nekj,ki->neij", pairs, HALVES)
    return np.asarray(np.abs(_resultant(pairs, turns=axes[step.other].turns)).max(axis=1) < _VANISHED)


def two_equations(rows: Rows, step: Two) -> Array:
    """The coefficients of both equations in both joints, shape (N, 2, 3, 3)."""
    loop = rows.loop()
    tensors = {cut: loop.tensor(cut, (step.joint, step.other)) for cut, _ in step.equations}
    return np.stack([tensors[cut][:, k] for cut, k in step.equations], axis=1)


def roots(pairs: Array, *, turns: bool) -> tuple[Ints, Array]:
    """The angles at which two equations, linear in the cosine and sine of another joint, have a common solution.

    Args:
        pairs: Coefficients (N, 2, 3, 3) by 1, cosine and sine of this angle, and the same of the other; of a slide
            that is eliminated by 1, length and half its square.
        turns: Whether the other joint turns.

    Returns:
        The row and the angle of each root, sorted by row.
    """
    return unit_roots(_resultant(pairs, turns=turns))


def _resultant(pairs: Array, *, turns: bool) -> Array:
    """The values, at 16 angles, of what is 0 where two equations have a common solution, shape (N, 16)."""
    phi = 2 * np.pi * np.arange(_POINTS) / _POINTS
    basis = np.stack([np.ones(_POINTS), np.cos(phi), np.sin(phi)])
    values = np.einsum("nekj,kp->nepj", pairs, basis)
    (e1, a1, b1), (e2, a2, b2) = (np.moveaxis(values[:, k], 2, 0) for k in range(2))
    cosine, sine, det = b1 * e2 - e1 * b2, e1 * a2 - a1 * e2, a1 * b2 - b1 * a2
    if turns:
        return np.asarray(cosine**2 + sine**2 - det**2)
    if np.abs(pairs[..., 2]).max(initial=0) < _LINEAR * np.abs(pairs).max(initial=0):
        return np.asarray(e1 * a2 - a1 * e2)
    return np.asarray(2 * sine * det - cosine**2)


def unit_roots(values: Array) -> tuple[Ints, Array]:
    """The real angles at which trigonometric polynomials of degree 4 vanish, from their values at 16 points."""
    spectrum = np.fft.fft(values, axis=1) / _POINTS
    coefficients = np.concatenate([spectrum[:, -DEGREE:], spectrum[:, : DEGREE + 1]], axis=1)
    size = np.abs(coefficients).max(axis=1)
    usable = np.flatnonzero(size > 0)
    # counted from a turned zero, the leading coefficient is not small beside all others by accident of symmetry
    monic = coefficients[usable] / size[usable, None]
    degree = 2 * DEGREE
    lead = np.where(np.abs(monic[:, -1]) < 1e-14, 1e-14, monic[:, -1])  # noqa: PLR2004
    companion = np.zeros((len(usable), degree, degree), dtype=complex)
    companion[:, range(1, degree), range(degree - 1)] = 1
    companion[:, :, -1] = -monic[:, :-1] / lead[:, None]
    z = np.linalg.eigvals(companion)
    real = np.abs(np.abs(z) - 1) < _NEAR_CIRCLE
    which, k = np.nonzero(real)
    angles = np.angle(z[which, k])
    row, middle = _middles(z, real)
    if len(row):
        which, angles = np.concatenate([which, row]), np.concatenate([angles, middle])
        order = np.argsort(which, kind="stable")
        which, angles = which[order], angles[order]
    return usable[which].astype(np.int64), angles


def _middles(z: NDArray[Any], real: Flags) -> tuple[Ints, Array]:
    """Where roots stand that rounding has split: a double one by the root of its size, a fourfold one by its fourth.

    Between those it was split into stands the one that equations may vanish at, far more exact than they are.

    Args:
        z: Roots, shape (N, 8).
        real: Which of them are near the circle, shape (N, 8).

    Returns:
        The row and the angle of each.
    """
    apart = np.where(real[:, :, None] & real[:, None], np.abs(z[:, :, None] - z[:, None]), np.inf)
    row, i, k = np.nonzero(np.triu(apart < _SPLIT, 1))
    rows, middles = [row], [z[row, i] + z[row, k]]
    for fewest, width in _SPLIT_WIDE:
        near = apart < width
        many, first = np.nonzero((near.sum(axis=2) >= fewest) & (near.argmax(axis=2) == np.arange(z.shape[1])))
        rows.append(many)
        middles.append(np.einsum("nk,nk->n", near[many, first], z[many]))
    return np.concatenate(rows), np.angle(np.concatenate(middles))
