"""The rule ALL: three joints at once, when no two equations hold two joints alone.

The point and direction of an axis carried by three joints stand against what two joints and the pose make of them:
fourteen equations. The two joints are eliminated linearly, which leaves six; multiplied by the tangent of half of one
angle they are twelve in twelve monomials of two half tangents, with coefficients quadratic in the third: an eigenvalue
problem of size 24, whose real eigenvalues give the third joint, and whose eigenvectors the other two.

Source: M. Raghavan and B. Roth, Inverse kinematics of the general 6R manipulator and related linkages, J. Mechanical
Design 115, 1993; D. Manocha and J. Canny, Efficient inverse kinematics for general 6R manipulators, IEEE Trans.
Robotics and Automation 10, 1994.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.motions import SIZES
from dhcli.kinematics.inverse.pairings import Loop
from dhcli.kinematics.inverse.polishing import spread
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.rule_two import HALVES
from dhcli.kinematics.inverse.steps import All

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags, Ints

TANGENTS = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 2.0], [1.0, -1.0, 0.0]])
"""1, t and t² by 1, c and s where t = tan(phi/2), all over 1 + t²."""

_REAL = 1e-2
"""Eigenvalues whose imaginary part is below this share are tried; Newton's steps and the robot decide."""

_ALIKE = 1e-6
"""Half tangents that are so near to each other, in shares of 1 or of their size, may be one that comes twice."""

_SPLIT = 2e-3
"""Roots whose three angles are all closer than this may be one that rounding has split."""

_SHARE = 0.3782
"""With which share of the other each of two tangents is told from those of other roots."""

_BLOCK = 512
"""Poses at a time: a pencil of each is held in memory."""

_FAR = 1e6

EQUATIONS = 6
"""How many are left."""

_TRIED = (0.3718, -1.2913)
"""Half tangents of the third joint that are hardly ever those of a root."""

_SINGULAR = 1e-9
"""A singular value of a pencil that is smaller [of equations of size 1] is zero."""


def all_at_once(rows: Rows, step: All) -> Rows:
    """Candidates with three joints more."""
    found = Rows.start(rows.actions, np.empty((0, 4, 4)), {})
    found = rows.take(np.arange(0))
    for joint in step.joints:
        found.known[joint] = np.empty(0), np.empty(0)
    for first in range(0, len(rows), _BLOCK):
        found = _block(rows.take(np.arange(first, min(first + _BLOCK, len(rows)))), step).joined(found)
    return found


def _block(rows: Rows, step: All) -> Rows:
    three, two = sides(rows.loop(), step)
    at, angles = solved(three[:, list(step.rows)], two[:, list(step.rows)], step.turn, _turning(rows, step))
    digit = np.arange(len(at)) - np.searchsorted(at, at)
    found = rows.take(at)
    found.path = found.path * 64 + digit
    found.loss = np.maximum(found.loss, 1e-10)
    usable = np.ones(len(at), dtype=bool)
    for joint, angle, turns in zip(step.joints, angles, _turning(rows, step), strict=True):
        if turns:
            found.known[joint] = np.cos(angle), np.sin(angle)
        else:
            with np.errstate(divide="ignore", over="ignore"):
                length = np.tan(angle / 2)
            usable &= np.abs(length) < _FAR
            found.known[joint] = length, 0.5 * length * length
    return found if usable.all() else found.take(usable)


def degenerate(rows: Rows, step: All) -> Flags:
    """Where the equations left depend on each other whatever the third joint, so that they say nothing of it.

    So it is at some poses at right angles, with whichever of the three joints for the third; other three serve there.
    """
    three, two = sides(rows.loop(), step)
    chosen = list(step.rows)
    system = _left(three[:, chosen], two[:, chosen], len(rows))
    last, middle, lead = _pencil(system, step.turn, _turning(rows, step))
    found = np.ones(len(rows), dtype=bool)
    for t in _TRIED:
        at = np.flatnonzero(found)
        sizes = np.linalg.svd(last[at] + t * middle[at] + t * t * lead[at], compute_uv=False)
        found[at] = sizes[:, -1] < _SINGULAR
    return found


def _turning(rows: Rows, step: All) -> list[bool]:
    return [rows.actions.arm.axes[joint].turns for joint in step.joints]


def sides(loop: Loop, step: All) -> tuple[Array, Array]:
    """Both sides of the equations, shapes (N, m, 3, 3, 3) and (N, m, 3, 3)."""
    three, two = [], []
    for kind, things in step.things:
        x, y = np.array(things).T, np.eye(SIZES[kind])
        three.append(loop.walked(kind, x, y, step.three[0], step.joints, back=step.three[1]))
        two.append(loop.walked(kind, x, y, step.two[0], step.others, back=step.two[1]))
    return _stacked(three), _stacked(two)


def _stacked(parts: list[Array]) -> Array:
    count = max(len(part) for part in parts)
    return np.concatenate([np.broadcast_to(part, (count, *part.shape[1:])) for part in parts], axis=1)


def solved(three: Array, two: Array, turn: tuple[float, ...], turning: list[bool]) -> tuple[Ints, list[Array]]:
    """The angles of the three joints from both sides of the equations; of a slide twice the arc tangent of its length.

    Returns:
        The row of each root, sorted, and the angles of the three joints.
    """
    count = max(len(three), len(two))
    pencil = _pencil(_left(three, two, count), turn, turning)
    values, vectors = _eigen(pencil)
    real = np.abs(values.imag) <= _REAL * (1 + np.abs(values.real))
    real &= np.isfinite(values.real)
    at, k = np.nonzero(real)
    t = values[at, k]
    vector = vectors[at, :, k]
    # an eigenvector is (w, t w): its larger half is the better one
    w = np.where((np.abs(t) > 1)[:, None], vector[:, 12:], vector[:, :12]).reshape(-1, 4, 3)
    w = _parted(at, t.real, w)
    here = np.arange(len(w))
    i, j = np.unravel_index(np.abs(w[:, :3]).reshape(len(w), 9).argmax(axis=1), (3, 3))
    with np.errstate(divide="ignore", invalid="ignore"):
        r = w[here, i + 1, j] / w[here, i, j]
        i, j = np.unravel_index(np.abs(w[:, :, :2]).reshape(len(w), 8).argmax(axis=1), (4, 2))
        s = w[here, i, j + 1] / w[here, i, j]
    tangents = (np.nan_to_num(part.real, nan=0.0, posinf=1e9, neginf=-1e9) for part in (t, r, s))
    angles = np.stack([2 * np.arctan(part) + zero for part, zero in zip(tangents, turn, strict=True)])
    more, middles = _middles(at, angles)
    if len(more):
        at, angles = np.concatenate([at, more]), np.concatenate([angles, middles], axis=1)
        order = np.argsort(at, kind="stable")
        at, angles = at[order], angles[:, order]
    return at.astype(np.int64), list(angles)


def _middles(at: Ints, angles: Array) -> tuple[Ints, Array]:
    """What stands in the middle of roots that may be one which rounding has split, far more exact than they are.

    Args:
        at: The row of each root, sorted.
        angles: The three angles of each, shape (3, M).

    Returns:
        The row and the angles, shape (3, K), of each.
    """
    rows = list[int]()
    found = [np.empty((3, 0))]
    order = np.lexsort((angles[0], at))
    close = (np.diff(at[order]) == 0) & (np.diff(angles[0, order]) < _SPLIT)
    for row in np.unique(at[order][1:][close]).tolist():
        own = angles[:, at == row]
        gaps = own[:, :, None] - own[:, None]
        gaps -= 2 * np.pi * np.round(gaps / (2 * np.pi))
        near = np.abs(gaps).max(axis=0) < _SPLIT
        first = np.flatnonzero((near.sum(axis=1) > 1) & (near.argmax(axis=1) == np.arange(len(near))))
        rows += [row] * len(first)
        found += [(own[:, k] - gaps[:, k, near[k]].mean(axis=1))[:, None] for k in first]
    return np.array(rows, dtype=np.int64), np.concatenate(found, axis=1)


def _parted(at: Ints, t: Array, w: Array) -> Array:
    """Eigenvectors of which each belongs to one root, where several roots have the third joint in common.

    Those of an eigenvalue that comes several times may be any mixtures of the powers of r and s of its roots. To
    multiply one power by r or by s is to go on to the next, which no mixture does: what does it to all that they span
    has the unmixed ones for eigenvectors.

    Args:
        at: The row of each root.
        t: The half tangent of the third joint.
        w: Powers of r and s of the other two, mixed, shape (M, 4, 3).
    """
    order = np.lexsort((t, at))
    gap = np.abs(np.diff(t[order])) <= _ALIKE * (1 + np.abs(t[order][1:]))
    runs = np.flatnonzero(~((np.diff(at[order]) == 0) & gap)) + 1
    if len(runs) + 1 >= len(order):
        return w
    w = w.astype(complex)
    for run in np.split(order, runs):
        if len(run) > 1:
            span = np.moveaxis(w[run], 0, -1)
            by_r, by_s = (_carrying(span[:-1], span[1:]), _carrying(span[:, :-1], span[:, 1:]))
            w[run] = np.moveaxis(span @ np.linalg.eig(by_r + _SHARE * by_s)[1], -1, 0)
    return w


def _carrying(powers: Array, following: Array) -> Array:
    """The square matrix that leads from some powers to those that follow them."""
    count = powers.shape[-1]
    return np.asarray(np.linalg.lstsq(powers.reshape(-1, count), following.reshape(-1, count), rcond=1e-9)[0])


def _left(three: Array, two: Array, count: int) -> Array:
    """What is left of the equations when the two joints are eliminated, shape (N, 6, 3, 3, 3)."""
    flat = two.reshape(len(two), two.shape[1], 9)
    total = np.broadcast_to(three, (count, *three.shape[1:])).copy()
    total[:, :, 0, 0, 0] -= flat[:, :, 0]
    orthogonal, triangle = np.linalg.qr(flat[:, :, 1:], mode="complete")
    null = _combined(orthogonal[:, :, 8:])
    sizes = np.abs(np.diagonal(triangle, axis1=1, axis2=2)).min(axis=1)
    for k in np.flatnonzero(sizes < _SINGULAR).tolist():  # at some poses at right angles more equations are left
        whole, size, _ = np.linalg.svd(flat[k, :, 1:])
        null[k] = _combined(whole[:, np.count_nonzero(size > _SINGULAR) :])
    result = null.transpose(0, 2, 1) @ total.reshape(count, total.shape[1], 27)
    return np.asarray(result.reshape(count, -1, 3, 3, 3))


def _combined(null: Array) -> Array:
    """As many columns as equations are needed, shape (..., m, 6), of all that there are."""
    count = null.shape[-1]
    return null if count == EQUATIONS else null @ (spread(count, EQUATIONS, 3) - 0.5)


def _pencil(system: Array, turn: tuple[float, ...], turning: list[bool]) -> Array:
    """Three matrices of each row, the coefficients of 1, t and t², shape (3, N, 12, 12)."""
    for axis, (zero, turns) in enumerate(zip(turn, turning, strict=True), 2):
        c, s = np.cos(zero), np.sin(zero)
        change = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
        change = change if turns else HALVES @ change
        system = np.moveaxis(np.moveaxis(system, axis, -1) @ (change @ TANGENTS.T), -1, axis)
    count, equations = system.shape[:2]
    result = np.zeros((3, count, 2 * equations, 4, 3))
    turned = system.transpose(2, 0, 1, 3, 4)
    result[:, :, :equations, :3] = turned
    result[:, :, equations:, 1:] = turned
    scale = np.abs(result).max(axis=(0, 3, 4), keepdims=True)
    return np.asarray((result / np.where(scale > 0, scale, 1)).reshape(3, count, 2 * equations, 12))


def _eigen(pencil: Array) -> tuple[Array, Array]:
    """Eigenvalues and eigenvectors of `C + t B + t² A`."""
    last, middle, lead = pencil
    size = last.shape[1]
    try:
        both = np.linalg.solve(lead, np.concatenate([last, middle], axis=2))
    except np.linalg.LinAlgError:
        lead = lead + 1e-12 * (spread(size, size, 1) - 0.5)
        both = np.linalg.solve(lead, np.concatenate([last, middle], axis=2))
    both = np.nan_to_num(both, nan=0.0, posinf=1e200, neginf=-1e200)
    companion = np.zeros((len(last), 2 * size, 2 * size))
    companion[:, range(size), range(size, 2 * size)] = 1
    companion[:, size:] = -both
    return np.linalg.eig(companion)
