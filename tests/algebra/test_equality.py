"""Whether two expressions are equal for all values of their names: identities, near misses, and what needs floats."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.equality import equal, equal_in_floats
from dhcli.algebra.floats import Floats
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Symbol, add, multiply, number
from tests.nightly import examples
from tests.row_by_row import row_by_row
from tests.strategies import LENGTHS, THETAS, polynomials

IDENTITIES = [
    ("sin²(θ1) + cos²(θ1)", "1"),
    ("cos(2θ1)", "2c1² - 1"),
    ("sin(2θ1)", "2 s1 c1"),
    ("cos(3θ1)", "4c1^3 - 3c1"),
    ("c12", "c1 c2 - s1 s2"),
    ("s123", "s1 c2 c3 + c1 s2 c3 + c1 c2 s3 - s1 s2 s3"),
    ("c1 c2", "(c12 + cos(θ1-θ2))/2"),
    ("2 cos(θ1/2)^2", "1 + c1"),
    ("sin(θ1)", "2 sin(θ1/2) cos(θ1/2)"),
    ("cos(θ1/3)", "4 cos(θ1/9)^3 - 3 cos(θ1/9)"),
    ("tan(θ1)", "s1/c1"),
    ("1 + tan(θ1)^2", "1/c1^2"),
    ("√2 √3", "√6"),
    ("√8", "2√2"),
    ("1/√3", "√3/3"),
    ("(√5 + 1)(√5 - 1)", "4"),
    ("√(3/4)", "√3/2"),
    ("cos(15°)", "(√6 + √2)/4"),
    ("cos(36°)", "(1 + √5)/4"),
    ("sin(18°)", "(√5 - 1)/4"),
    ("cos(60°)", "1/2"),
    ("sin(7.5°)^2", "(1 - cos(15°))/2"),
    ("cos(20°) cos(40°) cos(80°)", "1/8"),
    ("cos(θ1 + 60°)", "c1/2 - √3/2 s1"),
    ("cos(θ1 - π/2)", "s1"),
    ("sin(θ1 + π)", "-s1"),
    ("cos(-θ1)", "c1"),
    ("(a + b)(a - b)", "a² - b²"),
    ("a/(a + b) + b/(a + b)", "1"),
    ("(a² - b²)/(a - b)", "a + b"),
    ("√(-1)^2", "-1"),
    ("2π/π", "2"),
]
"""Each side is another way to say the other."""


@row_by_row(("one", "other"), IDENTITIES)
def test_an_identity_holds(one: str, other: str) -> None:
    """Whatever the form."""
    assert equal(parse(one), parse(other))


@row_by_row(("one", "other"), IDENTITIES)
def test_an_identity_that_is_off_by_little_does_not(one: str, other: str) -> None:
    """By one part in 10^20, by one per cent, by a sign: certainly unequal."""
    right = parse(other)
    for wrong in (right + number(1) * parse("1e-20"), right * parse("1.01"), -right, right * Symbol("z")):
        assert not equal(parse(one), wrong)


@row_by_row(
    ("one", "other"),
    [
        ("c12", "c1 c2 + s1 s2"),
        ("sin²(θ1) - cos²(θ1)", "1"),
        ("cos(2θ1)", "2c1"),
        ("cos(θ1/2)", "c1/2"),
        ("c1", "c2"),
        ("a1", "a2"),
        ("√2 + √3", "√5"),
        ("√3", "1.7320508"),
        ("√3/2", "0.8660254037844386"),
        ("π", "3.14159265358979"),
        ("cos(1°)", "1"),
        ("cos(60.5°)", "1/2"),
        ("cos(1)", "cos(1°)"),
        ("a/b", "b/a"),
        ("θ1", "c1"),
        ("0", "1e-30"),
        ("s1 c2", "c1 s2"),
    ],
)
def test_unequal_is_unequal(one: str, other: str) -> None:
    """Near misses of students, of rounding and of names."""
    assert not equal(parse(one), parse(other))


@row_by_row(
    ("one", "other", "verdict"),
    [
        ("√(a² + b²)", "√(b² + a²)", True),
        ("√(a² + b²)^2", "a² + b²", True),
        ("√(a²+2a b+b²)", "a + b", True),
        ("√(a² + b²)", "a + b", False),
        ("atan2(a, b)", "atan2(2a, 2b)", True),
        ("atan2(a, b)", "atan2(b, a)", False),
        ("cos(atan2(a, b))", "b/√(a²+b²)", True),
        ("cos(0.3)", "cos(0.3)", True),
        ("cos(0.3 + θ1)", "cos(0.3) c1 - sin(0.3) s1", True),
        ("cos(0.3)", "cos(0.30001)", False),
        ("cos(1/3 deg)", "sin(90° - 1/3 deg)", True),
        ("√7 √11", "√77", True),
        ("√7 + √11", "√18", False),
        ("2^(1/3)^3", "2", False),
        ("(2^(1/3))^3", "2", True),
        ("acos(2)", "acos(3)", False),
        ("asin(sin(a))", "a", False),
    ],
)
def test_what_residues_cannot_hold_is_judged_in_floats(one: str, other: str, verdict: bool) -> None:
    """Roots of sums, other primes under a root, bare radians, arc functions."""
    assert equal(parse(one), parse(other)) is verdict
    assert equal(parse(other), parse(one)) is verdict


@examples(0.6)
@given(polynomials, polynomials, polynomials)
def test_the_laws_of_a_ring_hold(a: Expr, b: Expr, c: Expr) -> None:
    """Distributed, commuted, regrouped: equal, though not the same tree."""
    assert equal(multiply(a, add(b, c)), add(multiply(a, b), multiply(a, c)))
    assert equal(add(a, b), add(b, a))
    assert equal(multiply(multiply(a, b), c), multiply(a, multiply(c, b)))


@examples(0.6)
@given(polynomials, st.fixed_dictionaries(dict.fromkeys((*THETAS, *LENGTHS), st.floats(0.3, 1.2))))
def test_equal_expressions_have_equal_floats(expr: Expr, at: dict[str, float]) -> None:
    """Expanding a product of the whole with a bracket changes no value."""
    expanded = add(multiply(expr, Symbol("a1")), multiply(expr, number(2)))
    together = multiply(expr, add(Symbol("a1"), number(2)))
    assert equal(expanded, together)
    assert Floats(at).value(expanded) == pytest.approx(Floats(at).value(together), rel=1e-6, abs=1e-6, nan_ok=True)


def test_points_where_both_are_undefined_say_nothing() -> None:
    """And if they say nothing anywhere, the two are not called equal."""
    assert not equal_in_floats(parse("acos(2 + a)"), parse("acos(3 + a)"))
    assert equal_in_floats(parse("acos(a - 0.3)"), parse("acos(a - 0.3)"))


def test_two_names_of_one_spelling_are_one_name() -> None:
    r"""θ1 and \theta_1 are the same unit of the field."""
    names = Scope(joints=("theta1",), aliases={"q1": "theta1"})
    assert equal(parse("cos(q1)", names), parse("cos(\\theta_1)", names))
