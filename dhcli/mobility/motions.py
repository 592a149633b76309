"""What each joint allows: a row of motions with one freedom each, as unit twists from its first link to its second."""

from __future__ import annotations

import numpy as np

from dhcli.geometry import twists
from dhcli.geometry.twists import Array
from dhcli.geometry.vectors import Vector
from dhcli.mobility.linkage import Joint

NORMAL: Vector = (0.0, 0.0, 1.0)
"""The normal of the plane of a planar linkage."""


def motions_of(joint: Joint, centre: Array, scale: float, *, planar: bool) -> list[Array]:
    """The motions of a joint in the world frame, each of shape (6,).

    Args:
        joint: The joint; gear meshes are equations between other joints and have none.
        centre: The point that becomes the origin [m].
        scale: The length that becomes 1 [m].
        planar: Whether it moves in the plane, where contacts and bars have pins for balls.
    """
    axis = _unit(joint.axis or NORMAL)
    at, far = _scaled(joint.point, centre, scale), _scaled(joint.other, centre, scale)
    match joint.pair.letter:
        case "R":
            return [twists.about(at, axis)]
        case "P":
            return [twists.along(axis)]
        case "H":
            return [twists.about(at, axis, (joint.pitch or 0.0) / (2 * np.pi * scale))]
        case "C":
            return [twists.about(at, axis), twists.along(axis)]
        case "U":
            return [twists.about(at, axis), twists.about(at, _unit(joint.axis2 or NORMAL))]
        case "S":
            return [twists.about(at, direction) for direction in np.eye(3)]
        case "E":
            across = _across(axis)
            return [twists.along(across), twists.along(np.cross(axis, across)), twists.about(np.zeros(3), axis)]
    if joint.pair.name in ("cam", "bar", "rolling"):
        return _kept_apart(at, far, axis, planar=planar)
    return _sliding(joint, at, axis)


def _sliding(joint: Joint, at: Array, axis: Array) -> list[Array]:
    """A pin in a slot, a ball in a tube, a cylinder on a plane: the second link slides along the first, and turns."""
    if joint.pair.name == "slot":
        return [twists.along(_unit(joint.slide or NORMAL)), twists.about(at, axis)]
    if joint.pair.name == "ball-in-tube":
        return [twists.along(axis), *(twists.about(at, direction) for direction in np.eye(3))]
    if joint.pair.name == "line-contact":
        line = np.array(joint.axis2 or NORMAL)
        line = _unit(line - (line @ axis) * axis)
        # plane on plane, then the turn of the cylinder about its own axis
        return [twists.along(line), twists.along(np.cross(axis, line)), twists.about(at, axis), twists.about(at, line)]
    return []


def _kept_apart(at: Array, far: Array, axis: Array, *, planar: bool) -> list[Array]:
    """Two points that keep their distance: pins or balls at both of them.

    So do the centres of curvature of two profiles in contact, as long as these are circles; of other profiles this is
    the motion up to second order.
    """
    if planar:
        return [twists.about(at, axis), twists.about(far, axis)]
    line = _unit(far - at) if float(np.linalg.norm(far - at)) > 0 else np.array(NORMAL)
    across = _across(line)
    ball = [twists.about(at, direction) for direction in np.eye(3)]
    return [*ball, twists.about(far, across), twists.about(far, np.cross(line, across))]


def _scaled(point: Vector | None, centre: Array, scale: float) -> Array:
    return np.zeros(3) if point is None else (np.array(point) - centre) / scale


def _unit(vector: Vector | Array) -> Array:
    found = np.array(vector, dtype=np.float64)
    return np.asarray(found / np.linalg.norm(found))


def _across(axis: Array) -> Array:
    """A unit vector at right angles to a direction."""
    return _unit(np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))]))
