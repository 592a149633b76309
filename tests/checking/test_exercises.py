"""What must be true of every exercise: its own solution is right however it is written, nothing else is for free."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.choice import ChoiceQuestion
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.truth import is_length, truth_of
from dhcli.checking.verdicts import Verdict
from dhcli.errors import RobotError
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.sheets import read_sheet, write_sheet
from dhcli.notation.styles import STYLES
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.matrix import matrix_lines
from tests.judging import case_of, expected, mark, mark_sheet, solution
from tests.nightly import in_turn
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[2]
NAMES = sorted(
    f"{path.parent.name}/{path.stem}" for path in (ROOT / "exercises").glob("*/*.yaml") if path.parent.name != "."
)
PROGRAMS = ("matlab", "numpy", "sympy")
Rows = list[list[str]]


def thirds(turn: int) -> pytest.MarkDecorator:
    """A law that by day is tried on every third exercise; those that everyone's own answers keep are on each."""
    return pytest.mark.parametrize("name", in_turn(NAMES, turn, 3))


def loaded(name: str) -> Exercise:
    """An exercise of this checkout."""
    return load_exercise(ROOT / "exercises" / f"{name}.yaml")


def rows_of(exercise: Exercise, question: MatrixQuestion) -> Iterator[tuple[str, Rows]]:
    """The entries of the right answer in every style that the writer knows, numbers in the sheet's unit."""
    truth = truth_of(question, case_of(exercise, exercise.parts[0]))
    if not exercise.numeric:
        for style in STYLES:
            yield style, [[write(entry, style, exercise.writing) for entry in row] for row in truth.rows]
        return
    assert truth.numbers is not None
    unit = float(exercise.metres)
    numbers = [
        [value / unit if is_length(question, r, c) else value for c, value in enumerate(row)]
        for r, row in enumerate(truth.numbers)
    ]
    for style, spelled in (("full", repr), ("short", "{:.6f}".format)):
        yield style, [[spelled(value) for value in row] for row in numbers]


def layouts(rows: Rows) -> Iterator[tuple[str, str]]:
    """Every way to arrange entries that somebody may paste."""
    yield "MATLAB", "[" + "; ".join(" ".join(row) for row in rows) + "]"
    yield "MATLAB with commas", "[" + "; ".join(", ".join(row) for row in rows) + "]"
    yield "lines", "\n".join("  ".join(row) for row in rows)
    yield "CSV", "\n".join(", ".join(row) for row in rows)
    yield "Markdown", "\n".join("| " + " | ".join(row) + " |" for row in rows)
    yield "named", "T_x = [" + "; ".join(", ".join(row) for row in rows) + "]"


def spellings(exercise: Exercise, question: MatrixQuestion) -> Iterator[tuple[str, str]]:
    """The right answer in every style, and in one style in every layout."""
    for style, rows in rows_of(exercise, question):
        if style in PROGRAMS and any("_im1" in entry for row in rows for entry in row):
            continue  # what a program calls a_{i-1} is not read back
        if question.shape == (1, 1):
            yield style, rows[0][0]
            continue
        if style == "latex":
            yield style, "\\begin{bmatrix}\n" + " \\\\\n".join(" & ".join(row) for row in rows) + "\n\\end{bmatrix}"
        else:
            yield style, "[" + ", ".join("[" + ", ".join(row) + "]" for row in rows) + "]"
        if style == "short":
            yield from layouts(rows)


def screen(exercise: Exercise, question: MatrixQuestion) -> str:
    """The right answer as dhcli draws it, a heading above it."""
    rows = truth_of(question, case_of(exercise, exercise.parts[0])).rows
    return "\n".join(["T of somebody", *matrix_lines(rows, exercise.writing, Look(paper=Paper(width=1000)))])


@thirds(0)
def test_its_own_solution_is_right_in_every_spelling(name: str) -> None:
    """As lists, in MATLAB, numpy, LaTeX, by lines, in tables: dhcli reads whatever it writes."""
    exercise = loaded(name)
    for part in exercise.parts:
        if isinstance(part.question, MatrixQuestion):
            answers = dict(spellings(exercise, part.question))
            if part.question.piece == "pose" and not exercise.numeric:
                answers["screen"] = screen(exercise, part.question)
        else:
            answers = {"expected": solved(exercise, part)}
        for spelling, answer in in_turn([*answers.items()], NAMES.index(name) // 3, min(len(answers), 5)):
            judged = mark(exercise, part, answer)
            assert judged.verdict is Verdict.RIGHT, (part.id, spelling, answer, judged.remarks)
            assert judged.earned == 1


def solved(exercise: Exercise, part: Part) -> str:
    """The right answer; for a table that the robot's file does not have, the one an own test calls right."""
    try:
        return expected(exercise, part)
    except RobotError:
        assert isinstance(part.question, TableQuestion)
        return next(t.answer for t in exercise.trials if t.part == part.id and t.verdict == "RIGHT")


@thirds(1)
def test_the_blank_sheet_earns_nothing(name: str, tmp_path: Path) -> None:
    """As `dhcli start` writes it, every part is skipped, and none is missing."""
    exercise = loaded(name)
    path = tmp_path / "sheet.yaml"
    path.write_text(write_sheet(exercise), "utf-8")
    sheet = read_sheet(path)
    assert sheet.exercise == exercise.id
    assert list(sheet.answers) == [part.id for part in exercise.parts]
    marked = mark_sheet(exercise, {part: answer.text for part, answer in sheet.answers.items()})
    assert {one.mark.verdict for one in marked.parts} == {Verdict.SKIPPED}
    assert (marked.verdict, marked.earned) == (Verdict.SKIPPED, 0)


@thirds(2)
def test_the_identity_earns_nothing_unless_it_is_right(name: str) -> None:
    """Whoever writes ones and zeros has not solved anything."""
    exercise = loaded(name)
    for part in exercise.parts:
        if isinstance(part.question, MatrixQuestion) and part.question.piece == "pose":
            judged = mark(exercise, part, "[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]")
            assert judged.earned == float(judged.verdict is Verdict.RIGHT), part.id


@pytest.mark.parametrize("name", NAMES)
def test_its_own_tests_come_out(name: str) -> None:
    """Every exercise tests itself, with a right answer and with a wrong one."""
    exercise = loaded(name)
    typed = [trial for trial in exercise.trials if not trial.mistake]
    for trial in typed:
        judged = mark(exercise, exercise.part(trial.part), trial.answer)
        assert judged.verdict.word == trial.verdict, (trial.part, trial.answer, judged.remarks)
    assert {"RIGHT", "WRONG"} <= {trial.verdict for trial in exercise.trials}


@thirds(1)
def test_every_part_has_hints_and_a_solution(name: str) -> None:
    """From gentle to plain, none twice; the solution ends with an answer that is right when it is copied."""
    exercise = loaded(name)
    for part in exercise.parts:
        assert part.hints, part.id
        assert all(hint.strip() for hint in part.hints)
        assert len(set(part.hints)) == len(part.hints)
        if isinstance(part.question, TableQuestion) and not _has_table(exercise, part):
            continue
        answer = solution(exercise, part)[-1].text.partition("nswer is ")[2]
        assert mark(exercise, part, answer).verdict is Verdict.RIGHT, part.id


@row_by_row("name", NAMES)
def test_a_printed_answer_is_right_or_recognised_as_a_misprint(name: str) -> None:
    """Who copies the document is told so, and who copies what is right is right."""
    exercise = loaded(name)
    for part in exercise.parts:
        if part.printed is None:
            continue
        judged = mark(exercise, part, part.printed.text)
        told = any("misprint" in remark for remark in judged.remarks)
        assert told is not judged.verdict.passed, (part.id, judged.verdict, judged.remarks)
        if isinstance(part.question, ChoiceQuestion) and told:
            assert not any(str(part.question.right) in remark for remark in judged.remarks)


@row_by_row("name", NAMES)
def test_it_says_where_it_comes_from_and_what_to_do(name: str) -> None:
    """Nothing is left empty, and every credit is worth something."""
    exercise = loaded(name)
    assert all((exercise.title, exercise.source, exercise.task.strip(), exercise.parts))
    assert all(part.credit > 0 for part in exercise.parts)


def test_every_name_of_the_library_stands_for_one_thing() -> None:
    """A robot, a linkage or an exercise, the last by its short name, too."""
    names = [entry.name.split("/")[-1] for kind in Kind for entry in entries(kind)]
    assert sorted({name for name in names if names.count(name) > 1}) == []


def test_every_document_has_its_exercises() -> None:
    """One folder each."""
    assert {name.split("/")[0] for name in NAMES} >= {"bajd", "wpi", "yim", "zhou"}


def _has_table(exercise: Exercise, part: Part) -> bool:
    try:
        return bool(expected(exercise, part))
    except RobotError:
        return False
