"""The family of motions through a landing: its dimension, and the tangents that tell how the output link moves.

The rank may be constant along a branch and yet leave more than its dimension: equal parallel legs let a platform turn
about their direction for an instant, wherever it stands. So the tangents are tested: to second order, by the quadratic
forms of `second_order`, and by small displacements. A set of dimension d meets d general conditions near one of its
points, and not d + 1.
"""

from __future__ import annotations

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.rank import orthonormal, spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.draws import Draws
from dhcli.mobility.landing import FARTHEST, ROUNDING, close
from dhcli.mobility.model import Model
from dhcli.mobility.motion import residual
from dhcli.mobility.second_order import (
    CLEAR,
    DRAWN,
    DRAWN_NEGATIVE,
    MOST_FORMS,
    possible,
    quadratic_forms,
    size_of_curvature,
)

LANDED = 1e-5
"""Relative tolerance of ranks at a landing, which a double root gives to half the digits only; what vanished in the
given position has grown like a power of A there."""

SMALL = (0.02, 0.004)
"""Displacements that test tangents: the first one that closes counts."""

ROUNDED = 0.1
"""The same in a rounded drawing, whose errors hide the gap of smaller ones."""

FLAT = 1e-3
"""A quadratic form below this part of the curvature is zero."""

BLUNT = 1e-3
"""Relative tolerance of tangents that come from small displacements."""


@frozen
class Branch:
    """A family of positions through a landing.

    Attributes:
        dimension: Its dimension, without idle freedoms; None if it stayed unclear.
        exact: Whether the rank there is full, so that the dimension is certain.
        motions: Basis of its tangents there, shape (m, k).
        twists: World twists there, shape (m, 6).
        blur: Relative error of the tangents.
    """

    dimension: int | None
    exact: bool
    motions: Array
    twists: Array
    blur: float = LANDED


def branch_at(model: Model, q: Array, frozen: Array, equations: int, tolerance: float) -> Branch:
    """The dimension of the motion at a landing.

    Args:
        model: The linkage.
        q: Joint values there, shape (m,).
        frozen: Orthonormal rows of the idle freedoms.
        equations: The number of equations that loops and ties really have.
        tolerance: Relative error of rounded input; 0 for exact input.
    """
    gap, twists = residual(model, q)
    jacobian = np.concatenate([model.jacobian(twists), frozen])
    rank, motions, stresses = spaces(jacobian, max(LANDED, tolerance))
    k = motions.shape[1]
    if k == 0:  # a place where nothing moves has been reached by moving: the rank is not to be trusted
        return Branch(None, exact=False, motions=motions, twists=twists)
    if rank.rank == equations + len(frozen) and not tolerance:
        return Branch(k, exact=True, motions=motions, twists=twists)
    motions, most = _tangents(model, motions, stresses, twists, tolerance)
    near = _Near(model, q, frozen, motions, max(ROUNDING, tolerance, 30 * float(np.abs(gap).max(initial=0.0))))
    smalls = SMALL if not tolerance else (ROUNDED,)
    met = near.meets(most, smalls)
    low, high = (most, most) if met else (0, most)
    while high - low > 1:
        middle = (low + high) // 2
        if (now := near.meets(middle, smalls)) is not None:
            low, met = middle, now
        else:
            high = middle
    if met is None:
        return Branch(None, exact=False, motions=motions, twists=twists)
    if low == motions.shape[1]:
        return Branch(low, exact=False, motions=motions, twists=twists)
    return Branch(low, exact=False, motions=near.tangents(*met), twists=twists, blur=BLUNT)


def _tangents(model: Model, motions: Array, stresses: Array, twists: Array, tolerance: float) -> tuple[Array, int]:
    """The motions at a landing that the second order test leaves, and how many freedoms they can have at the most.

    On a smooth branch the forms vanish for every two tangents; so if they do not, one freedom less is left.
    """
    if motions.shape[1] > MOST_FORMS:
        return motions, motions.shape[1]
    forms = quadratic_forms(model, motions, stresses, twists)
    flat = max(FLAT * size_of_curvature(model, motions, twists), CLEAR, DRAWN * tolerance)
    left = possible(forms, flat, max(flat * 1e-3, DRAWN_NEGATIVE * tolerance))
    if not left.shape[1]:
        left = np.eye(motions.shape[1])  # nothing is left though the place was reached by moving: not to be trusted
    bent = float(np.abs(left.T @ forms @ left).max(initial=0.0)) > flat
    return motions @ left, left.shape[1] - bent


@frozen
class _Near:
    """The neighbourhood of a landing.

    Attributes:
        model: The linkage.
        q: Joint values of the landing.
        frozen: Orthonormal rows of the idle freedoms.
        motions: Orthonormal columns of the instantaneous motions there.
        closed: A gap below this is none.
    """

    model: Model
    q: Array
    frozen: Array
    motions: Array
    closed: float

    def meets(self, count: int, smalls: tuple[float, ...]) -> tuple[Array, float] | None:
        """So many random conditions, `rows (q - landing) = values`, that are met near by, with their size; or None."""
        draw = Draws(count)
        for small in smalls if count else ():
            for _ in range(2):
                rows = np.linalg.qr(draw.normal(self.motions.shape[1], count))[0].T @ self.motions.T
                values = draw.normal(count)
                if self._moved(rows, small * values / np.linalg.norm(values)) is not None:
                    return rows, small
        return None

    def tangents(self, rows: Array, small: float) -> Array:
        """Orthonormal tangents of the branch, by differences to both sides, as columns."""
        found = []
        for value in small * np.eye(len(rows)):
            ahead, behind = self._moved(rows, value), self._moved(rows, -value)
            moved = [way for way in (ahead, None if behind is None else -behind) if way is not None]
            found += [np.mean(moved, axis=0)] if moved else []
        within = self.motions @ (self.motions.T @ np.array(found).T) if found else self.motions
        return orthonormal(within, BLUNT)

    def _moved(self, rows: Array, values: Array) -> Array | None:
        """The displacement that meets some conditions, or None if the loops do not close, or only far away."""
        held = np.concatenate([self.frozen, rows])
        targets = np.concatenate([self.frozen @ self.q, rows @ self.q + values])
        q, error = close(self.model, self.q + rows.T @ values, held, targets)
        moved = q - self.q
        near = float(np.linalg.norm(moved)) < FARTHEST * float(np.linalg.norm(values))
        return moved if near and error <= self.closed else None
