"""What must never be read as something else: units twice, foreign units, functions, words before brackets."""

from __future__ import annotations

import pytest

from dhcli.errors import NotationError
from dhcli.notation.parser import parse, parse_quantity
from dhcli.notation.products import parse_factors
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.notation.scope import OPEN, Scope, usual
from dhcli.notation.writer import write, write_angle
from tests.row_by_row import row_by_row

ROBOT = Scope(joints=("theta1", "theta2", "theta3", "theta4"), lengths=("a1", "d3", "c", "reach"))
SCOPES = (OPEN, ROBOT, Scope(), usual())


def refusal(text: str, scope: Scope) -> str:
    """Why a text is no length in a scope, with its hint."""
    with pytest.raises((NotationError, DimensionError)) as caught:
        to_length(parse(text, scope))
    if isinstance(caught.value, DimensionError):
        return f"{caught.value.message} ({caught.value.hint})"
    (problem,) = caught.value.problems
    return f"{problem.message} ({problem.hint})"


@row_by_row("scope", SCOPES)
@row_by_row(
    ("text", "said"),
    [
        ("400mm/2mm", "a second unit, mm, stands in one product"),
        ("1 m m", "a second unit, m, stands in one product"),
        ("400 mm/(2 mm)", "the units cancel, and a length is wanted"),
        ("400 mm/(2 cm)", "the units cancel, and a length is wanted"),
        ("0.1 m^-1", "this is a length to the power -1, a length is wanted"),
        ("9 mm^2", "this is an area, a length is wanted"),
        ("2 m * 3 m", "a second unit, m, stands in one product"),
        ("2 m * (3 m)", "this is an area, a length is wanted"),
        ("sqrt(2 mm)", "this is a length to the power 1/2, a length is wanted"),
        ("2 m 3", "a number stands behind the unit m"),
        ("3 mm + 1", "1 has no unit beside a length that has one"),
        ("3 mm + cos(30°)*2", "a length and a number cannot be added"),
        ("atan2(3 mm, 1)", "1 has no unit beside a length that has one"),
        ("acos(3 mm)", "acos takes a number, and not a length"),
        ("0x10", "0x10 is not a number that is read"),
        ("0b11", "0b11 is not a number that is read"),
        ("3 km", "km is not a unit that is read (write 1000 m)"),
        ("5 kg", "kg is not a unit that is read (units: mm, cm, m, in, deg, rad)"),
        ("sec(0)", "sec is a function that is not read (write 1/cos(theta1))"),
        ("abs(-3)", "abs is a function that is not read (write the number without its sign)"),
        ("ln(2)", "ln is a function that is not read"),
        ("ln 2", "ln is a function that is not read"),
        ("exp(1)", "exp is a function that is not read"),
        ("factorial(10**7)", "factorial is a function that is not read"),
        ("sine(2)", "sine is not a function that is known (did you mean sin"),
        ("coss(2)", "coss is not a function that is known (did you mean cos"),
        ("nan", "nan is no number that a robot can have"),
        ("-inf", "inf is no number that a robot can have"),
        ("Infinity", "Infinity is no number that a robot can have"),
        ("mm", "mm is a unit, and no number stands before it (write 1 mm)"),
        ("1e60^5", "a length or number beyond 100,000,000 is not read"),
        ("1e9", "a length or number beyond 100,000,000 is not read"),
        ("1e-60^5 mm", "the number becomes too large or too small"),
        ("sqrt(-1)", "sqrt(-1) is not a real number"),
        ("2*acos(2) + 1", "acos(2) is not a real number"),
    ],
)
def test_a_text_that_means_nothing_is_refused_in_every_scope(text: str, said: str, scope: Scope) -> None:
    """With what it might have meant; none becomes a product, a ratio or a length of another size."""
    assert refusal(text, scope).startswith(said)


@row_by_row(
    ("text", "metres"),
    [
        ("1/2 m", "1/2"),
        ("0.4*m", "0.4"),
        ("30*mm", "0.03"),
        ("a1*3 mm", "0.003*a1"),
        ("2 mm*cos(60°)", "0.001"),
        ("sqrt((3 mm)^2 + (4 mm)^2)", "1/200"),
        ("sqrt(a1^2 + (3 mm)^2)", "sqrt(a1^2 + 0.000009)"),
        ("6 mm^2/(2 mm)", "0.003"),
        ("400 mm*(24 mm/(48 mm))", "0.2"),
        ("reach(c + 1)", "reach*(c + 1)"),
        ("3 mm - 3 mm", "0"),
        ("1e8", "100000000"),
    ],
)
def test_a_length_in_any_form_is_still_read(text: str, metres: str) -> None:
    """Areas over lengths, roots of areas, ratios as factors, declared words before brackets."""
    assert write(to_length(parse(text, ROBOT))) == metres


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("30° 15", "a number stands behind the unit °"),
        ("30°15″", "a number stands behind the unit °"),
        ("30°75'", "a number stands behind the unit °"),
        ("30 deg deg", "a second unit, deg, stands in one product"),
    ],
)
def test_a_number_behind_degrees_that_are_no_minutes_is_a_question(text: str, said: str) -> None:
    """`30° 15` is neither 450° nor 45°, and there are no 75 minutes."""
    with pytest.raises(NotationError) as caught:
        parse(text)
    assert caught.value.problems[0].message == said


@pytest.mark.parametrize("text", ["1e60^5°", "1e19 rad", "2000000°", "-17454 rad"])
def test_an_angle_of_thousands_of_turns_is_refused(text: str) -> None:
    """Its cosine is nothing but rounding, and 1e19 would pass as a twist of 0."""
    with pytest.raises(DimensionError, match="an angle beyond 1,000,000° is not read"):
        to_angle(parse(text))


@row_by_row(
    ("text", "read"),
    [
        ("c(sin(θ2+θ3)*s4)", "c*s23*s4"),
        ("c(cos(theta1)+a1)", "c*(c1 + a1)"),
        ("c(a1 + cos θ1)", "c*(a1 + c1)"),
        ("c(sin 2θ1 + a1)", "c*(s(2*theta1) + a1)"),
        ("c(sin 30° + a1)", "c*(1/2 + a1)"),
        ("c(sin^2 θ1)", "c*s1^2"),
        ("c(s4)", "c*s4"),
        ("c(a1 + d3)", "c*(a1 + d3)"),
        ("c(θ1 + θ2)", "c12"),
        ("c(θ1 + 30°)", "c(theta1+30°)"),
        ("c(30°)", "sqrt(3)/2"),
    ],
)
def test_a_length_called_c_before_a_bracket_is_a_cosine_only_of_an_angle(text: str, read: str) -> None:
    """An angle inside a spelled-out sine or cosine in the bracket is none of the bracket's own."""
    assert write(parse(text, ROBOT)) == read


@pytest.mark.parametrize("text", ["sin(90+θ1)", "cos(θ1-45)", "c(θ1 + 180)", "tan(θ1 + 30)", "cos(30 - θ1 - θ2)"])
def test_degrees_without_their_sign_beside_an_angle_are_a_question(text: str) -> None:
    """As `cos30` is: nobody means 90 radians."""
    with pytest.raises(NotationError) as caught:
        parse(text, ROBOT)
    assert "does not say what" in caught.value.problems[0].message
    assert "° for degrees" in caught.value.problems[0].hint


@pytest.mark.parametrize("text", ["0.4 cos(25)", "sin 45", "cos(25 + 24)", "tan(60)", "3*sin(-90)"])
def test_a_cosine_of_degrees_without_their_sign_is_a_question(text: str) -> None:
    """Also where no angle stands beside them; a turn at most, and `7 rad`, are read."""
    with pytest.raises(NotationError) as caught:
        parse(text, Scope(joints=("theta1",), lengths=("a1",)))
    assert "does not say what" in caught.value.problems[0].message
    assert write(parse("cos(7 rad)*a1", ROBOT)) == "a1*cos(7 rad)"
    assert write(parse("cos(0.4)*a1", ROBOT)) == "a1*cos(0.4)"


def test_radians_beside_an_angle_are_read() -> None:
    """Below a turn, or with their unit; and what is written can be read back."""
    assert write(parse("cos(θ1 + 1.2)", ROBOT)) == "c(theta1+1.2)"
    long = parse("cos(θ1 + 90 rad)", ROBOT)
    assert write(long) == "c(theta1+90 rad)"
    assert parse(write(long), ROBOT) == long


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Trans(factorial(10**7),0,0)", "factorial is a function that is not read"),
        ("Trans(nan,0,0)", "nan is no number that a robot can have"),
        ("Trans(inf,0,0)", "inf is no number that a robot can have"),
        ("Trans(3 km,0,0)", "km is not a unit that is read"),
        ("Trans(shoulder,0,0)", "shoulder is not a name, a function or a unit that is known here"),
        ("Rot(z, angle)", "angle is not a name, a function or a unit that is known here"),
        ("Rot(z, a1*90°)", "an angle is a sum of joint angles and constants"),
    ],
)
def test_a_product_without_a_robot_asks_about_words(text: str, message: str) -> None:
    """With the column of the word; none becomes a length by itself."""
    with pytest.raises(NotationError) as caught:
        parse_factors(text, usual())
    (problem,) = caught.value.problems
    assert problem.message == message
    assert problem.place is not None
    assert (problem.place.column or 0) > 4


def test_a_product_takes_names_that_look_like_names_and_those_declared() -> None:
    """A letter or a Greek one with an index, `px`, and whatever `--symbols` says."""
    assert len(parse_factors("Trans(l1, d_f, px) Rot(z, phi) Rot(x, θ_1) Trans(0, 0, l_x)", usual())) == 4
    (move,) = parse_factors("Trans(shoulder, 0, 0)", usual(("shoulder", "l1")))
    assert write(move.offset[0]) == "shoulder"
    (turn,) = parse_factors("Rot(z, alpha_hand)", usual(("alpha_hand",)))
    assert turn.angle.names == {"alpha_hand"}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a1*90°", "an angle is a sum of joint angles and constants"),
        ("400 mm/(2 mm)", "the units cancel, and a length is wanted"),
        ("acos(2)", "acos(2) is not a real number"),
    ],
)
def test_a_quantity_is_checked_where_it_is_read(text: str, message: str) -> None:
    """With its place, so that a file says in which line and column."""
    with pytest.raises(NotationError) as caught:
        parse_quantity(text, ROBOT)
    assert caught.value.problems[0].message == message
    assert caught.value.problems[0].place is not None
    assert write(parse_quantity("2*a1", ROBOT)) == "2*a1"
    assert write_angle(to_angle(parse_quantity("atan2(24 mm, 24 mm)", ROBOT))) == "45°"
