"""Answer sheets: what `start` writes, and the answers read back, each with the place where it stands."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import field
from pathlib import Path

from dhcli.checking.earning import worth, worth_of
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.marked import SheetMark
from dhcli.checking.variants import variant_of
from dhcli.errors import DhcliError, FileError, Place
from dhcli.files.reading import read_text, source_of
from dhcli.files.yaml.apart import read_apart
from dhcli.files.yaml.beside import given_lines, how_written, values_text
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedNode, PlacedScalar, as_text
from dhcli.files.yaml.prose import folded
from dhcli.frozen import frozen
from dhcli.safe import one_line, yaml_scalar

KEYS = ("exercise", "answers", "variant", "given", "name")
BLANK = "_"
WIDEST = 88
"""Columns of a comment."""


@frozen
class Answer:
    """One answer: its text, where it stands, and what is wrong where the file does not hold it as a text."""

    text: str
    place: Place
    problem: str = ""


@frozen
class Sheet:
    """A filled-in sheet.

    Attributes:
        exercise: Id of the exercise; empty if the sheet does not say.
        answers: The answers by part.
        variant: What its numbers were drawn with; empty for those of the file.
        name: Who filled it in; empty if the sheet does not say.
        given: The values that it was written with, as texts; none if the sheet does not say.
    """

    exercise: str
    answers: Mapping[str, Answer]
    variant: str = ""
    name: str = ""
    given: Mapping[str, str] = field(default_factory=dict)


def read_sheet(path: Path | str) -> Sheet:
    """Read a sheet; `-` is standard input. An answer that is no YAML is told of, and the others are read.

    Raises:
        FileError: It is no sheet; every problem, with line and column.
    """
    problems = Problems()
    root, unread = read_apart(read_text(path), source_of(path))
    fields = problems.document(root, known=KEYS, required=("answers",))
    answers = {key: _answer(node) for key, (_, node) in fields.mapping("answers").entries.items()}
    answers |= {
        key: Answer(one.text, one.problem.place or Place(source_of(path)), str(one.problem))
        for key, one in unread.items()
    }
    values = fields.mapping("given")
    given = {key: values.text(key) for key in values.entries}
    exercise, variant = fields.text("exercise"), fields.text("variant")
    name = _name(fields)
    problems.raise_if_any(FileError)
    return Sheet(exercise, answers, variant, name, given)


def _name(fields: Fields) -> str:
    """Whose sheet it is; a blank that nobody has filled in is no name."""
    node = fields.get("name")
    if isinstance(node, PlacedScalar) and node.text.strip() in ("", BLANK):
        return ""
    return fields.text("name")


def check_numbers(sheet: Sheet, exercise: Exercise, written: str) -> None:
    """Make sure that a sheet was written with the numbers that its answers are judged by; an old one does not say.

    Raises:
        DhcliError: They differ, for the exercise, its ranges or its robot were changed meanwhile.
    """
    now = values_text(exercise)
    for name, then in sheet.given.items():
        if then != now.get(name):
            today = f"{now[name]} now" if name in now else "no value now"
            message = f"{written} was written with other numbers than this exercise has: {name} = {then} there, {today}"
            raise DhcliError(message, f"judge it by the exercise as it was, or dhcli start {exercise.typed} again")


def judged_sheet(
    judge: Judge, sheet: Sheet, written: str, asked: str | None = None, only: str | None = None
) -> SheetMark:
    """Judge a sheet by the numbers that it was written with.

    Raises:
        DhcliError: It is of another variant, or was written with other numbers, or answers no part of the exercise.
    """
    judge = variant_of(judge, asked, sheet.variant, written)
    check_numbers(sheet, judge.exercise, written)
    texts = {name: answer.text for name, answer in sheet.answers.items()}
    unread = {name: answer.problem for name, answer in sheet.answers.items() if answer.problem}
    return judge.sheet(texts, {name: answer.place for name, answer in sheet.answers.items()}, only, unread)


def write_sheet(exercise: Exercise, name: str = "") -> str:
    """A blank sheet, with comments that show how each kind of answer is written.

    Args:
        exercise: The exercise.
        name: Whose sheet it is, if that is known.
    """
    credit = f"Worth: {worth_of(exercise)}" if worth_of(exercise) else ""
    given = (text[0].upper() + text[1:] for text in given_lines(exercise))
    known = [line for text in (*given, credit) if text for line in _comment(text)]
    fill = f"Fill in each {BLANK} and save; leave a part as it is to skip it. Then:"
    lines = [
        *_comment(exercise.title),
        *_comment(exercise.source),
        "#",
        *_comment(exercise.task.strip()),
        *(["#", *known] if known else []),
        "#",
        *_comment(fill),
        f"#   dhcli check {one_line(exercise.id)} THIS_FILE",  # whole, to be copied
        *(line for text in how_written(exercise) for line in _comment(text)),
        "format: 1",
        f"exercise: {yaml_scalar(exercise.id)}",
        *([f"name: {yaml_scalar(name)}"] if name else []),
        *([f"variant: {yaml_scalar(exercise.variant)}"] if exercise.variant else []),
        *_given(exercise),
        "answers:",
    ]
    for part in exercise.asked:
        lines += _part_lines(exercise, part)
    return "\n".join(lines) + "\n"


def _given(exercise: Exercise) -> Iterator[str]:
    """The numbers of the sheet as data: if the exercise is changed later, a right answer must not become wrong."""
    if exercise.values and (exercise.numeric or exercise.variant):
        values = ", ".join(f"{yaml_scalar(name)}: {_value(text)}" for name, text in values_text(exercise).items())
        yield from folded(f"given: {{{values}}}", WIDEST, "", "  ")


def _value(text: str) -> str:
    """A value as YAML between braces; one with a comma or a bracket in it needs quotes."""
    return text if re.fullmatch(r"[-\w.°+*/^() ]+", text) else yaml_scalar(text)


def _comment(text: str, first: str = "# ", rest: str = "# ") -> list[str]:
    """Comment lines, folded."""
    return [line.rstrip() or "#" for line in folded(text, WIDEST, first, rest)]


def _part_lines(exercise: Exercise, part: Part) -> Iterator[str]:
    question = part.question
    yield ""
    asked = (part.prompt.strip(), part.form(exercise)) if part.prompt.strip() else (part.heading(exercise),)
    for text in (*asked[:-1], " · ".join(filter(None, (asked[-1], worth(exercise, part))))):
        yield from _comment(text, "  # ", "  # ")
    for note in question.notes(exercise):
        yield from _comment(note, "  # ", "  # ")
    for number, option in enumerate(question.statements, 1):
        yield from _comment(option, f"  #   {number}: ", "  #      ")
    yield f"  {part.id}: |"
    rows, columns = question.blank(exercise)
    yield from ["    " + "  ".join([BLANK] * columns)] * rows


def _answer(node: PlacedNode) -> Answer:
    """An answer as text; YAML lists become the matrix they look like."""
    place = node.place
    if isinstance(node, PlacedScalar) and place.line and place.text.rstrip().endswith(("|", ">", "|-", ">-")):
        place = Place(place.source, place.line + 1)  # a block begins on the line below
    return Answer(as_text(node).strip(), place)
