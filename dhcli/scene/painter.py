"""From back to front: bodies by what hides what, rods and turn arrows in short pieces between them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, cross, dot, length, minus, plus, scaled
from dhcli.scene.bodies import Body, Cylinder, body_of
from dhcli.scene.camera import Camera
from dhcli.scene.order import ordered
from dhcli.scene.primitives import Drum, Hand, Plate, Rod, Scene
from dhcli.scene.shapes import Shape, arrowhead, ring
from dhcli.scene.vectors import Flat, middle, unit

PIECE, MOST_PIECES = 0.4, 80
"""Length of a piece of a rod in radii of a drum, and how many of them a rod has at the most."""

TURN, ARC, SWEEP = 1.42, 22, (-215.0, 62.0)
"""Radius of a turn arrow in radii of the drum, its pieces, and where it starts and ends, 0 facing the reader [deg]."""

HATCHES = 13


@frozen
class Piece:
    """Something small enough to be wholly before or behind a body.

    Attributes:
        middle: Where it is in space.
        line: Its ends on paper.
        look: The name of its look.
        owner: What it is a piece of; neighbours of one owner are joined again.
        width: How wide a rod is [px]; 0 for a line.
    """

    middle: Vector
    line: tuple[Flat, ...]
    look: str
    owner: int
    width: float = 0.0


def painted(scene: Scene, camera: Camera, *, turns: bool) -> list[Shape]:
    """All solids of a scene with their rods, hand and turn arrows, from back to front."""
    bodies = [body_of(scene, solid) for solid in scene.solids]
    pieces = list(_rod_pieces(scene, bodies, camera))
    if scene.hand is not None:
        pieces += _hand_pieces(scene, scene.hand, camera)
    if turns:
        for number, (solid, body) in enumerate(zip(scene.solids, bodies, strict=True)):
            if isinstance(solid, Drum) and isinstance(body, Cylinder):
                pieces += _turn_pieces(body, camera, -1 - number)
    in_order = ordered(bodies, camera)
    slots: list[list[Piece]] = [[] for _ in range(len(bodies) + 1)]
    for piece in pieces:
        slots[_slot(piece, in_order, camera)].append(piece)
    shapes = list(ground(scene, scene.plate, camera)) if scene.plate else []
    for number, slot in enumerate(slots):
        slot.sort(key=lambda piece: camera.depth(piece.middle))
        shapes += _joined(slot)
        if number < len(in_order):
            shapes += in_order[number].shapes(camera)
    if scene.plate and not scene.plate.broken and camera.elevation < 0:
        count = sum(1 for _ in ground(scene, scene.plate, camera))
        shapes = shapes[count:] + shapes[:count]
    return shapes


def turn_arc(body: Cylinder, camera: Camera) -> list[Vector]:
    """The points of a turn arrow around a drum, from its start to its tip."""
    front = minus(camera.towards, scaled(body.axis, dot(camera.towards, body.axis)))
    facing = unit(front) if length(front) > 0.05 else unit(cross(camera.up, body.axis))  # noqa: PLR2004  end on
    side = cross(body.axis, facing)
    radius = TURN * body.radius
    low, high = (math.radians(angle) for angle in SWEEP)
    found = []
    for i in range(ARC + 1):
        t = low + (high - low) * i / ARC
        found.append(plus(plus(body.centre, facing, radius * math.cos(t)), side, radius * math.sin(t)))
    return found


def _turn_pieces(body: Cylinder, camera: Camera, owner: int) -> Iterator[Piece]:
    arc = turn_arc(body, camera)
    for a, b in pairwise(arc):
        yield Piece(middle(a, b), (camera.flat(a), camera.flat(b)), "turn", owner)
    flats = camera.flat(arc[-1]), camera.flat(arc[-3])
    yield Piece(arc[-1], arrowhead(*flats, 9.0), "turn-head", owner)


def _rod_pieces(scene: Scene, bodies: list[Body], camera: Camera) -> Iterator[Piece]:
    for number, rod in enumerate(scene.rods):
        start, end = scene.point(rod.start), scene.point(rod.end)
        yield from _one_rod(rod, start, end, bodies, camera, (number, scene.unit))


def _one_rod(
    rod: Rod, start: Vector, end: Vector, bodies: list[Body], camera: Camera, owner: tuple[int, float]
) -> Iterator[Piece]:
    number, unit_length = owner
    far = length(minus(end, start))
    if not far:
        return
    width = max(2 * rod.thickness * camera.scale, 3.0)
    way, look = unit(minus(end, start)), "ground-link" if rod.ground else "link"
    for low, high in _outside(start, way, far, bodies):
        count = max(1, min(MOST_PIECES, math.ceil((high - low) / (PIECE * unit_length))))
        points = [plus(start, way, low + (high - low) * i / count) for i in range(count + 1)]
        for a, b in pairwise(points):
            yield Piece(middle(a, b), (camera.flat(a), camera.flat(b)), look, number, width)
    for point in (start, end):
        if not _is_inside(point, bodies, camera):
            yield Piece(plus(point, camera.towards, -0.02 * unit_length), (camera.flat(point),), look, number, width)


def _outside(start: Vector, way: Vector, far: float, bodies: list[Body]) -> list[tuple[float, float]]:
    """The parts of a line that are in no body; what is inside one is dropped."""
    parts = [(0.0, far)]
    for body in bodies:
        span = body.span(start, way)
        if span is None or span[0] == span[1]:
            continue
        parts = [
            part
            for low, high in parts
            for part in ((low, min(high, span[0])), (max(low, span[1]), high))
            if part[1] - part[0] > 1e-9 * far
        ]
    return parts


def _is_inside(point: Vector, bodies: list[Body], camera: Camera) -> bool:
    return any(span and span[0] < 0 < span[1] for span in (body.span(point, camera.towards) for body in bodies))


def grip(scene: Scene, hand: Hand, camera: Camera) -> Shape:
    """What is between the fingers of the hand, where no label may stand."""
    _, sides, tips = _fork(scene, hand)
    return Shape(tuple(map(camera.flat, (*sides, *reversed(tips)))), "grip", closed=True)


def _fork(scene: Scene, hand: Hand) -> tuple[Vector, tuple[Vector, Vector], tuple[Vector, Vector]]:
    """The middle of the hand's bar, its ends, and the tips of the fingers."""
    wrist, state = scene.point(hand.wrist), hand.wrist.state
    forward, across = (scaled(scene.direction(state, d), hand.size) for d in (hand.forward, hand.across))
    palm = plus(wrist, forward, 0.3)
    sides = plus(palm, across, -0.38), plus(palm, across, 0.38)
    return palm, sides, (plus(sides[0], forward, 0.7), plus(sides[1], forward, 0.7))


def _hand_pieces(scene: Scene, hand: Hand, camera: Camera) -> Iterator[Piece]:
    palm, sides, tips = _fork(scene, hand)
    for a, b in ((scene.point(hand.wrist), palm), (sides[0], sides[1]), (sides[0], tips[0]), (sides[1], tips[1])):
        yield Piece(middle(a, b), (camera.flat(a), camera.flat(b)), "hand", -1000)


def _slot(piece: Piece, bodies: list[Body], camera: Camera) -> int:
    """Before which of the bodies, in their order, a piece is painted."""
    low, high = 0, len(bodies)
    depth = camera.depth(piece.middle)
    for number, body in enumerate(bodies):
        span = body.span(piece.middle, camera.towards)
        if span is None:
            continue
        if span[0] + span[1] > 0:
            high = min(high, number)
        else:
            low = max(low, number + 1)
    if low >= high:
        return low
    for number in range(low, high):
        if camera.depth(bodies[number].centre) > depth:
            return number
    return high


def _joined(pieces: list[Piece]) -> list[Shape]:
    """Pieces as shapes; neighbours that follow each other are one."""
    shapes: list[Shape] = []
    run: list[Flat] = []
    last: Piece | None = None
    for piece in pieces:
        joins = last and (piece.owner, piece.look, piece.width) == (last.owner, last.look, last.width)
        if joins and len(piece.line) == 2 and len(run) > 1 and piece.look != "hand":  # noqa: PLR2004  a line
            if math.dist(run[-1], piece.line[0]) < 0.01:  # noqa: PLR2004  the same pixel
                run.append(piece.line[1])
                continue
            if math.dist(run[0], piece.line[1]) < 0.01:  # noqa: PLR2004  the same pixel
                run.insert(0, piece.line[0])
                continue
        if last is not None:
            shapes += _drawn(last, run)
        run, last = list(piece.line), piece
    if last is not None:
        shapes += _drawn(last, run)
    return shapes


def _drawn(piece: Piece, run: list[Flat]) -> list[Shape]:
    if len(run) == 1:
        return [Shape(ring(run[0], piece.width / 2, 16), "knob", closed=True)]
    if not piece.width:
        return [Shape(tuple(run), piece.look, closed=piece.look.endswith("head"))]
    (x1, y1), (x2, y2) = run[0], run[-1]
    far = math.dist(run[0], run[-1])
    if far < 1e-9:  # noqa: PLR2004  end on
        return []
    nx, ny = (y1 - y2) / far * piece.width / 2, (x2 - x1) / far * piece.width / 2
    a, b = (x1 + nx, y1 + ny), (x2 + nx, y2 + ny)
    c, d = (x2 - nx, y2 - ny), (x1 - nx, y1 - ny)
    ex, ey = (x2 - x1) / far * 0.4, (y2 - y1) / far * 0.4
    fill = tuple(
        (x + s * ex, y + s * ey) for (x, y), s in zip((a, b, c, d), (-1, 1, 1, -1), strict=True)
    )  # a hair longer, or the seams between pieces would shine through
    return [Shape(fill, piece.look, closed=True), Shape((fill[0], fill[1]), "edge"), Shape((fill[3], fill[2]), "edge")]


def ground(scene: Scene, plate: Plate, camera: Camera) -> Iterator[Shape]:
    """The ground as a hatched plate, or the end of a link that goes on as a break."""
    centre = scene.point(plate.centre)
    normal = scene.direction(plate.centre.state, plate.normal)
    if plate.broken:
        yield from _break(centre, normal, plate.size, camera)
        return
    u = unit(cross((0.0, 1.0, 0.0), normal)) if abs(normal[1]) < 0.9 else (1.0, 0.0, 0.0)  # noqa: PLR2004  not along
    v = cross(normal, u)
    half = plate.size

    def at(s: float, t: float) -> Flat:
        return camera.flat(plus(plus(centre, u, s * half), v, t * half))

    yield Shape((at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)), "plate", closed=True)
    for i in range(1, HATCHES * 2):
        s = -2 + 2 * i / HATCHES
        low, high = max(-1.0, s - 1.0), min(1.0, s + 1.0)
        yield Shape((at(low, s - low), at(high, s - high)), "hatch")


def _break(centre: Vector, normal: Vector, size: float, camera: Camera) -> Iterator[Shape]:
    """A wavy line across the end of a rod."""
    x, y = camera.flat(centre)
    fx, fy = camera.flat_direction(normal)
    far = math.hypot(fx, fy) or 1.0
    ax, ay = -fy / far, fx / far
    wide = 0.75 * size * camera.scale
    points = []
    for i in range(-8, 9):
        t, bend = i / 8, math.sin(i / 8 * math.pi) * wide * 0.35
        points.append((x + ax * t * wide + fx / far * bend, y + ay * t * wide + fy / far * bend))
    yield Shape(tuple(points), "break")
