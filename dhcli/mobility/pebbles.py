"""How many freedoms pins and sliders leave wherever they are placed: the pebble game, which counts without geometry.

Each link stands for bars between its pins that make it rigid. Of 2V coordinates every bar takes one away, unless the
bars among some V' pins are more than 2V' - 3. Links that slide along one another turn together: they share one more
coordinate, their angle. With it two equations hold a pin to the first one of its link, and one holds a slide's two
sides at their distance; some that touch V' pins and C' angles are never more than 2V' + C' - 3, for whatever is placed
there can be moved about as a whole. What is left is the mobility of almost every placement, and no placement has less.
So where the rank leaves just as many motions, it is as large as it can be, here and all round: it stays the same along
every motion, which therefore goes on. That holds for over-braced linkages too.

Of pins alone the count is also reached by almost every placement; of slides that is found in all that were tried, and
nothing here depends on it.

Source: Laman 1970; Jacobs and Hendrickson 1997, the game; Streinu and Theran 2009, edges of more than two ends; Asimow
and Roth 1978, regular placements.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from dhcli.mobility.groups import Groups
from dhcli.mobility.model import Model

Edge: TypeAlias = tuple[int, ...]
"""An equation by what it is about: two pins, or one, and an angle if need be."""

PLAYED = frozenset({"revolute", "prismatic", "fixed", "bar"})
"""Joints of the plane that are pins, slides, or bars between pins."""

SAME = 9
"""Decimals of the size to which the places of two pins of a link agree that are one pin."""

TRIVIAL = 3
"""Freedoms of a body in the plane."""

PIN, ANGLE = 2, 1
"""Coordinates of each."""


def generic_freedoms(model: Model) -> int | None:
    """The fewest motions that a linkage of pins and slides in the plane may have in any placement.

    None for other joints, of which the game knows nothing. A linkage in space is played, too, if all its axes are
    parallel to z, and what slides does so across them.
    """
    if len(model.basis) != TRIVIAL or not all(joint.pair.name in PLAYED for joint in model.linkage.joints):
        return None
    pebbles, edges = _Framework(model).graph()
    return sum(pebbles) - TRIVIAL - independent(pebbles, edges)


def independent(pebbles: Sequence[int], edges: Iterable[Edge]) -> int:
    """The number of edges that count, of which no part is larger than its vertices' pebbles together less 3.

    An edge that counts is covered by a pebble of one of its ends. It counts if four pebbles can be brought to its ends
    together.

    Args:
        pebbles: How many each vertex owns, one for each coordinate.
        edges: The vertices of each edge.
    """
    game = _Game(pebbles)
    return sum(game.accepts(edge) for edge in edges)


class _Game:
    """Pebbles on a graph of the edges that count, each pointing away from the end that covers it."""

    def __init__(self, pebbles: Sequence[int]) -> None:
        self.owned = pebbles
        self.free = [*pebbles]
        self.covers: list[list[Edge]] = [[] for _ in pebbles]

    def accepts(self, edge: Edge) -> bool:
        """Whether one more edge counts; then it is laid."""
        while sum(self.free[end] for end in edge) <= TRIVIAL:
            if not any(self.free[end] < self.owned[end] and self._fetches(end, edge) for end in edge):
                return False
        first = next(end for end in edge if self.free[end])
        self.free[first] -= 1
        self.covers[first].append(edge)
        return True

    def _fetches(self, end: int, kept: Edge) -> bool:
        """Bring a pebble to an end of an edge from where there is one, but for its ends, which keep their own."""
        came: dict[int, tuple[int, Edge]] = dict.fromkeys(kept, (end, kept))
        waiting = [end]
        while waiting:
            here = waiting.pop()
            for edge in self.covers[here]:
                for there in edge:
                    if there not in came:
                        came[there] = here, edge
                        if self.free[there]:
                            self._turn_round(there, end, came)
                            return True
                        waiting.append(there)
        return False

    def _turn_round(self, there: int, end: int, came: dict[int, tuple[int, Edge]]) -> None:
        """Turn the edges on the way to a free pebble, which so comes to the beginning of the way."""
        self.free[there] -= 1
        self.free[end] += 1
        way = [there]
        while way[-1] != end:
            way.append(came[way[-1]][0])
        for far, near in pairwise(way):
            edge = came[far][1]
            self.covers[near].remove(edge)
            self.covers[far].append(edge)


class _Framework:
    """Pins and angles as vertices, and the equations between them, as many as are needed."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.bodies, self.turning, self.pins = Groups(), Groups(), Groups()
        self.held: dict[int, dict[tuple[float, ...], int]] = {}  # the pins of each body by their places
        self.pebbles: list[int] = []
        self.names: dict[tuple[str, int], int] = {}
        for step in model.steps:
            if step.first == step.last:
                self.bodies.join(step.tail, step.head)
        for step in model.steps:
            self._place(step.joint, (self.bodies.of(step.tail), self.bodies.of(step.head)))

    def graph(self) -> tuple[list[int], list[Edge]]:
        """The pebbles of each vertex, and the edges."""
        edges = [*self._lengths()]
        together = Counter(self.turning.of(body) for body in self._each_body())
        first = {}
        for body in self._each_body():
            own = list(dict.fromkeys(self._vertex("pin", self.pins.of(pin)) for pin in self.held[body].values()))
            slides = together[self.turning.of(body)] > 1
            while len(own) < (1 if slides else 2):  # a point alone does not tell how a body is turned
                own.append(self._vertex("free", len(self.names)))
            first[body] = own[0]
            if slides:
                angle = self._vertex("angle", self.turning.of(body), ANGLE)
                edges += [(own[0], pin, angle) for pin in own[1:] for _ in range(PIN)]
            else:
                edges += _braced(own)
        return self.pebbles, [*edges, *self._slides(first)]

    def _place(self, joint: int, ends: tuple[int, int]) -> None:
        """Put a joint's pins on the bodies that it holds together; what slides turns together."""
        one = self.model.linkage.joints[joint]
        kind = one.pair.name
        for number, body in enumerate(ends):
            own = self.held.setdefault(body, {})
            if kind in {"revolute", "bar"}:
                point = one.other if kind == "bar" and number else one.point
                place = np.round((np.array(point) - self.model.centre)[:2] / self.model.scale, SAME) + 0.0
                pin = 2 * joint + (number if kind == "bar" else 0)
                self.pins.join(pin, own.setdefault(tuple(place), pin))
        if kind == "prismatic":
            self.turning.join(*ends)

    def _each_body(self) -> Iterator[int]:
        return iter(dict.fromkeys(map(self.bodies.of, range(len(self.model.linkage.links)))))

    def _lengths(self) -> Iterator[Edge]:
        """An equation for each bar."""
        for step in self.model.steps:
            if self.model.linkage.joints[step.joint].pair.name == "bar":
                ends = (self._vertex("pin", self.pins.of(2 * step.joint + number)) for number in range(2))
                yield tuple(dict.fromkeys(ends))

    def _slides(self, first: dict[int, int]) -> Iterator[Edge]:
        """An equation for each slide, between the first pins of its bodies."""
        for step in self.model.steps:
            if self.model.linkage.joints[step.joint].pair.name == "prismatic":
                tail, head = self.bodies.of(step.tail), self.bodies.of(step.head)
                angle = self.names.get(("angle", self.turning.of(tail)))
                if tail != head and angle is not None:
                    yield tuple(dict.fromkeys((first[tail], first[head], angle)))

    def _vertex(self, kind: str, number: int, pebbles: int = PIN) -> int:
        """The number of a vertex in the graph, a new one if need be."""
        if (kind, number) not in self.names:
            self.names[kind, number] = len(self.pebbles)
            self.pebbles.append(pebbles)
        return self.names[kind, number]


def _braced(pins: list[int]) -> Iterator[Edge]:
    """Bars that hold all pins of a body together, 2k - 3 of them."""
    first, second, *others = pins
    yield first, second
    for pin in others:
        yield first, pin
        yield second, pin
