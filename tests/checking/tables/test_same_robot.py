"""Whether two tables are the same robot: what keeps the motion is accepted, what changes it never."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.tables.motions import Outcome, TwoArms
from dhcli.checking.tables.right import RightArm
from dhcli.checking.tables.samples import Values
from dhcli.checking.tolerance import DEFAULT
from dhcli.checking.verdicts import Verdict
from dhcli.errors import RobotError
from dhcli.geometry.rigid import Rigid
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.fits import Limits
from dhcli.kinematics.moves import Chain, Rot, Trans, read_chain, substituted
from dhcli.kinematics.same_robot import Registration
from dhcli.notation.angle import Angle
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO, Symbol, add, multiply, number
from tests.checking.tables.robots_with_tables import (
    NAMES,
    Move,
    Rows,
    arm,
    fk,
    holds,
    invariants,
    keeping,
    mutations,
    recounted,
    robot,
    rows_of,
)
from tests.nightly import NIGHT, examples, some

NOTHING = Values({}, {})
names = st.sampled_from(NAMES)


def same_motion(truth: Arm, other: Arm, values: Values = NOTHING) -> Outcome:
    """What comes of two arms of which the same motion is asked."""
    return TwoArms(RightArm(truth, values), other, DEFAULT).same_motion


def same_robot(truth: Arm, other: Arm, values: Values = NOTHING, *, end_free: bool = False) -> Outcome:
    """What comes of two arms that may be drawn with other frames."""
    return TwoArms(RightArm(truth, values), other, DEFAULT).same_robot(end_free=end_free)


def floats(point: object) -> dict[str, float]:
    """A point of names and floats, as it comes out of a comparison without given angles."""
    assert isinstance(point, dict)
    return point


# --- what keeps T ----------------------------------------------------------------------------------------------------


@given(names, st.lists(keeping(), max_size=8), st.randoms(use_true_random=False))
def test_moves_that_keep_the_motion_keep_it_for_numpy_and_for_dhcli(name: str, moves: list[Move], draw: object) -> None:
    """Flipped x and z, split d and theta: the same T(q), said by numpy first."""
    convention, variables, rows = robot(name).convention, robot(name).variables, rows_of(name)
    other = rows
    for move in moves:
        other = move(other, convention)
    point = {n: 0.3 + 0.1 * k for k, n in enumerate((*robot(name).parameters, "delta", *variables))}
    assert np.allclose(fk(rows, convention, point), fk(other, convention, point), atol=1e-9)
    outcome = same_motion(arm(rows, convention, variables), arm(other, convention, variables))
    assert outcome.verdict is Verdict.RIGHT


joint_changes = st.lists(
    st.tuples(
        st.floats(0, 0.999),
        st.sampled_from((1, -1)),
        st.sampled_from((0, 90, -90, 180, 37)),
        st.sampled_from((ZERO, Symbol("delta"))),
    ),
    max_size=4,
)


@given(names, st.lists(keeping(), max_size=6), joint_changes, st.sampled_from((ZERO, Symbol("b0"))))
def test_other_frames_senses_zeros_and_base_are_the_same_robot(
    name: str, moves: list[Move], joints: list, base: object
) -> None:
    """Frames, senses, zeros and base at random; what is claimed to lead over is checked in numpy."""
    convention, variables, rows = robot(name).convention, robot(name).variables, rows_of(name)
    other = rows
    for share, sense, degrees, metres in joints:
        other = recounted(other, variables, int(share * len(variables)), sense, degrees, metres)
    for move in moves:
        other = move(other, convention)
    first = other[0]
    if convention is Convention.STANDARD:
        other = (Row(first.a, first.alpha, add(first.d, base), first.theta), *other[1:])
    else:
        other = (Row(add(first.a, base), first.alpha + Angle.in_degrees(30), first.d, first.theta), *other[1:])
    truth, answer = arm(rows, convention, variables), arm(other, convention, variables)
    outcome = same_robot(truth, answer)
    assert outcome.verdict is Verdict.RIGHT
    assert outcome.match is not None
    assert holds(outcome.match, rows, other, convention, variables, floats(outcome.point))


# --- any robot at all ------------------------------------------------------------------------------------------------

LENGTHS = (ZERO, ZERO, Symbol("k1"), Symbol("k2"), Symbol("k3"))
twists = st.sampled_from((0, 0, 0, 90, -90, 90, 180, 30, -120)).map(Angle.in_degrees)
constants = st.sampled_from((0, 0, 0, 90, -90, 180, 45)).map(Angle.in_degrees)


@st.composite
def tables(draw: st.DrawFn) -> tuple[Rows, tuple[str, ...]]:
    """Tables of robots that nobody builds: parallel, coincident, intersecting axes, slides anywhere, fixed rows."""
    rows, variables = [], []
    for index in range(draw(st.integers(1, 6))):
        a, d = draw(st.sampled_from(LENGTHS)), draw(st.sampled_from(LENGTHS))
        alpha, theta = draw(twists), draw(constants)
        kind = draw(st.sampled_from("RRRPPF"))
        if kind == "R":
            theta += Angle.of(f"theta{index}")
            variables.append(f"theta{index}")
        if kind == "P":
            d = add(d, Symbol(f"q{index}"))
            variables.append(f"q{index}")
        rows.append(Row(a, alpha, d, theta))
    return tuple(rows), tuple(variables)


rigid_moves = st.lists(
    st.one_of(
        st.builds(Rot, st.sampled_from("xyz"), st.sampled_from((90, 180, 37, -60)).map(Angle.in_degrees)),
        st.tuples(*[st.fractions(-2, 2, max_denominator=4).map(number)] * 3).map(lambda p: Trans(*p)),
    ),
    max_size=4,
).map(tuple)
senses = st.lists(st.sampled_from((1, -1)), min_size=6, max_size=6)
zeros = st.lists(st.sampled_from((0, 0, 90, 180, 25)), min_size=6, max_size=6)
conventions = st.sampled_from((Convention.STANDARD, Convention.MODIFIED))


def moved(chain: Chain, variables: tuple[str, ...], senses: list[int], zeros: list[int]) -> Chain:
    """T(σq + q0) as a chain."""
    lengths = {
        n: add(multiply(number(s), Symbol(n)), number(Fraction(z, 100)))
        for n, s, z in zip(variables, senses, zeros, strict=False)
    }
    angles = {n: Angle.of(n) * s + Angle.in_degrees(z) for n, s, z in zip(variables, senses, zeros, strict=False)}
    return substituted(chain, lengths, angles)


@examples(0.6 if NIGHT else 0.3)
@given(tables(), conventions, senses, zeros, rigid_moves, rigid_moves)
def test_any_base_sense_zero_and_tool_is_found(
    table: tuple[Rows, tuple[str, ...]],
    convention: Convention,
    signs: list[int],
    shifts: list[int],
    base: Chain,
    tool: Chain,
) -> None:
    """The definition itself, B · T(σq + q0) · E, on robots of any geometry."""
    rows, variables = table
    truth = arm(rows, convention, variables)
    without = Arm.of((*base, *moved(truth.chain, variables, signs, shifts)), variables)
    assert same_robot(truth, without).verdict is Verdict.RIGHT
    whole = Arm.of((*without.chain, *tool), variables)
    outcome = same_robot(truth, whole, end_free=True)
    assert outcome.verdict is Verdict.RIGHT
    assert outcome.match is not None


@given(tables(), conventions, st.lists(keeping((Symbol("k2"), Symbol("delta"))), max_size=6))
def test_other_frames_of_any_robot_keep_its_motion(
    table: tuple[Rows, tuple[str, ...]], convention: Convention, moves: list[Move]
) -> None:
    """The same moves on robots of any geometry; no joint is lost on the way."""
    rows, variables = table
    other = rows
    for move in moves:
        other = move(other, convention)
    truth, answer = arm(rows, convention, variables), arm(other, convention, variables)
    assert same_motion(truth, answer).verdict is Verdict.RIGHT
    size = 10.0
    point = dict.fromkeys(("k1", "k2", "k3", "delta"), 0.0) | {"k1": 0.37, "k2": 0.81, "k3": 1.13, "delta": 0.29}
    search = Registration(truth, answer, point, Limits.exact(size))
    assert next(search.matches(), None) is not None
    assert search.deepest == len(variables)


# --- what changes it -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_a_slip_that_is_accepted_has_kept_the_motion(name: str) -> None:
    """Each slip in each table: accepted only with a proof, and never if two axes have moved."""
    convention, variables, rows = robot(name).convention, robot(name).variables, rows_of(name)
    truth = arm(rows, convention, variables)
    for slip, other in some([*mutations(rows, variables)], 25):
        outcome = same_robot(truth, arm(other, convention, variables))
        point = {**floats(outcome.point), "b9": 0.777}
        if outcome.verdict is Verdict.RIGHT:
            assert outcome.match is not None
            point = floats(outcome.point)
            assert holds(outcome.match, rows, other, convention, variables, point), slip
            assert outcome.match.tool.tilt() < 1e-6, slip
        differ = not np.allclose(
            invariants(rows, convention, variables, point), invariants(other, convention, variables, point), atol=1e-5
        )
        if differ:
            assert outcome.verdict is Verdict.WRONG, slip


@examples(0.4)
@given(names, st.lists(keeping(), max_size=5), st.data())
def test_a_slip_stays_found_among_other_frames(name: str, moves: list[Move], data: st.DataObject) -> None:
    """The verdict and the first wrong joint do not depend on how the frames are drawn."""
    convention, variables, rows = robot(name).convention, robot(name).variables, rows_of(name)
    slip, wrong = data.draw(st.sampled_from(mutations(rows, variables)))
    hidden = wrong
    for move in moves:
        hidden = move(hidden, convention)
    truth = arm(rows, convention, variables)
    plain = same_robot(truth, arm(wrong, convention, variables))
    other = same_robot(truth, arm(hidden, convention, variables))
    assert other.verdict is plain.verdict, slip
    assert other.joints == plain.joints, slip
    again = same_robot(arm(wrong, convention, variables), arm(hidden, convention, variables))
    assert again.verdict is Verdict.RIGHT, slip


@pytest.mark.parametrize(
    ("name", "row", "changed", "joints"),
    [
        ("puma560", 3, "alpha", 3),  # the twist between joints 3 and 4
        ("puma560", 2, "a", 2),
        ("puma560", 3, "d", 4),  # seen only where axes 4 and 5 meet
        ("ur5e", 1, "a", 2),
        ("stanford", 1, "alpha", 2),
        ("scara-yim", 1, "a", 3),  # the slide only has a direction; the tool axis is elsewhere
    ],
)
def test_the_first_wrong_joint_is_told_by_the_motion(name: str, row: int, changed: str, joints: int) -> None:
    """How many joints agree is known from the axes."""
    convention, variables, rows = robot(name).convention, robot(name).variables, rows_of(name)
    old = rows[row]
    cells = {"a": old.a, "alpha": old.alpha, "d": old.d, "theta": old.theta}
    cells[changed] = cells[changed] + Angle.in_degrees(20) if changed == "alpha" else add(cells[changed], Symbol("b9"))
    other = (*rows[:row], Row(**cells), *rows[row + 1 :])
    outcome = same_robot(arm(rows, convention, variables), arm(other, convention, variables))
    assert outcome.verdict is Verdict.WRONG
    assert outcome.joints == joints


def test_a_wrong_letter_is_wrong_even_where_its_value_is_the_same() -> None:
    """In the PUMA a2 and d4 have one value; the letters are still two."""
    puma = robot("puma560")
    rows = rows_of("puma560")
    own = Values({}, {name: value for name, value in puma.parameters.items() if value is not None})
    other = (*rows[:3], Row(rows[3].a, rows[3].alpha, Symbol("a2"), rows[3].theta), *rows[4:])
    truth = arm(rows, puma.convention, puma.variables)
    assert puma.parameters["a2"] == puma.parameters["d4"]
    assert same_robot(truth, arm(other, puma.convention, puma.variables), own).verdict is Verdict.WRONG
    mixed = (*other[:2], Row(rows[2].a, rows[2].alpha, number(Fraction(15005, 100000)), rows[2].theta), *other[3:])
    assert same_robot(truth, arm(mixed, puma.convention, puma.variables), own).verdict is Verdict.WRONG
    right = (*rows[:2], mixed[2], *rows[3:])
    assert same_robot(truth, arm(right, puma.convention, puma.variables), own).verdict is Verdict.RIGHT


# --- numbers ---------------------------------------------------------------------------------------------------------


def in_numbers(rows: Rows, name: str, digits: int) -> Rows:
    """The rows with the robot's own lengths, rounded to so many decimals of a metre."""
    from dhcli.checking.symbolic import put

    def length(expr: object) -> object:
        known = put(expr, {k: v for k, v in robot(name).parameters.items() if v is not None})
        return put_rounded(known, digits)

    return tuple(Row(length(row.a), row.alpha, length(row.d), row.theta) for row in rows)


def put_rounded(expr: object, digits: int) -> object:
    """An expression with its numbers rounded to so many decimals."""
    from dhcli.notation.tree import Number
    from dhcli.notation.walk import rebuild

    return rebuild(expr, lambda leaf: Number(round(leaf.value, digits), digits) if isinstance(leaf, Number) else leaf)


@given(
    st.sampled_from([name for name in NAMES if all(v is not None for v in robot(name).parameters.values())]),
    st.lists(keeping((number(Fraction(1, 8)),)), max_size=5),
    joint_changes,
)
def test_numbers_to_a_millimetre_are_right_in_any_frames(name: str, moves: list[Move], joints: list) -> None:
    """Lengths rounded to a tenth of a millimetre, whatever frames, senses and zeros."""
    convention, variables, rows = robot(name).convention, robot(name).variables, rows_of(name)
    own = Values({}, {k: v for k, v in robot(name).parameters.items() if v is not None})
    other = in_numbers(rows, name, 4)
    for share, sense, degrees, _ in joints:
        other = recounted(other, variables, int(share * len(variables)), sense, degrees, ZERO)
    for move in moves:
        other = move(other, convention)
    truth, answer = arm(rows, convention, variables), arm(other, convention, variables)
    assert same_robot(truth, answer, own).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("typed", "verdict"), [("0.4318", "RIGHT"), ("0.432", "RIGHT"), ("0.435", "CLOSE"), ("0.46", "WRONG")]
)
def test_numbers_are_judged_by_the_pose_they_give(typed: str, verdict: str) -> None:
    """432 for 431.8 is right, 435 is close, 460 is wrong."""
    puma, rows = robot("puma560"), in_numbers(rows_of("puma560"), "puma560", 5)
    own = Values({}, {k: v for k, v in puma.parameters.items() if v is not None})
    other = (*rows[:2], Row(number(Fraction(typed), 4), rows[2].alpha, rows[2].d, rows[2].theta), *rows[3:])
    truth = arm(rows_of("puma560"), puma.convention, puma.variables)
    assert same_robot(truth, arm(other, puma.convention, puma.variables), own).verdict is Verdict[verdict]


# --- chains ----------------------------------------------------------------------------------------------------------


def test_a_product_of_moves_and_a_table_are_the_same_robot() -> None:
    """Nothing asks how the chain was written."""
    scara = robot("scara")
    scope = Scope(joints=("theta1", "theta2"), lengths=("l1", "l2", "l3", "d3"))
    table = read_chain(
        "Rot(z, theta1 + 90°) Trans(0,0,l1) Trans(l2,0,0) Rot(z, theta2) Trans(l3,0,0) Rot(z, -90°) Trans(0,0,-d3)",
        scope,
    )
    truth = Arm.of(tuple(move for link in scara.links for move in link.moves), scara.variables)
    assert same_motion(truth, Arm.of(table, scara.variables)).verdict is Verdict.RIGHT


def test_a_variable_that_moves_two_joints_is_refused() -> None:
    """A joint has one axis."""
    with pytest.raises(RobotError, match="q1 does not move one joint"):
        Arm.of((Rot("z", Angle.of("q1")), Rot("x", Angle.of("q1"))), ("q1",))


def test_a_joint_that_turns_twice_as_fast_is_another_joint() -> None:
    """2*q1 is no freedom."""
    one, two = Arm.of((Rot("z", Angle.of("q1")),), ("q1",)), Arm.of((Rot("z", Angle.of("q1") * 2),), ("q1",))
    assert same_robot(one, two).verdict is Verdict.WRONG
    assert same_robot(two, two).verdict is Verdict.RIGHT


def test_a_turning_and_a_sliding_joint_are_never_the_same() -> None:
    """The kind of a joint is no freedom either."""
    one = Arm.of((Rot("z", Angle.of("q1")),), ("q1",))
    two = Arm.of((Trans(ZERO, ZERO, Symbol("q1")),), ("q1",))
    assert same_robot(one, two).verdict is Verdict.WRONG


@given(st.tuples(*[st.floats(-3, 3)] * 4), st.tuples(*[st.floats(-3, 3)] * 3))
def test_rigid_motions_form_a_group(angles: tuple[float, ...], offset: tuple[float, float, float]) -> None:
    """A motion and its inverse cancel, and a turn knows its angle."""
    one = Rigid.turn((0.0, 0.6, 0.8), angles[0], offset) @ Rigid.shift((angles[1], angles[2], angles[3]))
    back = one.inverse() @ one
    assert back.tilt() < 1e-12
    assert max(map(abs, back.offset)) < 1e-12
    assert abs(Rigid.turn((0.0, 0.6, 0.8), angles[0], offset).angle_about((0.0, 0.6, 0.8)) - angles[0]) < 1e-9
