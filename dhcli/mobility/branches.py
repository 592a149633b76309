"""The family of motions through a landing: its dimension, and the tangents that tell how the output link moves.

The rank may be constant along a branch and yet leave more than its dimension: equal parallel legs let a platform turn
about their direction for an instant, wherever it stands. So the tangents are tested: to second order, by the quadratic
forms of `second_order`, and by small displacements. A set of dimension d meets d general conditions near one of its
points, and not d + 1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dhcli.geometry.rank import orthonormal, spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.landing import FARTHEST, ROUNDING, close
from dhcli.mobility.model import Model
from dhcli.mobility.motion import residual
from dhcli.mobility.second_order import CLEAR, quadratic_forms, size_of_curvature

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


@dataclass(frozen=True)
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
    near = _Near(model, q, frozen, motions, max(ROUNDING, tolerance, 30 * float(np.abs(gap).max(initial=0.0))))
    bent = not tolerance and _bends(model, motions, stresses, twists)
    for count in range(k - bent, 0, -1):
        for small in SMALL if not tolerance else (ROUNDED,):
            rows = near.meets(count, small)
            if rows is not None:
                tangents = motions if count == k else near.tangents(rows, small)
                blur = LANDED if count == k else BLUNT
                return Branch(count, exact=False, motions=tangents, twists=twists, blur=blur)
    return Branch(None, exact=False, motions=motions, twists=twists)


def _bends(model: Model, motions: Array, stresses: Array, twists: Array) -> bool:
    """Whether some instantaneous motion at a landing is stopped in second order, so that it is no tangent."""
    forms = quadratic_forms(model, motions, stresses, twists)
    return float(np.abs(forms).max(initial=0.0)) > max(FLAT * size_of_curvature(model, motions, twists), CLEAR)


@dataclass(frozen=True)
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

    def meets(self, count: int, small: float) -> Array | None:
        """The rows of so many random conditions `rows (q - landing) = small` that can be met near by, or None."""
        draw = np.random.default_rng(count)
        for _ in range(2):
            rows = np.linalg.qr(draw.normal(size=(self.motions.shape[1], count)))[0].T @ self.motions.T
            values = draw.normal(size=count)
            if self._moved(rows, small * values / np.linalg.norm(values)) is not None:
                return np.asarray(rows)
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
