"""The rule ONE: a joint is read off equations in which nothing else is unknown."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.roots import STRAY, known_as, pair, slides, two_ways
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.steps import One

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

WEAK = 1e-4
"""Where an equation falls below this share of its ordinary size, all equations are used."""


def read_off(rows: Rows, step: One, draws: Array) -> Rows:
    """Candidates with one joint more."""
    joint = step.joint
    if not len(rows):
        return known_as(rows, joint, np.empty(0), np.empty(0))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        strong, found = _ordinary(rows, step)
    if strong.all():
        return found
    from dhcli.kinematics.inverse.weak import from_all  # ordinary poses need none of it

    weak = from_all(rows.take(~strong), step, draws)
    return found.joined(weak)


def _ordinary(rows: Rows, step: One) -> tuple[Flags, Rows]:
    """Which rows the chosen equations serve, and these with the joint known."""
    k = [np.broadcast_arrays(*rows.coefficients(e, step.joint), rows.loss)[:3] for e in step.equations]
    sizes = [equation.size for equation in step.equations]
    if step.kind == "both":
        return _both(rows, step.joint, k, sizes)
    (e, a, b), size = k[0], sizes[0]
    if step.kind == "length":
        strong = np.abs(a) > WEAK * size
        at = _strong(rows, strong)
        d = -e[strong] / a[strong]
        at.loss = at.loss * size / np.abs(a[strong])
        return strong, known_as(at, step.joint, d, 0.5 * d * d)
    if step.kind == "lengths":
        return _lengths(rows, step.joint, (e, a, b), size)
    r = np.hypot(a, b)
    strong = r > WEAK * size
    at = _strong(rows, strong)
    a, b, e, r = a[strong] / r[strong], b[strong] / r[strong], -e[strong] / r[strong], r[strong]
    at.loss = at.loss * size / r
    if step.kind == "opposite":
        return strong, two_ways(at, step.joint, (-b, a), (b, -a))
    return strong, pair(at, step.joint, a, b, e)


def _strong(rows: Rows, strong: Flags) -> Rows:
    """The rows that the chosen equations serve; all of them as they are."""
    return rows.take(np.arange(len(rows))) if strong.all() else rows.take(strong)


def _both(rows: Rows, joint: int, k: list[tuple[Array, ...]], sizes: list[float]) -> tuple[Flags, Rows]:
    (e1, a1, b1), (e2, a2, b2) = k
    det = a1 * b2 - b1 * a2
    share = np.abs(det) / (sizes[0] * sizes[1])
    strong = share > WEAK
    c, s = (b1 * e2 - e1 * b2) / det, (e1 * a2 - a1 * e2) / det
    h = np.hypot(c, s)
    kept = strong & (np.abs(h - 1) < STRAY)
    whole = kept.all()
    at = rows.take(np.arange(len(rows)) if whole else kept)
    c, s = c / h, s / h
    at.loss = at.loss / np.minimum(share if whole else share[kept], 1)
    return strong, known_as(at, joint, c if whole else c[kept], s if whole else s[kept])


def _lengths(rows: Rows, joint: int, k: tuple[Array, Array, Array], size: float) -> tuple[Flags, Rows]:
    e, a, b = k
    strong = np.abs(b) > WEAK * size
    at, e, a, b = _strong(rows, strong), e[strong], a[strong], b[strong]
    return strong, slides(at, joint, e / b, a / b)
