"""Lengths in another unit than that of the sheet are seen, also with rounded cosines or one more slip."""

from __future__ import annotations

import pytest

from dhcli.checking.verdicts import Mark, Verdict
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
