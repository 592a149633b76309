"""The fold with columns: over random chains it is the derivative of the pose, merged or not, in every arithmetic."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.arithmetic import evaluate_settled
from dhcli.algebra.floats import Floats
from dhcli.algebra.residues import Residues
from dhcli.algebra.terms import TERMS
from dhcli.kinematics.fold import fold
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, Rot, expressions, names, read_chain
from dhcli.kinematics.velocity.steps import fold_columns, steps_of
from dhcli.notation.derivative import derivative
from dhcli.notation.parser import parse
from dhcli.notation.tree import Call, Symbol
from tests.strategies import LENGTHS, THETAS, any_chains

PLANES = ((1, 2), (2, 0), (0, 1))


def point_for(chain: Chain) -> Residues:
    """A random point of the field that holds all angles of a chain."""
    return Residues(expressions(chain), [move.angle for move in chain if isinstance(move, Rot)], scale=2)


def moving(chain: Chain) -> dict[str, int]:
    """The names that stand in rotations or, by themselves, in offsets, each with a column."""
    return {name: k for k, name in enumerate(sorted(names(chain) & {*THETAS, *LENGTHS}))}


@given(any_chains)
def test_columns_are_the_derivative_of_the_pose(chain: Chain) -> None:
    """Linear of the position, angular of the rotation: the skew part of R' Rᵀ; decided in residues."""
    columns, at = moving(chain), point_for(chain)
    found = fold_columns(steps_of(merge(chain), columns), len(columns), at)
    pose = fold(chain, TERMS)
    for name, column in columns.items():
        rates = [[at.value(derivative(entry, name)) for entry in row] for row in pose[:3]]
        rotation = [[at.value(entry) for entry in row[:3]] for row in pose[:3]]
        assert [at.value(part) for part in found.linear[column]] == [row[3] for row in rates]
        for k, (first, second) in enumerate(PLANES):
            turning = sum(rates[second][c] * rotation[first][c] for c in range(3)) % at.field.prime
            assert at.value(found.angular[column][k]) == turning


@given(any_chains)
def test_merged_and_plain_chains_have_the_same_columns(chain: Chain) -> None:
    """In residues, for every joint."""
    columns, at = moving(chain), point_for(chain)
    one, other = (fold_columns(steps_of(each, columns), len(columns), at) for each in (chain, merge(chain)))
    for some, others in ((one.linear, other.linear), (one.angular, other.angular)):
        assert [[at.value(part) for part in v] for v in some] == [[at.value(part) for part in v] for v in others]


@given(any_chains)
def test_columns_in_terms_are_columns_in_residues(chain: Chain) -> None:
    """One fold, two kinds of number."""
    columns, at = moving(chain), point_for(chain)
    steps = steps_of(merge(chain), columns)
    terms, plain = fold_columns(steps, len(columns), TERMS), fold_columns(steps, len(columns), at)
    for some, others in ((terms.linear, plain.linear), (terms.angular, plain.angular)):
        assert [[at.value(part) for part in v] for v in some] == [[at.value(part) for part in v] for v in others]


@given(
    st.sampled_from(
        [
            "a*c1 + b*s12",
            "(a + b*c1)^3*s1",
            "d*c(2*theta1 - 30°)",
            "a/d + d^2",
            "sqrt(a)*s1",
            "c1^2 + s1^2",
            "7",
            "pi*a",
        ]
    ),
    st.sampled_from(["a", "b", "d", "theta1", "theta2"]),
    st.floats(0.3, 2.0),
)
def test_a_derivative_is_the_slope(text: str, name: str, at: float) -> None:
    """By central differences, for lengths and for angles."""
    expr = parse(text)
    around = {"a": 0.7, "b": 1.1, "d": 1.3, "theta1": 0.4, "theta2": 0.9, name: at}
    step = 1e-6
    up, down = (Floats({**around, name: at + sign * step}).value(expr) for sign in (1, -1))
    slope = evaluate_settled(derivative(expr, name), Floats(around))
    assert slope == pytest.approx((up - down) / (2 * step), abs=1e-7)


def test_a_derivative_expands_no_bracket() -> None:
    """And a cosine of a sum stays one."""
    assert str(derivative(parse("c1*(a2*c2 + a3*c23)"), "theta2")) == "-c1*(a2*s2 + a3*s23)"
    assert str(derivative(parse("c1*(a2*c2 + a3*c23)"), "theta1")) == "-s1*(a2*c2 + a3*c23)"


def test_no_derivative_is_taken_inside_an_arc_tangent() -> None:
    """Where no joint may stand; of another name it is zero."""
    inside = Call("atan2", (Symbol("a"), Symbol("b")))
    with pytest.raises(TypeError):
        derivative(inside, "a")
    assert str(derivative(inside, "c")) == "0"


def test_a_factor_of_the_joint_is_a_factor_of_its_column() -> None:
    """A gear of 2, turned the other way: Rot(z, -2*theta1)."""
    chain = read_chain("Rot(z, -2*theta1) Trans(a, 0, 0)")
    found = fold_columns(steps_of(chain, {"theta1": 0}), 1, TERMS)
    assert [str(part) for part in found.linear[0]][:2] == ["-2*a*s(2*theta1)", "-2*a*c(2*theta1)"]
    assert str(found.angular[0][2]) == "-2"


def test_a_slide_in_a_literal_matrix_has_a_column() -> None:
    """Its offset, turned by what stands before it."""
    chain = read_chain("Rot(z, theta1) [1 0 0 2*d; 0 1 0 0; 0 0 1 d; 0 0 0 1] Trans(a, 0, 0)")
    found = fold_columns(steps_of(chain, {"theta1": 0, "d": 1}), 2, TERMS)
    assert [str(part) for part in found.linear[1]] == ["2*c1", "2*s1", "1"]
    assert found.angular[1] == [0, 0, 0]
    at = Floats({"theta1": 0.3, "d": 0.2, "a": 0.5})
    turned = fold_columns(steps_of(chain, {"theta1": 0, "d": 1}), 2, at)
    assert turned.linear[0][1] == pytest.approx(Floats({"theta1": 0.3}).value(parse("c1")) * 0.9)


def test_fractions_of_a_joint_are_kept_exactly() -> None:
    """Half a turn of a coupled joint."""
    chain = read_chain("Rot(x, theta1/2)")
    (step,) = steps_of(chain, {"theta1": 0})
    assert step.turning == ((0, Fraction(1, 2)),)
