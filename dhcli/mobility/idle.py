"""Idle freedoms: motions of a part that move nothing else, such as a rod that spins between two ball joints.

They are real freedoms, and the formula counts them; but nobody drives them, and they are set apart: found, frozen while
the rest is looked at, and added again. A part that two joints alone hold, and whose two joints both allow the same
motion, can make this motion by itself.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from dhcli.mobility.loops import closure
from dhcli.mobility.model import Model, Step
from dhcli.mobility.rank import TIGHT, rank_of, spaces
from dhcli.mobility.screws import Array

MOST_PAIRS = 4000
"""Pairs of joints that are looked at; long chains of identical parts have many."""


@dataclass(frozen=True)
class Idle:
    """One idle freedom.

    Attributes:
        links: The part that moves.
        joints: Names of the two joints that allow it.
        turns: Whether it turns; otherwise it slides.
        rates: Rates of the motions, shape (m,).
    """

    links: tuple[str, ...]
    joints: tuple[str, str]
    turns: bool
    rates: Array

    def __str__(self) -> str:
        """`the rod spins between joints 2 and 3`."""
        part = " with ".join(self.links) if len(self.links) < 4 else f"{self.links[0]} ... {self.links[-1]}"  # noqa: PLR2004  as many as a person reads
        many = len(self.links) > 1
        verb = ("spin" if self.turns else "slide") + "s" * (not many)
        return f"{part} {verb} between joints {self.joints[0]} and {self.joints[1]} and moves nothing else".replace(
            "moves nothing", "move nothing" if many else "moves nothing"
        )


@dataclass(frozen=True)
class Part:
    """Links that two joints alone hold.

    Attributes:
        first: One of the two joints.
        second: The other one.
        links: Indices of the links.
    """

    first: Step
    second: Step
    links: frozenset[int]

    def carries(self, step: Step) -> bool:
        """Whether a joint moves along when the part moves."""
        return step not in (self.first, self.second) and (step.tail in self.links or step.head in self.links)

    def disturbs(self, other: Part) -> bool:
        """Whether it carries one of another part's two joints away and leaves the other one behind."""
        return self.carries(other.first) != self.carries(other.second)


def idle_freedoms(model: Model, tolerance: float = TIGHT) -> tuple[Idle, ...]:
    """All independent idle freedoms; none of those that would disturb each other."""
    found: list[tuple[Idle, Part]] = []
    rows: list[Array] = []
    names = [joint.name for joint in model.linkage.joints]
    for part in _parts(model):
        for rates, turns in _common(model, part, tolerance):
            if rank_of(np.array([*rows, rates]), TIGHT).rank > len(rows):
                rows.append(rates)
                links = tuple(model.linkage.links[i] for i in sorted(part.links))
                found.append((Idle(links, (names[part.first.joint], names[part.second.joint]), turns, rates), part))
    # a folded rhombus can turn about either of its two double pins, but not about both: neither turn is idle
    parts = [part for _, part in found]
    return tuple(idle for idle, own in found if not any(own.disturbs(one) or one.disturbs(own) for one in parts))


def _parts(model: Model) -> Iterator[Part]:
    """Parts that two joints alone hold, small ones first.

    Two joints of a graph cut a part off if and only if they lie on the same loops: with a random number for each chord,
    the joints of the tree get the combination of the loops through them, and equal numbers show such pairs.
    """
    draw = random.Random(1)  # noqa: S311  labels, no secret
    label = {chord.joint: draw.getrandbits(64) for chord in model.chords}
    for step, _ in model.tree:
        label[step.joint] = 0
    for row, chord in enumerate(model.chords):
        for step, _ in model.tree:
            if step.last > step.first and model.signs[row, step.first]:
                label[step.joint] ^= label[chord.joint]
    meshed = {
        model.linkage.links.index(link) for joint in model.linkage.joints if joint.carrier for link in joint.links
    }
    outputs = {i for i, link in enumerate(model.linkage.links) if link == model.linkage.output}
    classes: dict[int, list[Step]] = {}
    for step in model.steps:
        if step.last > step.first and label[step.joint]:
            classes.setdefault(label[step.joint], []).append(step)
    pairs = [(a, b) for group in classes.values() for i, a in enumerate(group) for b in group[i + 1 :]][:MOST_PAIRS]
    parts = [Part(a, b, _side(model, a, b)) for a, b in pairs]
    whole = len(model.linkage.links) - 1
    for part in sorted(parts, key=lambda found: len(found.links)):
        if len(part.links) < whole and not part.links & (meshed | outputs):
            yield part


def _side(model: Model, first: Step, second: Step) -> frozenset[int]:
    """The links that two joints cut off from the ground."""
    touching: list[list[int]] = [[] for _ in model.linkage.links]
    for step in model.steps:
        if step not in (first, second):
            touching[step.tail].append(step.head)
            touching[step.head].append(step.tail)
    reached, waiting = {0}, [0]
    while waiting:
        for link in touching[waiting.pop()]:
            if link not in reached:
                reached.add(link)
                waiting.append(link)
    return frozenset(range(len(model.linkage.links))) - reached


def _common(model: Model, part: Part, tolerance: float) -> Iterator[tuple[Array, bool]]:
    """Rates of the motions that both joints allow, for as long as one likes, to the part between them."""
    first, second = part.first, part.second
    a, b = slice(first.first, first.last), slice(second.first, second.last)
    senses = [1.0 if step.head in part.links else -1.0 for step in (first, second)]
    for own in _groups(model, first):
        for others in _groups(model, second):
            both = [senses[0] * model.twists[a].T @ own, -senses[1] * model.twists[b].T @ others]
            _, null, _ = spaces(np.concatenate(both, axis=1), tolerance)
            for column in null.T:
                rates = np.zeros(model.motions)
                rates[a], rates[b] = own @ column[: own.shape[1]], others @ column[own.shape[1] :]
                twist = rates[a] @ model.twists[a]
                free = not model.ties.size or np.abs(model.ties @ rates).max() < TIGHT
                if free and float(np.abs(twist).max()) > TIGHT:
                    yield rates / np.linalg.norm(rates), bool(np.abs(twist[:3]).max() > tolerance)


def _groups_of_four(twists: Array) -> list[Array]:
    """The groups within a ball in a tube and a line contact, as columns (4, d)."""
    along = np.eye(4)[:, [0]]
    if not twists[1, :3].any():  # a line contact: sliding on the plane, or along the line and about it
        return [np.eye(4)[:, :3], np.eye(4)[:, [0, 3]]]
    about = np.concatenate([[0.0], twists[0, 3:]])[:, None]
    return [np.eye(4)[:, 1:], np.concatenate([along, about], axis=1)]


def _groups(model: Model, step: Step) -> list[Array]:
    """Motions of a joint that form a group, as columns (f, d); within one, any twist can go on for ever.

    A cross is no group: between its two axes it turns for an instant only. So are a bar and a contact, but each of
    their ends is a ball in space and a pin in the plane.
    """
    f = step.last - step.first
    twists = model.twists[step.first : step.last]
    if closure(twists) == f:
        return [np.eye(f)]
    if f == 5:  # noqa: PLR2004  a ball at the near end, two turns about the far end
        line = np.cross(twists[3, :3], twists[4, :3])
        far = np.eye(5)[:, 2:]
        far[:, 0] = [*line, 0, 0]
        return [np.eye(5)[:, :3], far]
    if f == 4:  # noqa: PLR2004
        return _groups_of_four(twists)
    return [np.eye(f)[:, [k]] for k in range(f)]
