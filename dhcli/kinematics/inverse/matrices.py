"""The same actions as matrices: what a plan is found with, and what runs of joints leave fixed."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, cached_property
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.motions import SIZES, Entry, expanded, form, rotated, translated

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array, Axis

PARALLEL = 1e-6
"""Axes that are closer than this to being parallel, or to meeting, are first taken to be [rad, reaches].

The answer is polished on the robot as it is, so that nothing of it stays but the order in which joints are found.
"""

_CLEAN = 1e-12
"""Below this an entry of something fixed is zero."""


class Actions:
    """The matrices by which the joints of an arm act on each kind of thing."""

    def __init__(self, arm: Arm) -> None:
        """Take the arm; a joint's action is written out when it is asked for."""
        self.arm = arm
        self._fixed: dict[tuple[int, tuple[int, ...]], Array] = {}

    @cached_property
    def parts(self) -> list[list[Array]]:
        """For each kind and axis the three parts of its action, shape (3, d, d)."""
        return [[_parts(kind, axis) for axis in self.arm.axes] for kind in range(len(SIZES))]

    def fixed(self, kind: int, run: Sequence[int]) -> Array:
        """What a run of joints leaves fixed: a basis, one thing a row, with as many zeros as there can be."""
        key = kind, tuple(run)
        if key not in self._fixed:
            self._fixed[key] = self._found(kind, run)
        return self._fixed[key]

    def _found(self, kind: int, run: Sequence[int]) -> Array:
        if not run:
            return np.eye(SIZES[kind])
        # the generator is the sine's part of a turn and the linear part of a slide
        generators = [self.parts[kind][j][2 if self.arm.axes[j].turns else 1] for j in run]
        _, sizes, rows = np.linalg.svd(np.vstack(generators))
        return _reduced(rows[np.count_nonzero(sizes > PARALLEL) :])

    def moved(self, kind: int, joint: int, value: Sequence[Entry], *, back: bool = False) -> Array:
        """The matrices of a joint at known values, shape (N, d, d)."""
        rest, first, second = self.signed(kind, joint, back=back)
        u, v = (np.asarray(part)[..., None, None] for part in value)
        return np.asarray(rest + u * first + v * second)

    def signed(self, kind: int, joint: int, *, back: bool) -> Array:
        """The three parts of a joint's action or of its inverse, shape (3, d, d)."""
        rest, first, second = parts = self.parts[kind][joint]
        if not back:
            return parts
        return np.array([rest, first, -second] if self.arm.axes[joint].turns else [rest, -first, second])


def _parts(kind: int, axis: Axis) -> Array:
    columns = [expanded(kind, unit, axis) for unit in np.eye(SIZES[kind]).tolist()]
    return np.array(columns, dtype=float).transpose(1, 2, 0)


def acting(kind: int, goal: Array) -> Array:
    """The matrices by which rigid motions (N, 4, 4) act, shape (N, d, d)."""
    turn = [[goal[:, i, j] for j in range(3)] for i in range(3)]
    offset = [goal[:, i, 3] for i in range(3)]
    columns = [translated(kind, rotated(kind, unit, turn), offset) for unit in np.eye(SIZES[kind]).tolist()]
    result = np.empty((len(goal), SIZES[kind], SIZES[kind]))
    for j, column in enumerate(columns):
        for i, entry in enumerate(column):
            result[:, i, j] = entry
    return result


@cache
def forms(kind: int) -> Array:
    """The matrix of the form of a kind, shape (d, d)."""
    units = np.eye(SIZES[kind]).tolist()
    return np.array([[form(kind, x, y) for y in units] for x in units], dtype=float)


def value_of(angle_or_length: Array, *, turns: bool) -> tuple[Array, Array]:
    """The two numbers in which equations are linear: cosine and sine, or the length and half its square."""
    q = angle_or_length
    return (np.cos(q), np.sin(q)) if turns else (q, 0.5 * q * q)


def eliminate(rows: Array, i: int, k: int, pivot: int) -> None:
    """Bring row k to place i, and make its pivot 1 and those of all other rows 0, in place."""
    rows[[i, k]] = rows[[k, i]]
    rows[i] /= rows[i, pivot]
    for other in range(len(rows)):
        if other != i:
            rows[other] -= rows[other, pivot] * rows[i]


def _reduced(rows: Array) -> Array:
    """The same space spanned by rows in echelon form, pivots chosen by size."""
    rows = rows.copy()
    free = list(range(rows.shape[1])) if len(rows) else []
    for i in range(len(rows)):
        weights = np.abs(rows[i:][:, free])
        at, column = np.unravel_index(int(np.argmax(weights)), weights.shape)
        pivot = free.pop(int(column))
        eliminate(rows, i, i + int(at), pivot)
    rows[np.abs(rows) < _CLEAN] = 0.0
    near = np.abs(np.abs(rows) - 1) < _CLEAN
    rows[near] = np.sign(rows[near])
    return rows
