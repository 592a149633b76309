"""What the writer writes, the parser reads back as the same tree."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import assume, given
from hypothesis import strategies as st

from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.styles import Joints
from dhcli.notation.tree import HALF, Call, Expr, Number, Product, Sum, add, multiply, negate, power
from dhcli.notation.walk import walk
from dhcli.notation.writer import write, write_angle
from tests.nightly import examples
from tests.row_by_row import row_by_row
from tests.strategies import LENGTHS, THETAS, exact_angles, numeric_angles, polynomials

ROBOT = Scope(joints=THETAS, lengths=LENGTHS)
JOINTS = Joints.of(THETAS, THETAS)


def root(expr: Expr) -> Expr:
    """A square root, of numbers only where it is real."""
    return expr if isinstance(expr, Number) and expr.value < 0 else power(expr, HALF)


trees = st.one_of(
    polynomials,
    st.builds(lambda one, other: multiply(one, root(other)), polynomials, polynomials),
    st.builds(lambda one, other: add(one, root(other)), polynomials, polynomials),
    st.builds(lambda one, other: Call("atan2", (one, other)), polynomials, polynomials),
    st.builds(lambda one: Call("acos", (one,)), polynomials),
)


@examples(2)
@given(trees, st.sampled_from(["short", "full", "latex", "matlab", "numpy"]))
def test_an_expression_is_read_back(expr: Expr, style: str) -> None:
    """In every notation that the parser reads, without a robot and with its names and shorthand."""
    assume(len(write(expr, "numpy")) < 1900)
    assert parse(write(expr, style), OPEN) == expr
    assert parse(write(expr, style, JOINTS), ROBOT) == expr


@given(st.one_of(exact_angles, numeric_angles))
def test_an_angle_is_read_back(angle: Angle) -> None:
    """With its units; a bare number is never written."""
    assert to_angle(parse(write_angle(angle)), bare="refuse") == angle
    assert to_angle(parse(write_angle(angle, "full", JOINTS), ROBOT), bare="refuse") == angle
    assert to_angle(parse(write_angle(angle, "numpy"))) == angle


@examples(0.5)
@given(trees)
def test_trees_have_one_shape(expr: Expr) -> None:
    """Flat, numbers in front, no bracket that is multiplied starts with a minus, no number hidden below."""
    for node in walk(expr):
        if isinstance(node, Sum):
            assert len(node.terms) > 1
            assert not any(isinstance(term, Sum) for term in node.terms)
        if isinstance(node, Product):
            assert len(node.factors) > 1
            assert not any(isinstance(factor, Product) for factor in node.factors)
            assert not any(isinstance(factor, Number) for factor in node.factors[1:])
            assert node.factors[0] != Number(Fraction(1))
            brackets = [factor for factor in node.factors if isinstance(factor, Sum)]
            assert not any(write(bracket).startswith("-") for bracket in brackets)


@examples(0.5)
@given(trees)
def test_twice_negated_is_the_same(expr: Expr) -> None:
    """A minus costs nothing and hides nothing."""
    assert negate(negate(expr)) == expr
    assert add(expr, negate(expr)) == Number(Fraction(0))


@row_by_row(
    ("text", "style", "written"),
    [
        ("c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1", "short", "c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1"),
        ("c1*s23", "full", "cos(theta1)*sin(theta2+theta3)"),
        ("c1*s23", "latex", r"c_{1} s_{23}"),
        ("c1*s23", "matlab", "cos(theta1)*sin(theta2+theta3)"),
        ("c1*s23", "numpy", "np.cos(theta1)*np.sin(theta2+theta3)"),
        ("c1*s23", "sympy", "cos(theta1)*sin(theta2+theta3)"),
        ("a1^2/(2b)", "latex", r"\frac{a_{1}^{2}}{2 b}"),
        ("-(a1 + a2)/(d1 + d2)", "latex", r"-\frac{a_{1} + a_{2}}{d_{1} + d_{2}}"),
        ("(a1 + a2)*(d1 + d2)/3", "latex", r"\frac{\left(a_{1} + a_{2}\right) \left(d_{1} + d_{2}\right)}{3}"),
        ("a1^2/(2b)", "numpy", "a1**2/(2*b)"),
        ("a1^2/(2b)", "matlab", "a1^2/(2*b)"),
        ("√3/2", "latex", r"\frac{\sqrt{3}}{2}"),
        ("√3/2", "numpy", "np.sqrt(3)/2"),
        ("cos(θ1+30°)", "short", "c(theta1+30°)"),
        ("cos(θ1+30°)", "latex", r"\cos\left(\theta_{1}+30^{\circ}\right)"),
        ("cos(θ1+30°)", "numpy", "np.cos(theta1+np.pi/6)"),
        ("cos(θ1+0.3)", "short", "c(theta1+0.3)"),
        ("cos(α_{i-1})", "latex", r"\cos\left(\alpha_{i-1}\right)"),
        ("cos(α_{i-1})", "numpy", "np.cos(alpha_im1)"),
        ("cos(α_{i-1})", "short", "cos(alpha_{i-1})"),
        ("shoulder*c1", "latex", r"\mathrm{shoulder} c_{1}"),
        ("lambda", "numpy", "lambda_"),
        ("-(a + b)*c1", "short", "-c1*(a + b)"),
        ("0.50*a", "short", "0.5*a"),
        ("1e-17*a", "short", "0.00000000000000001*a"),
        ("1/3*a", "short", "a/3"),
        ("-a/3", "latex", r"-\frac{a}{3}"),
        ("pi*a", "latex", r"\pi a"),
        ("atan2(a, -b)", "numpy", "np.atan2(a, -b)"),
        ("(a + b)^-2", "short", "1/(a + b)^2"),
    ],
)
def test_a_notation_has_its_own_spelling(text: str, style: str, written: str) -> None:
    """Short by default; no 1.0, no 6e-17, no minus in front of a bracket that is multiplied."""
    assert write(parse(text), style) == written


def test_shorthand_is_the_robots_own() -> None:
    """Only angles with an index of their own have one, and factors stand in joint order."""
    joints = Joints.of(("shoulder", "theta2", "d3", "theta4"), ("shoulder", "theta2", "theta4"))
    names = Scope(joints=("shoulder", "theta2", "theta4"), lengths=("a", "d3"))
    text = "a*cos(theta4)*cos(shoulder)*cos(theta2 + theta4)"
    assert write(parse(text, names), "short", joints) == "a*cos(shoulder)*c24*c4"
    twins = Joints.of(("theta1", "phi1"), ("theta1", "phi1"))
    assert twins.index == {}
    assert (
        Joints.of(tuple(f"q{i}" for i in range(1, 11)), tuple(f"q{i}" for i in range(1, 11))).index.get("q10") is None
    )
