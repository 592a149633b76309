"""What lies over the bodies: frames, dimensions, axes and numbers of joints, and the labels that they want."""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.geometry.vectors import Vector, dot, length, minus, plus
from dhcli.scene.bodies import Cylinder, body_of
from dhcli.scene.camera import Camera
from dhcli.scene.ink import Ink
from dhcli.scene.labels import Wish
from dhcli.scene.painter import turn_arc
from dhcli.scene.primitives import Anchor, Arrow, Box, Dimension, Drum, Scene
from dhcli.scene.shapes import Shape, arrowhead, halfway, ring
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Run, spelled

END_ON = 0.13
"""An axis that looks shorter than this part of its length is ⊙ or ⊗."""

OFFSETS = (24.0, 31.0, 38.0, 46.0, 58.0)
"""Distances of a dimension line from its length [px]."""

SHORT, NOTHING = 22.0, 4.0
"""Dimensions shorter than this have their arrows outside; shorter than that only a label [px]."""

PAST_THE_HAND = 0.6
"""How far an axis that runs through the hand goes on behind the fingers, in its sizes, so that its number is free."""

HEAD = 10.0


def frames(scene: Scene, camera: Camera) -> tuple[list[Shape], list[Wish]]:
    """The axes of all frames, the nearest last, with a label at each tip."""
    shapes: list[Shape] = []
    wishes: list[Wish] = []
    for arrow in sorted(scene.arrows, key=lambda each: (-each.length, _tip_depth(scene, camera, each))):
        start = scene.point(arrow.start)
        direction = scene.direction(arrow.start.state, arrow.direction)
        tail, tip = camera.flat(start), camera.flat(plus(start, direction, arrow.length))
        if math.dist(tail, tip) < END_ON * arrow.length * camera.scale:
            towards = sum(a * b for a, b in zip(direction, camera.towards, strict=True)) > 0
            shapes += _end_on(tail, arrow.letter, towards=towards)
            wishes.append(Wish((tail,), arrow.words, arrow.letter, (1.0, 1.0)))
            continue
        head = arrowhead(tip, tail, HEAD)
        neck = (head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2
        shapes += [
            Shape((tail, neck), "halo"),
            Shape((tail, neck), arrow.letter),
            Shape(head, f"{arrow.letter}-head", closed=True),
        ]
        wishes.append(Wish((tip,), arrow.words, arrow.letter, (tip[0] - tail[0], tip[1] - tail[1])))
    return shapes, wishes


def dimensions(scene: Scene, camera: Camera, ink: Ink) -> tuple[list[Shape], list[Wish]]:
    """Dimension lines on the emptier sides, with extension lines, and a label at the middle of each."""
    shapes: list[Shape] = []
    wishes: list[Wish] = []
    for dimension in scene.dimensions:
        a, b = camera.flat(scene.point(dimension.start)), camera.flat(scene.point(dimension.end))
        look = "slide" if dimension.variable else "dim"
        if math.dist(a, b) < NOTHING:
            wishes.append(Wish((halfway(a, b),), dimension.words, look))
            continue
        drawn, wish = _dimension(a, b, dimension, look, ink)
        ink.add(drawn)
        shapes += drawn
        wishes.append(wish)
    return shapes, wishes


def turn_wishes(scene: Scene, camera: Camera) -> Iterator[Wish]:
    """A label at each turn arrow, anywhere along its front."""
    for solid in scene.solids:
        if isinstance(solid, Drum):
            body = body_of(scene, solid)
            assert isinstance(body, Cylinder)  # noqa: S101  the body of a drum
            arc = [camera.flat(point) for point in turn_arc(body, camera)]
            x, y = camera.flat(body.centre)
            front = (arc[-1], arc[-4], arc[-7], arc[-10])
            yield Wish(front, spelled(solid.name), "turn", (front[1][0] - x, front[1][1] - y))


def joint_axes(scene: Scene, camera: Camera, first: int | None) -> tuple[list[Shape], list[Wish]]:
    """The axes of the joints as dash-dotted lines with their numbers, if they have some, for a worksheet."""
    shapes: list[Shape] = []
    wishes: list[Wish] = []
    bodies = [solid for solid in scene.solids if isinstance(solid, Drum | Box)]
    for number, solid in enumerate(bodies, first or 1):
        centre = scene.point(solid.centre)
        axis = scene.direction(solid.centre.state, solid.axis)
        ends = [camera.flat(plus(centre, axis, sign * _reach(scene, centre, axis, sign))) for sign in (1, -1)]
        words = (Run(str(number)),)
        if math.hypot(*camera.flat_direction(axis)) < END_ON:
            middle = camera.flat(centre)
            shapes.append(Shape(ring(middle, 2.0, 8), "axis-dot", closed=True))
            wishes.append(Wish((middle,), words, "number", (1.0, -1.0)))
            continue
        shapes.append(Shape(tuple(ends), "axis"))
        wishes.append(Wish(tuple(ends), words, "number", (ends[0][0] - ends[1][0], ends[0][1] - ends[1][1])))
    return shapes, wishes if first is not None else []


def _reach(scene: Scene, centre: Vector, axis: Vector, sign: int) -> float:
    """How far the axis of a joint is drawn on one side of its middle; where the hand is on it, past the hand."""
    reach, hand = 3.2 * scene.unit, scene.hand
    if hand is None:
        return reach
    tip = plus(scene.point(hand.wrist), scene.direction(hand.wrist.state, hand.forward), hand.size)
    far = sign * dot(minus(tip, centre), axis)
    aside = length(minus(tip, plus(centre, axis, sign * far)))
    is_through = aside < 0.5 * hand.size and reach - 2 * hand.size < far < reach + hand.size
    return max(reach, far + PAST_THE_HAND * hand.size) if is_through else reach


def pins(scene: Scene, camera: Camera, anchors: tuple[Anchor, ...]) -> list[Shape]:
    """Triangles with hatching under points of the ground, in a figure that is seen in its plane."""
    shapes: list[Shape] = []
    for anchor in anchors:
        shapes += support(camera.flat(scene.point(anchor)), max(9.0, 1.0 * scene.unit * camera.scale))
    return shapes


def support(at: Flat, size: float) -> list[Shape]:
    """A bearing on the ground: a triangle on a hatched line."""
    x, y = at
    low = y + 1.7 * size
    shapes = [Shape(((x, y), (x + 0.95 * size, low), (x - 0.95 * size, low)), "pin-ground", closed=True)]
    shapes.append(Shape(((x - 1.5 * size, low), (x + 1.5 * size, low)), "ground-line"))
    return shapes + hatching((x - 1.5 * size, low), (x + 1.5 * size, low), size * 0.5)


def hatching(a: Flat, b: Flat, size: float) -> list[Shape]:
    """Short strokes along a line, on its right as one goes from its start to its end and down is down."""
    far = math.dist(a, b)
    count = max(2, round(far / (1.1 * size)))
    dx, dy = (b[0] - a[0]) / far, (b[1] - a[1]) / far
    found = []
    for i in range(count):
        t = (i + 1) / count * far
        x, y = a[0] + dx * t, a[1] + dy * t
        found.append(Shape(((x, y), (x - size * dx - size * dy, y - size * dy + size * dx)), "hatch-line"))
    return found


def _tip_depth(scene: Scene, camera: Camera, arrow: Arrow) -> float:
    start = scene.point(arrow.start)
    return camera.depth(plus(start, scene.direction(arrow.start.state, arrow.direction), arrow.length))


def _end_on(at: Flat, letter: str, *, towards: bool) -> list[Shape]:
    """⊙ for an axis towards the reader, ⊗ for one away."""
    x, y = at
    shapes = [Shape(ring(at, 6.5, 20), f"{letter}-ring", closed=True)]
    if towards:
        return [*shapes, Shape(ring(at, 2.0, 10), f"{letter}-head", closed=True)]
    return [*shapes, *(Shape(((x - s * 4.2, y - 4.2), (x + s * 4.2, y + 4.2)), letter) for s in (1, -1))]


def _dimension(a: Flat, b: Flat, dimension: Dimension, look: str, ink: Ink) -> tuple[list[Shape], Wish]:
    far = math.dist(a, b)
    dx, dy = (b[0] - a[0]) / far, (b[1] - a[1]) / far
    best: tuple[float, float, float] = (math.inf, 0.0, 0.0)
    for sign in (1.0, -1.0):
        for offset in OFFSETS:
            nx, ny = -dy * sign * offset, dx * sign * offset
            cost = ink.along((a[0] + nx, a[1] + ny), (b[0] + nx, b[1] + ny)) / (far + 20) + offset * 0.02
            if cost < best[0] - 1e-9:
                best = cost, nx, ny
    _, nx, ny = (0.0, -dy, dx) if dimension.direct else best
    c, d = (a[0] + nx, a[1] + ny), (b[0] + nx, b[1] + ny)
    past = 1 + 4 / math.hypot(nx, ny)
    shapes = [
        Shape((a, (a[0] + nx * past, a[1] + ny * past)), "extension"),
        Shape((b, (b[0] + nx * past, b[1] + ny * past)), "extension"),
    ]
    if far < SHORT:
        e, f = (c[0] - dx * 14, c[1] - dy * 14), (d[0] + dx * 14, d[1] + dy * 14)
        shapes += [
            Shape((e, f), look),
            *(Shape(arrowhead(t, u, 7.0), f"{look}-head", closed=True) for t, u in ((c, e), (d, f))),
        ]
    else:
        shapes += [
            Shape((c, d), look),
            *(Shape(arrowhead(t, u, 8.0), f"{look}-head", closed=True) for t, u in ((c, d), (d, c))),
        ]
    points = tuple((c[0] + (d[0] - c[0]) * t, c[1] + (d[1] - c[1]) * t) for t in (0.5, 0.38, 0.62))
    return shapes, Wish(points, dimension.words, look, (nx, ny))
