"""Room for the drums: one that shares its place with others slides along its own axis, which changes no motion.

Of joints at one point the first goes back, onto the link that comes in along its axis or onto a stub; the last goes
ahead; those between stay. Frames never move.
"""

from __future__ import annotations

from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, dot, length, minus
from dhcli.scene.skeleton import Axis, Leg, Skeleton
from dhcli.scene.vectors import unit

NEAR = 2.3
"""Joints nearer than this many radii share a place."""

HALF = 1.15
"""Half of the length of a drum, in radii."""

STEP = 2.45
"""How far a drum slides away from a place that is taken, in radii: past the drum that stays."""

PARALLEL = 0.999


@frozen
class Slid:
    """Where the body of a joint stands on its axis.

    Attributes:
        axis: The joint.
        shift: How far along its direction [m].
        stub: Whether a piece of its own ties it to its place, because no link runs there.
    """

    axis: Axis
    shift: float = 0.0
    stub: bool = False


def fanned(skeleton: Skeleton, unit_length: float) -> tuple[Slid, ...]:
    """The joints of a robot with the places of their bodies, drums of radius `unit_length` [m]."""
    found: list[Slid] = []
    for group in _groups(skeleton, unit_length):
        found += _spread(skeleton, group, unit_length, last=group[-1] is skeleton.axes[-1], first=not found)
    return tuple(found)


def _groups(skeleton: Skeleton, unit_length: float) -> list[list[Axis]]:
    """Consecutive joints that share a place."""
    groups: list[list[Axis]] = []
    for axis in skeleton.axes:
        near = groups and (
            length(minus(skeleton.place(axis)[0], skeleton.place(groups[-1][-1])[0])) < NEAR * unit_length
            and length(minus(skeleton.place(axis)[0], skeleton.place(groups[-1][0])[0])) < NEAR * unit_length
        )
        if near:
            groups[-1].append(axis)
        else:
            groups.append([axis])
    return groups


def _spread(skeleton: Skeleton, group: list[Axis], unit_length: float, *, last: bool, first: bool) -> list[Slid]:
    step = STEP * unit_length
    if len(group) == 1:
        return [_single(skeleton, group[0], unit_length, first=first)]
    incoming = _link(skeleton, group[0], before=True)
    outgoing = _link(skeleton, group[-1], before=False)
    slid = [Slid(axis) for axis in group]
    goes_back = len(group) > 2 or first or incoming or not (outgoing or last)  # noqa: PLR2004  a middle that stays
    if goes_back:
        back = incoming or _down(skeleton, group[0]) * (1 if first else _away(skeleton, group[0]))
        slid[0] = Slid(group[0], step * back, stub=not incoming)
    if len(group) > 2 or not goes_back:  # noqa: PLR2004  the same
        ahead = outgoing or _onward(skeleton, group[-1])
        slid[-1] = Slid(group[-1], step * ahead, stub=not outgoing)
    for number in range(2, len(group) - 1):
        slid[number] = Slid(group[number], step * (number // 2) * (-1) ** number, stub=True)
    return slid


def _single(skeleton: Skeleton, axis: Axis, unit_length: float, *, first: bool) -> Slid:
    """A joint alone: the first of an arm stands on the link that leaves along its axis, if one does."""
    ahead = _link(skeleton, axis, before=False)
    if first and ahead and axis.kind == "revolute" and not _link(skeleton, axis, before=True):
        reach = _length(skeleton, axis)
        clear = max(reach - (1.15 + HALF) * unit_length, 0.6 * unit_length)  # of a drum across the end of that link
        return Slid(axis, ahead * min(reach / 2, clear, 2.2 * unit_length))
    return Slid(axis)


def _neighbours(skeleton: Skeleton, axis: Axis, *, before: bool) -> list[Leg]:
    """The pieces on one side of a joint, nearest first; those of a joint that slides there are its own rod."""
    if before:
        return [leg for leg in reversed(skeleton.legs) if leg.state < axis.state and _is_long(leg)]
    return [leg for leg in skeleton.legs if leg.state >= axis.state and _is_long(leg)]


def _is_long(leg: Leg) -> bool:
    return length(minus(leg.end, leg.start)) > 0


def _link(skeleton: Skeleton, axis: Axis, *, before: bool) -> int:
    """On which side of its place a link runs along a joint's axis: 1, -1, or 0 if it does not."""
    point, direction = skeleton.place(axis)
    for leg in _neighbours(skeleton, axis, before=before)[:1]:
        start, end = skeleton.ends(leg)
        touching, far = (end, start) if before else (start, end)
        if length(minus(touching, point)) > length(minus(end, start)) * 1e-6:
            return 0
        cosine = dot(unit(minus(far, touching)), direction)
        return round(cosine) if abs(cosine) > PARALLEL else 0
    return 0


def _length(skeleton: Skeleton, axis: Axis) -> float:
    leg = _neighbours(skeleton, axis, before=False)[0]
    return length(minus(leg.end, leg.start))


def _down(skeleton: Skeleton, axis: Axis) -> int:
    """The side of an axis that goes down, or else against its direction."""
    return 1 if skeleton.place(axis)[1][2] < -0.1 else -1  # noqa: PLR2004  hardly level


def _away(skeleton: Skeleton, axis: Axis) -> int:
    """1 if the side that goes down is free, -1 if the next link goes there."""
    point, direction = skeleton.place(axis)
    down = _down(skeleton, axis)
    for leg in _neighbours(skeleton, axis, before=False)[:1]:
        towards: Vector = unit(minus(skeleton.ends(leg)[1], point))
        if dot(towards, direction) * down > 0.5:  # noqa: PLR2004  within 60°
            return -1
    return 1


def _onward(skeleton: Skeleton, axis: Axis) -> int:
    """The side of the last axis that leads on: away from where the arm comes from, or else along z."""
    point, direction = skeleton.place(axis)
    for leg in _neighbours(skeleton, axis, before=True)[:1]:
        cosine = dot(unit(minus(point, skeleton.ends(leg)[0])), direction)
        if abs(cosine) > 0.5:  # noqa: PLR2004  within 60°
            return 1 if cosine > 0 else -1
    return 1
