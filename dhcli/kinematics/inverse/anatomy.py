"""Shoulder, elbow and wrist of an arm, where its axes lie as they do in an arm with those, and how it holds them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.polishing import motion

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Arm

CLOSE = 1e-7
"""Axes are parallel, or meet, within this."""

_NOWHERE = 1e-9
"""Below this a sign means nothing: the arm stands where two branches meet."""


@dataclass(frozen=True, slots=True)
class Anatomy:
    """Which parts an arm has.

    Attributes:
        wrist: The point that the last axes turn about, in the zero pose; the tip where there is none.
        shoulder: Whether the first two axes cross, so that the arm can reach a point facing it or backwards.
        offset: By how much the arm stands beside the first axis, along the second.
        elbow: The number of the joint that is the elbow, with the shoulder's joint before it; -1 where there is none.
        flips: Whether the last three joints are a wrist that can flip.
        ahead: Sign of the direction in which the arm faces in the zero pose.
        level: Whether the arm moves in a plane across its first axis, as SCARA does.
    """

    wrist: tuple[float, float, float]
    shoulder: bool
    offset: float
    elbow: int
    flips: bool
    ahead: float
    level: bool


def anatomy(arm: Arm) -> Anatomy:
    """The parts of an arm, from its axes in the zero pose."""
    axes = arm.axes[: arm.joints]
    turns = [axis.turns for axis in axes]
    z = [np.array(axis.direction) for axis in axes]
    p = [np.array(axis.point) for axis in axes]
    count = arm.joints
    tip = arm.home[:3, 3]
    wrist, flips = tip, False
    if count >= 3 and all(turns[-3:]):  # noqa: PLR2004  joints of a wrist
        centre = _common_point(z[-2:], p[-2:])
        if centre is not None:
            wrist = centre
        flips = _parallel_nowhere(z[-3:]) and (count > 3 or centre is not None)  # noqa: PLR2004
        flips = flips and (count == 3 or centre is not None)  # noqa: PLR2004
    across = count > 2 and turns[0] and turns[1] and not _parallel(z[0], z[1])  # noqa: PLR2004
    shoulder = across and count - 3 * flips > 1
    offset = float((wrist - p[0]) @ z[1]) if shoulder else 0.0
    elbow, level = -1, False
    for first in (0, 1):
        pair = first + 1 < count and turns[first] and turns[first + 1] and _parallel(z[first], z[first + 1])
        # the pair is an elbow only where both move the wrist, and nothing before them but a turn does
        if pair and (first == 0 or turns[0]):
            elbow, level = first + 1, first == 0
            break
    if elbow >= 0 and count > 3 and not flips and level is False:  # noqa: PLR2004
        nxt = elbow + 1
        if nxt < count and turns[nxt] and _parallel(z[elbow], z[nxt]):
            flips = count == 6 and _parallel_nowhere(z[-3:])  # noqa: PLR2004
    ahead = 1.0
    if shoulder:
        facing = float(np.cross(z[1], z[0]) @ (wrist - p[0]))
        ahead = np.sign(facing) if abs(facing) > CLOSE else (np.sign(np.cross(z[1], z[0]) @ (1.0, 0.3, 0.1)) or 1.0)
    x, y, height = (float(part) for part in wrist)
    return Anatomy((x, y, height), shoulder, offset, elbow, flips, float(ahead), level)


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


def posture(arm: Arm, parts: Anatomy, motions: Array) -> tuple[tuple[str, str], ...]:
    """How an arm holds its parts, as pairs of part and word, such as ("elbow", "up").

    Args:
        arm: The arm.
        parts: Its parts.
        motions: Motions of the joints, shape (n,).
    """
    z, p, wrist = _placed(arm, parts, motions)
    words = []
    facing = 1.0
    if parts.shoulder:
        facing = float(np.cross(z[1], z[0]) @ (wrist - p[0]))
        if abs(parts.offset) > CLOSE:
            words.append(("shoulder", _word(facing * parts.offset, "left", "right")))
        else:
            words.append(("shoulder", _word(facing * parts.ahead, "front", "back")))
    if parts.elbow >= 0:
        first, second = parts.elbow - 1, parts.elbow
        end = wrist
        if not parts.level and second + 1 < arm.joints and _parallel(z[second], z[second + 1]):
            end = p[second + 1]  # three parallel axes: the third stands where the forearm ends
        bend = float(np.cross(end - p[first], p[second] - p[first]) @ z[first])
        if parts.level:
            words.append(("elbow", _word(bend, *(("left", "right") if _slides(arm) else ("up", "down")))))
        else:
            words.append(("elbow", _word(-bend * np.sign(facing or 1.0), "up", "down")))
    if parts.flips:
        words.append(("wrist", _word(float(np.cross(z[-3], z[-1]) @ z[-2]), "noflip", "flip")))
    return tuple((part, word) for part, word in words if word)


def _slides(arm: Arm) -> bool:
    return any(not axis.turns for axis in arm.axes[: arm.joints])


def _word(sign: float, positive: str, negative: str) -> str:
    return "" if abs(sign) < _NOWHERE else positive if sign > 0 else negative


def _placed(arm: Arm, parts: Anatomy, motions: Array) -> tuple[list[Array], list[Array], Array]:
    """Axes, points on them, and the wrist, at some joint values."""
    total = np.eye(4)
    z, p, wrist = [], [], np.array(parts.wrist)
    last = arm.joints - 1
    place = wrist
    for k in range(arm.joints):
        axis = arm.axes[k]
        z.append(total[:3, :3] @ np.array(axis.direction))
        p.append(total[:3, :3] @ np.array(axis.point) + total[:3, 3])
        if k == last and parts.flips:
            place = total[:3, :3] @ wrist + total[:3, 3]
        total = total @ motion(axis, motions[k : k + 1])[0]
    if not parts.flips:
        place = total[:3, :3] @ wrist + total[:3, 3]
    return z, p, place
