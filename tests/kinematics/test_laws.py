"""Laws of chains, over random mixtures of moves: group of rigid motions, one fold for every kind of number, merging."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.columns import Columns
from dhcli.algebra.floats import Floats
from dhcli.algebra.residues import Residues
from dhcli.algebra.symbolic import Sympy, to_sympy
from dhcli.algebra.terms import TERMS
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, expressions, inverse, names, read_chain, substituted
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.recorded import recorded_chain
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Symbol, number
from dhcli.notation.walk import substitute
from tests.nightly import examples
from tests.row_by_row import row_by_row
from tests.strategies import (
    LENGTHS,
    THETAS,
    any_chains,
    axes,
    chains,
    lengths,
    named_angles,
    numeric_moves,
    parallel_moves,
    quarter_turns,
    quarters,
    rows,
    small_fractions,
)

values = st.fixed_dictionaries(
    {
        **dict.fromkeys(THETAS, st.floats(-7, 7)),
        **dict.fromkeys(LENGTHS, st.floats(-2, 2)),
    }
)


def point_for(*some: Chain) -> Residues:
    """A random point of the field that holds all angles of some chains."""
    moves = [move for chain in some for move in chain]
    angles = [move.angle for move in moves if isinstance(move, Rot)]
    return Residues(expressions(moves), angles, scale=2)


def residues(chain: Chain, at: Residues) -> list[list[int]]:
    """A chain multiplied out modulo the prime."""
    return [[at.value(entry) for entry in row] for row in fold(chain, at)]


def multiplied(one: Sequence[Sequence[int]], other: Sequence[Sequence[int]], prime: int) -> list[list[int]]:
    """The product of two matrices modulo a prime."""
    columns = list(zip(*other, strict=True))
    return [[sum(a * b for a, b in zip(row, column, strict=True)) % prime for column in columns] for row in one]


def oracle(chain: Chain, at: dict[str, float]) -> np.ndarray[Any, Any]:
    """The product of 4x4 arrays, each by Rodrigues' formula or as it stands; nothing exact, nothing skipped."""
    over, pose = Floats(at), np.eye(4)
    for move in chain:
        matrix = np.eye(4)
        match move:
            case Rot(axis, angle):
                turn = np.radians(float(angle.degrees)) + float(angle.radians)
                turn += sum(float(factor) * at[name] for name, factor in angle.terms)
                x, y, z = (float(axis == letter) for letter in "xyz")
                skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
                matrix[:3, :3] += np.sin(turn) * skew + (1 - np.cos(turn)) * skew @ skew
            case Trans():
                matrix[:3, 3] = [over.value(entry) for entry in move.offset]
            case Fixed(entries):
                matrix[:3] = [[over.value(entry) for entry in row] for row in entries]
        pose = pose @ matrix
    return pose


def test_the_24_quarter_turns_are_24() -> None:
    """The literal matrices that the laws are tried with."""
    assert len(set(quarter_turns())) == 24
    assert all(round(np.linalg.det(np.array(turn))) == 1 for turn in quarter_turns())


@examples(2)
@given(any_chains)
def test_merging_does_not_change_the_pose(chain: Chain) -> None:
    """fold(merge(c)) = fold(c), exactly; the law that lets the textbook's form be trusted."""
    merged = merge(chain)
    at = point_for(chain, merged)
    assert residues(merged, at) == residues(chain, at)


PARALLEL = [
    "Rot(z, theta1) Trans(a1, 0, 0) Rot(z, theta2)",
    "Rot(z, theta1) Rot(x, 180°) Rot(z, theta2)",
    "Rot(z, theta1) Trans(a1, 0, d3) Rot(x, -180°) Trans(0, a2, 0) Rot(z, theta2) Trans(a1, 0, 0)",
    "Rot(z, theta1) Rot(x, 90°) Rot(y, theta2)",
    "Rot(z, theta1) Rot(x, -90°) Rot(y, theta2)",
    "Rot(z, theta1) Rot(y, 90°) Rot(z, 90°) Rot(y, theta2)",
    "Rot(x, theta1) Rot(y, 180°) Rot(z, 90°) Rot(y, theta2) Rot(z, 270°) Rot(x, theta3)",
    "Rot(z, theta1) [0 -1 0 a1; 0 0 -1 a2; 1 0 0 d3; 0 0 0 1] Rot(x, theta2)",
    "Rot(z, theta1) [0 0 1 a1; 0 -1 0 a2; 1 0 0 d3; 0 0 0 1] Rot(x, theta2)",
    "[0 0 1 a1; 0 -1 0 a2; 1 0 0 d3; 0 0 0 1] Rot(x, theta2) Trans(a1, a2, d3) Rot(x, -theta2)",
    "Rot(y, theta1) Rot(y, 30°) Trans(a1, 0, 0) Rot(y, theta2 - 30°)",
    "Rot(z, 90°) Trans(a1, 0, 0) Rot(z, theta1) Rot(z, 45°)",
    "Rot(z, theta1) Rot(z, -theta1)",
    "Rot(z, theta1) Rot(x, 360°) Rot(z, theta2)",
    "Rot(z, theta1) Rot(x, 60°) Rot(x, -60°) Rot(z, theta2)",
]
"""Bundles of parallel axes, with everything that can stand between two of them."""


@row_by_row("text", PARALLEL)
def test_merging_a_bundle_does_not_change_the_pose(text: str) -> None:
    """Twists of 180°, letters that change, literal matrices, constants before and after."""
    chain = read_chain(text)
    merged = merge(chain)
    at = point_for(chain, merged)
    assert residues(merged, at) == residues(chain, at)


@row_by_row("text", PARALLEL)
def test_a_bundle_turns_once(text: str) -> None:
    """After merging, at most one rotation in a bundle still holds a joint angle."""
    merged = merge(read_chain(text))
    assert sum(bool(move.angle.names) for move in merged if isinstance(move, Rot)) <= 1


@examples(0.5)
@given(st.lists(st.tuples(axes, named_angles, quarters, lengths), min_size=2, max_size=4))
def test_joints_about_one_axis_all_become_one(joints: list[tuple[str, Angle, Angle, Expr]]) -> None:
    """Whatever lies between them along the way, when all turn about z and only x is twisted by half turns."""
    chain: list[Any] = []
    for _, angle, quarter, length in joints:
        chain += [Rot("z", angle), Trans(length, ZERO, length), Rot("x", quarter + quarter)]
    assert sum(bool(move.angle.names) for move in merge(tuple(chain)) if isinstance(move, Rot)) <= 1


@examples(0.5)
@given(any_chains)
def test_every_chain_is_a_rigid_motion_exactly(chain: Chain) -> None:
    """R^T R = 1 and det R = 1 in residues, and the last row is 0 0 0 1."""
    at = point_for(chain)
    pose, prime = residues(chain, at), at.field.prime
    rotation = [row[:3] for row in pose[:3]]
    transposed = [list(column) for column in zip(*rotation, strict=True)]
    assert multiplied(transposed, rotation, prime) == [[int(i == j) for j in range(3)] for i in range(3)]
    (a, b, c), (d, e, f), (g, h, i) = rotation
    assert (a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) % prime == 1
    assert pose[3] == [0, 0, 0, 1]


@examples(0.5)
@given(chains(8, numeric_moves))
def test_every_chain_is_a_rigid_motion_in_floats(chain: Chain) -> None:
    """To 1e-12."""
    rotation = np.array(fold(chain, Floats()))[:3, :3]
    assert rotation.T @ rotation == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(rotation) == pytest.approx(1, abs=1e-12)


@examples(0.5)
@given(any_chains, any_chains)
def test_a_chain_of_two_chains_is_the_product_of_their_poses(one: Chain, other: Chain) -> None:
    """chain(a + b) = chain(a) @ chain(b)."""
    at = point_for(one, other)
    product = multiplied(residues(one, at), residues(other, at), at.field.prime)
    assert residues((*one, *other), at) == product


@examples(0.5)
@given(any_chains)
def test_a_chain_times_its_inverse_is_nothing(chain: Chain) -> None:
    """On both sides, exactly."""
    at = point_for(chain)
    unit = [[int(i == j) for j in range(4)] for i in range(4)]
    assert residues((*chain, *inverse(chain)), at) == unit
    assert residues((*inverse(chain), *chain), at) == unit


@examples(0.5)
@given(any_chains)
def test_the_inverse_of_a_pose_is_the_pose_of_the_inverse(chain: Chain) -> None:
    """Transposing is the same as going back move by move."""
    at = point_for(chain)
    back = Pose(fold(chain, TERMS)).inverse()
    assert [[at.value(entry) for entry in row] for row in back.rows] == residues(inverse(chain), at)


@examples(0.5)
@given(any_chains)
def test_terms_are_residues(chain: Chain) -> None:
    """The symbolic result, merged and not, evaluated at the point, is the fold at the point."""
    at = point_for(chain)
    wanted = residues(chain, at)
    for terms in (fold(chain, TERMS), fold(merge(chain), TERMS)):
        assert [[at.value(entry) for entry in row] for row in terms] == wanted


@examples(0.5)
@given(any_chains, values)
def test_terms_with_numbers_put_in_are_floats_and_both_are_the_oracle(chain: Chain, at: dict[str, float]) -> None:
    """Three ways to the same pose; the oracle knows nothing of the other two."""
    over = Floats(at)
    wanted = pytest.approx(oracle(chain, at), abs=1e-9)
    assert np.array(fold(chain, over), dtype=float) == wanted
    terms = [[over.value(entry) for entry in row] for row in fold(merge(chain), TERMS)]
    assert np.array(terms) == wanted


@examples(0.5)
@given(chains(8, numeric_moves))
def test_a_pose_in_numbers_is_the_oracle(chain: Chain) -> None:
    """With radians too, which only floats and columns hold."""
    assert np.array(fold(chain, Floats()), dtype=float) == pytest.approx(oracle(chain, {}), abs=1e-12)


@examples(0.5)
@given(any_chains, st.lists(values, max_size=4))
def test_columns_are_floats_one_by_one(chain: Chain, listed: list[dict[str, float]]) -> None:
    """A batch of none, one or several poses at once, of the chain as it stands and merged."""
    variables = (*THETAS, *LENGTHS)
    values = np.array([[at[name] for at in listed] for name in variables])
    wanted = np.array([np.array(fold(chain, Floats(at))).ravel() for at in listed]).T.reshape(16, -1)
    recording = recorded_chain(chain, variables, {})
    for merged in (False, True):
        for tangents in (False, True):
            columns = Columns(recording.program(merged=merged, tangents=tangents), len(listed))
            assert columns.play(values) == pytest.approx(wanted, abs=1e-12)
        kernel, found = recording.kernel(merged=merged), np.empty((len(listed), 16))
        assert kernel is not None
        assert kernel.play(np.ascontiguousarray(values.T), found, width=2)
        assert np.array(found.T) == pytest.approx(wanted, abs=1e-12)
    ones = [recording.one(row) for row in values.T.tolist()]
    assert np.array(ones).reshape(-1, 16) == pytest.approx(wanted.T, abs=1e-12)


@examples(0.15)
@given(chains(3, parallel_moves), values)
def test_sympy_agrees(chain: Chain, at: dict[str, float]) -> None:
    """Folded over sympy, and as terms carried over the bridge; N() at the values is the oracle."""
    import sympy

    put = {sympy.Symbol(name, real=True): value for name, value in at.items()}
    folded = [entry for row in fold(chain, Sympy()) for entry in row]
    bridged = [to_sympy(entry) for row in fold(merge(chain), TERMS) for entry in row]
    wanted = pytest.approx(oracle(chain, at).flatten().tolist(), abs=1e-9)
    assert [float(sympy.N(entry.subs(put))) for entry in folded] == wanted
    assert [float(sympy.N(entry.subs(put))) for entry in bridged] == wanted


@examples(0.5)
@given(any_chains, st.sampled_from(THETAS), quarters, st.sampled_from(LENGTHS), small_fractions)
def test_values_may_be_put_in_before_or_after_multiplying(
    chain: Chain, theta: str, angle: Angle, length: str, value: Fraction
) -> None:
    """`--q theta4=0 --set a3=0` puts exactly those in."""
    lengths_, angles = {length: number(value)}, {theta: angle}
    before = substituted(chain, lengths_, angles)
    assert not names(before) & {theta, length}
    after = [[substitute(entry, lengths_, angles) for entry in row] for row in fold(chain, TERMS)]
    at = point_for(chain)
    assert [[at.value(entry) for entry in row] for row in after] == residues(before, at)


def modified_rows(table: list[Row]) -> list[Row]:
    """A standard table with a and alpha moved to the row below, and a last row that holds what is left."""
    nothing = Row(ZERO, Angle(), ZERO, Angle())
    return [
        Row(before.a, before.alpha, row.d, row.theta)
        for before, row in zip([nothing, *table], [*table, nothing], strict=True)
    ]


def chain_of(table: Iterable[Row], convention: Convention) -> Chain:
    """The moves of a table."""
    return tuple(move for row in table for move in moves_of(row, convention))


@examples(0.5)
@given(st.lists(rows, max_size=5))
def test_a_standard_table_is_the_modified_one_with_a_and_alpha_one_row_lower(table: list[Row]) -> None:
    """The two conventions cut the same chain in other places."""
    standard = chain_of(table, Convention.STANDARD)
    modified = chain_of(modified_rows(table), Convention.MODIFIED)
    at = point_for(standard, modified)
    assert residues(standard, at) == residues(modified, at)


@examples(0.5)
@given(st.lists(rows, max_size=5))
def test_both_conventions_write_the_same_terms(table: list[Row]) -> None:
    """Merged, the two tables give not only equal entries but the same trees."""
    standard = fold(merge(chain_of(table, Convention.STANDARD)), TERMS)
    assert standard == fold(merge(chain_of(modified_rows(table), Convention.MODIFIED)), TERMS)


@examples(0.5)
@given(any_chains, lengths, lengths, lengths)
def test_a_point_is_where_a_translation_to_it_ends(chain: Chain, x: Expr, y: Expr, z: Expr) -> None:
    """Pose @ point is the position reached by the chain and the point's own coordinates."""
    at = point_for(chain, (Trans(x, y, z),))
    seen = Pose(fold(chain, TERMS)) @ (x, y, z)
    assert [at.value(entry) for entry in seen] == [row[3] for row in residues((*chain, Trans(x, y, z)), at)[:3]]


def test_merging_keeps_names_together_as_a_reader_expects() -> None:
    """A length behind the last rotation of a bundle stays in its bracket."""
    rows_ = fold(merge(read_chain("Rot(z, theta1) Trans(a1, 0, 0) Rot(x, 90°) Rot(z, theta2) Trans(a2, 0, 0)")), TERMS)
    assert str(rows_[0][3]) == "c1*(a1 + a2*c2)"
    assert rows_[2][3] == Symbol("a2") * fold(read_chain("Rot(x, theta2)"), TERMS)[2][1]
