"""Shoulder, elbow and wrist of an arm, where its axes lie as they do in an arm with those, and how it holds them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.twists import cross
from dhcli.kinematics.inverse.polishing import lines, products

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array

CLOSE = 1e-7
"""Axes are parallel, or meet, within this."""

_NOWHERE = 1e-9
"""Below this a sign means nothing: the arm stands where two branches meet."""


@frozen
class Anatomy:
    """Which parts an arm has.

    Attributes:
        wrist: The point that the last axes turn about, in the zero pose; the tip where there is none.
        shoulder: Whether the first two axes cross, so that the arm can reach a point facing it or backwards.
        offset: By how much the arm stands beside the first axis, along the second.
        elbow: The number of the joint that is the elbow, with the shoulder's joint before it; -1 where there is none.
        three: Whether a third axis is parallel to those of shoulder and elbow.
        flips: Whether the last three joints are a wrist that can flip.
        ahead: Sign of the direction in which the arm faces in the zero pose.
        level: Whether the arm moves in a plane across its first axis, as SCARA does.
    """

    wrist: tuple[float, float, float]
    shoulder: bool
    offset: float
    elbow: int
    three: bool
    flips: bool
    ahead: float
    level: bool


NOTHING = Anatomy((0.0, 0.0, 0.0), False, 0.0, -1, False, False, 1.0, False)  # noqa: FBT003
"""Of an arm seen from its end."""


def anatomy(arm: Arm) -> Anatomy:
    """The parts of an arm, from its axes in the zero pose."""
    axes = arm.axes[: arm.joints]
    turns = [axis.turns for axis in axes]
    z = [np.array(axis.direction) for axis in axes]
    p = [np.array(axis.point) for axis in axes]
    count = arm.joints
    wrist = _common_point(z[-2:], p[-2:]) if count > 2 and all(turns[-2:]) else None  # noqa: PLR2004
    flips = wrist is not None and all(turns[-3:]) and _parallel_nowhere(z[-3:])
    place = arm.home[:3, 3] if wrist is None else wrist
    elbow, three, level = -1, False, False
    for first in (0, 1):
        if first + 1 < count and turns[0] and turns[first] and turns[first + 1] and _parallel(z[first], z[first + 1]):
            elbow, level = first + 1, first == 0
            three = first + 2 < count and turns[first + 2] and _parallel(z[first + 1], z[first + 2])
            break
    shoulder = count - 3 * flips > 1 and turns[0] and turns[1] and not _parallel(z[0], z[1])
    offset, ahead = 0.0, 1.0
    if shoulder:
        offset = float((place - p[0]) @ z[1])
        facing = np.cross(z[1], z[0])
        ahead = float(facing @ (place - p[0]))
        ahead = ahead if abs(ahead) > CLOSE else float(facing @ (1.0, 0.3, 0.1))
    x, y, height = (float(part) for part in place)
    return Anatomy((x, y, height), shoulder, offset, elbow, three, flips, -1.0 if ahead < 0 else 1.0, level)


def _parallel(a: Array, b: Array) -> bool:
    return float(np.abs(np.cross(a, b)).max()) < CLOSE


def _parallel_nowhere(z: Sequence[Array]) -> bool:
    return not _parallel(z[0], z[1]) and not _parallel(z[1], z[2])


def _common_point(z: Sequence[Array], p: Sequence[Array]) -> Array | None:
    """The point in which two axes meet."""
    normal = np.cross(z[0], z[1])
    size = float(normal @ normal)
    if size < CLOSE or abs(float((p[1] - p[0]) @ normal)) > CLOSE:
        return None
    return np.asarray(p[0] + z[0] * float(np.cross(p[1] - p[0], z[1]) @ normal) / size)


def posture(arm: Arm, parts: Anatomy, motions: Array) -> list[list[str]]:
    """How an arm holds its parts, in words such as `elbow up`, for each of some motions of its joints, shape (K, n)."""
    z, p, wrist = _placed(arm, parts, motions)
    said: list[list[str]] = [[] for _ in motions]
    facing = np.ones(len(motions))
    if parts.shoulder:
        facing = _along(cross(z[1], z[0]), wrist - p[0])
        if abs(parts.offset) > CLOSE:
            _say(said, "shoulder", facing * parts.offset, ("left", "right"))
        else:
            _say(said, "shoulder", facing * parts.ahead, ("front", "back"))
    if parts.elbow >= 0:
        first, second = parts.elbow - 1, parts.elbow
        # three parallel axes: the third stands where the forearm ends
        end = p[second + 1] if parts.three else wrist
        bend = _along(cross(end - p[first], p[second] - p[first]), z[first])
        if parts.level:
            _say(said, "elbow", bend, ("left", "right") if _slides(arm) else ("up", "down"))
        else:
            _say(said, "elbow", -bend * np.where(facing < 0, -1.0, 1.0), ("up", "down"))
    if parts.flips:
        _say(said, "wrist", _along(cross(z[-3], z[-1]), z[-2]), ("noflip", "flip"))
    return said


def _say(said: list[list[str]], part: str, signs: Array, words: tuple[str, str]) -> None:
    """A word for each by a sign; none where the arm stands where two branches meet."""
    for names, sign in zip(said, signs.tolist(), strict=True):
        if abs(sign) > _NOWHERE:
            names.append(f"{part} {words[sign < 0]}")


def _along(one: Array, other: Array) -> Array:
    return np.asarray((one * other).sum(axis=-1))


def _slides(arm: Arm) -> bool:
    return any(not axis.turns for axis in arm.axes[: arm.joints])


def _placed(arm: Arm, parts: Anatomy, motions: Array) -> tuple[Array, Array, Array]:
    """Axes and points on them, shape (n, K, 3), and the wrist, (K, 3), at some joint values."""
    before = products(arm, motions[:, : arm.joints])
    carries = before[-2 if parts.flips else -1]
    return *lines(arm, before), carries[:, :3, :3] @ np.array(parts.wrist) + carries[:, :3, 3]
