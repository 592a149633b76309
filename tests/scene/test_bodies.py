"""Solids: where a line enters and leaves them, and which of two is in front."""

from __future__ import annotations

import math

from hypothesis import given, settings
from hypothesis import strategies as st

from dhcli.geometry.vectors import Vector, cross, dot, length, minus, plus
from dhcli.scene.bodies import Block, Body, Cylinder, Sphere
from dhcli.scene.camera import Camera
from dhcli.scene.order import ordered
from dhcli.scene.vectors import unit

numbers = st.floats(-2, 2)
vectors = st.tuples(numbers, numbers, numbers)
directions = vectors.filter(lambda v: length(v) > 0.2).map(unit)


def _cylinder(centre: Vector, axis: Vector) -> Cylinder:
    side = unit(cross(axis, (0.3, 0.5, 0.81)))
    return Cylinder(centre, axis, 0.7, 0.9, (side, cross(axis, side)))


def _block(centre: Vector, axis: Vector) -> Block:
    side = unit(cross(axis, (0.3, 0.5, 0.81)))
    return Block(centre, (axis, side, cross(axis, side)), (0.6, 0.5, 0.4))


def _has_inside(body: Body, point: Vector) -> bool:
    """Whether a point is inside, from the definition of the body and not by its lines."""
    rel = minus(point, body.centre)
    if isinstance(body, Cylinder):
        height = dot(rel, body.axis)
        return abs(height) < body.half and length(rel) ** 2 - height**2 < body.radius**2 * 0.98
    if isinstance(body, Block):
        return all(abs(dot(rel, a)) < h * 0.98 for a, h in zip(body.axes, body.halves, strict=True))
    assert isinstance(body, Sphere)
    return length(rel) ** 2 < body.radius**2 * 0.98


@settings(max_examples=150)
@given(
    make=st.sampled_from([_cylinder, _block, lambda c, _: Sphere(c, 0.8)]),
    centre=vectors,
    axis=directions,
    point=vectors,
    way=directions,
)
def test_a_line_is_inside_a_body_between_the_ends_of_its_span_and_nowhere_else(
    make: object, centre: Vector, axis: Vector, point: Vector, way: Vector
) -> None:
    """Tried at points along the line, away from the very surface."""
    assert callable(make)
    if isinstance(axis, tuple) and length(cross(axis, (0.3, 0.5, 0.81))) < 0.1:
        return
    body = make(centre, axis)
    span = body.span(point, way)
    for step in range(-40, 41):
        t = step / 8 + 0.0137
        inside = _has_inside(body, plus(point, way, t))
        expected = span is not None and span[0] < t < span[1]
        near = span is not None and min(abs(t - span[0]), abs(t - span[1])) < 1e-6
        assert near or inside == expected


@given(azimuth=st.floats(-180, 180), elevation=st.floats(-80, 80))
def test_of_two_drums_in_line_with_the_eye_the_nearer_is_painted_last(azimuth: float, elevation: float) -> None:
    """Whichever comes first in the list."""
    camera = Camera.at(azimuth, elevation)
    near = _cylinder(plus((0.0, 0.0, 0.0), camera.towards, 3.0), (0.0, 0.6, 0.8))
    back = _cylinder((0.1, 0.0, 0.0), (0.6, 0.0, 0.8))
    assert ordered([near, back], camera) == [back, near]
    assert ordered([back, near], camera) == [back, near]


@given(azimuth=st.floats(-360, 360), elevation=st.floats(-90, 90), point=vectors)
def test_a_camera_has_right_angles_and_keeps_lengths_across_the_line_of_sight(
    azimuth: float, elevation: float, point: Vector
) -> None:
    """Right, up and towards the reader are a right-handed frame."""
    camera = Camera.at(azimuth, elevation)
    assert length(minus(cross(camera.right, camera.up), camera.towards)) < 1e-12
    x, y = camera.flat_direction(point)
    assert math.isclose(x * x + y * y + camera.depth(point) ** 2, length(point) ** 2, abs_tol=1e-9)
