"""Copies of a linkage in other places: moved, disturbed, or with the same joint graph and random geometry."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from dhcli.geometry.twists import Array
from dhcli.geometry.vectors import Vector
from dhcli.mobility.draws import Draws
from dhcli.mobility.linkage import Joint, Linkage

POINTS = ("point", "other")
DIRECTIONS = ("axis", "axis2", "slide")

PointMap = Callable[[Array], Array]


def mapped(linkage: Linkage, points: PointMap, directions: PointMap, scale: float = 1.0) -> Linkage:
    """A copy with other points and directions."""
    return replace(linkage, joints=tuple(_mapped(joint, points, directions, scale) for joint in linkage.joints))


def disturbed(linkage: Linkage, amount: float, seed: int) -> Linkage:
    """A copy whose points are moved at random by a part of its size; joints at one point stay together."""
    points = [np.array(p) for joint in linkage.joints for p in (joint.point, joint.other) if p is not None]
    size = float(np.sqrt(np.mean([np.sum((p - np.mean(points, axis=0)) ** 2) for p in points]))) if points else 1.0
    size = size or 1.0  # all joints at one point
    draw = Draws(seed)
    free = [1, 1, 0] if linkage.space.is_planar else [1, 1, 1]
    move = _shared(lambda: amount * size * draw.normal(3) * free, size)
    return mapped(linkage, lambda p: p + move(p), lambda d: d)


def twisted(linkage: Linkage, amount: float, seed: int) -> Linkage:
    """A copy whose joint directions are turned at random by some radians, each by itself."""
    draw = Draws(seed)
    return mapped(linkage, lambda p: p, lambda d: d / np.linalg.norm(d) + amount * draw.normal(3))


def generic(linkage: Linkage, seed: int) -> Linkage:
    """A copy with the same joint graph and random points and directions; a planar one stays planar."""
    draw = Draws(seed)
    flat = linkage.space.is_planar
    place = _shared(lambda: draw.normal(3) * ([1, 1, 0] if flat else [1, 1, 1]), 1.0)

    def point(p: Array) -> Array:
        return place(p) if flat else draw.normal(3)

    def direction(d: Array) -> Array:
        return d if flat and abs(d[2]) > 0 else draw.normal(3) * ([1, 1, 0] if flat else [1, 1, 1])

    return mapped(linkage, point, direction)


def _mapped(joint: Joint, points: PointMap, directions: PointMap, scale: float) -> Joint:
    changed: dict[str, Vector | float | None] = {}
    for key, change in ((k, points) for k in POINTS):
        value = getattr(joint, key)
        changed[key] = None if value is None else _vector(change(np.array(value)))
    for key in DIRECTIONS:
        value = getattr(joint, key)
        changed[key] = None if value is None else _vector(directions(np.array(value)))
    if joint.pair.name == "line-contact" and changed["axis"] and changed["axis2"]:
        normal, line = np.array(changed["axis"]), np.array(changed["axis2"])  # the line lies in the plane
        changed["axis2"] = _vector(line - normal * (normal @ line) / (normal @ normal))
    changed["pitch"] = None if joint.pitch is None else joint.pitch * scale
    return replace(joint, **changed)  # type: ignore[arg-type]


def _vector(array: Array) -> Vector:
    return float(array[0]), float(array[1]), float(array[2])


def _shared(draw: Callable[[], Array], size: float) -> PointMap:
    """A random value for each place; the same one for joints at the same place."""
    known: dict[tuple[int, ...], Array] = {}

    def value(point: Array) -> Array:
        key = tuple(int(c) for c in np.round(point / size * 1e6))
        if key not in known:
            known[key] = draw()
        return known[key]

    return value
