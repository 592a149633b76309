"""The slip behind a wrong matrix, and the matrix of somebody who has made one."""

from __future__ import annotations

from dhcli.checking.diagnosis.bench import terms
from dhcli.checking.diagnosis.by_entry import matrix_entry_causes
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.search import search_of
from dhcli.checking.diagnosis.slips import candidates, setting_of
from dhcli.checking.diagnosis.typed import TypedMatrix, typed_answer
from dhcli.checking.diagnosis.work import Work, right_work
from dhcli.checking.entries import Entries, entries_text
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.numeric import in_other_unit
from dhcli.checking.returned import Causes
from dhcli.checking.truth import entries_on_sheet, truth_of, unit_of
from dhcli.checking.wanted import Wanted
from dhcli.notation.quantity import LENGTH_UNITS
from dhcli.notation.writer import write

OTHER_UNIT = {"mm": "m", "m": "mm"}


MOST_BESIDES = 2
"""Slips besides a unit that are named; more are chance."""


def matrix_causes(case: Case, question: Wanted, entries: Entries) -> Causes:
    """The mistakes that give just a matrix, one or two; or one besides the unit of the lengths."""
    typed = typed_answer(case, question, entries)
    if typed is None:
        return ()
    exercise = case.exercise
    if typed.is_general and not exercise.numeric:
        return _in_symbols(typed)
    truth = truth_of(question, case)
    if not typed.is_general and (other := in_other_unit(question, truth, entries, case.memo, case.tolerance)):
        return _in_other_unit(exercise, typed, other.unit)
    found = typed.search.causes(typed.values, typed.sharp, stages=("singles",)) if typed.sharp else ()
    for slack in typed.slacks if not found else ():
        found = found or typed.search.causes(typed.values, slack, typed.slacks[0])
    if found:
        return tuple(cause.slips for cause in found)
    return _in_other_unit(exercise, typed, OTHER_UNIT.get(exercise.unit, ""))


def _in_symbols(typed: TypedMatrix) -> Causes:
    """One mistake in the work, one in the terms that were written down, two in the work, more in the terms."""

    def in_work(stage: str) -> Causes:
        found = typed.search.causes(typed.values, typed.slacks[0], stages=(stage,))
        return tuple(cause.slips for cause in found)

    singles = in_work("singles")
    if singles:
        return singles
    in_terms = matrix_entry_causes(typed)
    return in_terms.one or in_work("pairs") or in_terms.more


def answer_with(case: Case, question: Wanted, name: str) -> str | None:
    """What a student with a mistake types; None if it cannot be made."""
    exercise = case.exercise
    setting = case.memo.of("setting", lambda: setting_of(exercise))
    for one in candidates(right_work(question, exercise.robot, setting), setting, name=name):
        if one.slips[0].name == name:
            return typed_text(case, one.work)
    return None


def typed_text(case: Case, work: Work) -> str:
    """What a student types: expressions, or numbers in the unit of the sheet to six decimals."""
    exercise, question = case.exercise, work.question
    if not exercise.numeric:
        typed = entries_on_sheet(question, terms(work, {}), exercise)
        rows = [[write(entry, "short", exercise.writing) for entry in row] for row in typed]
    else:
        entries = search_of(question, case.memo).entries(work)
        rows = [
            [_six_decimals(entry / unit_of(question, r, c, exercise)) for c, entry in enumerate(row)]
            for r, row in enumerate(entries)
        ]
    return entries_text(rows)


def _in_other_unit(exercise: Exercise, typed: TypedMatrix, unit: str) -> Causes:
    """The slips besides the unit of the lengths, such as metres for millimetres; none where many would do."""
    if typed.is_general or not unit:
        return ()
    other = typed.scaled(float(LENGTH_UNITS[unit] / LENGTH_UNITS[exercise.unit]))
    if other.values == typed.values:
        return ()
    causes = other.search.causes(other.values, other.slacks[0], stages=("singles",))
    slip = Slip(f"in-{unit}", f"the lengths are in {unit}, not {exercise.unit}", "look at the unit of the sheet")
    return tuple((*one.slips, slip) for one in causes) if len(causes) <= MOST_BESIDES else ()


def _six_decimals(value: float) -> str:
    """A number as people type it, without the minus of a zero."""
    return f"{round(value, 6) + 0:.6f}"
