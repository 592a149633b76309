"""How many freedoms pins leave wherever they are placed: the pebble game, which counts and needs no geometry.

Each link stands for bars between its pins that make it rigid. Of 2V coordinates every bar takes one away, unless the
bars among some V' pins are more than 2V' - 3. What is left is the mobility of almost every placement, and no placement
has less. So where the rank leaves just as many motions, it is as large as it can be, here and all round: it stays
the same along every motion, which therefore goes on. That holds for over-braced linkages too.

Source: Laman 1970; Jacobs and Hendrickson 1997, the game; Asimow and Roth 1978, regular placements.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from dhcli.mobility.groups import Groups
from dhcli.mobility.model import Model

Bar: TypeAlias = tuple[int, int]

PLAYED = frozenset({"revolute", "fixed", "bar"})
"""Joints of the plane that are pins, or bars between pins."""

SAME = 9
"""Decimals of the size to which the places of two pins of a link agree that are one pin."""

TRIVIAL = 3
"""Freedoms of a body in the plane."""


def generic_freedoms(model: Model) -> int | None:
    """The motions that a linkage of pins in the plane has in almost every placement, and at least in each.

    None for other joints, of which the game knows nothing. A linkage in space is played, too, if all its axes are
    parallel to z.
    """
    if len(model.basis) != TRIVIAL or not all(joint.pair.name in PLAYED for joint in model.linkage.joints):
        return None
    vertices, bars = _framework(model)
    return 2 * vertices - TRIVIAL - independent(vertices, bars)


def independent(vertices: int, bars: list[Bar]) -> int:
    """The number of bars that count, of a graph whose vertices are placed at random in the plane.

    Each vertex owns two pebbles, one for each coordinate; a bar that counts is covered by one of its ends' pebbles. It
    counts if four pebbles can be brought to its ends together.
    """
    game = _Game(vertices)
    return sum(game.accepts(a, b) for a, b in bars)


class _Game:
    """Pebbles on a graph whose edges are the bars that count, each pointing away from the end that covers it."""

    def __init__(self, vertices: int) -> None:
        self.free = [2] * vertices
        self.covers: list[list[int]] = [[] for _ in range(vertices)]

    def accepts(self, a: int, b: int) -> bool:
        """Whether one more bar counts; then it is laid."""
        # both of its own come back to any one vertex; then they stay there while the other end looks for its own
        while self.free[a] < 2 and self._fetches(a, a):  # noqa: PLR2004  both of its own
            pass
        while self.free[b] < 2:  # noqa: PLR2004  the same
            if not self._fetches(b, a):
                return False
        self.free[a] -= 1
        self.covers[a].append(b)
        return True

    def _fetches(self, end: int, kept: int) -> bool:
        """Bring a pebble to an end of a bar from where there is one, but for a vertex that keeps its own."""
        came, waiting = {end: end, kept: end}, [end]
        while waiting:
            here = waiting.pop()
            for there in self.covers[here]:
                if there not in came:
                    came[there] = here
                    if self.free[there]:
                        self._turn_round(there, end, came)
                        return True
                    waiting.append(there)
        return False

    def _turn_round(self, there: int, end: int, came: dict[int, int]) -> None:
        """Turn the bars on the way to a free pebble, which so comes to the beginning of the way."""
        self.free[there] -= 1
        self.free[end] += 1
        way = [there]
        while way[-1] != end:
            way.append(came[way[-1]])
        for far, near in pairwise(way):
            self.covers[near].remove(far)
            self.covers[far].append(near)


def _framework(model: Model) -> tuple[int, list[Bar]]:
    """The pins as vertices, and bars that make each link rigid, as many as needed."""
    bodies, pins = _bodies(model), Groups()
    held: dict[int, dict[tuple[float, ...], int]] = {}  # the pins of each body by their places
    for step in model.steps:
        joint = model.linkage.joints[step.joint]
        ends = {"revolute": (joint.point, joint.point), "bar": (joint.point, joint.other)}.get(joint.pair.name, ())
        for number, (link, point) in enumerate(zip((step.tail, step.head), ends, strict=False)):
            place = tuple(np.round((np.array(point) - model.centre)[:2] / model.scale, SAME) + 0.0)
            pin = 2 * step.joint + (number if joint.pair.name == "bar" else 0)
            pins.join(pin, held.setdefault(bodies.of(link), {}).setdefault(place, pin))
    lengths = [
        (2 * step.joint, 2 * step.joint + 1)
        for step in model.steps
        if model.linkage.joints[step.joint].pair.name == "bar"
    ]
    names: dict[int, int] = {}
    bars = [(names.setdefault(pins.of(a), len(names)), names.setdefault(pins.of(b), len(names))) for a, b in lengths]
    for body in {bodies.of(link): None for link in range(len(model.linkage.links))}:
        own = list(dict.fromkeys(names.setdefault(pins.of(pin), len(names)) for pin in held.get(body, {}).values()))
        while len(own) < 2:  # noqa: PLR2004  a point alone does not tell how a body is turned
            own.append(names.setdefault(-1 - len(names), len(names)))
        bars += _braced(own)
    return len(names), bars


def _braced(pins: list[int]) -> Iterator[Bar]:
    """Bars that hold all pins of a body together, 2k - 3 of them."""
    first, second, *others = pins
    yield first, second
    for pin in others:
        yield first, pin
        yield second, pin


def _bodies(model: Model) -> Groups:
    """The links, those that are welded together as one."""
    found = Groups()
    for step in model.steps:
        if step.first == step.last:
            found.join(step.tail, step.head)
    return found
