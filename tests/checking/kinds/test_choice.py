"""One of several statements: its number, its letter or its words."""

from __future__ import annotations

from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.files.yaml.exercises import read_exercise
from tests.row_by_row import row_by_row

EXERCISE = """
format: 1
title: Words
source: of a test
robot: planar-2r
task: The arm of two links.
parts:
  - id: which
    ask: choice
    options:
      - Yes, because the axes are parallel
      - No; the axes meet in a point
      - 'a singular pose, where "theta2 = 0"'
      - not a singular pose
      - theta2 = -90°
    right: 2
"""


def judged(answer: str) -> Mark:
    """An answer to the question, whose right one is the second."""
    exercise = read_exercise(EXERCISE, "test.yaml", "test/words")
    return Judge(exercise).check(exercise.parts[0], answer)


@row_by_row(
    ("answer", "number"),
    [
        ("2", 2),
        ("(b)", 2),
        ("b", 2),
        ("no", 2),
        ("No; the axes meet in a point.", 2),
        ("no the AXES meet in a point", 2),
        ("axes meet", 2),
        ("2: the axes meet in a point", 2),
        ("yes", 1),
        ("the second one", 2),
        ("two", 2),
        ("3rd", 3),
        ("First option.", 1),
        ("1. parallel", 1),
        ("a singular pose, where theta2 = 0", 3),
        ("not a singular pose", 4),
        ("-90°", 5),
    ],
)
def test_the_words_of_one_statement_are_its_number(answer: str, number: int) -> None:
    """All of them or some that stand in no other, with the marks of a sentence or without."""
    mark = judged(answer)
    assert mark.verdict is (Verdict.RIGHT if number == 2 else Verdict.WRONG)
    assert f"{number}: " in str(mark)


@row_by_row("answer", ["", "6", "0", "maybe", "the axes", "singular pose", "90°", "1: the axes meet", "z"])
def test_words_that_fit_none_or_several_are_not_guessed_at(answer: str) -> None:
    """Neither is a number whose words are those of another statement."""
    assert judged(answer).verdict in (Verdict.CANNOT_READ, Verdict.SKIPPED)


def test_short_statements_are_listed_where_no_words_of_theirs_are_typed() -> None:
    """A sheet does not always lie beside the message; long ones stand in the task."""
    (remark,) = judged("left-handed").remarks
    assert remark.endswith(
        "write the words of one statement alone: Yes, because the axes are parallel · No; the axes meet in a point · "
        'a singular pose, where "theta2 = 0" · not a singular pose · theta2 = -90°'
    )
    long = EXERCISE.replace("not a singular pose", "not a singular pose " + "at all " * 20)
    exercise = read_exercise(long, "test.yaml", "test/words")
    (remark,) = Judge(exercise).check(exercise.parts[0], "left-handed").remarks
    assert remark.endswith("write the words of one statement alone")
