"""Lengths in another unit than that of the sheet are seen, also with rounded cosines or one more slip."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.files.yaml.exercises import load_exercise
from tests.checking.mutated_kinds import exercise_of
from tests.judging import checked

GIVEN = {"theta1": "30°", "theta2": "45°"}


def judged(answer: str, ask: str = "pose 0..2", unit: str = "m") -> Mark:
    """An answer about the planar arm, explained."""
    exercise, part = exercise_of(ask, given=GIVEN, numeric=True, unit=unit)
    return checked(exercise, part, answer)


@pytest.mark.parametrize(
    ("answer", "remark"),
    [
        (
            "[0.2588 -0.9659 0 424.06; 0.9659 0.2588 0 489.78; 0 0 1 0; 0 0 0 1]",
            "right in mm; this sheet is in m",
        ),
        (
            "[0.26 -0.97 0 424.06; 0.97 0.26 0 489.78; 0 0 1 0; 0 0 0 1]",
            "right in mm, to the digits typed; this sheet is in m",
        ),
        (
            "[0.2588 -0.9659 0 42.406; 0.9659 0.2588 0 48.978; 0 0 1 0; 0 0 0 1]",
            "right in cm; this sheet is in m",
        ),
    ],
)
def test_nothing_else_wrong(answer: str, remark: str) -> None:
    """Then it is no wrong answer, and the unit gate speaks."""
    mark = judged(answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert mark.remarks == (remark,)


@pytest.mark.parametrize(
    ("answer", "wrong", "slip"),
    [
        (
            "[0.2588 -0.9659 0 -424.06; 0.9659 0.2588 0 489.78; 0 0 1 0; 0 0 0 1]",
            {(0, 3)},
            "the sign of entry (1,4) is turned round",
        ),
        (
            "[0.2588 0.9659 0 424.06; -0.9659 0.2588 0 489.78; 0 0 1 0; 0 0 0 1]",
            {(0, 1), (1, 0)},
            "the rotation is transposed: its columns, not its rows, are the axes of the frame described",
        ),
    ],
)
def test_with_one_more_slip_the_rest_is_judged_in_that_unit(
    answer: str, wrong: set[tuple[int, int]], slip: str
) -> None:
    """Only the entries that are wrong in millimetres are; both slips are named."""
    mark = judged(answer)
    assert mark.verdict is Verdict.WRONG
    assert mark.remarks[0] == "the lengths are in mm; this sheet is in m: the rest is judged in mm"
    assert {(cell.row, cell.column) for cell in mark.cells if cell.verdict is not Verdict.RIGHT} == wrong
    assert mark.diagnosis is not None
    assert [one.words for one in mark.diagnosis.causes[0]] == [slip, "the lengths are in mm, not m"]


def test_metres_on_a_sheet_in_millimetres() -> None:
    """A sign besides: no length is taken for forgotten because it is small."""
    mark = judged("[0.42406, -0.48978, 0]", "position of pose 0..2", "mm")
    assert mark.remarks[0].startswith("the lengths are in m; this sheet is in mm")
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == ("theta-signs + in-m", "entry-sign 2,1 + in-m")


@pytest.mark.parametrize(
    "answer",
    [
        "[0.2588 -0.9659 0 0.42406; 0.9659 0.2588 0 489.78; 0 0 1 0; 0 0 0 1]",
        "[0.2588 -0.9659 0 0.3; 0.9659 0.2588 0 0.5; 0 0 1 0; 0 0 0 1]",
    ],
)
def test_what_is_right_in_no_other_unit_is_judged_as_it_is(answer: str) -> None:
    """One length in millimetres among metres is a slip in one place; other lengths are only wrong."""
    mark = judged(answer)
    assert mark.verdict is Verdict.WRONG
    assert not any(remark.startswith("the lengths are in") for remark in mark.remarks)


ARM = """format: 1
title: Planar arm in numbers
source: a test
convention: standard
variables: [theta1, theta2]
links:
  - {a: 400 mm, alpha: 0, d: 0, theta: theta1}
  - {a: 300 mm, alpha: 0, d: 0, theta: theta2}
"""
ASKED = {
    "position of pose 0..2": "(0.4241, 0.4898, 0)",
    "angle theta2 of position": "±acos((px^2 + py^2 - 0.25)/0.24)",
    "jacobian linear of 0..2": "[-0.4898 -0.2898; 0.4241 0.0776; 0 0]",
}


@pytest.mark.parametrize("order", list(itertools.permutations(ASKED)))
def test_parts_of_one_exercise_are_read_in_another_unit_in_any_order(tmp_path: Path, order: tuple[str, ...]) -> None:
    """What is kept for one kind of question is no hindrance to another."""
    (tmp_path / "arm.yaml").write_text(ARM, "utf-8")
    parts = "".join(f"  - {{id: p{k}, ask: {ask}}}\n" for k, ask in enumerate(order))
    text = "format: 1\ntitle: t\nsource: s\nrobot: ./arm.yaml\nnumeric: true\nunit: mm\ntask: t\n"
    (tmp_path / "one.yaml").write_text(f"{text}given: {{theta1: 30°, theta2: 45°}}\nparts:\n{parts}", "utf-8")
    judge = Judge(load_exercise(tmp_path / "one.yaml"))
    for part, ask in zip(judge.exercise.parts, order, strict=True):
        assert judge.judged(part, ASKED[ask]).mark.remarks == ("right in m; this sheet is in mm",), ask


def test_a_number_too_small_to_matter_shows_no_unit() -> None:
    """Half of the truth twice, once with 0.1 m added to a length: as 0.1 mm it is lost in the digits of 0.5."""
    exercise, part = exercise_of("scalar a1*c1 + a2*s12", given={}, numeric=False, unit="m")
    wrong = checked(exercise, part, "(a1*c1 + (a2 + 0.1)*s12)/2 + 0.5*(a1*c1 + a2*s12)")
    assert wrong.verdict is Verdict.WRONG
    assert checked(exercise, part, "(a1*c1 + a2*s12)^2/0.4").verdict is Verdict.WRONG
