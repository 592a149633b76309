"""Numbers as somebody typed them, with what their digits leave open."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Self

from dhcli.checking.diagnosis.chance import Evidence, is_chance
from dhcli.checking.entries import Entries, Entry, values_of
from dhcli.checking.exercise import Exercise
from dhcli.checking.motion.grid import Grid, Numbers, scale_of, within
from dhcli.checking.tolerance import SLACK, typed_decimals, without_unit
from dhcli.frozen import frozen

EXACT = 1e-9
"""What a value without a decimal may be off, as a share."""

COARSE = 0.02
"""A share of the largest number that its digits must not leave open: two of them are too few."""


@frozen
class Digits:
    """Numbers, lengths in metres.

    Attributes:
        values: What was typed.
        steps: Half a unit in the last place of each.
    """

    values: Numbers
    steps: Numbers

    @classmethod
    def of(cls, exercise: Exercise, right: Grid, entries: Entries) -> Self:
        """The numbers of an answer.

        Raises:
            UnreadableError: One of them is none.
        """
        pairs = zip(entries, right.powers, strict=True)
        steps = (
            tuple(_step(entry, scale_of(exercise, power)) for entry, power in zip(row, powers, strict=True))
            for row, powers in pairs
        )
        return cls(values_of(entries, exercise), tuple(steps))

    def are_those_of(self, seen: Numbers) -> bool:
        """Whether they are other numbers, rounded."""
        return within(self.values, seen, self.steps)

    def within(self, limits: Numbers) -> Numbers:
        """What the digits leave open of each number, where that is less than its limit."""
        return tuple(
            tuple(min(step or EXACT * (1 + abs(value)), limit) for value, step, limit in zip(*row, strict=True))
            for row in zip(self.values, self.steps, limits, strict=True)
        )

    def say_enough(self, right: Numbers, limits: Numbers, others: Iterable[Numbers]) -> bool:
        """Whether some of other answers would hardly be met by chance."""
        largest = max(range(len(_flat(self.values))), key=lambda k: abs(_flat(self.values)[k]))
        if _flat(self.steps)[largest] > COARSE * abs(_flat(self.values)[largest]):
            return False
        slack = [max(pair) for pair in zip(_flat(self.steps), _flat(limits), strict=True)]
        typed = Evidence(_flat(self.values), slack, _flat(right), [True] * len(slack))
        return not is_chance("singles", map(_flat, others), typed)


def _flat(table: Numbers) -> Sequence[float]:
    return [value for row in table for value in row]


def _step(entry: Entry, scale: float) -> float:
    number, unit = without_unit(entry.typed, scale)
    places = typed_decimals(number)
    return 0.0 if places is None else unit * 10.0**-places / 2 * (1 + SLACK)
