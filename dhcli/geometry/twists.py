"""Twists of rigid bodies in numpy: their displacements, brackets and changes of frame, many at a time.

A twist is (ω, v): angular velocity, then the velocity of the point at the origin. Source: Lynch and Park, chapter 3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

Array: TypeAlias = "NDArray[np.float64]"


def cross(one: Array, other: Array) -> Array:
    """The vector product of vectors in the last place, shape (..., 3); numpy's own takes long for a few of them."""
    x, y, z = one[..., 0], one[..., 1], one[..., 2]
    u, v, w = other[..., 0], other[..., 1], other[..., 2]
    found = np.empty((*np.broadcast(x, u).shape, 3))
    found[..., 0], found[..., 1], found[..., 2] = y * w - z * v, z * u - x * w, x * v - y * u
    return found


def about(point: Array, axis: Array, pitch: float = 0.0) -> Array:
    """The unit twist about a line, shape (6,); `pitch` is the advance for each radian."""
    return np.concatenate([axis, cross(point, axis) + pitch * axis])


def along(axis: Array) -> Array:
    """The unit twist of a translation, shape (6,)."""
    return np.concatenate([np.zeros(3), axis])


def hats(vectors: Array) -> Array:
    """Matrices of the cross product, (n, 3) to (n, 3, 3)."""
    found = np.zeros((*vectors.shape[:-1], 3, 3))
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    found[..., 0, 1], found[..., 0, 2], found[..., 1, 2] = -z, y, -x
    found[..., 1, 0], found[..., 2, 0], found[..., 2, 1] = z, -y, x
    return found


def displacements(twists: Array, q: Array) -> Array:
    """exp(ξ q) of unit twists, (m, 6) and (m,) to (m, 4, 4).

    Source: Rodrigues' formula; Lynch and Park, eq. 3.88. It holds for translations too, whose ω is zero.
    """
    omega = hats(twists[:, :3])
    squared = omega @ omega
    sine, versine = np.sin(q)[:, None, None], (1 - np.cos(q))[:, None, None]
    angle = q[:, None, None]
    found = np.zeros((len(q), 4, 4))
    found[:, :3, :3] = np.eye(3) + sine * omega + versine * squared
    reach = angle * np.eye(3) + versine * omega + (angle - sine) * squared
    found[:, :3, 3] = (reach @ twists[:, 3:, None])[:, :, 0]
    found[:, 3, 3] = 1
    return found


def inverse(poses: Array) -> Array:
    """The inverses of displacements, shape (..., 4, 4)."""
    found = np.zeros_like(poses)
    found[..., :3, :3] = np.swapaxes(poses[..., :3, :3], -1, -2)
    found[..., :3, 3:] = -found[..., :3, :3] @ poses[..., :3, 3:]
    found[..., 3, 3] = 1
    return found


def carried(poses: Array, twists: Array) -> Array:
    """Twists moved with displacements (the adjoint map), (m, 4, 4) and (m, 6) to (m, 6)."""
    omega = (poses[:, :3, :3] @ twists[:, :3, None])[:, :, 0]
    velocity = (poses[:, :3, :3] @ twists[:, 3:, None])[:, :, 0]
    return np.concatenate([omega, velocity + cross(poses[:, :3, 3], omega)], axis=1)


def brackets(first: Array, second: Array) -> Array:
    """Lie brackets [ξ, η], shapes (..., 6)."""
    omega = cross(first[..., :3], second[..., :3])
    velocity = cross(first[..., :3], second[..., 3:]) - cross(second[..., :3], first[..., 3:])
    return np.concatenate([omega, velocity], axis=-1)


def deviations(poses: Array) -> Array:
    """How far displacements are from none, as twists, (n, 4, 4) to (n, 6); exact to first order."""
    turns = (poses[:, [2, 0, 1], [1, 2, 0]] - poses[:, [1, 2, 0], [2, 0, 1]]) / 2
    return np.concatenate([turns, poses[:, :3, 3]], axis=1)
