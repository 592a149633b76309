"""An answer about a matrix as numbers, at each point where a search compares it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from dhcli.checking.diagnosis.search import Numbers, Search, search_of
from dhcli.checking.diagnosis.seen import SAME
from dhcli.checking.entries import Entries, Entry
from dhcli.checking.exercise import Case
from dhcli.checking.symbolic import has_decimals
from dhcli.checking.tolerance import typed_decimals, without_unit
from dhcli.checking.truth import is_length
from dhcli.checking.wanted import Wanted
from dhcli.frozen import frozen
from dhcli.notation.walk import symbols

ROUGH = 1e-3
"""What decimals in the place of exact values may be off, as a share."""


@frozen
class TypedMatrix:
    """An answer in numbers.

    Attributes:
        search: The search that it is compared in.
        values: Its entries at each point.
        slacks: What each entry may be off: by the digits typed, then by the tolerance of the task.
        sharp: The first of them, if zeros at the end are left out: 0.55 beside 0.3992 may be 0.5500.
    """

    search: Search
    values: tuple[Numbers, ...]
    slacks: tuple[Numbers, ...]
    sharp: Numbers | None = None

    def scaled(self, factor: float) -> TypedMatrix:
        """The answer with its lengths in another unit: the digits typed count as many times as much."""
        question = self.search.right.question

        def grown(entries: Numbers) -> Numbers:
            return tuple(
                tuple(factor * x if is_length(question, r, c) else x for c, x in enumerate(row))
                for r, row in enumerate(entries)
            )

        near, *far = self.slacks
        return TypedMatrix(self.search, tuple(map(grown, self.values)), (grown(near), *far))

    @property
    def is_general(self) -> bool:
        """Whether the points are general ones; else there is one, at the values of the task."""
        return not self.search.is_known


def typed_answer(case: Case, question: Wanted, entries: Entries) -> TypedMatrix | None:
    """An answer in numbers; None where it holds a name that has no value."""
    search = search_of(question, case.memo)
    if any(not symbols(entry.expr) <= search.names for row in entries for entry in row):
        return None
    values = tuple(tuple(tuple(over.value(e.expr) for e in row) for row in entries) for over in search.points)
    if not search.is_known:
        shares = [[ROUGH if has_decimals(entry.expr) else SAME for entry in row] for row in entries]
        pairs = (zip(r, v, strict=True) for r, v in zip(shares, values[0], strict=True))
        return TypedMatrix(search, values, (tuple(tuple(share * (1 + abs(v)) for share, v in row) for row in pairs),))
    rotation = case.tolerance.rotation
    near, far = [], []
    for r, row in enumerate(entries):
        lengths = [is_length(question, r, c) for c in range(len(row))]
        units = [float(case.exercise.metres) if length else 1.0 for length in lengths]
        near.append(tuple(_half_unit(entry, unit) for entry, unit in zip(row, units, strict=True)))
        limits = [search.tolerance[1] if length else rotation for length in lengths]
        far.append(tuple(max(a, b) for a, b in zip(near[-1], limits, strict=True)))
    sharp = tuple(map(tuple, _with_zeros([[_places(entry) for entry in row] for row in entries], near)))
    return TypedMatrix(search, values, (tuple(near), tuple(far)), sharp if sharp != tuple(near) else None)


def _half_unit(entry: Entry, unit: float) -> float:
    """Half a unit of the last digit typed; nothing to speak of for an exact value."""
    _, unit = without_unit(entry.typed, unit)
    places = _places(entry)
    return SAME if places is None else unit * (0.5 * 10.0**-places * (1 + SAME)) + SAME


def _places(entry: Entry) -> int | None:
    return typed_decimals(without_unit(entry.typed, 1.0)[0])


def _with_zeros(places: list[list[int | None]], slack: Sequence[Sequence[float]]) -> Iterator[list[float]]:
    """What entries may be off that have as many decimals as the others: as most of them, of which half have more."""
    known = [one for row in places for one in row if one is not None]
    for row, limits in zip(places, slack, strict=True):
        own: list[float] = []
        for one, limit in zip(row, limits, strict=True):
            others = sorted(known)
            if one is not None:
                others.remove(one)
            usual = others[(len(others) - 1) // 2] if others else 0
            own.append(limit if one is None or usual <= one else (limit - SAME) * 10.0 ** (one - usual) + SAME)
        yield own
