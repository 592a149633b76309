"""Formulas for a joint at random poses, on all branches: sound if every value solves, covering if none is missing.

The other joints that stand in a formula come from each true solution; lengths without a value are drawn, too.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from dhcli.algebra.floats import Floats
from dhcli.checking.solving.derived import values_at
from dhcli.checking.solving.formulas import Formula
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_points import pose_values
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Call, Expr
from dhcli.notation.walk import walk
from dhcli.notation.writer import write

POSES = 25
"""Random poses at which a formula is tried."""

SAME = 1e-6
CONFIRMED = 1e-7
Known = dict[str, Angle | float]


@frozen
class Case:
    """One true solution at one pose.

    Attributes:
        known: The entries of the pose, every length, and the joints as they stand in it.
        right: The value of what is asked.
        others: The values it has in the solutions that agree on some other joints; all solutions of the pose.
        ends: Values of the textbook formula from which no other joint leads on: whoever has them has made no slip.
    """

    known: Known
    right: float
    others: tuple[tuple[Known, float], ...]
    ends: tuple[float, ...] = ()


@frozen
class Asked:
    """What is asked: a joint, or a sum of joints, each with its factor."""

    terms: tuple[tuple[str, int], ...]
    turns: bool

    def value(self, q: Mapping[str, float]) -> float:
        """Its value in a solution."""
        return sum(factor * q[name] for name, factor in self.terms)

    def same(self, one: float, other: float) -> bool:
        """Whether two values are one, whole turns aside."""
        gap = math.remainder(one - other, math.tau) if self.turns else one - other
        return abs(gap) <= SAME


def points(
    derivation: Derivation, robot: Robot, given: Mapping[str, Value], asked: Asked, textbook: Formula
) -> tuple[Case, ...]:
    """Every true solution at random poses, confirmed by the forward kinematics; lengths not given are drawn."""
    draw = random.Random(23)  # noqa: S311  a fixed seed, for the same judgement every time
    chain = between(robot, derivation.start, derivation.end)
    there = sorted(names(chain))
    joints = [name for name in robot.variables if name in there]
    found = list[Case]()
    for _ in range(POSES):
        known: Known = dict(numbers({name: value for name, value in given.items() if name in there}))
        for name in there:
            if name not in known:
                known[name] = draw.uniform(-3, 3) if name in robot.angles else draw.uniform(0.2, 1.3)
        entries = pose_values(chain, known)
        lengths = {name: value for name, value in known.items() if name not in joints}
        solved: list[Known] = []
        values = list[float]()
        for q in values_at(derivation, robot, {}, {**lengths, **entries}):  # type: ignore[dict-item]
            own: Known = {**lengths, **entries, **{name: q[name] for name in joints}}
            if _reaches(chain, own, entries, place_only=derivation.place_only) and not any(
                all(_close(own[name], other[name], turns=name in robot.angles) for name in joints) for other in solved
            ):
                solved.append(own)
                values.append(asked.value(q))
        pairs = tuple(zip(solved, values, strict=True))
        found += [Case(own, value, pairs, _ends(textbook, own, values, asked)) for own, value in pairs]
    return tuple(found)


def _ends(textbook: Formula, known: Known, values: Sequence[float], asked: Asked) -> tuple[float, ...]:
    """Values of the textbook formula that are those of no solution: with them the rest of the arm is too short."""
    return tuple(end for end in textbook.at(known) if not any(asked.same(end, value) for value in values))


def _close(one: Angle | float, other: Angle | float, *, turns: bool) -> bool:
    if isinstance(one, Angle) or isinstance(other, Angle):
        return one == other
    return abs(math.remainder(one - other, math.tau) if turns else one - other) <= SAME


def _reaches(chain: Sequence[object], q: Known, entries: Mapping[str, float], *, place_only: bool) -> bool:
    rows = fold(chain, Floats(q))  # type: ignore[arg-type]
    off = max(abs(rows[i][3] - entries[f"p{axis}"]) for i, axis in enumerate("xyz"))
    if not place_only:
        off = max(off, *(abs(rows[i][j] - entries[f"r{i + 1}{j + 1}"]) for i in range(3) for j in range(3)))
    return off <= CONFIRMED


@frozen
class Outcome:
    """How a formula does at all points.

    Attributes:
        hits: For each true solution whether the formula has its value.
        strangers: For each whether the formula has a value that solves nothing.
        silent: How many of them it has no real value for.
        wrapped: Whether every value that solves nothing is half a turn from one that does.
        values: What the formula has there.
    """

    hits: tuple[bool, ...]
    strangers: tuple[bool, ...]
    silent: int
    wrapped: bool
    values: tuple[list[float], ...]

    @property
    def is_sound(self) -> bool:
        """Whether every value solves."""
        return not any(self.strangers) and any(self.hits)

    @property
    def is_covering(self) -> bool:
        """Whether no value is missing."""
        return all(self.hits)

    @property
    def is_right(self) -> bool:
        """Whether it has all values and no others."""
        return self.is_sound and self.is_covering

    @property
    def share(self) -> float:
        """Share of the solutions that it has."""
        return sum(self.hits) / max(1, len(self.hits))


def tried(formula: Formula, cases: Sequence[Case], asked: Asked, robot: Robot) -> Outcome:
    """Try a formula at every true solution of all poses.

    Several ± in it may be meant to go together, or each by itself: it is right if it is so in one of the two ways.
    """
    if formula.together:
        linked = tried(replace(formula, values=formula.together, together=()), cases, asked, robot)
        if linked.is_right:
            return linked
    own = {name for name, _ in asked.terms}
    used = [name for name in robot.variables if name in formula.names and name not in own]
    hits, strangers, silent, wrapped = list[bool](), list[bool](), 0, True
    found = tuple(formula.at(case.known) for case in cases)
    for case, values in zip(cases, found, strict=True):
        silent += not values
        agreeing = [
            right
            for known, right in case.others
            if all(_close(known[n], case.known[n], turns=n in robot.angles) for n in used)
        ]
        hits.append(any(asked.same(value, case.right) for value in values))
        known = (*agreeing, *case.ends)
        wrong = [value for value in values if not any(asked.same(value, right) for right in known)]
        strangers.append(bool(wrong))
        wrapped &= all(any(asked.same(value + math.pi, right) for right in agreeing) for value in wrong)
    return Outcome(tuple(hits), tuple(strangers), silent, wrapped, found)


def where(flags: Sequence[bool], cases: Sequence[Case], asked: Asked, candidates: Iterable[tuple[str, Expr]]) -> str:
    """The sign that tells the solutions flagged from the others: `px > 0`; empty where none does."""
    if all(flags) or not any(flags):
        return ""

    def telling(name: str, values: Sequence[float]) -> str:
        for word, sign in ((">", 1), ("<", -1)):
            if all((sign * value > 0) == flag for value, flag in zip(values, flags, strict=True)):
                return f"{name} {word} 0"
        return ""

    name = " + ".join(n for n, _ in asked.terms)
    if asked.turns and (found := telling(name, [math.remainder(case.right, math.tau) for case in cases])):
        return found
    for name, expr in candidates:
        if found := telling(name, [Floats(case.known).value(expr) for case in cases]):
            return found
    return ""


def arguments(exprs: Iterable[Expr], robot: Robot) -> Iterator[tuple[str, Expr]]:
    """What stands in the atan2 of formulas, shortest first: what the sign of which may matter."""
    found = dict[Expr, str]()
    for expr in exprs:
        for node in walk(expr):
            if isinstance(node, Call) and node.function == "atan2":
                for argument in node.arguments:
                    found.setdefault(argument, write(argument, "short", robot.writing))
    yield from sorted(((text, expr) for expr, text in found.items()), key=lambda pair: len(pair[0]))
