"""What stands on paper: polygons, lines and texts, each with the name of its look; writers know the looks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import TypeVar

from dhcli.frozen import frozen
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Words

P = TypeVar("P", bound=tuple[float, ...])


@frozen
class Shape:
    """A line or an area.

    Attributes:
        points: Its corners [px].
        look: The name of its look.
        closed: Whether the last corner is tied to the first.
        shade: Where its shading starts and ends; None if it has one colour.
    """

    points: tuple[Flat, ...]
    look: str
    closed: bool = False
    shade: tuple[Flat, Flat] | None = None


@frozen
class Text:
    """A text.

    Attributes:
        at: The middle of its line of writing [px].
        words: Its letters.
        look: The name of its look.
        size: Height of its letters [px].
    """

    at: Flat
    words: Words
    look: str
    size: float


@frozen
class Figure:
    """A finished drawing.

    Attributes:
        width: Of the paper [px].
        height: Of the paper [px].
        shapes: From back to front.
        texts: All labels.
        title: What it shows.
        caption: The line under it: what, how, at which pose, seen from where.
    """

    width: float
    height: float
    shapes: tuple[Shape, ...]
    texts: tuple[Text, ...]
    title: str = ""
    caption: str = ""


def arrowhead(tip: Flat, tail: Flat, size: float) -> tuple[Flat, Flat, Flat]:
    """A slim triangle at the end of a line."""
    dx, dy = tip[0] - tail[0], tip[1] - tail[1]
    length = math.hypot(dx, dy) or 1.0
    dx, dy = dx / length, dy / length
    back = tip[0] - size * dx, tip[1] - size * dy
    half = 0.36 * size
    return tip, (back[0] - half * dy, back[1] + half * dx), (back[0] + half * dy, back[1] - half * dx)


def hull(points: Sequence[Flat]) -> tuple[Flat, ...]:
    """The convex hull, by Andrew's monotone chain."""
    ordered = sorted(set(points))
    if len(ordered) < 3:  # noqa: PLR2004  a triangle
        return tuple(ordered)
    halves: list[list[Flat]] = []
    for row in (ordered, ordered[::-1]):
        chain: list[Flat] = []
        for point in row:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        halves.append(chain[:-1])
    return tuple(halves[0] + halves[1])


def ring(centre: Flat, radius: float, count: int = 24) -> tuple[Flat, ...]:
    """A circle as a polygon."""
    turns = [2 * math.pi * i / count for i in range(count)]
    return tuple((centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in turns)


def sides(corners: Sequence[P]) -> Iterator[tuple[P, P]]:
    """The sides of a polygon, each by its two ends."""
    return zip(corners, (*corners[1:], corners[0]), strict=True)


def cuts(edges: Iterable[tuple[Flat, Flat]], y: float) -> Iterator[tuple[float, float]]:
    """Where a polygon with these sides is on a level: from its left to its right, once or more often."""
    found = sorted(a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]) for a, b in edges if (a[1] <= y) != (b[1] <= y))
    return zip(found[::2], found[1::2], strict=False)


def halfway(a: Flat, b: Flat) -> Flat:
    """The point halfway."""
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def _turn(a: Flat, b: Flat, c: Flat) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
