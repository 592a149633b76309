import pytest

from dhcli import check, load_exercise
from dhcli.checking.diagnosis.chance import Evidence, is_chance
from dhcli.checking.verdicts import Verdict, too_few
from tests.row_by_row import row_by_row

SHEET = load_exercise("puma560-at-work-in-mm")
ELBOW = load_exercise("three-r-arm-tip-in-numbers")


@pytest.mark.parametrize("answer", ["0.1 0.2 0.97", "0.3 0.3 0.9", "1 0 0", "0 0 1", "0 0 0"])
def test_a_guess_has_no_name(answer: str) -> None:
    """Of thousands of pairs some lie near any direction typed to a digit or two."""
    judged = check(SHEET, "approach", answer)
    assert judged.verdict is Verdict.WRONG
    assert judged.diagnosis is None


def test_a_place_typed_to_one_digit_has_no_name() -> None:
    """Not even where one of its entries is right, as it is for everybody."""
    assert check(ELBOW, "elbow", "0.5 0.4 0").diagnosis is None


@pytest.mark.parametrize(
    ("part", "answer"), [("wrist", "0 0 0"), ("flange", "0.1 0.2 0.3"), ("flange", "0.311 0.3 0.1")]
)
def test_what_is_near_zero_is_no_product_entry_by_entry(part: str, answer: str) -> None:
    """That gives zero, which many mistakes do, and a tolerance of half a millimetre reaches far from there."""
    assert check(SHEET, part, answer).diagnosis is None


def test_a_slip_typed_to_three_decimals_keeps_its_name() -> None:
    """The digits say enough."""
    found = check(SHEET, "approach", "0.277, -0.347, 0.896").diagnosis
    assert found is not None
    assert "direction" in found.ids


def test_a_slip_in_metres_on_a_sheet_in_millimetres_is_named() -> None:
    """With the unit beside it."""
    found = check(SHEET, "flange", "0.35586, 0.37872, -0.06501").diagnosis
    there = check(SHEET, "flange", "355.86, 378.72, -65.01").diagnosis
    assert found is not None
    assert there is not None
    assert found.ids == tuple(f"{name} + in-m" for name in there.ids)
    assert found.names[0].endswith(" and the lengths are in m, not mm")


def test_too_few_digits_have_no_name() -> None:
    """What is right as far as it was typed holds no slip."""
    judged = check(SHEET, "approach", "-0.3, 0.3, -0.9")
    assert judged.remarks == (too_few(None),)
    assert judged.diagnosis is None


def test_chance_counts_the_candidates_that_the_digits_leave_open() -> None:
    """A hundred candidates over a range of two: of slack 0.1 a tenth is met, of 0.001 a thousandth."""
    given = [(k / 50 - 1.01,) for k in range(100)]

    def met(slack: float, stage: str = "singles") -> bool:
        return is_chance(stage, given, Evidence((0.33,), (slack,), (5.0,), (True,)))

    assert met(0.1)
    assert met(0.001)
    assert not met(0.0001)
    assert met(0.0001, "pairs")
    assert not met(0.00001, "pairs")


@row_by_row(
    ("part", "answer"),
    [
        ("tool", "0.0435, 0.399, 0.55"),
        ("tool", "0.0435154, 0.398955, 0.55"),
        ("t03", "0.766 -0.643 0 0.0435; 0.643 0.766 0 0.399; 0 0 1 0.55; 0 0 0 1"),
    ],
)
def test_a_number_without_its_last_zeros_is_as_sharp_as_the_others(part: str, answer: str) -> None:
    """0.55 beside 0.399 is 0.550, and not 0.546: it is the height with the other sign of d3."""
    found = check(load_exercise("bajd/scara-pose-in-m"), part, answer).diagnosis
    assert found is not None
    assert found.ids == ("shift-sign 3.2 z",)


def test_a_number_as_rough_as_the_others_says_no_more_than_they_do() -> None:
    """With two decimals throughout, any height would be met by some slip."""
    assert check(load_exercise("bajd/scara-pose-in-m"), "tool", "0.04, 0.40, 0.55").diagnosis is None
