"""How the output link moves: the type of its motion, from the tangents of the branch it is on."""

from __future__ import annotations

import numpy as np

from dhcli.geometry.rank import spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.draws import Draws
from dhcli.mobility.landing import AMPLITUDES, CLOSED, close
from dhcli.mobility.model import Model
from dhcli.mobility.motion import residual

LOOSE = 1e-6
"""Relative tolerance of an output link's motion."""

LANDED = 1e-5
"""The same a little away from the given position, which is reached with a small error."""

DRAWN = 4.0
"""Errors of a rounded drawing, as multiples of its tolerance, that a motion may have."""

MOST_DRAWN = 0.3


def motion_type(
    model: Model, motions: Array, twists: Array | None = None, *, blur: float = LOOSE, tolerance: float = 0.0
) -> str:
    """The output link's motion as `3T0R`: translations, and rotations beyond them; empty without an output.

    Args:
        model: The linkage.
        motions: Basis of the motions, as columns.
        twists: World twists where they are meant, shape (m, 6); those of the given position by default.
        blur: Relative error of the motions.
        tolerance: Relative error of rounded input; 0 for exact input.
    """
    links = model.linkage.links
    if model.linkage.output not in links:
        return ""
    if not motions.shape[1]:
        return "0T0R"
    output = links.index(model.linkage.output)
    moving = model.link_twists(motions, twists, slice(output, output + 1))[0]
    least = max(LOOSE, blur, min(DRAWN * tolerance, MOST_DRAWN))
    values = np.linalg.svd(moving, compute_uv=False)
    whole = int(np.count_nonzero(values > max(least * values[0], LOOSE)))
    # compared with the whole motion: a platform that only translates has rotations too, of the size of rounding
    turning = int(np.count_nonzero(np.linalg.svd(moving[:3], compute_uv=False) > max(least * values[0], LOOSE)))
    return f"{max(whole - turning, 0)}T{turning}R"


def motion_nearby(model: Model, motions: Array, tolerance: float) -> str:
    """The output link's motion a little away from the given position, where the link may be at a dead point."""
    here = motion_type(model, motions, tolerance=tolerance)
    if not motions.shape[1] or model.linkage.output not in model.linkage.links:
        return here
    found = twists_nearby(model, motions, tolerance)
    if found is None:
        return here
    _, there, _ = spaces(model.jacobian(found), max(LANDED, tolerance))
    # of two with as many freedoms the one near by counts: here a link may translate for an instant only
    return max(motion_type(model, there, found, blur=LANDED, tolerance=tolerance), here, key=freedoms_of)


def twists_nearby(model: Model, motions: Array, tolerance: float) -> Array | None:
    """World twists a little away from the given position, in a random direction; None if it is not reached."""
    weights = Draws(3).normal(motions.shape[1])
    direction = motions @ (weights / np.linalg.norm(weights))
    q, error = close(model, AMPLITUDES[1] * direction, direction[None, :], np.array(AMPLITUDES[1:2]))
    return None if error > max(CLOSED, tolerance) else residual(model, q)[1]


def freedoms_of(motion: str) -> int:
    """How many freedoms a type such as 3T1R has; none without an output."""
    return int(motion[0]) + int(motion[2]) if motion else 0
