"""The other form of the equations: what each joint forbids, written for the twists of the links.

Each joint gives C = λ - f rows `W (V_b - V_a) = 0`, where the rows of W are orthogonal to all that the joint allows.
Twists are taken at the links' own centres. In long chains the gap of its singular values falls as N^-2, that of the
loop form as N^-3; and a row touches two links only, so that the links can be eliminated one after the other.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.rank import TIGHT
from dhcli.geometry.twists import Array, hats
from dhcli.mobility.model import Model


@frozen
class Rows:
    """Equations between the twists of a few links.

    Attributes:
        links: Indices of the links, the ground not among them.
        block: Coefficients, shape (rows, λ · links), columns in the order of the links.
    """

    links: tuple[int, ...]
    block: Array


def constraints(model: Model) -> Iterator[Rows]:
    """The equations of each joint, then those of the gears."""
    size = len(model.basis)
    frames = _frames(model)
    for step in model.steps:
        allowed = model.twists[step.first : step.last] @ model.basis.T
        if model.linkage.joints[step.joint].pair.name == "rolling":
            tie = next(row for row in model.ties if row[step.first])[step.first : step.last]
            allowed = np.array([tie[1], -tie[0]])[None, :] @ allowed
        _, values, right = np.linalg.svd(allowed) if len(allowed) else (None, np.zeros(0), np.eye(size))
        forbidden = right[int(np.count_nonzero(values > TIGHT)) :]
        yield _between(forbidden @ frames[step.tail], forbidden @ frames[step.head], step.tail, step.head)
    meshes = sum(joint.pair.name == "gear" for joint in model.linkage.joints)
    for tie in model.ties[:meshes]:  # those of rolling come behind them, and are part of what the joint allows
        yield _meshed(model, tie, frames)


def _frames(model: Model) -> Array:
    """For each link the map from its twist at its own centre to the twist at the origin, shape (n, λ, λ)."""
    sums, counts = np.zeros((len(model.linkage.links), 3)), np.zeros(len(model.linkage.links))
    for step in model.steps:
        point = model.linkage.joints[step.joint].point
        if point is not None:
            for link in (step.tail, step.head):
                sums[link] += (np.array(point) - model.centre) / model.scale
                counts[link] += 1
    centres = sums / np.maximum(counts, 1)[:, None]
    found = np.tile(np.eye(6), (len(centres), 1, 1))
    found[:, 3:, :3] = hats(centres)  # v at the origin is v at the centre less ω × c
    return np.asarray(model.basis @ found @ model.basis.T)


def _between(first: Array, second: Array, tail: int, head: int) -> Rows:
    parts = [(link, block) for link, block in ((tail, -first), (head, second)) if link]
    if not parts:
        return Rows((), np.zeros((0, 0)))
    return Rows(tuple(link for link, _ in parts), np.concatenate([block for _, block in parts], axis=1))


def _meshed(model: Model, tie: Array, frames: Array) -> Rows:
    """Willis' equation for link twists: a motion's rate is its axis times the difference of its links' ω."""
    size = len(model.basis)
    found: dict[int, Array] = {}
    for step in model.steps:
        for k in range(step.first, step.last):
            if tie[k]:
                axis = model.basis @ np.concatenate([model.twists[k, :3], np.zeros(3)])
                for link, sign in ((step.tail, -1.0), (step.head, 1.0)):
                    if link:
                        found[link] = found.get(link, np.zeros(size)) + sign * tie[k] * (axis @ frames[link])
    links = tuple(found)
    return Rows(links, np.concatenate([found[link] for link in links])[None, :])
