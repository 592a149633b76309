"""Right angles written in radians: to their own digits they are what they are meant as."""

from __future__ import annotations

import math
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Decimal, localcontext
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.notation.parser import parse
from dhcli.notation.products import parse_factors
from dhcli.notation.quantity import to_angle
from dhcli.notation.quarters import Slight, right_angle_of, with_right_angles
from dhcli.notation.writer import write_angle
from tests.row_by_row import row_by_row

PI = Decimal("3.14159265358979323846264338327950288")


@row_by_row(
    ("text", "degrees"),
    [
        ("1.5708 rad", "90°"),
        ("-1.5708 rad", "-90°"),
        ("3.1416 rad", "180°"),
        ("3.1415 rad", "180°"),
        ("1.570796327 rad", "90°"),
        ("1.57079632679489661923 rad", "90°"),
        ("1.57 rad", "90°"),
        ("4.712 rad", "270°"),
        ("theta1 - 1.5708 rad", "theta1 - 90°"),
        ("-(theta1 + 3.1416 rad)", "-theta1 - 180°"),
    ],
)
def test_a_right_angle_in_decimals_is_taken_exactly_and_said(text: str, degrees: str) -> None:
    """Rounded or cut off."""
    remarks: list[str] = []
    assert write_angle(to_angle(with_right_angles(parse(text), remarks))) == degrees
    assert len(remarks) == 1
    assert "which it is to its digits" in remarks[0]


@row_by_row(
    "text",
    [
        "1.5 rad",
        "1.58 rad",
        "1.5709 rad",
        "1.5702 rad",
        "1.57089 rad",
        "3 rad",
        "0.0001 rad",
        "1.6 rad",
        "90°",
        "theta1",
    ],
)
def test_any_other_angle_stays_as_it_is(text: str) -> None:
    """A calibrated twist of 1.5702 is none of 90°, and 1.5709 is no rounding of it."""
    remarks: list[str] = []
    assert with_right_angles(parse(text), remarks) == parse(text)
    assert remarks == []


@given(st.integers(1, 8), st.integers(3, 20), st.sampled_from([ROUND_HALF_EVEN, ROUND_DOWN]), st.sampled_from([1, -1]))
def test_every_multiple_is_known_at_every_number_of_digits(count: int, places: int, rounding: str, sign: int) -> None:
    """By the standard library's decimals, to 35 digits."""
    with localcontext(prec=40):
        typed = (sign * count * PI / 2).quantize(Decimal(1).scaleb(-places), rounding=rounding)
        beside = typed + 2 * Decimal(1).scaleb(-places)
    assert right_angle_of(Fraction(typed), places) == sign * count * 90
    assert right_angle_of(Fraction(beside), places) is None


def test_a_symbolic_result_has_no_cosine_of_a_right_angle_in_decimals() -> None:
    """Nor of one that was given for a joint; in numbers a joint stands where it was put."""
    from dhcli import load_robot
    from dhcli.kinematics.frames import View
    from dhcli.kinematics.question import Question, answer
    from dhcli.kinematics.values import joint_values

    robot = load_robot("planar-2r")
    values = joint_values(robot, {"theta1": 1.5708})
    found = answer(robot, values, Question(View("0", "2"), symbolic=True))
    assert "1.57" not in str(found.pose.rows)
    assert found.warnings == ("theta1: 1.5708 rad is taken as 90°, which it is to its digits",)
    kept = answer(robot, joint_values(robot, {"theta1": 1.57089}), Question(View("0", "2"), symbolic=True))
    assert "1.57089" in str(kept.pose.rows)


def test_a_product_says_so_where_somebody_listens() -> None:
    """Whoever gives a list for remarks; else the angle stays as typed."""
    remarks: list[str] = []
    (exact,) = parse_factors("Rot(x, 1.5708 rad)", remarks=remarks)
    (typed,) = parse_factors("Rot(x, 1.5708 rad)")
    assert write_angle(exact.angle) == "90°"
    assert write_angle(typed.angle) == "1.5708 rad"
    assert remarks == ["1.5708 rad is taken as 90°, which it is to its digits"]


@pytest.mark.parametrize("text", ["0.000010077797806037976", "0.3", "0.00000000000000000123"])
def test_small_angles_in_radians_are_decimals(text: str) -> None:
    """With all digits of a float; as a fraction nobody could read them."""
    assert write_angle(to_angle(parse(f"{text} rad"), bare="refuse")) == f"{text} rad"
    assert "/" in write_angle(to_angle(parse("1/3 rad"), bare="refuse"))


@pytest.mark.parametrize(
    ("typed", "is_slight"), [("1.5708", True), ("-3.14159", True), ("1.571", False), ("1.57", False)]
)
def test_a_remark_is_slight_where_no_result_shows_the_difference(typed: str, is_slight: bool) -> None:
    """Four decimals are what results show."""
    remarks: list[str] = []
    parse_factors(f"Rot(x, {typed} rad)", remarks=remarks)
    assert [isinstance(remark, Slight) for remark in remarks] == [is_slight]
    assert is_slight is (abs(float(typed) - math.radians(round(math.degrees(float(typed)) / 90) * 90)) < 5e-5)
