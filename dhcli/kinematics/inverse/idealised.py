"""An arm as its drawing has it, near an arm as it was measured: axes that nearly do are parallel, or meet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array, Axis

NEARLY = 5e-3
"""Axes this near to being parallel, or to meeting, were meant to [rad, reaches]."""


def idealised(arm: Arm) -> Arm | None:
    """The arm that an arm was meant to be; None where it is that one already.

    Axes are compared with those before them: a direction that is nearly the same becomes the same, and a line that
    nearly passes through a point where others meet, or nearly meets the axis before it, does so.
    """
    axes = list["Axis"]()
    meeting = list["Array"]()
    for axis in arm.axes[: arm.joints]:
        along = _direction(axis, axes)
        point = np.array(axis.point)
        if axis.turns:
            point = _point(point, along, axes, meeting)
        x, y, z = along.tolist()
        p, q, r = point.tolist()
        axes.append(replace(axis, direction=(x, y, z), point=(p, q, r)))
    made = replace(arm, axes=(*axes, *arm.axes[arm.joints :]))
    return None if made.axes == arm.axes else made


def _direction(axis: Axis, before: Sequence[Axis]) -> Array:
    along = np.array(axis.direction)
    for other in before:
        direction = np.array(other.direction)
        if np.linalg.norm(np.cross(direction, along)) < NEARLY:
            return np.asarray(direction if direction @ along > 0 else -direction)
    return along


def _point(point: Array, along: Array, before: Sequence[Axis], meeting: list[Array]) -> Array:
    """The point moved so that the line passes through what it nearly passes through."""
    for place in meeting:
        if _off(place, point, along) < NEARLY:
            return place
    for other in reversed([axis for axis in before if axis.turns]):
        normal = np.cross(other.direction, along)
        if np.linalg.norm(normal) < NEARLY:
            continue
        to = point - other.point
        place = other.point + np.array(other.direction) * float(np.cross(to, along) @ normal) / float(normal @ normal)
        if _off(place, point, along) < NEARLY:
            meeting.append(place)
            return np.asarray(place)
    return point


def _off(place: Array, point: Array, along: Array) -> float:
    """How far a line passes by a place."""
    return float(np.linalg.norm(np.cross(place - point, along)))
