"""What people write, and what it is read as: numbers, units, names, shorthand, products without a sign."""

from __future__ import annotations

import pytest

from dhcli.errors import NotationError
from dhcli.notation.names import usual_aliases
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Number, Symbol, add
from dhcli.notation.writer import write, write_angle
from tests.row_by_row import row_by_row

ROBOT = Scope(
    joints=("theta1", "theta2", "theta3"),
    angles=("alpha", "alpha_{i-1}"),
    lengths=("a1", "a2", "a12", "b", "c", "d3", "d_f", "l_x"),
    aliases={"q1": "theta1", "q2": "theta2", "q3": "theta3"},
)
"""The names of an exercise: joints, twists, lengths, one of them called c."""


@row_by_row(
    ("text", "read"),
    [
        # numbers
        ("0.5", "0.5"), ("-.5", "-0.5"), ("5.", "5"), ("1e-3", "0.001"), ("2.5E3", "2500"), ("1/2", "1/2"),
        ("0,5", "0.5"), ("-1,25", "-1.25"), ("√3/2", "sqrt(3)/2"), ("sqrt(3)/2", "sqrt(3)/2"), ("2√3", "2*sqrt(3)"),
        ("√(2)√(3)", "sqrt(6)"), ("√12", "2*sqrt(3)"), ("1/√2", "sqrt(2)/2"), ("\\sqrt{2}/2", "sqrt(2)/2"),
        ("\\frac{\\sqrt{3}}{2}", "sqrt(3)/2"), ("\\frac{1}{2} a1", "a1/2"),
        ("π/6", "pi/6"), ("pi/6", "pi/6"), ("\\pi/6", "pi/6"), ("2π", "2*pi"), ("np.pi/2", "pi/2"), ("−1", "-1"),
        ("–1", "-1"), ("2*-3", "-6"), ("--1", "1"), ("+1", "1"), ("2^3", "8"), ("2**3", "8"), ("2²", "4"),
        ("b²³", "b^23"), ("b⁻¹", "1/b"), ("b^{-2}", "1/b^2"), ("-2^2", "-4"), ("(-2)^2", "4"), ("2^3^2", "512"),
        # names
        ("θ1", "theta1"), ("theta1", "theta1"), ("theta_1", "theta1"), ("\\theta_1", "theta1"),
        ("\\theta_{1}", "theta1"), ("\\vartheta_1", "theta1"), ("ϑ1", "theta1"), ("θ₁", "theta1"), ("q1", "theta1"),
        ("Theta1", "theta1"), ("Theta_{1}", "theta1"), ("Alpha_{i-1}", "alpha_{i-1}"), ("cosTheta1", "c1"),
        ("q_1", "theta1"), ("a_1", "a1"), ("a_{1}", "a1"), ("a₁", "a1"), ("a_{12}", "a12"), ("\\mathrm{a}_1", "a1"),
        ("d_f", "d_f"), ("d_{f}", "d_f"), ("α", "alpha"), ("\\alpha_{i-1}", "alpha_{i-1}"), ("α_{i-1}", "alpha_{i-1}"),
        # cosines and sines
        ("cos(theta1)", "c1"), ("cos θ1", "c1"), ("cosθ1", "c1"), ("\\cos\\theta_1", "c1"), ("Cos(q1)", "c1"),
        ("np.cos(theta1)", "c1"), ("a1a2sin θ2", "a1*a2*s2"), ("a1sin 30°", "a1/2"), ("a1sqrt 3", "sqrt(3)*a1"),
        ("a1.c1", "a1*c1"), ("-a1.s12.c3", "-a1*s12*c3"), ("(a1+a2).c1", "c1*(a1 + a2)"),
        ("minus 2", "-2"), ("a1 minus a2", "a1 - a2"),
        ("\\cos\\left(\\theta_1\\right)", "c1"), ("cos(theta1+theta2)", "c12"),
        ("cos(theta2 + theta1)", "c12"), ("sin^2 θ1", "s1^2"), ("sin²(θ1)", "s1^2"), ("\\sin^2\\theta_1", "s1^2"),
        ("cos 2θ1", "c(2*theta1)"), ("cos(-θ1)", "c1"), ("sin(-θ1)", "-s1"), ("sin α", "sin(alpha)"),
        ("cos(θ1 - 90°)", "s1"), ("cos(θ1 + π)", "-c1"), ("sin(θ1+θ2-π/2)", "-c12"), ("cos(60°)", "1/2"),
        ("sin 45°", "sqrt(2)/2"), ("cos(360°)", "1"), ("sin(-720°)", "0"),
        ("cos(θ1 + 360°)", "c1"), ("sin(θ1 - 2π)", "s1"), ("cos(θ1 + 450°)", "-s1"), ("cos(390°)", "sqrt(3)/2"),
        ("cos(θ1 + 390°)", "c(theta1+30°)"), ("cos(30 deg)", "sqrt(3)/2"), ("cosd(60)", "1/2"), ("sind(θ1)", "s1"),
        ("cos(0.3)", "cos(0.3)"), ("tan 45°", "1"), ("tan(θ1)", "s1/c1"), ("sqrt(b^2)", "sqrt(b^2)"),
        ("atan2(a1, a2)", "atan2(a1, a2)"), ("arctan2(a1, a2)", "atan2(a1, a2)"), ("arccos(b)", "acos(b)"),
        # a function without brackets or blanks, as on paper
        ("14cos30°-6sin30°", "7*sqrt(3) - 3"), ("2cos45°", "sqrt(2)"), ("cos22.5°", "cos(22.5°)"), ("sin30 deg", "1/2"),
        ("cos30^\\circ", "sqrt(3)/2"), ("\\cos 60^{\\circ}", "1/2"), ("a1cos60°", "a1/2"), ("sqrt3", "sqrt(3)"),
        ("2sqrt3/3", "2*sqrt(3)/3"), ("\\sqrt3", "sqrt(3)"), ("\\frac12", "1/2"), ("\\frac12 a1", "a1/2"),
        ("a1cosθ_1 + a2cos(θ_1+θ_2)", "a1*c1 + a2*c12"), ("a1bsin^2(θ1)", "a1*b*s1^2"),
        # shorthand
        ("c1", "c1"), ("s1", "s1"), ("C1", "c1"), ("S2", "s2"), ("c12", "c12"), ("s23", "s23"), ("c123", "c123"),
        ("c_1", "c1"), ("c_{12}", "c12"), ("c_12", "c12"), ("cθ1", "c1"), ("cθ_1", "c1"), ("c\\theta_1", "c1"),
        ("sα", "sin(alpha)"), ("cα_{i-1}", "cos(alpha_{i-1})"), ("s\\alpha_{i-1}", "sin(alpha_{i-1})"),
        ("c(θ1+θ2)", "c12"), ("s(θ1)", "s1"), ("c*(a1+a2)", "c*(a1 + a2)"), ("c(a1+a2)", "c*(a1 + a2)"), ("c", "c"),
        ("cθ12", "c12"), ("cosθ12", "c12"), ("cos θ12", "c12"), ("cos(θ_{12})", "c12"), ("s\\theta_{23}", "s23"),
        ("sin(q12)", "s12"), ("cos(θ12 - 90°)", "s12"),
        # products and brackets
        ("a1cosθ1", "a1*c1"), ("a1cosθ12", "a1*c12"), ("a1 b cosθ1sinθ2", "a1*b*c1*s2"), ("2a1sinθ23", "2*a1*s23"),
        ("c1 s12", "c1*s12"), ("a1c1", "a1*c1"), ("2a1", "2*a1"), ("a₁c₁", "a1*c1"), ("a1c1s23", "a1*c1*s23"),
        ("a1(b+c)", "a1*(b + c)"), ("[a1 + b]{c1}", "c1*(a1 + b)"), ("(a1)(b)", "a1*b"), ("a1 × b", "a1*b"),
        ("a1 · b", "a1*b"), ("a1\\cdot b", "a1*b"), ("a1\\,b", "a1*b"), ("a1 ÷ b", "a1/b"), ("a1/b*c", "a1*c/b"),
        ("a1/2 b", "a1*b/2"), ("1/2a1", "a1/2"), ("-(a1 - b)", "-a1 + b"), ("a1 - (b - c)", "a1 - b + c"),
        ("c1*(-a1 - b)", "-c1*(a1 + b)"), ("a1 - a1", "0"), ("a1 + 2a1", "3*a1"), ("c1 c1", "c1^2"),
        ("\\frac{a1 c1}{2}", "a1*c1/2"), ("\\left[a1\\right]", "a1"),
    ],
)  # fmt: skip
def test_a_spelling_is_read_as_it_is_meant(text: str, read: str) -> None:
    """One grammar for files, options and answers."""
    assert write(parse(text, ROBOT)) == read


@row_by_row(
    ("text", "read"),
    [
        ("c12", "c12"), ("cα_i", "cos(alpha_i)"), ("a1c1", "a1*c1"), ("c5", "c5"), ("l_1 c_1", "l1*c1"),
        ("x y", "x*y"), ("θ1θ2", "theta1*theta2"), ("c(φ)", "cos(phi)"), ("shoulder", "shoulder"),
        ("c12 + c", "c12 + c"),
        ("c_ij", "c_ij"), ("q1", "q1"), ("θ12", "theta12"), ("cθ12", "cos(theta12)"),
        ("a1cosθ_1", "a1*c1"), ("a2cos(2φ)", "a2*cos(2*phi)"),
    ],
)  # fmt: skip
def test_without_a_robot_names_stand_for_themselves(text: str, read: str) -> None:
    """And `c12` for cos(theta1 + theta2)."""
    assert write(parse(text)) == read


@row_by_row(
    ("text", "angle"),
    [
        ("-90°", "-90°"), ("90 deg", "90°"), ("90º", "90°"), ("90^\\circ", "90°"), ("90^{\\circ}", "90°"),
        ("pi/2", "90°"), ("-π/6", "-30°"), ("2*pi/3", "120°"), ("0.5 rad", "0.5 rad"), ("0", "0"), ("0°", "0"),
        ("theta3 - 180°", "theta3 - 180°"), ("90° + θ1", "theta1 + 90°"), ("theta1/2", "theta1/2"),
        ("2*theta1 - theta2 + 0.25 rad", "2*theta1 - theta2 + 0.25 rad"), ("π rad", "180°"), ("22.5°", "22.5°"),
        ("30 degrees", "30°"), ("-(θ1 + 90°)", "-theta1 - 90°"), ("1/3 deg", "(1/3)°"),
        ("2°28′38″", "(4459/1800)°"), ("-2° 28' 38\"", "(-4459/1800)°"), ("30°15'", "30.25°"), ("-0°30'", "-0.5°"),
        ("2 deg 28 min", "(37/15)°"), ("2 degrees 28 minutes 38 seconds", "(4459/1800)°"), ("-2° 30 min", "-2.5°"),
        ("2deg 28min 38s", "(4459/1800)°"), ("2 deg 30'", "2.5°"), ("2º30 arcmin", "2.5°"),
        ("30 DEG", "30°"), ("0.5Rad", "0.5 rad"), ("-30 Degrees", "-30°"),
    ],
)  # fmt: skip
def test_an_angle_is_read_exactly(text: str, angle: str) -> None:
    """Degrees stay degrees, multiples of π become degrees, radians are written."""
    assert write_angle(to_angle(parse(text), bare="refuse")) == angle


@row_by_row(
    ("text", "metres"),
    [
        ("432 mm", "0.432"), ("432mm", "0.432"), ("43.18cm", "0.4318"), ("0.4 m", "0.4"), ("0.4m", "0.4"),
        ("1 in", "0.0254"),
        ("2 inch", "0.0508"), ("0.4", "0.4"), ("1/3 m", "1/3"), ("0,4 m", "0.4"), ("3 mm + 2 cm", "0.023"),
        ("-5 mm", "-0.005"),
        ("a + 3 mm", "a + 0.003"), ("2*(a + 3 mm)", "2*(a + 0.003)"),
    ],
)  # fmt: skip
def test_a_length_is_read_in_metres(text: str, metres: str) -> None:
    """Whatever the unit, exactly."""
    assert write(to_length(parse(text))) == metres


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("90", "the angle 90 has no unit"),
        ("-1.57", "the angle -1.57 has no unit"),
        ("30 mm", "mm is a unit of length, an angle is wanted"),
        ("theta1*theta2", "an angle is a sum of joint angles and constants"),
        ("theta1*90°", "an angle is a sum of joint angles and constants"),
        ("1/theta1", "an angle is a sum of joint angles and constants"),
    ],
)
def test_what_is_no_angle_is_refused(text: str, message: str) -> None:
    """A bare number is the first slip of all."""
    with pytest.raises(DimensionError, match=message):
        to_angle(parse(text), bare="refuse")


@pytest.mark.parametrize("text", ["30°", "0.4 rad", "a + 30°"])
def test_an_angle_is_no_length(text: str) -> None:
    """Wherever the unit stands."""
    with pytest.raises(DimensionError, match="is a unit of angle, a length is wanted"):
        to_length(parse(text))


@pytest.mark.parametrize(
    ("text", "places", "shown"), [("0.50", 2, "0.5"), ("1e-3", 3, "0.001"), ("2.5e1", None, "25"), ("12", None, "12")]
)
def test_a_decimal_stays_a_decimal(text: str, places: int | None, shown: str) -> None:
    """It is not turned into a fraction where it is shown, and its digits are known to the judge."""
    found: Expr = parse(text)
    assert isinstance(found, Number)
    assert (found.places, write(found)) == (places, shown)


def test_a_power_of_ten_is_asked_about_where_a_length_is_called_so() -> None:
    """2e1 is twenty, or twice e1; 2e2 is two hundred there."""
    names = Scope(lengths=("e1",))
    with pytest.raises(NotationError, match="2e1 could be a power of ten or a multiple of the length e1"):
        parse("2e1", names)
    assert write(parse("2e2", names)) == "200"


def test_a_capital_that_is_a_name_stands_beside_the_small_letter() -> None:
    """It is another length then; where it is none, nobody knows whether it is."""
    two = Scope(lengths=("a1", "A1"), aliases=usual_aliases(("a1", "A1")))
    assert parse("a1 + A1", two) == add(Symbol("a1"), Symbol("A1"))
    one = Scope(lengths=("a1",), aliases=usual_aliases(("a1",)))
    assert parse("A1 + A1", one) == parse("2*a1", one)
    with pytest.raises(NotationError, match="A1 stands beside a1"):
        parse("a1 + A1", one)


def test_an_angle_called_like_a_length_is_known_by_its_list() -> None:
    """`c(…)` around an angle is its cosine, around a length it is the length times it."""
    names = Scope(joints=("phi",), lengths=("c", "x"))
    assert write(parse("c(phi) + c(x) + c x", names), "full") == "cos(phi) + 2*c*x"


@row_by_row(
    ("text", "message"),
    [
        ("c12", "c12 could be cos(theta12) or cos(theta1+theta2)"),
        ("s1", "s1 could be s1 or sin(theta1)"),
        ("5m", "m could be the unit or the name m"),
        ("2e3", "2e3 could be a power of ten or a multiple of the length e"),
        ("a/b s2", "what is divided by a product without a sign can be read in two ways"),
        ("abd", "abd could be a * b * d or a * bd"),
        ("sin^-1(0.5)", "sin to a negative power can be read in two ways"),
        ("cos30", "cos30 does not say what 30 is"),
        ("a cos1", "cos1 does not say what 1 is"),
        ("b/a cos30°", "what is divided by a product without a sign can be read in two ways"),
        ("b/acos30°", "what is divided by a product without a sign can be read in two ways"),
    ],
)
def test_what_can_be_read_in_two_ways_is_a_question(text: str, message: str) -> None:
    """Never a guess; both readings are named, and how to write one of them."""
    names = Scope(joints=("theta1", "theta2", "theta12"), lengths=("s1", "m", "e", "a", "b", "d", "ab", "bd"))
    with pytest.raises(NotationError) as caught:
        parse(text, names)
    assert caught.value.problems[0].message == message
    assert caught.value.problems[0].hint
