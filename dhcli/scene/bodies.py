"""Solids in the world: whether they hide a point from the reader, and how they look on paper."""

from __future__ import annotations

import math
from dataclasses import field
from typing import Protocol

from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, cross, dot, length, minus, plus, scaled
from dhcli.scene.camera import Camera
from dhcli.scene.primitives import Ball, Drum, Face, Scene, Solid
from dhcli.scene.shapes import Shape, hull, ring
from dhcli.scene.vectors import centroid, unit

RIM = tuple((math.cos(t), math.sin(t)) for t in (math.tau * i / 32 for i in range(32)))
"""Corners of the rim of a drum of radius one."""

SKIN = 1e-9
INSIDE = 0.98
"""A point this far inside, in parts of the radius, is taken to be inside; a rod that touches is not."""


class Body(Protocol):
    """A solid in the world."""

    @property
    def centre(self) -> Vector:
        """Its middle."""

    def span(self, point: Vector, towards: Vector) -> tuple[float, float] | None:
        """Where a line through a point enters and leaves the body, counted along a direction; None past it."""

    def samples(self) -> tuple[Vector, ...]:
        """Points all over its surface."""

    def shapes(self, camera: Camera) -> list[Shape]:
        """How it looks, from back to front."""


@frozen
class Cylinder:
    """A drum in the world."""

    centre: Vector
    axis: Vector
    radius: float
    half: float
    across: tuple[Vector, Vector] = field(repr=False)

    def span(self, point: Vector, towards: Vector) -> tuple[float, float] | None:
        """Where a line goes through; see Body."""
        rel = minus(point, self.centre)
        height, climb = dot(rel, self.axis), dot(towards, self.axis)
        p, d = plus(rel, self.axis, -height), plus(towards, self.axis, -climb)
        a, b, c = dot(d, d), dot(p, d), dot(p, p) - self.radius * self.radius * INSIDE
        low, high = -math.inf, math.inf
        if a > SKIN:
            root = b * b - a * c
            if root <= 0:
                return None
            low, high = (-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a
        elif c > 0:
            return None
        return _between(low, high, height, climb, self.half)

    def rim(self, end: float) -> tuple[Vector, ...]:
        """The circle at one end."""
        middle = plus(self.centre, self.axis, end * self.half)
        (u, v), radius = self.across, self.radius
        return tuple(plus(plus(middle, u, radius * x), v, radius * y) for x, y in RIM)

    def samples(self) -> tuple[Vector, ...]:
        """Points of both rims, and of the middle."""
        top, down = self.rim(1)[::4], scaled(self.axis, -self.half)
        return (*top, *self.rim(-1)[::4], *(plus(p, down) for p in top))

    def shapes(self, camera: Camera) -> list[Shape]:
        """The side, shaded across, and the end that faces the reader."""
        near = 1 if dot(self.axis, camera.towards) >= 0 else -1
        front = tuple(map(camera.flat, self.rim(near)))
        back = tuple(map(camera.flat, self.rim(-near)))
        fx, fy = camera.flat_direction(self.axis)
        seen = math.hypot(fx, fy)
        if seen < 1e-6:  # noqa: PLR2004  seen along its axis
            return [Shape(front, "cap", closed=True)]
        x, y = camera.flat(self.centre)
        wide = self.radius * camera.scale
        sx, sy = -fy / seen * wide, fx / seen * wide
        if (sx, sy) < (0.0, 0.0):
            sx, sy = -sx, -sy
        shade = (x - sx, y - sy), (x + sx, y + sy)
        return [Shape(hull(front + back), "drum", closed=True, shade=shade), Shape(front, "cap", closed=True)]


@frozen
class Block:
    """A box in the world."""

    centre: Vector
    axes: tuple[Vector, Vector, Vector]
    halves: tuple[float, float, float]

    def span(self, point: Vector, towards: Vector) -> tuple[float, float] | None:
        """Where a line goes through; see Body."""
        rel = minus(point, self.centre)
        low, high = -math.inf, math.inf
        for axis, half in zip(self.axes, self.halves, strict=True):
            cut = _between(low, high, dot(rel, axis), dot(towards, axis), half * INSIDE)
            if cut is None:
                return None
            low, high = cut
        return low, high

    def corner(self, *signs: int) -> Vector:
        """One of the eight corners."""
        point = self.centre
        for sign, axis, half in zip(signs, self.axes, self.halves, strict=True):
            point = plus(point, axis, sign * half)
        return point

    def samples(self) -> tuple[Vector, ...]:
        """The corners, and the middles of the faces."""
        corners = [self.corner(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
        faces = [
            plus(self.centre, axis, sign * half)
            for axis, half in zip(self.axes, self.halves, strict=True)
            for sign in (-1, 1)
        ]
        return (*corners, *faces)

    def shapes(self, camera: Camera) -> list[Shape]:
        """The faces that the reader sees."""
        found = []
        for number, axis in enumerate(self.axes):
            facing = dot(axis, camera.towards)
            if abs(facing) < 1e-9:  # noqa: PLR2004  seen edge on
                continue
            sign = 1 if facing > 0 else -1
            corners = []
            for i, j in ((-1, -1), (-1, 1), (1, 1), (1, -1)):
                signs = [i, j]
                signs.insert(number, sign)
                corners.append(camera.flat(self.corner(*signs)))
            light = dot(scaled(axis, sign), camera.up)
            look = "face-light" if light > 0.5 else "face" if light > -0.2 else "face-dark"  # noqa: PLR2004  from above
            found.append(Shape(tuple(corners), look, closed=True))
        return found


@frozen
class Sphere:
    """A ball in the world."""

    centre: Vector
    radius: float

    def span(self, point: Vector, towards: Vector) -> tuple[float, float] | None:
        """Where a line goes through; see Body."""
        rel = minus(point, self.centre)
        b, c = dot(rel, towards), dot(rel, rel) - self.radius * self.radius * INSIDE
        root = b * b - c
        return (-b - math.sqrt(root), -b + math.sqrt(root)) if root > 0 else None

    def samples(self) -> tuple[Vector, ...]:
        """Six points of its surface."""
        r = self.radius
        return tuple(
            plus(self.centre, v) for v in ((r, 0, 0), (-r, 0, 0), (0, r, 0), (0, -r, 0), (0, 0, r), (0, 0, -r))
        )

    def shapes(self, camera: Camera) -> list[Shape]:
        """A disc."""
        x, y = camera.flat(self.centre)
        r = self.radius * camera.scale
        return [Shape(ring((x, y), r), "ball", closed=True, shade=((x - r, y - r), (x + r, y + r)))]


@frozen
class Sheet:
    """A flat link in the world."""

    centre: Vector
    corners: tuple[Vector, ...]
    look: str = "sheet"

    def span(self, point: Vector, towards: Vector) -> tuple[float, float] | None:
        """Where a line goes through; see Body."""
        a, b, c = self.corners[:3]
        normal = unit(cross(minus(b, a), minus(c, a)))
        slope = dot(towards, normal)
        if abs(slope) < 1e-6:  # noqa: PLR2004  seen edge on
            return None
        t = dot(minus(a, point), normal) / slope
        hit = plus(point, towards, t)
        signs = {
            dot(cross(minus(q, p), minus(hit, p)), normal) >= 0
            for p, q in zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True)
        }
        return (t, t) if len(signs) == 1 else None

    def samples(self) -> tuple[Vector, ...]:
        """Corners drawn a little inwards, and the middle."""
        return (*(plus(scaled(c, 0.8), scaled(self.centre, 0.2)) for c in self.corners), self.centre)

    def shapes(self, camera: Camera) -> list[Shape]:
        """The outline, filled."""
        return [Shape(tuple(map(camera.flat, self.corners)), self.look, closed=True)]


def body_of(scene: Scene, solid: Solid) -> Body:
    """A solid of a scene in the world."""
    if isinstance(solid, Face):
        corners = tuple(scene.point(corner) for corner in solid.corners)
        return Sheet(centroid(corners), corners, "ground-sheet" if solid.ground else "sheet")
    centre = scene.point(solid.centre)
    if isinstance(solid, Ball):
        return Sphere(centre, solid.radius)
    axis = unit(scene.direction(solid.centre.state, solid.axis))
    if isinstance(solid, Drum):
        u = _level(axis)
        return Cylinder(centre, axis, solid.radius, solid.half, (u, cross(axis, u)))
    side = _level(axis)
    half = solid.half
    return Block(centre, (axis, side, cross(axis, side)), (half, half * 0.8, half * 0.8))


def _level(axis: Vector) -> Vector:
    """A level direction at right angles to an axis."""
    flat = cross((0.0, 0.0, 1.0), axis)
    return unit(flat) if length(flat) > 1e-6 else (1.0, 0.0, 0.0)  # noqa: PLR2004  an upright axis


def _between(low: float, high: float, height: float, climb: float, half: float) -> tuple[float, float] | None:
    """The part of a stretch of a line that is between two planes at right angles to an axis."""
    if abs(climb) > SKIN:
        ends = sorted(((-half - height) / climb, (half - height) / climb))
        low, high = max(low, ends[0]), min(high, ends[1])
    elif abs(height) > half:
        return None
    return (low, high) if low < high else None
