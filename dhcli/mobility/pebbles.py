"""How many freedoms pins, slides and slots leave wherever they are placed: the pebble game counts without geometry.

Each link stands for bars between its pins that make it rigid. Of 2V coordinates every bar takes one away, unless the
bars among some V' pins are more than 2V' - 3. A link that guides others has one more coordinate, its angle, and links
that slide along one another turn together and share it. With it two equations hold a pin to the first one of its link,
and one holds a slide, or a pin in its slot, at its distance; some that touch V' pins and C' angles never count for more
than 2V' + C' - 3, for whatever they touch can be moved about as a whole. What is left is the mobility of almost every
placement, and no placement has less. So where the rank leaves just as many motions, it is as large as it can be, here
and all round: it stays the same along every motion, which therefore goes on. That holds for over-braced linkages too.

Of pins alone the count is also reached by almost every placement; with slides and slots that is found in all that were
tried, and nothing here depends on it.

Source: Laman 1970; Jacobs and Hendrickson 1997, the game; Streinu and Theran 2009, edges of more than two ends; Asimow
and Roth 1978, regular placements.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from dhcli.mobility.linkage import Joint
from dhcli.mobility.model import Model

Edge: TypeAlias = tuple[int, ...]
"""An equation by what it is about: two pins, or one, and an angle if need be."""

GUIDES = frozenset({"prismatic", "slot"})
"""Joints that are guided along a direction of the first link."""

PLAYED = frozenset({"revolute", "fixed", "bar", *GUIDES})
"""Joints of the plane that are pins, slides, pins in slots, or bars between pins."""

SAME = 9
"""Decimals of the size to which the places of two pins of a link agree that are one pin."""

TRIVIAL = 3
"""Freedoms of a body in the plane."""

PIN, ANGLE = 2, 1
"""Coordinates of each."""


def generic_freedoms(model: Model) -> int | None:
    """The fewest motions that a linkage of pins, slides and slots in the plane may have in any placement.

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
        """Put the pins of all joints on the bodies that they hold together."""
        self.model = model
        self.bodies, self.turning, self.pins = Groups(), Groups(), Groups()
        self.held: dict[int, dict[tuple[float, ...], int]] = {}  # the pins of each body by their places
        self.pebbles: list[int] = []
        self.names: dict[tuple[str, int], int] = {}
        for step in model.steps:
            if step.first == step.last:
                self.bodies.join(step.tail, step.head)
        self.joints = [
            (number, model.linkage.joints[step.joint], (self.bodies.of(step.tail), self.bodies.of(step.head)))
            for number, step in enumerate(model.steps)
        ]
        for number, joint, ends in self.joints:
            self._place(number, joint, ends)

    def graph(self) -> tuple[list[int], list[Edge]]:
        """The pebbles of each vertex, and the edges."""
        edges: list[Edge] = []
        guides = {self.turning.of(ends[0]) for _, joint, ends in self.joints if joint.pair.name in GUIDES}
        first: dict[int, int] = {}
        for body in self.held:
            own = list(dict.fromkeys(self._pin(pin) for pin in self.held[body].values()))
            has_angle = self.turning.of(body) in guides
            while len(own) < (1 if has_angle else 2):  # a point alone does not tell how a body is turned
                own.append(self._vertex("free", len(self.names)))
            first[body] = own[0]
            if has_angle:
                edges += [(own[0], pin, self._angle(body)) for pin in own[1:] for _ in range(PIN)]
            else:
                edges += _braced(own)
        return self.pebbles, [*edges, *self._single(first)]

    def _place(self, number: int, joint: Joint, ends: tuple[int, int]) -> None:
        """Put the pins of a joint on its bodies; what slides along one another turns together."""
        kind = joint.pair.name
        points = {
            "revolute": (joint.point, joint.point),
            "bar": (joint.point, joint.other),
            "slot": (None, joint.point),
        }.get(kind, (None, None))
        for side, (body, point) in enumerate(zip(ends, points, strict=True)):
            own = self.held.setdefault(body, {})
            if point is not None:
                place = np.round((np.array(point) - self.model.centre)[:2] / self.model.scale, SAME) + 0.0
                pin = 2 * number + (0 if kind == "revolute" else side)
                self.pins.join(pin, own.setdefault(tuple(place), pin))
        if kind == "prismatic":
            self.turning.join(*ends)

    def _single(self, first: dict[int, int]) -> Iterator[Edge]:
        """The equation of each bar, slide and slot."""
        for number, joint, (tail, head) in self.joints:
            match joint.pair.name:
                case "bar":
                    yield _once(self._pin(2 * number), self._pin(2 * number + 1))
                case "prismatic":
                    yield _once(first[tail], first[head], self._angle(tail))
                case "slot":
                    yield _once(first[tail], self._pin(2 * number + 1), self._angle(tail))

    def _pin(self, pin: int) -> int:
        return self._vertex("pin", self.pins.of(pin))

    def _angle(self, body: int) -> int:
        return self._vertex("angle", self.turning.of(body), ANGLE)

    def _vertex(self, kind: str, number: int, pebbles: int = PIN) -> int:
        """The number of a vertex in the graph, a new one if need be."""
        if (kind, number) not in self.names:
            self.names[kind, number] = len(self.pebbles)
            self.pebbles.append(pebbles)
        return self.names[kind, number]


def _once(*ends: int) -> Edge:
    """An edge, each of its ends once."""
    return tuple(dict.fromkeys(ends))


def _braced(pins: list[int]) -> Iterator[Edge]:
    """Bars that hold all pins of a body together, 2k - 3 of them."""
    first, second, *others = pins
    yield first, second
    for pin in others:
        yield first, pin
        yield second, pin


class Groups:
    """Numbers that stand for the same thing; each by itself at first.

    Source: Tarjan 1975, union and find with the ways halved.
    """

    def __init__(self) -> None:
        """Begin with each number by itself."""
        self._above: dict[int, int] = {}

    def of(self, one: int) -> int:
        """The number that all of a group share."""
        while (above := self._above.get(one, one)) != one:
            self._above[one] = one = self._above.get(above, above)
        return one

    def join(self, one: int, other: int) -> None:
        """Make two groups one."""
        self._above[self.of(one)] = self.of(other)
