"""What an answer earns of the credit of its part, and what a part is worth."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from dhcli.checking.credit import USUAL, Shares, credits_text
from dhcli.checking.exercise import Exercise, Part, Question
from dhcli.checking.verdicts import UNSOLVED, CellMark, Mark, Verdict, worst


def earned(shares: Shares, question: Question[Any], mark: Mark, *, numeric: bool) -> float:
    """The share of its credit that an answer earns.

    Args:
        shares: What the author has set.
        question: What was asked.
        mark: How the answer was judged; what it has earned by the usual shares.
        numeric: Whether the answer is in numbers, where all direction cosines together are one item.
    """
    if mark.other_unit:
        return shares.unit
    if mark.verdict is Verdict.ROUNDED:
        return shares.rounded * mark.earned
    if mark.verdict not in UNSOLVED or shares == USUAL or mark.is_in_other_unit:
        return mark.earned
    if mark.found:
        return shares.moves * mark.found
    if len(mark.cells) <= 1:
        return max(mark.earned, shares.of(mark.verdict))
    if mark.verdict is Verdict.WRONG and not mark.earned:
        return 0.0  # such as a matrix of zeros and ones that nobody has worked out
    if question.earns_by_row:
        return _of_rows(shares, mark.cells)
    return _of_entries(shares, question, mark.cells, numeric=numeric)


def worth_of(exercise: Exercise) -> str:
    """What an exercise is worth, and by which rules if not by the usual ones; nothing for a single plain question."""
    said = [*exercise.shares.beside(USUAL)]
    for part in exercise.asked:
        said += [f"{part.id}: {words}" for words in (part.shares.beside(exercise.shares) if part.shares else ())]
    if len(exercise.asked) > 1:
        said.insert(0, f"{len(exercise.asked)} parts, {credits_text(exercise.credit)}")
    return "; ".join(said)


def worth(exercise: Exercise, part: Part) -> str:
    """What one part is worth; nothing where it is the only one."""
    return credits_text(part.credit) if len(exercise.asked) > 1 else ""


def _of_rows(shares: Shares, cells: Sequence[CellMark]) -> float:
    """A table earns by its cells or by its rows; those that are the same for everybody only cost something."""
    if shares.table == "whole":
        return 0.0
    counted = [cell for cell in cells if cell.counted or cell.verdict is Verdict.WRONG]
    if shares.table == "cells":
        return _mean(shares.of(cell.verdict) for cell in counted)
    rows = sorted({cell.row for cell in counted})
    return _mean(shares.of(worst(cell.verdict for cell in counted if cell.row == row)) for row in rows)


def _of_entries(shares: Shares, question: Question[Any], cells: Sequence[CellMark], *, numeric: bool) -> float:
    """A matrix earns by its entries; in numbers its direction cosines are one item."""

    def items(chosen: Sequence[CellMark]) -> list[float]:
        return list(_in_numbers(shares, question, chosen) if numeric else _in_symbols(shares, chosen))

    rotation = items([cell for cell in cells if not question.is_length(cell.row, cell.column)])
    position = items([cell for cell in cells if question.is_length(cell.row, cell.column)])
    share = shares.rotation
    if share is None or not rotation or not position:
        return max(0.0, _mean(items(cells)))
    return share * max(0.0, _mean(rotation)) + (1 - share) * max(0.0, _mean(position))


def _in_numbers(shares: Shares, question: Question[Any], cells: Sequence[CellMark]) -> Iterator[float]:
    """The direction cosines together, and each length; what is the same for everybody only where it is wrong."""
    matter = [cell for cell in cells if cell.counted or cell.verdict is not Verdict.RIGHT]
    cosines = [cell.verdict for cell in matter if not question.is_length(cell.row, cell.column)]
    if cosines:
        yield shares.of(worst(cosines))
    yield from (shares.of(cell.verdict) for cell in matter if question.is_length(cell.row, cell.column))


def _in_symbols(shares: Shares, cells: Sequence[CellMark]) -> Iterator[float]:
    """Every entry that is not the same for everybody; a zero that is no zero costs what an entry earns."""
    counted = [shares.of(cell.verdict) for cell in cells if cell.counted]
    spoiled = sum(not cell.counted and cell.verdict is not Verdict.RIGHT for cell in cells)
    yield from (value - spoiled / len(counted) for value in counted)


def _mean(values: Iterable[float]) -> float:
    listed = list(values)
    return sum(listed) / len(listed) if listed else 0.0
