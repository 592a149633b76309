"""Slips in single entries of an answer about motion: in the sign of one, and in the terms of formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from typing import TypeAlias

from dhcli.checking.diagnosis.by_entry import EntryCauses, WrongEntry, entry_causes
from dhcli.checking.diagnosis.mistakes.in_terms import among_of
from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.diagnosis.slips import setting_of
from dhcli.checking.exercise import Exercise
from dhcli.checking.motion.grid import Grid, Numbers, alike
from dhcli.checking.returned import Causes
from dhcli.errors import joined
from dhcli.notation.tree import ZERO, Expr, negate

MOST_TOLD = 4
"""Entries that are told one by one; of more, it is told how many."""

HALF = 3
"""Rows of v, and of ω."""

AtPoints: TypeAlias = Callable[[Grid], tuple[Numbers, ...]]
"""The entries of a grid at a few general points."""

Placed: TypeAlias = Callable[[int, int], str]
"""Row and column of an entry as they are told."""


def signs(right: Grid, placed: Placed) -> Iterator[tuple[Slip, Grid]]:
    """Each entry with the other sign."""
    for r, row in enumerate(right.rows):
        for c, entry in enumerate(row):
            if entry != ZERO and right.shape != (1, 1):
                words = f"the sign of entry ({placed(r, c)}) is turned round"
                slip = Slip(f"entry-sign {placed(r, c)}", words, f"look at the signs in row {r + 1}", Rank.SYMPTOM)
                yield slip, replace(right, rows=(*right.rows[:r], _negated(row, c), *right.rows[r + 1 :]))


def column_signs(right: Grid) -> Iterator[tuple[Slip, Grid]]:
    """Each column with the other sign, and of one with v and ω each half of it alone."""
    rows, width = right.shape
    halves = [range(rows)] if rows <= HALF else [range(rows), range(HALF), range(HALF, rows)]
    for c in range(width):
        for half in halves:
            if sum(right.rows[r][c] != ZERO for r in half) < 2:  # noqa: PLR2004  one is a sign of its own
                continue
            column = f"column {c + 1}" if width > 1 else "the column"
            part = "" if len(half) == rows else f"rows {half[0] + 1} to {half[-1] + 1}"
            words = f"{part} of {column} have the opposite sign" if part else f"{column} has the opposite sign"
            name = f"column-sign {c + 1} {part}".strip()
            slip = Slip(name, words, "which way does the axis of each joint point?", Rank.SYMPTOM)
            yield (
                slip,
                replace(right, rows=tuple(_negated(row, c) if r in half else row for r, row in enumerate(right.rows))),
            )


def _negated(row: Sequence[Expr], at: int) -> tuple[Expr, ...]:
    """A row with the other sign of one entry."""
    return (*row[:at], negate(row[at]), *row[at + 1 :])


def sign_causes(right: Grid, given: Grid, at: AtPoints, placed: Placed) -> Causes:
    """The entries whose signs are turned round, where all others are right."""
    try:
        typed, true = at(given), at(right)
    except KeyError:  # a name that has no value
        return ()
    wrong = []
    for r, row in enumerate(right.rows):
        for c in range(len(row)):
            seen, wanted = _only(typed, r, c), _only(true, r, c)
            if alike(seen, wanted):
                continue
            if not alike(seen, tuple(((-table[0][0],),) for table in wanted)):
                return ()
            wrong.append(placed(r, c))
    if len(wrong) < 2:  # noqa: PLR2004  one is a mistake of its own
        return ()
    places = joined([f"({place})" for place in wrong])
    shown = f"entries {places}" if len(wrong) <= MOST_TOLD else f"{len(wrong)} entries"
    words = f"the signs of {shown} are turned round"
    return ((Slip("entry-signs " + " ".join(wrong), words, "look at the signs", Rank.SYMPTOM),),)


def swapped(right: Grid) -> Iterator[tuple[Slip, Grid]]:
    """Two numbers of a list, or two coordinates of a vector in every column, in each other's place."""
    rows, width = right.shape
    for i, j in combinations(range(rows), 2):
        order = [j if k == i else i if k == j else k for k in range(rows)]
        both = f"{i + 1} and {j + 1}"
        if width == 1:
            name, words, hint = f"numbers-swapped {both}", f"numbers {both}", "in which order are they asked for?"
        elif i // 3 == j // 3:  # of v, or of ω
            name, words, hint = f"rows-swapped {both}", f"rows {both}", "which row belongs to which coordinate?"
        else:
            continue
        slip = Slip(name, f"{words} have changed places", hint, Rank.SYMPTOM)
        yield slip, replace(right, rows=tuple(right.rows[k] for k in order))


def term_causes(exercise: Exercise, right: Grid, given: Grid, at: AtPoints, placed: Placed) -> EntryCauses:
    """Slips in the terms of the entries that are wrong; numbers have no terms."""
    if exercise.numeric:
        return EntryCauses()
    try:
        typed, true = at(given), at(right)
    except KeyError:  # a name that has no value
        return EntryCauses()
    wrong = [
        WrongEntry(placed(r, c), entry, partial(_is_given, _only(typed, r, c), at))
        for r, row in enumerate(right.rows)
        for c, entry in enumerate(row)
        if not alike(_only(true, r, c), _only(typed, r, c))
    ]
    return entry_causes(wrong, among_of(right.rows, setting_of(exercise)))


def _only(points: tuple[Numbers, ...], row: int, column: int) -> tuple[Numbers, ...]:
    """One entry at each point."""
    return tuple(((table[row][column],),) for table in points)


def _is_given(typed: tuple[Numbers, ...], at: AtPoints, expr: Expr) -> bool:
    return alike(at(Grid(((expr,),), ((0,),))), typed)
