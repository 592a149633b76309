"""The kinds of number: what each holds exactly, and what stays structural."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra import floats
from dhcli.algebra.arithmetic import Arithmetic, CannotHoldError, plus, right_angle, times
from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats, cosine_of_degrees
from dhcli.algebra.residues import STEPS, Field, Residues, field_of_the_day, is_prime
from dhcli.algebra.symbolic import Sympy, to_sympy
from dhcli.algebra.tape import Tape
from dhcli.algebra.terms import TERMS
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import read_chain
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.tree import Expr, number
from dhcli.notation.trig import cosine, sine
from tests.nightly import examples
from tests.row_by_row import row_by_row
from tests.strategies import exact_angles

FIELDS = [field_of_the_day(), Field(720 * 3 * 7 + 1) if is_prime(720 * 3 * 7 + 1) else Field(2161)]


@pytest.mark.parametrize("field", FIELDS)
def test_the_field_holds_i_and_the_roots_of_2_3_and_5(field: Field) -> None:
    """Consistent with its cosines."""
    prime = field.prime
    assert prime % STEPS == 1
    assert field.i**2 % prime == prime - 1
    for value in (2, 3, 5, 6, 10, 15, 30, 12, 45):
        assert field.square_root(Fraction(value)) ** 2 % prime == value
    half = field.square_root(Fraction(1, 2))
    assert half * half * 2 % prime == 1
    assert field.square_root(Fraction(-4)) ** 2 % prime == prime - 4
    root6 = field.square_root(Fraction(2)) * field.square_root(Fraction(3)) % prime
    assert root6 == field.square_root(Fraction(6))


def test_the_field_of_the_day_holds_the_roots_of_all_primes_to_31() -> None:
    """A root of their product is the product of theirs; in a smaller field some are missing, and said so."""
    field = field_of_the_day()
    for value in (7, 11, 13, 17, 19, 23, 29, 31, 77, 2 * 3 * 5 * 7, 11 * 11 * 13, Fraction(7, 11)):
        assert (field.square_root(Fraction(value)) ** 2 - residue(field, Fraction(value))) % field.prime == 0
    both = field.square_root(Fraction(7)) * field.square_root(Fraction(11)) % field.prime
    assert both == field.square_root(Fraction(77))
    assert not equal(parse("10^9 √11"), parse("10^9 √11 + 1"))  # nine digits of a float are the same
    with pytest.raises(CannotHoldError):
        Field(2161).square_root(Fraction(11))


def residue(field: Field, value: Fraction) -> int:
    """A fraction in a field."""
    return value.numerator * field.inverse(value.denominator) % field.prime


@pytest.mark.parametrize("field", FIELDS)
def test_the_unit_of_the_field_has_720_steps_and_no_fewer(field: Field) -> None:
    """Half a degree each."""
    units = [field.root_of_unity(steps) for steps in range(STEPS)]
    assert len(set(units)) == STEPS
    assert field.root_of_unity(STEPS) == 1
    assert field.root_of_unity(-1) * field.root_of_unity(1) % field.prime == 1


@row_by_row(
    ("steps", "twice"),
    [(0, "2"), (120, "1"), (90, "√2"), (60, "√3"), (180, "0"), (240, "-1"), (72, "(1+√5)/2"), (360, "-2")],
)
def test_cosines_of_the_field_are_the_exact_ones(steps: int, twice: str) -> None:
    """Cos 60° is 1/2, cos 45° is √2/2, and so on, in half degrees."""
    at = Residues()
    assert at.field.two_cosines(steps) == at.value(parse(twice))


def test_the_prime_is_large_random_and_prime() -> None:
    """An accident has probability below 2^-119 for the degrees that occur."""
    prime = field_of_the_day().prime
    assert prime.bit_length() >= 126
    assert is_prime(prime)
    assert field_of_the_day() is field_of_the_day()
    field_of_the_day.cache_clear()
    assert field_of_the_day().prime != prime


def test_primes_are_told_from_other_numbers() -> None:
    """Carmichael numbers too, which fool a simpler test."""
    small = [n for n in range(3, 400, 2) if is_prime(n)]
    assert small == [n for n in range(3, 400, 2) if all(n % k for k in range(2, n))]
    assert not any(map(is_prime, (561, 1105, 294409, 825265, 2**127 + 1, (2**61 - 1) * (2**31 - 1))))
    assert is_prime(2**127 - 1)


@pytest.mark.parametrize("text", ["cos(1/3 deg)", "√37", "√(a+b)", "acos(a)", "a^(1/3)", "atan2(a, b)"])
def test_residues_refuse_what_the_field_does_not_hold(text: str) -> None:
    """So that the judge knows to use floats."""
    expr = parse(text)
    with pytest.raises(CannotHoldError):
        Residues((expr,)).value(expr)


@examples(0.6)
@given(exact_angles)
def test_the_cosine_of_an_angle_is_the_cosine_of_its_tree(angle: Angle) -> None:
    """What the tree makes of right angles, roots and signs changes no value, in residues and floats."""
    at = Residues(angles=(angle,), scale=2)
    cos, sin = at.cos_sin(angle)
    assert (at.value(cosine(angle)), at.value(sine(angle))) == (cos % at.field.prime, sin % at.field.prime)
    over = Floats({name: 0.1 + i for i, name in enumerate(sorted(angle.names))})
    cosine_, sine_ = over.cos_sin(angle)
    assert (over.value(cosine(angle)), over.value(sine(angle))) == pytest.approx((cosine_, sine_), abs=1e-12)


@row_by_row("quarters", range(-5, 9))
def test_right_angles_are_structural_in_every_arithmetic(quarters: int) -> None:
    """The integers 0, 1 and -1 before any float, array or symbol exists."""
    angle = Angle.in_degrees(90 * quarters)
    wanted = (round(math.cos(math.pi / 2 * quarters)), round(math.sin(math.pi / 2 * quarters)))
    arithmetics: tuple[Arithmetic[object], ...] = (Floats(), Tape([]), TERMS, Residues())
    for over in arithmetics:
        found = over.cos_sin(angle)
        assert found == wanted
        assert all(type(value) is int for value in found)
    assert right_angle(angle) == wanted
    assert right_angle(Angle.in_degrees(91)) is None
    assert right_angle(Angle.of("theta1")) is None
    assert [int(value) for value in Sympy().cos_sin(angle)] == list(wanted)


@row_by_row(
    ("degrees", "cosine_"),
    [
        (0, 1.0),
        (60, 0.5),
        (90, 0.0),
        (120, -0.5),
        (180, -1.0),
        (240, -0.5),
        (270, 0.0),
        (300, 0.5),
        (360, 1.0),
        (-60, 0.5),
    ],
)
def test_floats_of_round_angles_are_exact(degrees: int, cosine_: float) -> None:
    """Cos 60° is 0.5, not 0.5000000000000001; sin 30° too."""
    assert cosine_of_degrees(Fraction(degrees)) == cosine_
    assert float(Floats().cos_sin(Angle.in_degrees(degrees))[0]) == cosine_
    assert float(Floats().cos_sin(Angle.in_degrees(90 - degrees))[1]) == cosine_


@given(st.fractions(-1000, 1000, max_denominator=720))
def test_floats_of_degrees_are_those_of_the_math_library(degrees: Fraction) -> None:
    """To the last digits, and cos² + sin² = 1."""
    radians = math.radians(float(degrees % 360))
    assert cosine_of_degrees(degrees) == pytest.approx(math.cos(radians), abs=1e-15)
    assert cosine_of_degrees(degrees - 90) == pytest.approx(math.sin(radians), abs=1e-15)


def test_a_quarter_turn_in_values_is_exact_too() -> None:
    """theta1 = 90° put in as an exact angle leaves no 6e-17."""
    rows = fold(read_chain("Rot(z, theta1) Trans(0.5, 0, 0)"), Floats({"theta1": Angle.in_degrees(90)}))
    assert rows[0] == (0.0, -1.0, 0.0, 0.0)
    assert rows[1] == (1.0, 0.0, 0.0, 0.5)


def test_floats_keep_the_cosines_of_so_many_angles_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is that of the angle, however many came before it."""
    monkeypatch.setattr(floats, "MOST_TURNED", 3)
    over, angles = Floats(), [Angle.in_degrees(7 * k) for k in range(1, 8)]
    for angle in (*angles, *angles, *reversed(angles)):
        assert over.cos_sin(angle) == Floats().cos_sin(angle)
        assert len(over._turned) <= 3


@pytest.mark.parametrize("text", ["√(-1)", "a^(1/3)", "acos(2)", "a^-1 + √(a - 5)", "cos(1e60^5 a)"])
def test_floats_without_a_value_are_nan_and_never_an_error(text: str) -> None:
    """Of numbers that are not real, or too large."""
    value = Floats({"a": 0.0 if "a^-1" in text else 1e300 if "cos(" in text else -8.0}).value(parse(text))
    assert math.isnan(value)


@pytest.mark.parametrize("zero", [0, 1, -1])
def test_structural_integers_cost_nothing(zero: int) -> None:
    """A product with 0, 1 or -1 is not computed; other numbers are multiplied as they are."""
    big = parse("a1*c1 + a2*c12")
    assert times(zero, big) == times(big, zero) == {0: 0, 1: big, -1: -big}[zero]
    assert plus(0, big) is big
    assert plus(big, 0) is big


@row_by_row(
    ("text", "sympy_text"),
    [
        ("c1*(a1 + a2)", "(a1 + a2)*cos(theta1)"),
        ("cos(α_{i-1})/2", "cos(alpha_im1)/2"),
        ("√3/2 + π", "sqrt(3)/2 + pi"),
        ("tan(a b)", "tan(a*b)"),
        ("atan2(a, b)", "atan2(a, b)"),
        ("cos(θ1 + 30°)", "cos(theta1 + pi/6)"),
        ("a^(1/3)", "a**(1/3)"),
        ("1", "1"),
        ("0", "0"),
    ],
)
def test_the_bridge_to_sympy_keeps_the_meaning(text: str, sympy_text: str) -> None:
    """Names become real symbols that programs accept."""
    import sympy

    expr: Expr = parse(text)
    found = to_sympy(expr)
    assert str(found) == sympy_text
    assert all(symbol.is_real for symbol in found.free_symbols)
    assert isinstance(found, sympy.Basic)
    assert to_sympy(number(1) * expr) == found


def test_a_part_of_an_angle_too_small_for_an_exact_sum_is_added_in_floats() -> None:
    """A variable in two rows may stand at 1e-296: its sum with another has no exact form that is worth its length."""
    tiny = Angle((), radians=Fraction("1.1457236281781556e-296"))
    floats = Floats({"j2": Angle((), degrees=Fraction(30)), "j3": tiny})
    cos, sin = floats.cos_sin(Angle((("j2", Fraction(1)), ("j3", Fraction(-1)))))
    assert math.isclose(cos, math.sqrt(3) / 2)
    assert math.isclose(sin, 0.5)
