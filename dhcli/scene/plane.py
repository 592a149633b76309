"""A planar linkage on paper: bars and plates with their pins, the ground, sliders, slots, gears and cams."""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.scene import vectors
from dhcli.scene.ink import Ink
from dhcli.scene.labels import Wish, placed
from dhcli.scene.overlay import hatching, support
from dhcli.scene.places import Places, corners, farthest, is_straight
from dhcli.scene.shapes import Figure, Shape, Text, halfway, hull, ring, sides
from dhcli.scene.staging import Paper
from dhcli.scene.vectors import Flat, unit
from dhcli.scene.words import Run, named

BAR, PIN = 7.5, 5.5
"""Half of the width of a bar, and the radius of a pin [px]."""

MOST_NAMED = 9
"""In a linkage with more links than this only the pins have names."""

SLIDER = (21.0, 14.0)
GUIDE = 62.0


@frozen
class Sheet:
    """Where the plane is on paper."""

    scale: float
    centre: Flat
    middle: Flat

    def at(self, point: Vector) -> Flat:
        """Where a point is [px]."""
        return (
            self.middle[0] + self.scale * (point[0] - self.centre[0]),
            self.middle[1] - self.scale * (point[1] - self.centre[1]),
        )


def plane_figure(linkage: Linkage, paper: Paper, caption: list[Text], *, worksheet: bool) -> Figure:
    """The figure of a planar linkage that is placed."""
    places = Places(linkage)
    sheet = _sheet(places, paper)
    shapes = [*_ground(places, sheet), *_wheels(places, sheet), *_links(places, sheet), *_joints(places, sheet)]
    ink = Ink(paper.width, paper.height)
    ink.add(shapes)
    wishes = [] if worksheet else list(_wishes(places, sheet))
    leaders, texts = placed(wishes, ink, paper.room, paper.lettering)
    return Figure(paper.width, paper.height, (*shapes, *leaders), (*texts, *caption), linkage.title)


def circles(places: Places) -> Iterator[tuple[str, Vector, float]]:
    """Wheels and cams: the link, the centre and the radius of each."""
    seen = set()
    for joint in places.linkage.joints:
        for link, centre, radius in _round(joint, places):
            if (link, centre) not in seen:
                seen.add((link, centre))
                yield link, centre, radius


def _round(joint: Joint, places: Places) -> Iterator[tuple[str, Vector, float]]:
    if joint.pair.name == "gear" and joint.radii:
        for link, radius in zip(joint.links, joint.radii, strict=True):
            yield link, _hub(link, joint.carrier or "", places), radius
    elif joint.pair.name == "rolling" and joint.radii and joint.point and joint.other:
        yield joint.links[0], joint.point, joint.radii[0]
        yield joint.links[1], joint.other, joint.radii[1]
    elif joint.pair.name == "cam" and joint.point and joint.other:
        distance = math.dist(joint.point, joint.other)
        second = min(0.25 * distance, 0.08 * places.size + 0.1 * distance)
        yield joint.links[0], joint.point, distance - second
        yield joint.links[1], joint.other, second


def _hub(link: str, carrier: str, places: Places) -> Vector:
    """Where a wheel turns in its carrier."""
    for joint, at in zip(places.linkage.joints, places.at, strict=True):
        if set(joint.links) == {link, carrier} and joint.point:
            return at
    return next(iter(places.links[link]), (0.0, 0.0, 0.0))


def _sheet(places: Places, paper: Paper) -> Sheet:
    points = [p for held in places.links.values() for p in held]
    points += list(places.at)
    for _, (x, y, z), r in circles(places):
        points += [(x - r, y - r, z), (x + r, y + r, z)]
    left, right = min(p[0] for p in points), max(p[0] for p in points)
    low, high = min(p[1] for p in points), max(p[1] for p in points)
    margin = paper.margin * 1.25
    width, height = paper.width - 2 * margin, paper.height - paper.foot - 1.9 * margin
    most = min(width, height)
    scale = min(width / max(right - left, 1e-9), height / max(high - low, 1e-9), most / (0.5 * places.size))
    middle = paper.width / 2, (paper.height - paper.foot) / 2
    return Sheet(scale, ((left + right) / 2, (low + high) / 2), middle)


def _is_bar(places: Places) -> bool:
    """Whether the ground is one of the bars, and no ground that bearings stand on."""
    return places.linkage.ground != "ground"


def _ground(places: Places, sheet: Sheet) -> Iterator[Shape]:
    """Bearings under the pins of the ground; sliders that run on it have their guide."""
    linkage = places.linkage
    if _is_bar(places):
        return
    seen: list[Vector] = []
    for joint, at in zip(linkage.joints, places.at, strict=True):
        if linkage.ground not in joint.links or any(places.same(at, other) for other in seen):
            continue
        if joint.pair.name in ("revolute", "bar", "cam"):
            seen.append(at)
            yield from support(sheet.at(at), 11.0)


def _links(places: Places, sheet: Sheet) -> Iterator[Shape]:
    linkage = places.linkage
    round_links = {link for link, _, _ in circles(places)}
    for link, points in places.links.items():
        if link == linkage.ground and not _is_bar(places):
            continue
        apart = [p for i, p in enumerate(points) if not any(places.same(p, q) for q in points[:i])]
        if len(apart) < 2 or (link in round_links and len(apart) < 2):  # noqa: PLR2004  a bar has two ends
            continue
        straight = is_straight(apart, places.size)
        ends = list(farthest(apart)) if straight else corners(apart)
        flats = [sheet.at(p) for p in ends]
        outline = hull([p for flat in flats for p in ring(flat, BAR, 20)]) if straight else None
        yield Shape(outline or _rounded(flats), "bar", closed=True)
        if link == linkage.ground:
            a, b = _lower_side(flats) if straight else _outer_side(flats, sheet.middle)
            dx, dy = (b[0] - a[0]) / math.dist(a, b), (b[1] - a[1]) / math.dist(a, b)
            shift = (-dy * BAR, dx * BAR)
            yield from hatching((a[0] + shift[0], a[1] + shift[1]), (b[0] + shift[0], b[1] + shift[1]), 9.0)


def _lower_side(flats: list[Flat]) -> tuple[Flat, Flat]:
    """The ends of a bar, so that what is on the right as one goes is below."""
    a, b = flats[0], flats[-1]
    return (b, a) if (a[0], -a[1]) > (b[0], -b[1]) else (a, b)


def _outer_side(flats: list[Flat], middle: Flat) -> tuple[Flat, Flat]:
    """The side of a plate that is farthest from the middle of the paper, with the plate on the left as one goes."""
    a, b = max(sides(flats), key=lambda side: round(math.dist(middle, halfway(*side)), 6))
    x, y = sum(p[0] for p in flats) / len(flats), sum(p[1] for p in flats) / len(flats)
    is_left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) < 0
    return (a, b) if is_left else (b, a)


def _rounded(flats: list[Flat]) -> tuple[Flat, ...]:
    """A plate around its corners: their own outline where it is not convex."""
    around = hull([p for flat in flats for p in ring(flat, BAR, 20)])
    inside = hull(flats)
    return around if len(inside) == len(flats) else tuple(flats)


def _wheels(places: Places, sheet: Sheet) -> Iterator[Shape]:
    for link, centre, radius in circles(places):
        x, y = sheet.at(centre)
        r = radius * sheet.scale
        yield Shape(ring((x, y), r, 60), "wheel", closed=True)
        yield Shape(ring((x, y), 2.0, 8), "axis-dot", closed=True)
        hub = next((p for p in places.links[link] if not places.same(p, centre)), None)
        if hub is not None:
            yield Shape((sheet.at(hub), (x, y)), "axis")


def _joints(places: Places, sheet: Sheet) -> Iterator[Shape]:
    linkage = places.linkage
    seen: list[Vector] = []
    for joint, at in zip(linkage.joints, places.at, strict=True):
        x, y = sheet.at(at)
        if joint.pair.name == "prismatic" and joint.axis:
            yield from _slider(joint, (x, y), on_ground=linkage.ground in joint.links)
        elif joint.pair.name == "slot" and joint.slide:
            dx, dy, _ = unit(joint.slide)
            ends = [(x + s * 46 * dx, y - s * 46 * dy) for s in (-1, 1)]
            yield Shape(hull([p for end in ends for p in ring(end, PIN + 3, 20)]), "pin", closed=True)
        if joint.pair.name == "bar" and joint.other:
            yield Shape(((x, y), sheet.at(joint.other)), "edge")
    for joint, at in zip(linkage.joints, places.at, strict=True):
        if joint.pair.name in ("revolute", "slot", "bar") and not any(places.same(at, p) for p in seen):
            seen.append(at)
            yield Shape(ring(sheet.at(at), PIN, 20), "pin", closed=True)


def _slider(joint: Joint, at: Flat, *, on_ground: bool) -> Iterator[Shape]:
    """A box, and the guide that it runs on."""
    assert joint.axis is not None  # noqa: S101  the caller has looked
    dx, dy = unit(joint.axis)[0], -unit(joint.axis)[1]
    if (dx, -dy) < (0.0, 0.0):
        dx, dy = -dx, -dy
    nx, ny = -dy, dx
    w, h = SLIDER
    box = [
        (at[0] + s * w * dx + t * h * nx, at[1] + s * w * dy + t * h * ny)
        for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    a, b = ((at[0] + s * GUIDE * dx + h * nx, at[1] + s * GUIDE * dy + h * ny) for s in (-1, 1))
    yield Shape((a, b), "ground-line")
    if on_ground:
        yield from hatching(a, b, 9.0)
    else:
        c, d = ((x - 2 * h * nx, y - 2 * h * ny) for x, y in (a, b))
        yield Shape((c, d), "ground-line")
    yield Shape(tuple(box), "bar", closed=True)


def _wishes(places: Places, sheet: Sheet) -> Iterator[Wish]:
    for name, at in places.named():
        yield Wish((sheet.at(at),), named(name), "mark", (0.6, -1.0))
    moving = [link for link in places.links if link != places.linkage.ground]
    if len(moving) > MOST_NAMED:
        return
    rounds = {link: (centre, radius) for link, centre, radius in circles(places)}
    for link in moving:
        points = places.links[link]
        if link in rounds:
            (x, y, z), r = rounds[link]
            spots = [(x + r * math.cos(t), y + r * math.sin(t), z) for t in (0.9, 2.3, -0.8, -2.3)]
            yield Wish(tuple(sheet.at(p) for p in spots), (Run(link),), "dim")
        elif points:
            yield Wish(tuple(sheet.at(vectors.middle(a, b)) for a, b in sides(corners(points))), (Run(link),), "dim")
