"""Imposed amplitude: is an instantaneous motion a true one?

Along a direction n of the instantaneous motions the displacement n·q = A is required, and the loops are closed with
all that is left. A true motion closes to rounding at every A. A shaky structure leaves an error that grows like A^k,
which also tells its order k. Projecting back without the requirement would slide back to the start, and cannot tell
x^8 from 0.

Source of the solver: Levenberg 1944 and Marquardt 1963.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from dhcli.geometry.rank import rank_of, spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.model import Model
from dhcli.mobility.motion import residual

AMPLITUDES = (0.3, 0.1, 0.03)
CLOSED = 1e-11
"""A gap below this, with lengths scaled to 1, is rounding."""

ITERATIONS = 60
TRIES = 8
STIFF = 0.03
"""Singular values above this, relative to the largest, are stiff."""

BENT = 0.3
"""Directions that differ by less may be one direction along a bent path."""

SHAKY = 1.9
"""Gaps of a shaky structure grow like A² at least, those of a rounded drawing of a true motion like A."""

FARTHEST = 40.0
"""A landing farther away than this many amplitudes is in another assembly."""

LANDED = 1e-5
"""Relative tolerance of ranks at a landing, which a double root gives to half the digits only; what vanished in the
given position has grown like a power of A there."""

SMALL = 1 / 25
"""Displacements that test tangents, as a part of the amplitude."""


@dataclass(frozen=True)
class Trial:
    """What came of one direction.

    Attributes:
        moves: Whether the loops close at every amplitude; None if the answer is not clear.
        order: The power k of A that the error grows with, where it does not close to rounding.
        q: Joint values at the landing, shape (m,), where it closes.
    """

    moves: bool | None
    order: float | None = None
    q: Array | None = None


def close(model: Model, start: Array, held: Array, targets: Array) -> tuple[Array, float]:
    """Close the loops by damped least squares while some combinations of the joint values are kept.

    Args:
        model: The linkage.
        start: Joint values to begin with, shape (m,).
        held: Orthonormal rows of the combinations kept, shape (c, m).
        targets: Their values, shape (c,).

    Returns:
        The joint values and the largest gap that is left.
    """
    q = start + held.T @ (targets - held @ start)
    # steps are combinations of these rows alone: a matrix that only ought to vanish along what is held vanishes there
    # to rounding, and that, divided by a floor still smaller, would grow to a step that lets go of it
    _, rest, _ = spaces(held)
    gap, twists = residual(model, q)
    damping = 0.1
    for _ in range(ITERATIONS):
        size = float(np.abs(gap).max(initial=0.0))
        if size < CLOSED / 100 or not math.isfinite(size):
            break
        left, values, right = np.linalg.svd(model.jacobian(twists) @ rest, full_matrices=False)
        right = right @ rest.T
        largest = float(values.max(initial=0.0))
        wanted, stiff = left.T @ gap, values > STIFF * largest
        floor = (1e-10 * largest) ** 2
        for _ in range(TRIES):
            step = right.T @ (values / (values**2 + max(damping * size, floor)) * wanted)
            ahead, nearer, turned = _righted(model, q - step, left[:, stiff] / values[stiff], right[stiff])
            if float(nearer @ nearer) < float(gap @ gap):
                break
            damping *= 6
        else:
            break
        stalled = float(nearer @ nearer) > (1 - 1e-9) * float(gap @ gap)
        q, gap, twists, damping = ahead, nearer, turned, damping / 6
        if stalled:
            break
    return q, float(np.abs(gap).max(initial=0.0))


def _righted(model: Model, q: Array, left: Array, right: Array) -> tuple[Array, Array, Array]:
    """A step put right in the stiff directions, whose curvature would hide what it gained in the soft ones."""
    for _ in range(2):
        gap, _ = residual(model, q)
        q = q - right.T @ (left.T @ gap)
    return q, *residual(model, q)


def attempt(model: Model, direction: Array, frozen: Array, tolerance: float) -> Trial:
    """Impose amplitudes along one direction.

    Args:
        model: The linkage.
        direction: A unit vector among the instantaneous motions, shape (m,).
        frozen: Orthonormal rows of the idle freedoms, shape (i, m).
        tolerance: Gap that rounded input may leave; 0 for exact input.
    """
    closed = max(CLOSED, tolerance)
    held = np.concatenate([frozen, direction[None, :]])
    errors, landing = [], None
    # a rounded drawing cannot tell A² from its own errors where A is small
    amplitudes = AMPLITUDES if not tolerance else AMPLITUDES[:2]
    for amplitude in amplitudes:
        targets = np.array([*np.zeros(len(frozen)), amplitude])
        q, error = close(model, amplitude * direction, held, targets)
        errors.append(error)
        if error < closed and amplitude == AMPLITUDES[1] and float(np.linalg.norm(q)) < FARTHEST * amplitude:
            landing = q
    return _judged(errors, amplitudes, closed, landing)


def _judged(errors: list[float], amplitudes: tuple[float, ...], closed: float, landing: Array | None) -> Trial:
    """Closing, growing like a power, or neither."""
    order = None
    if min(errors[:2]) > CLOSED:
        order = math.log(errors[0] / errors[1]) / math.log(amplitudes[0] / amplitudes[1])
    if order is not None and errors[0] > closed and errors[1] < closed and order > SHAKY:
        return Trial(moves=False, order=order)  # rounded input hides the gap at the smaller amplitude only
    if landing is not None and errors[-1] < closed:
        return Trial(moves=True, order=order, q=landing)
    if order is not None and errors[0] > closed and errors[1] > closed:
        expected = errors[1] * (amplitudes[-1] / amplitudes[1]) ** order
        same = len(errors) < 3 or errors[2] < closed or 0.1 < errors[2] / expected < 10  # noqa: PLR2004  rounded input has two amplitudes
        if order > SHAKY and same:
            return Trial(moves=False, order=order)
    return Trial(moves=None)


@dataclass(frozen=True)
class Branch:
    """A family of positions through a landing.

    Attributes:
        dimension: Its dimension, without idle freedoms; None if it stayed unclear.
        exact: Whether the rank there is full, so that the dimension is certain.
        motions: Basis of the instantaneous motions there, shape (m, k).
        twists: World twists there, shape (m, 6).
    """

    dimension: int | None
    exact: bool
    motions: Array
    twists: Array


def branch_at(model: Model, q: Array, frozen: Array, equations: int, tolerance: float) -> Branch:
    """The dimension of the motion at a landing.

    Args:
        model: The linkage.
        q: Joint values there, shape (m,).
        frozen: Orthonormal rows of the idle freedoms.
        equations: The number of equations that loops and ties really have.
        tolerance: As for `attempt`.
    """
    _, twists = residual(model, q)
    rank, motions, _ = spaces(np.concatenate([model.jacobian(twists), frozen]), max(LANDED, tolerance))
    k = motions.shape[1]
    if k == 0:  # a place where nothing moves has been reached by moving: the rank is not to be trusted
        return Branch(None, exact=False, motions=motions, twists=twists)
    if rank.rank == equations + len(frozen) and not tolerance:
        return Branch(k, exact=True, motions=motions, twists=twists)
    small = AMPLITUDES[1] * SMALL if not tolerance else AMPLITUDES[1]
    reached = []
    for tangent in motions.T:
        held = np.concatenate([frozen, tangent[None, :]])
        targets = np.array([*frozen @ q, tangent @ q + small])
        landed, error = close(model, q + small * tangent, held, targets)
        moved = landed - q
        if error < max(CLOSED, tolerance) and float(np.linalg.norm(moved)) < FARTHEST * small:
            reached.append(moved / np.linalg.norm(moved))
    if len(reached) == k:
        return Branch(k, exact=False, motions=motions, twists=twists)
    if not reached:
        return Branch(None, exact=False, motions=motions, twists=twists)
    # those that closed lie along the true tangents, up to the curvature over a small displacement
    dimension = rank_of(np.array(reached), min(10 * small, BENT)).rank
    return Branch(dimension, exact=False, motions=np.array(reached).T, twists=twists)
