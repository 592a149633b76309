"""Poses in which the chosen equations of a joint vanish: all are asked then, and the joint may turn out to be free."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.roots import STRAY, known_as, pair, slides
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.steps import One

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

FREE = 50.0
"""Coefficients below this many times the rounding are zero."""

DIM = 1e-6
"""Below this the second direction of the equations is too faint to tell the two roots of the first apart."""

UNSURE = 1e4
"""Coefficients below this many times the rounding leave the joint so uncertain that it is tried as a free one too."""

MOST = 1e-5
"""No coefficient above this is zero, unless next to nothing is certain."""

UNKNOWN = 1e-2
"""Coefficients below this part of the rounding are zero in any case."""

_CONTRADICTS = 1e-5
"""A constant above this in an equation without unknown is a contradiction."""


@frozen
class Directions:
    """All equations of rows in the two numbers of a joint, by the directions that these tell apart (an SVD).

    Attributes:
        joint: The joint.
        turns: Whether the two numbers are cosine and sine; else a length and half its square.
        sizes: How much is said of each direction, the most first, shape (N, 2).
        ways: The directions, shape (N, 2, 2).
        constants: What the two numbers have along each, times how much is said, shape (N, 2).
    """

    joint: int
    turns: bool
    sizes: Array
    ways: Array
    constants: Array

    def take(self, at: Flags) -> Directions:
        """Those of some rows."""
        return Directions(self.joint, self.turns, self.sizes[at], self.ways[at], self.constants[at])


def from_all(rows: Rows, step: One, draws: Array) -> Rows:
    """Candidates with one joint more, from every equation there is in it."""
    loop = rows.loop()
    tensor = np.concatenate([loop.tensor(cut, (step.joint,)) for cut in step.cuts], axis=1)
    if tensor.shape[1] == 1:  # one equation gives one of two numbers
        tensor = np.concatenate([tensor, np.zeros_like(tensor)], axis=1)
    left, sizes, ways = np.linalg.svd(tensor[:, :, 1:], full_matrices=False)
    constants = -np.einsum("nmk,nm->nk", left, tensor[:, :, 0])
    said = Directions(step.joint, rows.actions.arm.axes[step.joint].turns, sizes, ways, constants)
    most = np.maximum(MOST, UNKNOWN * rows.loss)
    zero = np.minimum(FREE * rows.loss, most)
    free = sizes[:, 0] < zero
    dim = ~free & (sizes[:, 1] < np.maximum(zero, DIM * sizes[:, 0]))
    clear = ~free & ~dim
    found = _clear(rows.take(clear), said.take(clear)).joined(_dim(rows.take(dim), said.take(dim)))
    free |= sizes[:, 0] < np.minimum(UNSURE * rows.loss, most)
    free &= np.abs(tensor[:, :, 0]).max(axis=1) < np.maximum(_CONTRADICTS, FREE * rows.loss)
    return found.joined(_free(rows.take(free), step.joint, draws, turns=said.turns))


def _clear(rows: Rows, said: Directions) -> Rows:
    """Where the equations give both numbers."""
    u, v = np.einsum("nk,nkj->jn", said.constants / said.sizes, said.ways)
    rows.loss = rows.loss / np.minimum(said.sizes[:, 1], 1)
    if not said.turns:
        return known_as(rows, said.joint, u, 0.5 * u * u)
    h = np.hypot(u, v)
    near = np.abs(h - 1) < STRAY
    return known_as(rows.take(near), said.joint, u[near] / h[near], v[near] / h[near])


def _dim(rows: Rows, said: Directions) -> Rows:
    """Where they give one equation of the two numbers."""
    size, (a, b), e = said.sizes[:, 0], said.ways[:, 0].T, said.constants[:, 0] / said.sizes[:, 0]
    rows.loss = rows.loss / np.minimum(size, 1)
    if said.turns:
        return pair(rows, said.joint, a, b, e)
    linear = np.abs(b) < DIM
    d = e[linear] / a[linear]
    found = known_as(rows.take(linear), said.joint, d, 0.5 * d * d)
    e, a, b = e[~linear], a[~linear], b[~linear]
    return found.joined(slides(rows.take(~linear), said.joint, -e / b, a / b))


def _free(rows: Rows, joint: int, draws: Array, *, turns: bool) -> Rows:
    """Where nothing is said of the joint: each of the values to try."""
    count, tried = len(rows), draws.shape[-1]
    many = rows.take(np.repeat(np.arange(count), tried))
    values = np.tile(draws, count)
    many.free = many.free | (1 << joint)
    many.draw = many.draw * tried + np.tile(np.arange(tried), count)
    if turns:
        return known_as(many, joint, np.cos(values), np.sin(values))
    return known_as(many, joint, values, 0.5 * values * values)
