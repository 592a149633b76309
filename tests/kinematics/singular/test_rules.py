"""The rules behind singularities: blocks, forms, arithmetic modulo a prime, points where something vanishes."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import load_robot
from dhcli.algebra.equality import equal
from dhcli.algebra.residues import field_of_the_day, random_below
from dhcli.kinematics.frames import between
from dhcli.kinematics.singular.arm import Arm, Point
from dhcli.kinematics.singular.blocks import blocks_of
from dhcli.kinematics.singular.forms import determinant, factors_of, shortest
from dhcli.kinematics.singular.modular import determinant as modular
from dhcli.kinematics.singular.modular import null_space, rank, square_root
from dhcli.kinematics.singular.polynomial import TooLongError, contracted, expanded, grouped, product
from dhcli.kinematics.singular.square import size_of
from dhcli.kinematics.singular.vanishing import fresh, right_angles, vanishing
from dhcli.notation.parser import parse
from dhcli.notation.tree import ZERO, Expr, add, multiply, negate
from dhcli.notation.walk import operations
from tests.nightly import examples

FIELD = field_of_the_day()

entries = st.sampled_from(["0", "0", "1", "a", "b", "c1", "s1", "s2", "a*c1", "b*s2", "-a", "a*c1 + b"]).map(parse)
matrices = st.integers(1, 3).flatmap(
    lambda n: st.lists(st.lists(entries, min_size=n, max_size=n), min_size=n, max_size=n)
)


def by_permutations(rows: list[list[Expr]]) -> Expr:
    """A determinant by its definition."""
    terms = []
    for order in permutations(range(len(rows))):
        swaps = sum(order[i] > order[j] for i in range(len(order)) for j in range(i + 1, len(order)))
        term = multiply(*(row[k] for row, k in zip(rows, order, strict=True)))
        terms.append(negate(term) if swaps % 2 else term)
    return add(*terms)


@examples(2)
@given(matrices)
def test_a_determinant_by_laplace_is_that_by_permutations(rows: list[list[Expr]]) -> None:
    """Common factors out or not."""
    assert equal(determinant(rows), by_permutations(rows))


@given(st.integers(2, 5).flatmap(lambda n: st.lists(st.integers(0, 2**n - 1), min_size=n, max_size=n)))
def test_blocks_hold_the_determinant(pattern: list[int]) -> None:
    """Random entries where the pattern has any: the product of the blocks up to sign; zero where there is no choice."""
    size = len(pattern)
    rows = [[random_below(FIELD.prime) if bits >> c & 1 else 0 for c in range(size)] for bits in pattern]
    whole, blocks = modular(rows, FIELD), blocks_of(pattern, size)
    if blocks is None:
        assert whole == 0
        return
    assert sorted(c for _, columns in blocks for c in columns) == list(range(size))
    assert sorted(r for some, _ in blocks for r in some) == list(range(size))
    found = 1
    for some, columns in blocks:
        found = found * modular([[rows[r][c] for c in columns] for r in some], FIELD) % FIELD.prime
    assert found in (whole, -whole % FIELD.prime)


def test_a_triangle_falls_into_single_entries() -> None:
    """In whatever order its rows stand."""
    blocks = blocks_of([0b100, 0b111, 0b110], 3)
    assert blocks is not None
    assert sorted(len(columns) for _, columns in blocks) == [1, 1, 1]


@given(st.lists(st.lists(st.integers(-3, 3), min_size=4, max_size=4), min_size=2, max_size=4))
def test_the_null_space_is_what_a_matrix_sends_to_zero(rows: list[list[int]]) -> None:
    """As many vectors as the rank lacks, and the determinant of a square is zero exactly if there is one."""
    basis = null_space(rows, FIELD)
    assert len(basis) == 4 - rank(rows, FIELD)
    for vector in basis:
        assert all(sum(a * x for a, x in zip(row, vector, strict=True)) % FIELD.prime == 0 for row in rows)
    if len(rows) == 4:
        assert (modular(rows, FIELD) == 0) == bool(basis)


def test_square_roots_are_roots_or_none() -> None:
    """Half of the residues have one."""
    values = [random_below(FIELD.prime) for _ in range(30)]
    roots = [square_root(value, FIELD) for value in values]
    assert all(root is None or root * root % FIELD.prime == value for root, value in zip(roots, values, strict=True))
    assert None in roots
    assert any(root is not None for root in roots)
    assert square_root(0, FIELD) == 0


@pytest.mark.parametrize(
    ("text", "best"),
    [
        ("c3*c23 + s3*s23", "c2"),
        ("s1*c2 - c1*s2", "sin(theta1-theta2)"),
        ("a*c1*s12 - a*s1*c12", "a*s2"),
        ("a*c1^2 + a*s1^2", "a"),
        ("a*(b + c) - a*b", "a*c"),
        ("a*c1*(b*c2 + d) + a*s1*c1*e", "a*c1*(b*c2 + d + e*s1)"),
    ],
)
def test_the_shortest_form_is_taken(text: str, best: str) -> None:
    """Contracted, multiplied out or nested, whichever has the fewest operations."""
    found = product(*shortest(parse(text)))
    assert equal(found, parse(best))
    assert operations(found) <= operations(parse(best))


@examples(2)
@given(
    st.lists(
        st.sampled_from(["a", "-b", "c1*c2", "s1*s2", "2*s1*c2", "-c1*s2", "a*(b + c1)", "c1^2", "s1^2"]),
        min_size=1,
        max_size=4,
    )
)
def test_every_form_is_equal(texts: list[str]) -> None:
    """None of them changes the value."""
    whole = add(*map(parse, texts))
    terms = expanded(whole)
    for form in (product(*factors_of(whole)), product(*shortest(whole)), grouped(terms), grouped(contracted(terms))):
        assert equal(form, whole)


def test_what_is_too_long_is_not_multiplied_out() -> None:
    """It is told before the work is done."""
    long = multiply(*(add(*(parse(f"x{k}*y{n}") for n in range(8))) for k in range(4)))
    with pytest.raises(TooLongError):
        expanded(long)


def test_the_size_of_a_determinant_is_known_before() -> None:
    """Of every product all symbols, nothing where a row is empty."""
    rows = [[parse("a"), parse("b")], [parse("c1"), parse("d")]]
    assert size_of(rows) == 4
    assert size_of([[ZERO, ZERO], [parse("a"), parse("b")]]) == 0


def puma() -> Arm:
    """PUMA 560 from 0 to 6."""
    robot = load_robot("puma560")
    return Arm(robot, "0", "6", robot.variables, between(robot, "0", "6"))


@pytest.mark.parametrize(
    "texts",
    [("s5",), ("c23",), ("a3*s3 + d4*c3",), ("a2*c2 + a3*c23 - d4*s23",), ("s5", "a3*s3 + d4*c3"), ("s2", "c23")],
)
def test_points_are_found_where_factors_vanish(texts: tuple[str, ...]) -> None:
    """All of them at once, with everything else at random."""
    robot = load_robot("puma560")
    zeros = [parse(text, robot.scope) for text in texts]
    points = list(vanishing(puma(), zeros))
    assert points
    for over in points:
        assert [over.value(zero) for zero in zeros] == [0] * len(zeros)
        assert over.value(parse("theta_free")) != over.value(parse("another"))


def test_joints_at_right_angles_are_exact() -> None:
    """Cosines 0, 1 and -1."""
    over = right_angles(puma(), {"theta2": 1, "theta3": 2})
    robot = load_robot("puma560")
    cosines = [over.value(parse(text, robot.scope)) for text in ("c2", "s2", "c3", "s3")]
    assert cosines == [0, 1, over.field.prime - 1, 0]


def test_an_arm_at_a_point_is_the_arm() -> None:
    """Velocities move with the point, axes have unit length, parallel ones are told."""
    arm = puma()
    at = Point.of(arm, fresh(arm))
    prime = at.field.prime
    assert at.velocity(0, at.origins[-1]) == at.linear[0]
    assert all(sum(a * a for a in axis) % prime == 1 for axis in at.angular)
    assert (at.parallel(1, 2), at.parallel(0, 1)) == (1, 0)
    assert arm.frame_at(0) == "0"
    assert arm.frame_at(len(arm.chain)) == "6"
    assert Fraction(1) in {
        abs(dict(move.angle.terms).get("theta1", Fraction(1))) for move in arm.chain if hasattr(move, "angle")
    }
