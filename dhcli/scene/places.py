"""Where the joints of a linkage are, what they are called, and which points each link has."""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.errors import plural
from dhcli.geometry.vectors import ORIGIN, Vector, dot, length, minus, scaled
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import LinkageError
from dhcli.scene.vectors import centroid, unit

SAME = 1e-9
"""Points nearer than this part of the linkage's size are one."""

MOST_LINKS = 60
"""A linkage with more links is no picture any more."""


class Places:
    """The geometry of a placed linkage.

    Attributes:
        linkage: The linkage.
        size: The extent of its points [m].
        at: Where each joint is, in the order of the joints.
        links: The points of each link, in the order in which the joints name them.
    """

    def __init__(self, linkage: Linkage) -> None:
        """Find a place for each joint.

        Raises:
            LinkageError: There are too many links for a picture.
        """
        check_count(linkage)
        self.linkage = linkage
        known = [joint.point for joint in linkage.joints if joint.point]
        known += [joint.other for joint in linkage.joints if joint.other] + [point.at for point in linkage.points]
        self.size = math.hypot(*(max(p[i] for p in known) - min(p[i] for p in known) for i in range(3))) if known else 0
        self.size = self.size or 1.0
        self.at = tuple(self._place(joint) for joint in linkage.joints)
        self.links: dict[str, list[Vector]] = {link: [] for link in linkage.links}
        for joint, at in zip(linkage.joints, self.at, strict=True):
            for link, held in self._held(joint, at):
                if all(not self.same(held, other) for other in self.links[link]):
                    self.links[link].append(held)
        for point in linkage.points:
            if point.link:
                self.links[point.link].append(point.at)

    def same(self, a: Vector, b: Vector) -> bool:
        """Whether two points are one."""
        return math.dist(a, b) < SAME * self.size

    def named(self) -> Iterator[tuple[str, Vector]]:
        """Every name with its point: as the file calls them, else the numbers of the joints."""
        seen: list[Vector] = []
        held = [at for points in self.links.values() for at in points]
        for point in self.linkage.points:
            if any(self.same(point.at, other) for other in held):
                seen.append(point.at)
                yield point.name, point.at
        for joint, at in zip(self.linkage.joints, self.at, strict=True):
            if not any(self.same(at, other) for other in seen) and joint.point is not None:
                seen.append(at)
                yield joint.name, at

    def _place(self, joint: Joint) -> Vector:
        """Where a joint is; one without a point, such as a slider, is where the lighter of its links is held."""
        if joint.point is not None:
            return joint.point
        found: list[tuple[int, Vector]] = []
        for link in joint.links:
            others = [o.point for o in self.linkage.joints if link in o.links and o is not joint and o.point]
            if others and (link != self.linkage.ground or not found):
                found.append((len(others) + 10 * (link == self.linkage.ground), centroid(others)))
        if joint.pair.name == "prismatic" and joint.axis and len(found) == 2 and max(n for n, _ in found) < 10:  # noqa: PLR2004
            (_, a), (_, b) = found
            return scaled((a[0] + b[0], a[1] + b[1], a[2] + b[2]), 0.5)
        return min(found)[1] if found else ORIGIN

    def _held(self, joint: Joint, at: Vector) -> Iterator[tuple[str, Vector]]:
        """The points that a joint gives to its links."""
        first, second = joint.links
        if joint.pair.name in ("cam", "bar", "rolling") and joint.point and joint.other:
            yield first, joint.point
            yield second, joint.other
        elif joint.pair.name not in ("gear", "fixed", "planar"):
            yield first, at
            yield second, at


def check_count(linkage: Linkage) -> None:
    """Refuse what would be a blot.

    Raises:
        LinkageError: There are too many links for a picture.
    """
    if len(linkage.links) > MOST_LINKS:
        count = plural(len(linkage.links), "link")
        raise LinkageError(f"{linkage.name} has {count}, more than the {MOST_LINKS} that a picture holds")


def corners(points: list[Vector]) -> list[Vector]:
    """The points of a link in an order that goes around it."""
    if len(points) < 3:  # noqa: PLR2004  a bar
        return points
    count = len(points)
    middle = scaled((sum(p[0] for p in points), sum(p[1] for p in points), sum(p[2] for p in points)), 1 / count)
    u = unit(minus(points[0], middle))
    beside = [minus(minus(p, middle), scaled(u, dot(minus(p, middle), u))) for p in points]
    widest = max(beside, key=length)
    v = unit(widest)

    def turn(point: Vector) -> float:
        way = minus(point, middle)
        return math.atan2(dot(way, v), dot(way, u))

    return sorted(points, key=turn)


def is_straight(points: list[Vector], size: float) -> bool:
    """Whether points lie on one line."""
    ends = farthest(points)
    way = unit(minus(ends[1], ends[0]))
    aside = [minus(minus(p, ends[0]), scaled(way, dot(minus(p, ends[0]), way))) for p in points]
    return max(map(length, aside)) < 1e-6 * size


def farthest(points: list[Vector]) -> tuple[Vector, Vector]:
    """The two points farthest apart."""
    return max(((a, b) for a in points for b in points), key=lambda pair: math.dist(*pair))
