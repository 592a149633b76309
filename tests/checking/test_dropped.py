"""Nothing that stands before or behind a right answer is dropped as if it were not there."""

from __future__ import annotations

from itertools import product

from dhcli.checking.verdicts import Verdict
from tests.checking.test_whole import EXERCISES
from tests.judging import expected, mark
from tests.once import load_exercise
from tests.row_by_row import row_by_row

BEFORE = ("-", "2*", "3 ", "a1*", "7, ", "7; ", "[1 2 3] ", "not ", "1 - ", "sqrt")
BEHIND = ("*2", " + 1", ", 7", "; 7", "\n7", " 7", " or 7", " km", " [1 2 3]", " = 7", ", x = 7", "^3", " - 1")
HOLDS = (Verdict.RIGHT, Verdict.EQUIVALENT)


@row_by_row("name", EXERCISES)
def test_what_changes_a_right_answer_makes_it_another_one(name: str) -> None:
    """A sign, a factor, another number: in lists, matrices, tables and joint values, all in brackets."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        text = expected(exercise, part)
        if not text.startswith("[") or not text.strip("[]0, "):
            continue
        for before, behind in (*product(BEFORE, [""]), *product([""], BEHIND)):
            found = mark(exercise, part, f"{before}{text}{behind}")
            assert found.verdict not in HOLDS, (part.id, before, behind)
