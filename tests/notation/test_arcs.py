"""Angles by inverse functions: exact where they are multiples of 30° or 45°, sixteen digits elsewhere."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st

from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle
from dhcli.notation.writer import write_angle
from tests.row_by_row import row_by_row

ROOTS = ("0", "1", "-1", "1/2", "-1/2", "sqrt(2)/2", "-sqrt(2)/2", "sqrt(3)/2", "-sqrt(3)/2", "sqrt(3)", "1/sqrt(3)")


@row_by_row("function", ["acos", "asin", "atan"])
@row_by_row("argument", ROOTS)
def test_a_multiple_of_30_or_45_degrees_is_exact(function: str, argument: str) -> None:
    """As sympy knows it; beyond 1 there is no arc cosine."""
    right = getattr(sympy, function)(sympy.sympify(argument))
    if not right.is_real:
        with pytest.raises(DimensionError, match="is not a real number"):
            to_angle(parse(f"{function}({argument})"))
        return
    angle = to_angle(parse(f"{function}({argument})"), bare="refuse")
    if not (right / sympy.pi).is_rational:
        assert angle.radians
        return
    assert not angle.radians
    assert sympy.Rational(angle.degrees.numerator, angle.degrees.denominator) == right * 180 / sympy.pi


@row_by_row("y", ["0", "1", "-1", "sqrt(3)", "-sqrt(3)", "2 mm", "-2 mm", "0 mm"])
@row_by_row("x", ["1", "-1", "sqrt(3)", "-sqrt(3)", "0", "2 mm", "-2 mm", "0 mm"])
def test_the_arc_tangent_of_two_numbers_knows_its_quadrant(y: str, x: str) -> None:
    """Lengths with lengths, numbers with numbers; the same as in floats."""
    if ("mm" in y) != ("mm" in x) and "0" not in (y[0], x[0]):  # 0 is 0 in any unit
        with pytest.raises(DimensionError, match=r"no unit beside|cannot be added"):
            to_angle(parse(f"atan2({y}, {x})"))
        return
    angle = to_angle(parse(f"atan2({y}, {x})"), bare="refuse")
    top, below = (float(sympy.sympify(text.removesuffix(" mm"))) for text in (y, x))
    assert angle.constant() == pytest.approx(math.atan2(top, below), abs=1e-15)


@given(st.fractions(-1, 1, max_denominator=1000), st.sampled_from(["acos", "asin", "atan"]))
@example(Fraction(-1, 2), "acos")
def test_any_other_angle_has_the_digits_of_a_float(value: Fraction, function: str) -> None:
    """And no fewer; Python's own may be the other neighbour of the truth, as that of 120° is."""
    angle = to_angle(parse(f"{function}({value})"), bare="refuse")
    assert angle.constant() == pytest.approx(getattr(math, function)(value), abs=math.ulp(math.pi))


@row_by_row(
    ("text", "written"),
    [
        ("theta2 - acos(1/2)", "theta2 - 60°"),
        ("2*asin(1/2) + 10°", "70°"),
        ("-(theta1 + atan2(1, 1))", "-theta1 - 45°"),
        ("2*(theta1 + 30°)", "2*theta1 + 60°"),
        ("theta1 + atan2(3, 4)", "theta1 + 0.6435011087932844 rad"),
        ("acos(0.5) rad", "60°"),
        ("acos(cos(60°))", "60°"),
        ("atan(tan(30°))", "30°"),
    ],
)
def test_an_inverse_function_stands_wherever_an_angle_does(text: str, written: str) -> None:
    """In sums, multiples and brackets."""
    assert write_angle(to_angle(parse(text), bare="refuse")) == written
    assert has_angle_unit(parse("atan2(1, 2)"))


def test_an_inverse_function_of_names_wants_a_name_of_its_own() -> None:
    """For a table needs a number, or a parameter."""
    with pytest.raises(DimensionError, match="has no value here, for a3, d4 is a name") as caught:
        to_angle(parse("theta3 - atan2(a3, d4)"))
    assert caught.value.hint == "give the angle a name among the parameters, off: atan2(a3, d4)"


def test_the_cosine_of_an_arc_stays_one() -> None:
    """It is no cosine of sixteen digits, and means four fifths exactly."""
    from dhcli.algebra.equality import equal

    assert equal(parse("cos(atan2(3, 4))"), parse("4/5"))
    assert equal(parse("cos(theta1 + acos(1/2))"), parse("cos(theta1 + 60°)"))
