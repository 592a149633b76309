"""One sheet graded, whatever it holds; and all sheets of a class, in parallel."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import replace
from functools import lru_cache, partial

from dhcli.checking.judge import Judge
from dhcli.checking.marked import PartMark
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.classroom.folder import Submission
from dhcli.classroom.pool import Lost, spread
from dhcli.errors import DhcliError, Place, Problem, UnknownNameError, did_you_mean
from dhcli.files.library.lookup import Kind, entries, full_id
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.sheets import Sheet, judged_sheet, read_sheet
from dhcli.frozen import frozen
from dhcli.regex import regex

TIMEOUT = 10.0
"""Seconds that one sheet may take; an honest one takes a hundredth of one."""
_NUMBER = regex(r"(?<![\w.(,])-?\d+(?:\.\d+)?(?=\s?(?:°|rad|m|mm|cm)(?!\w))|(?<!\w)-?\d+\.\d+")
"""A number with a unit, or with decimals: one that comes of the values of a sheet."""
_LONGEST = 120
"""Longest name of a student, an exercise or a variant that is kept."""
_HINTS = 2
"""Places to look that a student is told of."""


@frozen
class PartGrade:
    """What a student got for one part.

    Attributes:
        part: Its id.
        verdict: The verdict.
        earned: Credit earned.
        credit: Credit there was to earn.
        reading: The answer as it was read.
        remarks: What the student should know, and where to look.
        slips: Names of the mistakes that explain the answer, each by itself, the likeliest first.
        other_unit: The unit in which all of the answer is right, where nothing else is wrong with it.
    """

    part: str
    verdict: Verdict
    earned: float
    credit: float
    reading: str = ""
    remarks: tuple[str, ...] = ()
    slips: tuple[str, ...] = ()
    other_unit: str = ""


@frozen
class Graded:
    """A sheet with its grades, or with what kept it from being graded.

    Attributes:
        sheet: Its path below the folder of the class.
        student: Whose it is.
        exercise: Id of the exercise; as the sheet says if it was not graded.
        variant: What the numbers were drawn with.
        parts: The grades of the parts; none if it was not graded.
        problems: Why it was not graded.
    """

    sheet: str
    student: str
    exercise: str = ""
    variant: str = ""
    parts: tuple[PartGrade, ...] = ()
    problems: tuple[Problem, ...] = ()

    @property
    def earned(self) -> float:
        """Credit earned."""
        return sum(part.earned for part in self.parts)

    @property
    def credit(self) -> float:
        """Credit there was to earn."""
        return sum(part.credit for part in self.parts)

    @property
    def other_unit(self) -> str:
        """The unit that some or all of its answers are in, where nothing else is wrong with any of them; else empty."""
        units = {part.other_unit for part in self.parts if part.other_unit}
        fine = {Verdict.RIGHT, Verdict.EQUIVALENT, Verdict.ROUNDED, Verdict.SKIPPED}
        return units.pop() if len(units) == 1 and all(p.other_unit or p.verdict in fine for p in self.parts) else ""


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
        return _failed(row, Problem(submission.problem))
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
        return _failed(row, *error.problems)
    except Exception as error:  # noqa: BLE001  a bug that one sheet brings to light must not cost the others their grade
        return _failed(row, Problem(f"this is a bug in dhcli: {type(error).__name__}: {error}"))


def grade_all(
    submissions: Sequence[Submission],
    only: str | None = None,
    *,
    jobs: int,
    timeout: float = TIMEOUT,
    tell: Callable[[], object] = lambda: None,
    work: Callable[..., Graded] = grade,
) -> tuple[Graded, ...]:
    """Grade the sheets of a class in several processes.

    Args:
        submissions: The sheets.
        only: The exercise that all of them should be of; each says its own by default.
        jobs: Most processes at a time.
        timeout: Longest that one sheet may take [s].
        tell: Called when a sheet is done.
        work: What grades one sheet; another one only in tests.

    Returns:
        The grades in the order of the sheets.
    """
    graded: dict[Submission, Graded] = {}
    with closing(spread(partial(work, only=only), submissions, jobs=jobs, timeout=timeout)) as outcomes:
        for submission, outcome in outcomes:
            graded[submission] = _lost(submission, outcome, timeout) if isinstance(outcome, Lost) else outcome
            tell()
    return tuple(graded[submission] for submission in submissions)


def _lost(submission: Submission, why: Lost, timeout: float) -> Graded:
    if why is Lost.TIMED_OUT:
        problem = Problem(f"took longer than {timeout:g} s", hint="--timeout gives it more")
    else:
        problem = Problem("the process that graded it died", hint="perhaps it ran out of memory")
    return _failed(Graded(submission.sheet, submission.student), problem)


def _failed(row: Graded, *problems: Problem) -> Graded:
    """The row of a sheet that was not graded; places without their line of text, which may be long."""
    placed = (
        replace(problem, place=problem.place and Place(row.sheet, problem.place.line, problem.place.column))
        for problem in problems
    )
    return replace(row, problems=tuple(placed))


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

    A remark leaves its numbers out, so that the same slip is the same in every variant. An answer that cannot be read,
    or that is right from an earlier one, is no slip of its own.
    """
    if mark.verdict.passed is not False or (mark.diagnosis and mark.diagnosis.follows):
        return ()
    if mark.diagnosis and mark.diagnosis.names:
        return mark.diagnosis.names
    return tuple(_NUMBER.sub("…", remark) for remark in mark.remarks[:1])


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"
