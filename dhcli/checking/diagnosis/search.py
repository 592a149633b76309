"""The search for mistakes that give exactly the answer typed: every single one, and then every two.

All works are evaluated in floats: at the values of the task where the answer is in numbers, and at two general points
where it is in expressions. A product costs a few microseconds, so that even the thousands of pairs take well under a
second; two expressions that agree at two general points to nine digits are the same.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.checking.diagnosis.bench import Bench, Folds
from dhcli.checking.diagnosis.chance import Evidence, is_chance, lengths_of
from dhcli.checking.diagnosis.mistakes import MISTAKES
from dhcli.checking.diagnosis.seen import SAME, Seen, same
from dhcli.checking.diagnosis.slips import Candidate, candidates, setting_of
from dhcli.checking.diagnosis.work import Matrix, Multiplied, Work, right_work
from dhcli.checking.exercise import Memo
from dhcli.checking.truth import chain_of, is_length
from dhcli.checking.wanted import Wanted
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers
from dhcli.notation.walk import symbols

SEED = 11
MOST_CAUSES = 12
STAGES = ("singles", "pairs")
MOST_STEPS = 100
"""Moves and rows of the longest product in which mistakes are looked for."""
MOST_WORK = 5_000_000
"""Pairs of mistakes times factors of their products, beyond which pairs are not looked for: a few seconds' work."""

MOST_KINDS = 100
"""Kinds of draws, by the mistakes that their values allow, whose single mistakes are kept."""

PLAIN = math.sqrt(2)
"""Tolerances that a mistake is off by where it shows plainly; no round number, so that no mistake is off by just that,
one machine rounding up and the other down."""

OF_VALUES = tuple(mistake for mistake in MISTAKES if mistake.of_values)

Numbers: TypeAlias = Matrix[float]
"""The entries of an answer at one point."""


class Search:
    """The mistakes in one question of an exercise, evaluated once for all answers to it."""

    def __init__(self, memo: Memo, question: Wanted, like: Search | None = None) -> None:
        """Evaluate the right work, and every one with a single mistake.

        Args:
            memo: The exercise, and what its searches share.
            question: One of its questions.
            like: The search for the same question where only the joints stand at other values, if there is one: most
                of its work need not be done again.
        """
        exercise = memo.exercise
        self.setting = memo.of("setting", lambda: setting_of(exercise))
        if like:
            self.setting.share_links(like.setting)
        self.right: Work = like.right if like else right_work(question, exercise.robot, self.setting)
        needed = names(chain_of(question, exercise.robot)).union(*(symbols(e) for e in question.point))
        known = dict(exercise.values)
        self.is_known = exercise.numeric and needed <= known.keys()
        self.names = needed.union(known, exercise.scope.names)
        held = {name: v for name, v in known.items() if not (exercise.robot and name in exercise.robot.variables)}
        self.general: Bench = like.general if like else Bench(self.right, point(self.names, held, SEED))
        seeds = (0,) if self.is_known else (SEED + 1, SEED + 2)
        self.points = tuple(point(self.names, known, seed) for seed in seeds)
        folds = like.folds if like else None
        matrices: dict[object, Numbers] | None = memo.of("matrices", dict) if self.is_known else None
        self.benches = tuple(Bench(self.right, over, folds, matrices) for over in self.points)
        self.truth = tuple(bench.entries(self.right) for bench in self.benches)
        self.tolerance = (exercise.tolerance.rotation, exercise.tolerance.position or 1e-3 * self._size())
        self.of_values = {one.slips[0].name: one for one in candidates(self.right, self.setting, among=OF_VALUES)}
        self._folded: dict[object, Numbers] = memo.of("folded", dict)
        self._given: dict[str, list[array[float]]] = {}
        self.distinguished: dict[tuple[str, ...], tuple[Candidate, ...]] = like.distinguished if like else {}
        self.singles: tuple[Candidate, ...] = self._singles()

    def _singles(self) -> tuple[Candidate, ...]:
        """The single mistakes; they are told apart once for all draws in which the same mistakes of values exist."""
        found = self.distinguished.get(tuple(self.of_values))
        if found is not None:
            return tuple(self.of_values.get(one.slips[0].name, one) for one in found)
        if len(self.right.steps) > MOST_STEPS:
            return ()
        if len(self.distinguished) >= MOST_KINDS:
            self.distinguished.clear()
        found = self._distinct(candidates(self.right, self.setting))
        self.distinguished[tuple(self.of_values)] = found
        return found

    @cached_property
    def folds(self) -> Folds:
        """The factors of all single mistakes that are made the same way whatever the values are."""
        lasting = (one.work for one in self.singles if one.slips[0].name not in self.of_values)
        return Folds((step for work in (self.right, *lasting) for step in work.steps), self._folded)

    @cached_property
    def visible(self) -> tuple[Candidate, ...]:
        """Single mistakes whose answer here is not the right one."""
        return tuple(one for one, is_right in self._compared() if not is_right)

    @cached_property
    def hidden(self) -> tuple[Candidate, ...]:
        """Single mistakes whose answer here is right, though at other joint values it is not."""
        return tuple(one for one, is_right in self._compared() if is_right)

    @cached_property
    def unclear(self) -> tuple[Candidate, ...]:
        """Single mistakes whose answer here is right, or so near that it is hardly wrong."""
        return tuple(one for one, is_right in self._compared(PLAIN) if is_right)

    @cached_property
    def pairs(self) -> tuple[Candidate, ...]:
        """Two mistakes at once, the one of the earlier level first; none where there are too many to look through."""
        paired = sum(not one.mistake.alone for one in self.singles)
        if paired**2 * len(self.right.steps) > MOST_WORK:
            return ()
        found: list[Candidate] = []
        place = {one.slips[0].name: k for k, one in enumerate(self.singles)}
        for k, one in enumerate(self.singles):
            for two in candidates(one.work, self.setting, one):
                other = place.get(two.slips[-1].name, -1)
                if two.mistake.level > one.mistake.level or other > k:
                    found.append(two)
        return tuple(found)

    def entries(self, work: Work) -> Numbers:
        """What a work leads to at the values of the task."""
        return self.benches[0].entries(work)

    def causes(
        self, typed: Sequence[Numbers], slack: Numbers, near: Numbers | None = None, stages: Sequence[str] = STAGES
    ) -> tuple[Candidate, ...]:
        """The single mistakes that give an answer; if there are none, the pairs that do; the plainest first.

        In numbers, what an arbitrary answer would meet as well has no name, and nor has one that is zero everywhere.

        Args:
            typed: The answer at each point.
            slack: What each entry may be off.
            near: What an entry may be off where a mistake gives 0, which many do; as much as others by default.
            stages: Whether single mistakes are looked for, or pairs, or both.
        """
        if self.is_known and is_zero(typed[0]):
            return ()
        for stage in stages:
            likely = self._likely(stage, typed[0], slack, near or slack)
            found = [one for one in likely if self._gives(one, typed, slack)]
            if found:
                if self.is_known and is_chance(stage, self._given[stage], self._typed(typed[0], slack)):
                    return ()
                plainest = min(sum(slip.rank for slip in one.slips) for one in found)
                plain = (one for one in found if sum(slip.rank for slip in one.slips) == plainest)
                return tuple(self._different(plain))[:MOST_CAUSES]
        return ()

    def _typed(self, typed: Numbers, slack: Numbers) -> Evidence:
        lengths = lengths_of(self.right.question, typed)
        return Evidence(_flat(typed), _flat(slack), _flat(self.truth[0]), lengths)

    def _likely(self, stage: str, typed: Numbers, slack: Numbers, near: Numbers) -> Iterator[Candidate]:
        """The candidates that give an answer at the first point; what each gives there is kept for the next answer."""
        every, kept = self._first(stage)
        flat, limits, zeros = _flat(typed), _flat(slack), _flat(near)
        wanted = [
            (a - limit - SAME, a + limit + SAME, abs(a) <= z) for a, limit, z in zip(flat, limits, zeros, strict=True)
        ]
        for one, given in zip(every, kept, strict=True):
            for (low, high, may_be_zero), value in zip(wanted, given, strict=True):
                if not low <= value <= high or (not may_be_zero and abs(value) <= SAME):
                    break
            else:
                yield one

    def _gives(self, one: Candidate, typed: Sequence[Numbers], slack: Numbers) -> bool:
        """Whether a candidate gives an answer at every point, and not what is right too."""
        return all(
            matches(answer, bench.entries(one.work), slack) for answer, bench in zip(typed, self.benches, strict=True)
        ) and not all(matches(r, b.entries(one.work), slack) for r, b in zip(self.truth, self.benches, strict=True))

    def _first(self, stage: str) -> tuple[Sequence[Candidate], list[array[float]]]:
        """The candidates of a stage, and what each gives at the first point, worked out once for all answers."""
        every: Sequence[Candidate] = getattr(self, stage)
        if stage not in self._given:
            self._given[stage] = [_flat(self.entries(one.work)) for one in every]
        return every, self._given[stage]

    def _compared(self, times: float = 1.0) -> Iterator[tuple[Candidate, bool]]:
        """Each single mistake, and whether its answer counts as right if an entry may be off so many tolerances."""
        within = self._limits(times)
        right, limits = _flat(self.truth[0]), _flat(within)
        others = tuple(zip(self.truth, self.benches, strict=True))[1:]
        for one, given in zip(*self._first("singles"), strict=True):
            is_right = all(abs(a - b) <= limit for a, b, limit in zip(right, given, limits, strict=True))
            yield one, is_right and all(matches(t, bench.entries(one.work), within) for t, bench in others)

    def _limits(self, times: float = 1.0) -> Numbers:
        """So many tolerances of each entry."""
        rotation, position = (times * limit for limit in (self.tolerance if self.is_known else (SAME, SAME)))
        return tuple(
            tuple(position if is_length(self.right.question, r, c) else rotation for c in range(len(row)))
            for r, row in enumerate(self.truth[0])
        )

    def _distinct(self, found: Iterator[Candidate]) -> tuple[Candidate, ...]:
        """Mistakes that change something, each of those that are the same everywhere under its first name."""
        kept: list[Candidate] = []
        known = Seen()
        known.is_new(self.general.matrix(self.right))
        right = self.general.entries(self.right)
        for one in found:
            entries = self.general.entries(one.work)
            if same(entries, right) or (one.work.multiplied is Multiplied.ELEMENTWISE and is_zero(entries)):
                continue
            if one.work.question is not self.right.question or one.work.entry:  # written otherwise, the matrix is right
                kept.append(one)
                continue
            if known.is_new(self.general.matrix(one.work)):
                kept.append(one)
        return tuple(kept)

    def _different(self, found: Iterator[Candidate]) -> Iterator[Candidate]:
        known = Seen()
        for one in found:
            if known.is_new((*self.general.matrix(one.work), *self.general.entries(one.work))):
                yield one

    def _size(self) -> float:
        lengths = [abs(self.benches[0].matrix_of(step)[k][3]) for step in self.right.steps for k in range(3)]
        return max(sum(lengths), 1e-9)


def search_of(question: Wanted, memo: Memo) -> Search:
    """The search for one question, made once; with the joints at other values it saves work of the first one."""

    def made() -> Search:
        return Search(memo, question, search_of(question, memo.like) if memo.like else None)

    return memo.of(("search", question), made)


def point(free: frozenset[str], known: dict[str, Value], seed: int) -> Floats:
    """Values for all names: those known, and for the others some between 0.2 and 1.3, the same for everybody."""
    return Floats({**next(general(free, seed)), **numbers(known)})


def is_zero(entries: Numbers) -> bool:
    """Whether nothing but zeros was typed, above the bottom row of a pose: nobody has worked out anything."""
    return not any(abs(entry) > SAME for row in entries[:3] for entry in row)


def _flat(entries: Numbers) -> array[float]:
    """All entries in a row, in little memory: there are thousands of pairs."""
    return array("d", (entry for row in entries for entry in row))


def matches(first: Numbers, second: Numbers, slack: Numbers) -> bool:
    """Whether two answers agree within what each entry may be off."""
    for row, other, near in zip(first, second, slack, strict=True):
        for a, b, limit in zip(row, other, near, strict=True):
            if not abs(a - b) <= limit:
                return False
    return True
