"""Answers that copy what a document prints where it prints it wrong."""

from __future__ import annotations

from dhcli.checking.exercise import Exercise, Printed
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.questions import MatrixQuestion
from dhcli.checking.reading import Entry, read_entries
from dhcli.checking.symbolic import same
from dhcli.checking.truth import Truth
from dhcli.checking.verdicts import CellMark, Verdict


def misprint_remarks(
    question: MatrixQuestion,
    cells: tuple[CellMark, ...],
    entries: tuple[tuple[Entry, ...], ...],
    exercise: Exercise,
    printed: Printed,
) -> tuple[str, ...]:
    """A remark for each wrong entry of an answer that is just what the document prints.

    The right entry is told only where the exercise shows what was expected: a misprint is no reason to give it away.

    Args:
        question: The question.
        cells: The judgement of each entry.
        entries: The answer as read.
        exercise: The exercise, for the values given, and whether it shows what was expected.
        printed: What the document prints.
    """
    try:
        shown = read_entries(question, exercise, printed.text)
    except UnreadableError:
        return ()
    remarks = []
    for cell in cells:
        r, c = cell.row, cell.column
        wrong = cell.verdict in (Verdict.WRONG, Verdict.CLOSE)
        if wrong and same(entries[r][c].expr, shown[r][c].expr, exercise.values):
            where = "this" if len(cells) == 1 else f"entry ({r + 1},{c + 1})"
            right = f", the right entry is {cell.expected}" if exercise.shows_expected else ""
            remarks.append(f"{where} is what the document prints; it is a misprint{right}")
    return tuple(remarks)


def misprints(
    question: MatrixQuestion, truth: Truth, exercise: Exercise, printed: Printed
) -> tuple[tuple[int, int], ...]:
    """Row and column, from 0, of each entry that a document prints wrong.

    Raises:
        UnreadableError: What is printed cannot be read.
    """
    shown = read_entries(question, exercise, printed.text)
    return tuple(
        (r, c)
        for r, row in enumerate(shown)
        for c, entry in enumerate(row)
        if not same(entry.expr, truth.rows[r][c], exercise.values)
    )
