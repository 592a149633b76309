"""Slips in several rows of a DH table: each row is the right one, or holds a slip of its own.

The rows are compared one by one, so that a table with many slips is as cheap as one with a single slip. The same kind
of slip in some rows has one name.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import product

from dhcli.checking.diagnosis.bench import Bench
from dhcli.checking.diagnosis.mistakes import BY_ID
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.search import Numbers, matches
from dhcli.checking.diagnosis.slips import Candidate
from dhcli.checking.diagnosis.work import Work
from dhcli.checking.returned import Causes
from dhcli.errors import joined

PAIR = 2


def same_in_rows(found: Sequence[Sequence[Candidate]]) -> Causes:
    """One kind of slip that is made in each of some rows."""
    if len(found) < PAIR or not all(found):
        return ()
    where = [{one.mistake.id: one.slips[0].name.partition(" ")[2] for one in row} for row in found]
    shared = [name for name in where[0] if all(row.get(name, "").isalnum() for row in where)]
    return tuple((_in_rows(name, [row[name] for row in where]),) for name in shared)


def each_in_a_row(found: Sequence[Sequence[Candidate]]) -> Causes:
    """Two slips of different kinds, each in a row of its own."""
    return tuple(tuple(one.slips[0] for one in pair) for pair in product(*found)) if len(found) == PAIR else ()


def slips_by_row(
    right: Work,
    every: Sequence[Candidate],
    benches: Sequence[Bench],
    typed: Sequence[Sequence[Numbers]],
    slack: Numbers,
) -> tuple[tuple[Candidate, ...], ...]:
    """For each row that is not the right one the slips that give it, perhaps none."""
    if any(len(rows) != len(right.steps) for rows in typed):
        return ()
    found = []
    for k, step in enumerate(right.steps):
        given = [rows[k] for rows in typed]
        if all(matches(b.matrix_of(step), one, slack) for b, one in zip(benches, given, strict=True)):
            continue
        here = (one for one in every if _only_in(one, right, k))
        found.append(
            tuple(
                one
                for one in here
                if all(matches(b.matrix_of(one.work.steps[k]), m, slack) for b, m in zip(benches, given, strict=True))
            )
        )
    return tuple(found)


def _only_in(one: Candidate, right: Work, index: int) -> bool:
    """Whether a mistake changes one row and nothing else."""
    steps = zip(one.work.steps, right.steps, strict=True)
    return [k for k, (step, other) in enumerate(steps) if step.row != other.row] == [index]


def _in_rows(name: str, places: Sequence[str]) -> Slip:
    """A slip that is made in several rows, such as `alpha-sign 4, 5 and 6`."""
    mistake = BY_ID[name]
    where = joined(places)

    def told(words: str) -> str:
        return re.sub(r"(row|joint) \{\w+\}", rf"\1s {where}", words)

    return Slip(f"{name} {where}", told(mistake.words), told(mistake.hint), mistake.rank)
