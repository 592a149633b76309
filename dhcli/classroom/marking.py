"""One sheet graded, whatever it holds."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from dhcli.checking.judge import Judge
from dhcli.checking.marked import PartMark
from dhcli.checking.verdicts import Mark
from dhcli.classroom.folder import Submission
from dhcli.classroom.grades import Graded, PartGrade, failed
from dhcli.errors import DhcliError, Problem, UnknownNameError, bug, did_you_mean
from dhcli.files.library.entries import Kind, entries, full_id
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.sheets import Sheet, judged_sheet, read_sheet
from dhcli.regex import regex

_NUMBER = regex(r"(?<![\w.(,])-?\d+(?:\.\d+)?(?=\s?(?:°|rad|m|mm|cm)(?!\w))|(?<!\w)-?\d+\.\d+")
"""A number with a unit, or with decimals: one that comes of the values of a sheet."""
_AXIS = regex(r"(?<=…°) about .*")
"""About which axis an orientation is off; without its angle that says nothing."""
_LONGEST = 120
"""Longest name of a student, an exercise or a variant that is kept."""
_HINTS = 2
"""Places to look that a student is told of."""


def grade(submission: Submission, only: str | None = None) -> Graded:
    """Grade one sheet.

    Args:
        submission: The sheet.
        only: The exercise that all sheets should be of, by name or path; each sheet says its own by default.

    Returns:
        The grades. A sheet that cannot be graded comes back with its problems: nothing is raised.
    """
    row = Graded(submission.sheet, submission.student)
    if submission.problem:
        return failed(row, Problem(submission.problem))
    try:
        sheet = read_sheet(submission.path)
        row = replace(
            row,
            student=_short(sheet.name) or row.student,
            exercise=_short(sheet.exercise),
            variant=_short(sheet.variant),
        )
        judge = _judge_of(sheet, only, submission.sheet)
        marked = judged_sheet(judge, sheet, "this sheet")
        return replace(row, exercise=marked.exercise.id, parts=tuple(map(_part_grade, marked.parts)))
    except DhcliError as error:
        return failed(row, *error.problems)
    except Exception as error:  # noqa: BLE001  a bug that one sheet brings to light must not cost the others their grade
        return failed(row, bug(error))


def _judge_of(sheet: Sheet, only: str | None, written: str) -> Judge:
    """The judge of the exercise that a sheet is of."""
    if only is not None:
        judge = _loaded(only)
        exercise = judge.exercise
        named = sheet.exercise if sheet.exercise == exercise.id else full_id(sheet.exercise)
        exercise.accepts(_short(named), written)
        return judge
    if sheet.exercise:
        return _of_library(sheet.exercise)
    raise DhcliError("exercise: is missing", "--exercise says which one it is")


@lru_cache(maxsize=64)
def _of_library(name: str) -> Judge:
    """The exercise of a name that a student wrote: never a path, or students could choose what they are asked."""
    known = {entry.name: entry.path for entry in entries(Kind.EXERCISES) if not entry.shadowed}
    path = known.get(full_id(name))
    if path is None:
        name = _short(name)
        hint = "exercises are looked for in ./exercises and in the folders of DHCLI_PATH, then among the built-in ones"
        similar = did_you_mean(name, known)
        raise UnknownNameError(f"exercise: there is no exercise '{name}'", f"{similar} {hint}".strip())
    return Judge(load_exercise(path))


@lru_cache(maxsize=1)
def _loaded(name: str) -> Judge:
    """The exercise of a name that the lecturer wrote."""
    return Judge(load_exercise(name))


def _part_grade(one: PartMark) -> PartGrade:
    mark, credit = one.mark, one.part.credit
    note = next((cell.note for cell in mark.cells if cell.note), "")
    hints = mark.diagnosis.hints[:_HINTS] if mark.diagnosis else ()
    remarks = (*mark.remarks, *((note,) if note else ()), *hints)
    return PartGrade(
        one.part.id, mark.verdict, mark.earned * credit, credit, mark.reading, remarks, _slips(mark), mark.other_unit
    )


def _slips(mark: Mark) -> tuple[str, ...]:
    """Names of the mistakes that explain a wrong answer; what was remarked of it where none is known.

    A remark leaves its numbers and axes out, so that the same slip is the same in every variant. An answer that cannot
    be read, or that is right from an earlier one, is no slip of its own.
    """
    if mark.verdict.passed is not False or (mark.diagnosis and mark.diagnosis.follows):
        return ()
    if mark.diagnosis and mark.diagnosis.names:
        return mark.diagnosis.names
    return tuple(_AXIS.sub("", _NUMBER.sub("…", remark)) for remark in mark.remarks[:1])


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"
