"""Room for labels: 16 places on 6 rings around each, the most crowded first, none ever on another."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from dhcli.frozen import frozen
from dhcli.scene.ink import Ink
from dhcli.scene.shapes import Shape, Text
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Words

PLACES = tuple((math.cos(math.tau * i / 16), math.sin(math.tau * i / 16)) for i in range(16))
RINGS = (2.0, 7.0, 14.0, 23.0, 34.0, 48.0)
FAR_RINGS = (66.0, 90.0, 120.0, 160.0, 210.0, 270.0, 340.0, 420.0, 520.0, 640.0)
"""Distances between a label and its point [px]; the far ones are tried where the near ones are taken."""

LEADER = 10.0
"""From this distance on a thin line ties a label to its point [px]."""

INK, DISTANCE, TURNED, CROSSED = 30.0, 0.16, 2.2, 6.0
"""Costs: of ink under a label, of a pixel of distance, of the wrong side, of a line across a label."""


@frozen
class Lettering:
    """How large letters are.

    Attributes:
        size: Height of a letter [px].
        wide: Width of a letter in parts of its height; generous, because fonts differ.
        below: Height of an index in parts of a letter.
        height: Height of a line in parts of a letter.
        spell: How a label is spelled where each letter has a cell of its own; None where indices are small.
        pad: Room that a label keeps free beside it [px].
    """

    size: float = 17.0
    wide: float = 0.66
    below: float = 0.72
    height: float = 1.42
    spell: Callable[[Words], str] | None = None
    pad: float = 2.0

    def box(self, words: Words) -> Flat:
        """Width and height of a label [px]."""
        if self.spell:
            return len(self.spell(words)) * self.wide * self.size + self.pad, self.height * self.size
        letters = sum(len(run.text) * (self.below if run.below else 1) for run in words)
        return letters * self.wide * self.size + self.pad, self.height * self.size


PRINT = Lettering()


@frozen
class Wish:
    """A label that wants a place.

    Attributes:
        points: The points it may belong to, one or several of a line [px].
        words: Its letters.
        look: The name of its look.
        away: The side on which it is best, a direction; none is as good as any.
    """

    points: tuple[Flat, ...]
    words: Words
    look: str
    away: Flat = (0.0, 0.0)


@frozen
class Rect:
    """A rectangle on paper [px]."""

    left: float
    top: float
    right: float
    bottom: float

    def meets(self, other: Rect) -> bool:
        """Whether they overlap."""
        return (
            self.left < other.right and other.left < self.right and self.top < other.bottom and other.top < self.bottom
        )

    def cuts(self, a: Flat, b: Flat) -> bool:
        """Whether a line runs through it."""
        if (a[0] <= self.left and b[0] <= self.left) or (a[0] >= self.right and b[0] >= self.right):
            return False
        if (a[1] <= self.top and b[1] <= self.top) or (a[1] >= self.bottom and b[1] >= self.bottom):
            return False
        low, high = 0.0, 1.0
        for start, way, least, most in (
            (a[0], b[0] - a[0], self.left, self.right),
            (a[1], b[1] - a[1], self.top, self.bottom),
        ):
            if abs(way) < 1e-9:  # noqa: PLR2004  level or upright
                if not least < start < most:
                    return False
                continue
            ends = sorted(((least - start) / way, (most - start) / way))
            low, high = max(low, ends[0]), min(high, ends[1])
        return low < high


def placed(wishes: list[Wish], ink: Ink, room: Rect, lettering: Lettering = PRINT) -> tuple[list[Shape], list[Text]]:
    """Leader lines and labels.

    Returns:
        Lines and texts; no text overlaps another. A label for which nowhere is room is left out.
    """
    taken: list[Rect] = []
    leaders: list[tuple[Flat, Flat]] = []
    texts: list[Text] = []
    for wish in sorted(wishes, key=lambda wish: -_crowd(wish, wishes, ink)):
        box = lettering.box(wish.words)
        best: tuple[float, Rect, Flat] | None = None
        for rings in (RINGS, FAR_RINGS):
            for cost, (x, y), point in _places(wish, box, rings, room):
                if best and cost >= best[0]:
                    continue
                rect = Rect(x - box[0] / 2, y - box[1] / 2, x + box[0] / 2, y + box[1] / 2)
                if _is_taken(rect, taken):
                    continue
                crossed = cost + _crossed(rect, point, taken, leaders)
                if best and crossed >= best[0]:
                    continue  # what stands below makes no place better, and takes longest to add up
                full = crossed + _below(rect, ink)
                if best is None or full < best[0] - 1e-9:
                    best = full, rect, point
            if best:
                break
        if best is None:
            continue
        _, rect, point = best
        taken.append(rect)
        centre = (rect.left + rect.right) / 2, (rect.top + rect.bottom) / 2
        texts.append(Text((centre[0], centre[1] + 0.26 * lettering.size), wish.words, wish.look, lettering.size))
        edge = min(max(point[0], rect.left + 1), rect.right - 1), min(max(point[1], rect.top + 4), rect.bottom - 4)
        if math.dist(edge, point) > LEADER:
            leaders.append((point, edge))
    return [Shape(line, "leader") for line in leaders], texts


def _places(wish: Wish, box: Flat, rings: tuple[float, ...], room: Rect) -> Iterator[tuple[float, Flat, Flat]]:
    """Every middle of a label inside the room, with its cost by distance and side, and the point it belongs to."""
    half_w, half_h = box[0] / 2, box[1] / 2
    left, top, right, bottom = room.left + half_w, room.top + half_h, room.right - half_w, room.bottom - half_h
    wanted = math.hypot(*wish.away)
    ways = []
    for dx, dy in PLACES:
        side = (dx * wish.away[0] + dy * wish.away[1]) / wanted if wanted > 1e-9 else 1.0  # noqa: PLR2004
        to_edge = min(half_w / max(abs(dx), 1e-9), half_h * 0.8 / max(abs(dy), 1e-9))
        ways.append((dx, dy, to_edge, TURNED * (1 - side)))
    for number, point in enumerate(wish.points):
        for ring in rings:
            for dx, dy, to_edge, turned in ways:
                x, y = point[0] + dx * (ring + to_edge), point[1] + dy * (ring + to_edge)
                if left <= x <= right and top <= y <= bottom:
                    yield DISTANCE * ring + turned + 0.01 * number, (x, y), point


def _is_taken(rect: Rect, taken: list[Rect]) -> bool:
    """Whether a rectangle meets one of others; asked for each place of each label, so without a call for each."""
    left, top, right, bottom = rect.left, rect.top, rect.right, rect.bottom
    for other in taken:
        if left < other.right and other.left < right and top < other.bottom and other.top < bottom:
            return True
    return False


def _below(rect: Rect, ink: Ink) -> float:
    """Cost of what a label stands on."""
    area = max((rect.right - rect.left) * (rect.bottom - rect.top) / 16, 1.0)
    return INK * ink.amount(rect.left + 2, rect.top + 4, rect.right - 2, rect.bottom - 4) / 6 / math.sqrt(area) / 3


def _crossed(rect: Rect, point: Flat, taken: list[Rect], leaders: list[tuple[Flat, Flat]]) -> float:
    """Cost of lines that cross."""
    edge = min(max(point[0], rect.left), rect.right), min(max(point[1], rect.top), rect.bottom)
    return CROSSED * (sum(rect.cuts(*leader) for leader in leaders) + sum(other.cuts(point, edge) for other in taken))


def _crowd(wish: Wish, wishes: list[Wish], ink: Ink) -> float:
    """How little room there is around a label."""
    x, y = wish.points[0]
    near = sum(math.dist((x, y), other.points[0]) < 50 for other in wishes)  # noqa: PLR2004  within reach of a label
    return near * 100 + ink.amount(x - 30, y - 30, x + 30, y + 30) / 10 - 40 * len(wish.points)
