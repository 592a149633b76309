"""Idle freedoms: motions of a part that move nothing else, such as a rod that spins between two ball joints.

They are real freedoms, and the formula counts them; but nobody drives them, and they are set apart: found, frozen while
the rest is looked at, and added again. A part that two joints alone hold, and whose two joints both allow the same
motion, can make this motion by itself.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from itertools import combinations, islice

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.rank import TIGHT, rank_of, spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.loops import closure
from dhcli.mobility.model import Model, Step

MOST_PAIRS = 4000
"""Pairs of joints that are looked at; long chains of identical parts have many."""

ALIKE = 0.95
"""Cosine of two twists, in six dimensions, that may be one in a rounded drawing."""


@frozen
class Idle:
    """One idle freedom.

    Attributes:
        links: The part that moves.
        joints: Names of the two joints that allow it.
        turns: Whether it turns; otherwise it slides.
        rates: Rates of the motions, shape (m,).
        part: The part and the joints that hold it.
        lasting: Whether the part itself keeps what both joints allow, wherever the linkage goes: a rod keeps the line
            between its balls. Two bars that lie over one pin may come apart.
    """

    links: tuple[str, ...]
    joints: tuple[str, str]
    turns: bool
    rates: Array
    part: Part
    lasting: bool

    __eq__ = object.__eq__  # each equals itself only
    __hash__ = object.__hash__

    def __str__(self) -> str:
        """`rod spins between joints 2 and 3 and moves nothing else`."""
        return f"{self._moves} and {'move' if len(self.links) > 1 else 'moves'} nothing else"

    @property
    def passing(self) -> str:
        """The same of a motion that the rest of the linkage takes away when it moves."""
        return (
            f"{self._moves} in this position only: when the rest moves, the two joints no longer allow the same motion"
        )

    @property
    def _moves(self) -> str:
        part = " with ".join(self.links) if len(self.links) < 4 else f"{self.links[0]} ... {self.links[-1]}"  # noqa: PLR2004  as many as a person reads
        verb = ("spin" if self.turns else "slide") + "s" * (len(self.links) == 1)
        return f"{part} {verb} between joints {self.joints[0]} and {self.joints[1]}"


@frozen
class Part:
    """Links that two joints alone hold."""

    first: Step
    second: Step
    links: frozenset[int]

    def carries(self, step: Step) -> bool:
        """Whether a joint moves along when the part moves."""
        return step not in (self.first, self.second) and (step.tail in self.links or step.head in self.links)

    def keeps(self, step: Step, where: str) -> bool:
        """Whether it is one link, in which a group of one of its joints stands still."""
        return len(self.links) == 1 and (where == BOTH or (where == SECOND) == (step.head in self.links))

    def disturbs(self, other: Part) -> bool:
        """Whether it carries one of another part's two joints away and leaves the other one behind."""
        return self.carries(other.first) != self.carries(other.second)


def idle_freedoms(model: Model, tolerance: float) -> tuple[Idle, ...]:
    """All independent idle freedoms; none of those that would disturb each other."""
    found: list[tuple[Idle, Part]] = []
    rows: list[Array] = []
    names = [joint.name for joint in model.linkage.joints]
    for part in _parts(model):
        links = tuple(model.linkage.links[i] for i in sorted(part.links))
        ends = names[part.first.joint], names[part.second.joint]
        for rates, turns, lasting in _common(model, part, tolerance):
            if rank_of(np.array([*rows, rates]), TIGHT).rank > len(rows):
                rows.append(rates)
                found.append((Idle(links, ends, turns, rates, part, lasting), part))
    # a folded rhombus can turn about either of its two double pins, but not about both: neither turn is idle
    parts = [part for _, part in found]
    return tuple(idle for idle, own in found if not any(own.disturbs(one) or one.disturbs(own) for one in parts))


def still_idle(model: Model, idle: Sequence[Idle], twists: Array, tolerance: float) -> tuple[Idle, ...]:
    """Those idle freedoms that are still there in another position.

    Args:
        model: The linkage.
        idle: Idle freedoms of the given position.
        twists: World twists in the other position, shape (m, 6).
        tolerance: Relative error of that position.
    """
    left: dict[Part, list[Array]] = {}
    found = []
    for one in idle:
        if one.part not in left:
            left[one.part] = [rates for rates, _, _ in _common(model, one.part, tolerance, twists)]
        if one.lasting or left[one.part]:
            found.append(one)
            left[one.part] = left[one.part][1:]
    return tuple(found)


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
    alike = ((a, b) for group in classes.values() for a, b in combinations(group, 2) if _may_share(model, a, b))
    parts = [Part(a, b, _side(model, a, b)) for a, b in islice(alike, MOST_PAIRS)]
    whole = len(model.linkage.links) - 1
    for part in sorted(parts, key=lambda found: len(found.links)):
        if len(part.links) < whole and not part.links & (meshed | outputs):
            yield part


def _may_share(model: Model, first: Step, second: Step) -> bool:
    """Whether two joints may allow the same motion; most pairs of a long chain are told apart by a glance at this."""
    if first.last - first.first > 1 or second.last - second.first > 1:
        return True
    a, b = model.twists[first.first], model.twists[second.first]
    return bool(abs(a @ b) > ALIKE * np.sqrt((a @ a) * (b @ b)))


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


def _common(
    model: Model, part: Part, tolerance: float, twists: Array | None = None
) -> Iterator[tuple[Array, bool, bool]]:
    """Rates of the motions that both joints allow, for as long as one likes, to the part between them.

    Yields:
        The rates, whether the part turns, and whether it can do so wherever the linkage goes.
    """
    seen = model.twists if twists is None else twists
    first, second = part.first, part.second
    a, b = slice(first.first, first.last), slice(second.first, second.last)
    senses = [1.0 if step.head in part.links else -1.0 for step in (first, second)]
    for own, kept in _groups(seen[a]):
        for others, kept_too in _groups(seen[b]):
            lasting = part.keeps(first, kept) and part.keeps(second, kept_too)
            both = [senses[0] * seen[a].T @ own, -senses[1] * seen[b].T @ others]
            _, null, _ = spaces(np.concatenate(both, axis=1), tolerance)
            for column in null.T:
                rates = np.zeros(model.motions)
                rates[a], rates[b] = own @ column[: own.shape[1]], others @ column[own.shape[1] :]
                twist = rates[a] @ seen[a]
                free = not model.ties.size or np.abs(model.ties @ rates).max() < max(TIGHT, tolerance)
                if free and float(np.abs(twist).max()) > tolerance:
                    turns = bool(np.abs(twist[:3]).max() > tolerance)
                    yield rates / np.linalg.norm(rates), turns, lasting


BOTH, FIRST, SECOND = "both links", "the first link", "the second link"
"""In which link the axes and centres of a group stand still: of a ball in both, of the first axis of a cross in one."""


def _groups(twists: Array) -> list[tuple[Array, str]]:
    """Motions of a joint that form a group, as columns (f, d), and the links that keep it.

    Within a group any twist can go on for ever. A cross is no group: between its two axes it turns for an instant only.
    So are a bar and a contact, but each of their ends is a ball in space and a pin in the plane.
    """
    f = len(twists)
    unit = np.eye(f)
    if closure(twists) == f:
        return [(unit, BOTH)]
    if f == 5:  # noqa: PLR2004  a ball at the near end, two turns about the far end
        line = np.cross(twists[3, :3], twists[4, :3])
        far = unit[:, 2:].copy()
        far[:, 0] = [*np.linalg.solve(twists[:3, :3].T, line), 0, 0]
        return [(unit[:, :3], FIRST), (far, SECOND)]
    if f == 4:  # noqa: PLR2004  a ball in a tube, or a cylinder on a plane
        if twists[1, :3].any():
            tube = np.concatenate([[0.0], np.linalg.solve(twists[1:, :3].T, twists[0, 3:])])
            return [(unit[:, 1:], SECOND), (np.column_stack([unit[:, 0], tube]), FIRST)]
        return [(unit[:, :3], FIRST), (unit[:, [0, 3]], SECOND)]
    return [(unit[:, [k]], FIRST if k == 0 else SECOND) for k in range(f)]
