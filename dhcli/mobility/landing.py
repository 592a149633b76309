"""Imposed amplitude: is an instantaneous motion a true one?

Along a direction n of the instantaneous motions the displacement n·q = A is required, and the loops are closed with
all that is left. A true motion closes to rounding at every A. A shaky structure leaves an error that grows like A^k,
which also tells its order k. Projecting back without the requirement would slide back to the start, and cannot tell
x^8 from 0.

Source of the solver: Levenberg 1944 and Marquardt 1963.
"""

from __future__ import annotations

import math
from dataclasses import field
from itertools import pairwise

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.rank import spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.model import Model
from dhcli.mobility.motion import residual

AMPLITUDES = (0.3, 0.1, 0.03)
FAR = (0.9, 1.8)
"""Amplitudes at which a high power of A shows that only seemed to be a motion."""

CLOSED = 1e-11
"""A gap below this, with lengths scaled to 1, may be rounding of the input; that it is one, its growth must show."""

ROUNDING = 1e-14
"""A gap below this is rounding of double precision: true motions close to 2e-16."""

FINISHED = 3e-16
"""A gap below this gets no smaller."""

STEEP = 1e-8
"""Just beyond the end of a range the gap is larger than this; a power of the amplitude would be smaller."""

NARROW = 1.05
"""Ratio of two amplitudes, one that closes and one that does not, between which a range is said to end."""

ITERATIONS = 60
TRIES = 8
STIFF = 0.03
"""Singular values above this, relative to the largest, are stiff."""

SHAKY = 1.9
"""Gaps of a shaky structure grow like A² at least, those of a rounded drawing of a true motion like A."""

FARTHEST = 40.0
"""A landing farther away than this many amplitudes is in another assembly."""


@frozen
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
        if size < FINISHED or not math.isfinite(size):
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


@frozen
class Path:
    """Positions along one direction.

    Attributes:
        model: The linkage.
        direction: A unit vector among the instantaneous motions, shape (m,).
        frozen: Orthonormal rows of the idle freedoms, shape (i, m).
    """

    model: Model
    direction: Array
    frozen: Array
    _known: dict[float, tuple[Array, float]] = field(default_factory=dict, init=False, repr=False)

    def closed(self, amplitude: float) -> tuple[Array, float]:
        """Joint values with an amplitude imposed, and the gap that is left."""
        if amplitude not in self._known:
            held = np.concatenate([self.frozen, self.direction[None, :]])
            targets = np.array([*np.zeros(len(self.frozen)), amplitude])
            self._known[amplitude] = close(self.model, amplitude * self.direction, held, targets)
        return self._known[amplitude]

    def goes_on(self) -> bool:
        """Whether nothing speaks against a motion at large amplitudes either, where a high power of A shows."""
        ends = (AMPLITUDES[0], *FAR)
        orders = (self.grows(near, far) for near, far in pairwise(ends))
        return all(order is None or order <= SHAKY for order in orders)

    def grows(self, near: float, far: float) -> float | None:
        """The power of A that the gap grows with from one amplitude to a larger one.

        None where it does not grow, or where a range ends: beyond its end a motion leaves a gap at once, while what
        only seemed to close, because a power of A was below rounding, leaves one that grows by degrees. Rounding of
        the input grows like A or less.
        """
        inner, outer = self.closed(near)[1], self.closed(far)[1]
        least = max(ROUNDING, 30 * inner)
        if outer <= least:
            return None
        low, high, error = near, far, outer
        while high > NARROW * low:
            middle = math.sqrt(low * high)
            found = self.closed(middle)[1]
            if found <= least:
                low = middle
            else:
                high, error = middle, found
        if error > STEEP:
            return None
        if high < far:
            return math.log(outer / error) / math.log(far / high)
        return math.log(outer / max(inner, FINISHED)) / math.log(far / near)


def attempt(path: Path, tolerance: float, least: float) -> Trial:
    """Impose amplitudes along one direction.

    Args:
        path: The direction.
        tolerance: Gap that rounded input may leave; 0 for exact input.
        least: Power of A that a gap must grow with at least to speak against a motion.
    """
    # a rounded drawing cannot tell A² from its own errors where A is small
    amplitudes = AMPLITUDES if not tolerance else AMPLITUDES[:2]
    errors = [path.closed(amplitude)[1] for amplitude in amplitudes]
    q, error = path.closed(AMPLITUDES[1])
    reached = error < max(CLOSED, tolerance) and float(np.linalg.norm(q)) < FARTHEST * AMPLITUDES[1]
    if not tolerance and reached and errors[0] > ROUNDING:
        order = path.grows(AMPLITUDES[1], AMPLITUDES[0])
        if order is not None and order > least:
            return Trial(moves=False, order=order)
    return _judged(errors, amplitudes, max(CLOSED, tolerance), q if reached else None, least)


def _judged(
    errors: list[float], amplitudes: tuple[float, ...], closed: float, landing: Array | None, least: float
) -> Trial:
    """Closing, growing like a power, or neither."""
    order = None
    if min(errors[:2]) > CLOSED:
        order = math.log(errors[0] / errors[1]) / math.log(amplitudes[0] / amplitudes[1])
    if order is not None and errors[0] > closed and errors[1] < closed and order > least:
        return Trial(moves=False, order=order)  # rounded input hides the gap at the smaller amplitude only
    if landing is not None and errors[-1] < closed:
        return Trial(moves=True, order=order, q=landing)
    if order is not None and errors[0] > closed and errors[1] > closed:
        expected = errors[1] * (amplitudes[-1] / amplitudes[1]) ** order
        same = len(errors) < 3 or errors[2] < closed or 0.1 < errors[2] / expected < 10  # noqa: PLR2004  rounded input has two amplitudes
        if order > least and same:
            return Trial(moves=False, order=order)
    return Trial(moves=None)
