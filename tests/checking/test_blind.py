"""Strategies of somebody who has not looked at the task: where they are wrong, they earn nothing."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from dhcli import load_exercise
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.count import CountQuestion
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.marked import PartMark
from dhcli.checking.verdicts import Verdict
from dhcli.files.library.entries import Kind, entries
from tests.judging import judge_of, mark_sheet, vary
from tests.nightly import in_turn, some

MOST = 0.15
"""Share of the credit that a sheet may earn whose answers show no work, where some are right by chance."""

ZERO_OF_MANY = "(1e6*(0.1*(cos(1)+1) - 0.1*(1+cos(1))))"
"""Zero, with decimals in it."""

PATHS = {f"{entry.path.parent.name}/{entry.path.stem}": entry.path for entry in entries(Kind.EXERCISES)}


def filled(exercise: Exercise, part: Part, cell: str, diagonal: str | None = None, bottom: str | None = None) -> str:
    """The blanks of a part filled with one text, but for the diagonal of a matrix and the last row of a pose."""
    rows, columns = part.question.blank(exercise)
    is_square = rows == columns > 1
    lines = [[diagonal if diagonal and is_square and r == c else cell for c in range(columns)] for r in range(rows)]
    if bottom and (rows, columns) == (4, 4):
        lines[3] = bottom.split()
    return cell if (rows, columns) == (1, 1) else "[" + "; ".join(", ".join(line) for line in lines) + "]"


STRATEGIES: dict[str, Callable[[Exercise, Part], str]] = {
    "blank": lambda _exercise, _part: "",
    "zeros": lambda exercise, part: filled(exercise, part, "0"),
    "zeros above 0 0 0 1": lambda exercise, part: filled(exercise, part, "0", bottom="0 0 0 1"),
    "identity": lambda exercise, part: filled(exercise, part, "0", diagonal="1"),
    "not a number": lambda exercise, part: filled(exercise, part, "nan", bottom="0 0 0 1"),
    "root of -1": lambda exercise, part: filled(exercise, part, "sqrt(-1)", bottom="0 0 0 1"),
    "a zero of decimals": lambda exercise, part: filled(
        exercise, part, ZERO_OF_MANY if isinstance(part.question, MatrixQuestion) else "0", bottom="0 0 0 1"
    ),
}


def is_right_count(one: PartMark) -> bool:
    """Whether a count was asked that is 0, or 1, by rights."""
    return isinstance(one.part.question, CountQuestion) and one.mark.verdict is Verdict.RIGHT


ORDINARY = [*dict.fromkeys([*some(list(PATHS), 9), "motion/cylindrical-jacobian"])]
"""Exercises of which a part is tried by day, one with a column of zeros around a one among them."""


@pytest.mark.parametrize(("name", "turn"), [(name, k) for k, name in enumerate(ORDINARY)])
def test_no_blind_strategy_earns_more_than_a_guess(name: str, turn: int) -> None:
    """Neither by itself nor by what follows from an answer that is as blind; and a wrong answer nothing at all."""
    exercise = load_exercise(PATHS[name])
    for title, answer in in_turn([*STRATEGIES.items()], turn, 5):
        sheet = mark_sheet(exercise, {part.id: answer(exercise, part) for part in exercise.parts})
        by_work = [one for one in sheet.parts if not is_right_count(one)]
        assert math.fsum(one.mark.earned * one.part.credit for one in by_work) <= MOST * sheet.credit, title
        wrong = {one.part.id: one.mark.earned for one in by_work if not one.mark.verdict.passed}
        assert not any(wrong.values()), (title, wrong)


VARIED = [name for name, path in PATHS.items() if "\nvariants:" in path.read_text("utf-8")]
SEEDS = ("2", "anna")


@pytest.mark.parametrize(("name", "seed"), in_turn([(name, seed) for name in VARIED for seed in SEEDS], 0, 5))
def test_a_sheet_copied_from_another_variant_earns_no_more_than_a_guess(name: str, seed: str) -> None:
    """Its answers follow from each other; but none of them comes from the numbers given."""
    exercise = load_exercise(PATHS[name])
    mine, other = vary(exercise, seed), vary(exercise, "1")
    assert mine.given != other.given
    copied = {part.id: judge_of(other).expected(other.part(part.id)) for part in exercise.parts}
    parts = mark_sheet(mine, copied).parts
    open_ones = [one for one in parts if one.mark.verdict is not Verdict.RIGHT]  # the same in every variant
    earned = math.fsum(one.mark.earned * one.part.credit for one in open_ones)
    assert earned <= MOST * math.fsum(one.part.credit for one in parts)
