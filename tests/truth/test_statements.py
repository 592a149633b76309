"""What the documents state in words: order of factors, rules of the frames, readings, equivalences between arms."""

from __future__ import annotations

import pytest

from dhcli.algebra.equality import equal
from dhcli.algebra.terms import TERMS
from dhcli.files.yaml.robots import load_robot
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.geometry.words import in_words
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import forward, symbolic
from dhcli.kinematics.frames import between
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, inverse, read_chain
from dhcli.kinematics.pose import Pose
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ONE, ZERO, Expr, Symbol, add, multiply, negate, number
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import substitute, symbols
from tests.row_by_row import row_by_row
from tests.truth.items import EQUATIONS, TRUTH, Matrix, chain, computed, matrix

A, ALPHA, D, THETA = Symbol("a"), Angle.of("alpha"), Symbol("d"), Angle.of("theta")
STANDARD = fold(moves_of(Row(A, ALPHA, D, THETA), Convention.STANDARD), TERMS)
MODIFIED = fold(moves_of(Row(A, ALPHA, D, THETA), Convention.MODIFIED), TERMS)


def product(text: str) -> Matrix:
    """A typed product, multiplied out."""
    return fold(read_chain(text), TERMS)


def same(one: Matrix, other: Matrix) -> bool:
    """Whether all entries are equal for all values of the names."""
    return all(equal(a, b) for p, q in zip(one, other, strict=True) for a, b in zip(p, q, strict=True))


def column(pose: Matrix, k: int) -> list[Expr]:
    """Axis x, y or z of the frame described (0, 1, 2), or its origin (3)."""
    return [row[k] for row in pose[:3]]


def dot(one: list[Expr], other: list[Expr]) -> Expr:
    """The scalar product."""
    return add(*(multiply(a, b) for a, b in zip(one, other, strict=True)))


def cross(one: list[Expr], other: list[Expr]) -> list[Expr]:
    """The vector product."""
    return [add(multiply(one[i], other[j]), negate(multiply(one[j], other[i]))) for i, j in ((1, 2), (2, 0), (0, 1))]


def agree(one: list[Expr], other: list[Expr]) -> bool:
    """Whether two vectors are equal for all values of the names."""
    return all(equal(a, b) for a, b in zip(one, other, strict=True))


def numbers(pose: Matrix) -> Pose[float]:
    """A pose without names, in floats."""
    return Pose(tuple(tuple(float(entry.value) for entry in row) for row in pose))  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("pair", "turned"),
    [
        ("Rot(z, theta) Trans(z, d)", "Trans(z, d) Rot(z, theta)"),
        ("Trans(x, a) Rot(x, alpha)", "Rot(x, alpha) Trans(x, a)"),
    ],
)
def test_turning_about_an_axis_and_sliding_along_it_commute(pair: str, turned: str) -> None:
    """Y18, Y25, Z04: each of the two pairs of a DH row."""
    assert same(product(pair), product(turned))


def test_the_two_pairs_of_a_row_do_not_commute() -> None:
    """Y18, Z04: nor does any factor of one with a turning factor of the other."""
    about_z, about_x = "Rot(z, theta) Trans(z, d)", "Trans(x, a) Rot(x, alpha)"
    assert same(product(f"{about_z} {about_x}"), STANDARD)
    assert not same(product(f"{about_x} {about_z}"), STANDARD)
    turn, slide, reach, twist = "Rot(z, theta)", "Trans(z, d)", "Trans(x, a)", "Rot(x, alpha)"
    for one, other in ((turn, reach), (turn, twist), (slide, twist)):
        assert not same(product(f"{one} {other}"), product(f"{other} {one}"))
    assert same(product("Trans(z, d) Trans(x, a)"), product("Trans(x, a) Trans(z, d)"))


def test_zhou_begins_with_the_translation_and_comes_to_the_same_matrix() -> None:
    """Z04, Z15: D_z R_z D_x R_x is R_z D_z D_x R_x."""
    assert same(product("Trans(z, d) Rot(z, theta) Trans(x, a) Rot(x, alpha)"), STANDARD)


def test_the_rules_of_standard_dh_hold() -> None:
    """Y21 to Y24: x_i meets z_{i-1} at a right angle, and the four parameters are what they are called."""
    x0, z0 = [ONE, ZERO, ZERO], [ZERO, ZERO, ONE]
    x1, z1, origin = (column(STANDARD, k) for k in (0, 2, 3))
    assert equal(STANDARD[2][0], ZERO)
    assert agree(origin, [add(multiply(A, x), multiply(D, z)) for x, z in zip(x1, z0, strict=True)])
    assert equal(dot(origin, x1), add(A, multiply(D, dot(z0, x1))))  # a: from z_{i-1} to z_i along x_i
    assert equal(dot(z0, z1), cosine(ALPHA))  # alpha: from z_{i-1} to z_i about x_i
    assert equal(dot(cross(z0, z1), x1), sine(ALPHA))
    assert equal(dot(origin, z0), D)  # d: from x_{i-1} to x_i along z_{i-1}
    assert equal(dot(x0, x1), cosine(THETA))  # theta: from x_{i-1} to x_i about z_{i-1}
    assert equal(dot(cross(x0, x1), z0), sine(THETA))


def test_the_rules_of_modified_dh_hold() -> None:
    """Z44, Z45: a and alpha lie on x_{i-1}, d and theta on z_i."""
    x0, z0 = [ONE, ZERO, ZERO], [ZERO, ZERO, ONE]
    x1, z1, origin = (column(MODIFIED, k) for k in (0, 2, 3))
    assert equal(dot(z1, x0), ZERO)
    assert agree(origin, [add(multiply(A, x), multiply(D, z)) for x, z in zip(x0, z1, strict=True)])
    assert equal(dot(origin, x0), A)
    assert equal(dot(z0, z1), cosine(ALPHA))
    assert equal(dot(cross(z0, z1), x0), sine(ALPHA))
    assert equal(dot(origin, z1), D)
    assert equal(dot(x0, x1), cosine(THETA))
    assert equal(dot(cross(x0, x1), z1), sine(THETA))


def test_joint_i_turns_about_the_axis_of_its_convention() -> None:
    """Y21, Z43, Z47: about z_{i-1} in standard DH, about z_i in modified DH."""
    theta = {"theta": Angle.of("phi")}
    moved = [[substitute(entry, {}, theta) for entry in row] for row in MODIFIED]
    assert agree(column(MODIFIED, 2), column(moved, 2))  # z_i and its origin stay where they are
    assert agree(column(MODIFIED, 3), column(moved, 3))
    back = fold(inverse(moves_of(Row(A, ALPHA, D, THETA), Convention.STANDARD)), TERMS)
    turned = [[substitute(entry, {}, theta) for entry in row] for row in back]
    assert agree(column(back, 2), column(turned, 2))  # z_{i-1}, seen from frame i
    assert not agree(column(STANDARD, 2), [substitute(entry, {}, theta) for entry in column(STANDARD, 2)])


@pytest.mark.parametrize(("twist", "sign"), [("0", 1), ("180°", -1)])
def test_between_parallel_axes_the_offset_may_be_shared_out_at_will(twist: str, sign: int) -> None:
    """Y26: only d_i + d_{i+1} counts, or d_i - d_{i+1} where the axis is turned over."""

    def pair(first: Expr, second: Expr) -> Matrix:
        one = Row(Symbol("a1"), to_angle(parse(twist)), first, Angle.of("theta1"))
        two = Row(Symbol("a2"), ALPHA, second, Angle.of("theta2"))
        return fold((*moves_of(one, Convention.STANDARD), *moves_of(two, Convention.STANDARD)), TERMS)

    d1, d2, free = Symbol("d1"), Symbol("d2"), Symbol("d3")
    assert same(pair(d1, d2), pair(d1 + free, d2 + free * -sign))
    assert not same(pair(d1, d2), pair(d1 + free, d2))


def test_the_printed_wrist_spoils_the_product_in_two_entries() -> None:
    """Y37: T_03 times the printed T_36 is wrong in (1,2) and (2,2), the right product is Y38."""
    arm, wrist = matrix(EQUATIONS["Y31"]["expected"]), matrix(EQUATIONS["Y36"]["expected"])
    printed = matrix(EQUATIONS["Y36"]["printed"])
    right = matrix(EQUATIONS["Y38"]["expected"])
    wrong = (Pose(arm, "0", "3") @ Pose(printed, "3", "6")).rows
    assert same((Pose(arm, "0", "3") @ Pose(wrist, "3", "6")).rows, right)
    differing = {(i + 1, j + 1) for i in range(4) for j in range(4) if not equal(wrong[i][j], right[i][j])}
    assert differing == {(1, 2), (2, 2)}


@row_by_row(
    ("name", "pattern"),
    [
        ("cartesian", "PPP"),
        ("cylindrical", "RPP"),
        ("stanford", "RRPRRR"),
        ("scara-yim", "RRPR"),
        ("scara", "RRP"),
        ("scara-zhou", "RRRP"),
        ("articulated", "RRR"),
        ("puma560", "RRRRRR"),
    ],
)
def test_the_standard_configurations_have_their_joints(name: str, pattern: str) -> None:
    """Y46, W01: Cartesian, cylindrical, spherical (Stanford's first three), SCARA, articulated."""
    assert load_robot(name).pattern == pattern


def test_a_displaced_point_is_the_sum_of_two_vectors() -> None:
    """B01, B05: v = q + d."""
    moved = Pose(product("Trans(a, b, c)"), "0", "1") @ [Symbol(name) for name in "xyz"]
    assert [str(entry) for entry in moved] == ["x + a", "y + b", "z + c"]


@pytest.mark.parametrize(("axis", "start", "end"), [("x", 1, 2), ("y", 2, 0), ("z", 0, 1)])
def test_a_positive_rotation_is_right_handed(axis: str, start: int, end: int) -> None:
    """B07: a quarter about x takes y to z, about y z to x, about z x to y."""
    unit = [number(int(k == start)) for k in range(3)]
    turned = Pose(product(f"Rot({axis}, 90°)")) @ unit
    assert list(turned) == [number(int(k == end)) for k in range(3)]


def test_the_coordinates_of_a_frame_turned_about_y() -> None:
    """B10: x = x' cos(beta) + z' sin(beta), y = y', z = -x' sin(beta) + z' cos(beta)."""
    point = Pose(product("Rot(y, beta)")) @ [Symbol(name) for name in "xyz"]
    printed = ("x cos(beta) + z sin(beta)", "y", "-x sin(beta) + z cos(beta)")
    assert all(equal(ours, parse(text)) for ours, text in zip(point, printed, strict=True))


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("B16", ("x' points along +y", "y' points along +z", "z' points along +x")),
        ("B24", ("x' points along +y", "y' points along -x", "z' points along +z")),
        ("B27", ("x' points along -y", "y' points along -z", "z' points along +x")),
    ],
)
def test_the_axes_point_where_the_text_says(name: str, words: tuple[str, ...]) -> None:
    """B17, B25, B27: the reading of a matrix by its columns."""
    assert in_words(numbers(computed(EQUATIONS[name])).rotation) == words


def test_moves_in_the_new_frame_are_the_moves_in_the_fixed_one_from_right_to_left() -> None:
    """B18: Trans, then about the new y, then about the newest z; or about fixed z, fixed y, then Trans."""
    new = [read_chain(text) for text in ("Trans(8, -6, 14)", "Rot(y, 90°)", "Rot(z, 90°)")]
    frame: Chain = ()
    for moves in new:
        frame = (*frame, *moves)  # post-multiplied: in the frame reached
    fixed: Chain = ()
    for moves in reversed(new):
        fixed = (*moves, *fixed)  # pre-multiplied: in the fixed frame
    assert same(fold(frame, TERMS), matrix(EQUATIONS["B16"]["expected"]))
    assert same(fold(frame, TERMS), fold(fixed, TERMS))
    assert not same(fold(tuple(reversed(frame)), TERMS), fold(frame, TERMS))


@pytest.mark.parametrize("name", ["B27", "B28", "B29"])
def test_the_given_matrices_of_the_blocks_are_rotations(name: str) -> None:
    """B27 to B29: perpendicular unit vectors, right-handed, and the one of the text."""
    (move,) = read_chain("[" + "; ".join(", ".join(row) for row in EQUATIONS[name]["expected"]) + "]")
    assert not_a_rotation(move.rows) == ""  # type: ignore[arg-type]
    assert fold((move,), TERMS) == computed(EQUATIONS[name])


def test_bajds_scara_at_home_stands_as_drawn() -> None:
    """B32: all frames parallel to the base, the end at (0, l2 + l3, l1)."""
    arm = load_robot("scara")
    home = symbolic(arm, "zero")
    assert same(home.rows, product("Trans(0, l2 + l3, l1)"))
    for number_ in (1, 2):
        assert home.rotation == symbolic(arm, "zero", end=number_).rotation


def test_c12_and_s12_are_the_cosine_and_sine_of_a_sum() -> None:
    """B38: c12 = c1*c2 - s1*s2 and s12 = s1*c2 + c1*s2, by whatever name the angle goes."""
    for letter in ("theta", "\\vartheta_"):
        assert parse("c12") == parse(f"cos({letter}1 + {letter}2)")
    assert equal(parse("c12"), parse("c1 c2 - s1 s2"))
    assert equal(parse("s12"), parse("s1 c2 + c1 s2"))
    assert not equal(parse("c12"), parse("c1 c2 + s1 s2"))


def test_the_order_of_columns_and_factors_is_named() -> None:
    """Y17, Z13: the four parameters by their names, and [n s a] as the columns of R."""
    arm = load_robot("dh-link")
    assert set(arm.columns) == {"a", "alpha", "d", "theta"}
    pose = symbolic(arm)
    assert [tuple(row[k] for row in pose.rows[:3]) for k in range(3)] == list(zip(*pose.rotation, strict=True))


def test_a_point_of_the_last_frame_is_turned_and_then_displaced() -> None:
    """Z11: r_P = R_n nr_P + d_n, which is [r_P; 1] = 0T_n [nr_P; 1]."""
    pose = symbolic(load_robot("puma560"))
    point = [Symbol(name) for name in "xyz"]
    by_parts = [add(dot(list(row), point), d) for row, d in zip(pose.rotation, pose.position, strict=True)]
    assert agree(list(pose @ point), by_parts)
    moves = (*between(load_robot("puma560"), "0", "6"), *read_chain("Trans(x, y, z)"))
    assert agree(column(fold(moves, TERMS), 3), by_parts)


def test_zhous_link_matrix_maps_coordinates_of_frame_i_to_those_before_it() -> None:
    """Z03: {i-1}T_i takes the origin of B_i, its own (0, 0, 0), to where it stands in B_{i-1}."""
    pose = symbolic(load_robot("dh-link"))
    assert agree(list(pose @ [ZERO, ZERO, ZERO]), list(pose.position))
    assert agree(list(pose.inverse() @ list(pose.position)), [ZERO, ZERO, ZERO])


def test_the_tip_of_the_3r_arm_is_found_back_from_its_printed_position() -> None:
    """Z20: 3r_P = R_3^T (P - d_3), and at α = π/6 it is (-√3 e/2, -e/2, c)."""
    pose = symbolic(load_robot("zhou-3r"))
    tip = [row[0] for row in matrix(EQUATIONS["Z21"]["expected"])]
    local = list(pose.inverse() @ tip)
    assert agree(local, [row[0] for row in matrix(EQUATIONS["Z20"]["expected"])][:3])
    bent = [substitute(entry, {}, {"alpha": to_angle(parse("π/6"))}) for entry in local]
    assert agree(bent, [parse(text) for text in TRUTH["Z20"]["facts"]["numeric"]])


def test_the_tip_of_the_3r_arm_has_a_short_form() -> None:
    """Z21: x = a c1 + b c12 - c s12 - e c12 cos(θ3+α), and so on."""
    tip = [row[0] for row in matrix(EQUATIONS["Z21"]["expected"])]
    names = Scope(joints=("theta1", "theta2", "theta3"), angles=("alpha",), lengths=("a", "b", "c", "e"))
    short = ("a c1 + b c12 - c*s12 - e c12 cos(θ3+α)", "a s1 + b s12 + c*c12 - e s12 cos(θ3+α)", "e sin(θ3+α)")
    assert agree(tip, [parse(text, names) for text in short])


def test_the_scara_of_zhou_is_the_one_of_yim_with_its_links_in_another_order() -> None:
    """Z27: with theta3 for -theta4 and d for -d3 - d4, the two arms reach the same pose."""
    zhou, yim = load_robot("scara-zhou"), load_robot("scara-yim")
    lengths: dict[str, Expr] = {"l1": Symbol("a1"), "l2": Symbol("a2"), "d": -(Symbol("d3") + Symbol("d4"))}
    angles = {"theta3": -Angle.of("theta4")}
    other = [[substitute(entry, lengths, angles) for entry in row] for row in symbolic(zhou).rows]
    assert same(other, symbolic(yim).rows)  # type: ignore[arg-type]


def test_with_the_brackets_of_the_6r_table_as_offsets_the_printed_matrices_do_not_come_out() -> None:
    """Z28: theta1(90°) is the value drawn; added to the variable it spoils 0T1, 2T3 and 0T3."""
    for name in ("Z30", "Z32", "Z37"):
        rows = [
            {**row, "theta": f"{row['theta']} + {row['home_deg']}*pi/180"} for row in EQUATIONS[name]["compute"]["rows"]
        ]
        offset = fold(merge(chain({**EQUATIONS[name]["compute"], "rows": rows})), TERMS)
        assert not same(offset, matrix(EQUATIONS[name]["expected"]))


def test_the_printed_0t3_of_the_6r_arm_does_not_follow_from_the_printed_factors() -> None:
    """Z37, Z38: with the misprinted 1 in (3,3) of 0T1 and 2T3 the product is another; without it, the printed one."""
    right = matrix(EQUATIONS["Z37"]["expected"])
    for key, outcome in (("printed", False), ("expected", True)):
        links = [matrix(EQUATIONS[name][key]) for name in ("Z30", "Z31", "Z32")]
        pose: Pose[Expr] = Pose(links[0], "0", "1")
        for i, link in enumerate(links[1:], 1):
            pose = pose @ Pose(link, str(i), str(i + 1))
        assert same(pose.rows, right) is outcome
    wrist: Pose[Expr] = Pose(matrix(EQUATIONS["Z33"]["expected"]), "3", "4")
    for i, name in ((4, "Z34"), (5, "Z35")):
        wrist = wrist @ Pose(matrix(EQUATIONS[name]["expected"]), str(i), str(i + 1))
    assert same(wrist.rows, matrix(EQUATIONS["Z38"]["expected"]))


def test_the_3r_arm_has_the_same_pose_in_both_conventions_but_other_links() -> None:
    """Z48: 0T3 agrees, 0T1 and 0T2 do not, as frames 1 and 2 stand elsewhere."""
    one, other = load_robot("zhou-3r"), load_robot("zhou-3r-modified")
    assert same(symbolic(one).rows, symbolic(other).rows)
    assert not same(symbolic(one, end=1).rows, symbolic(other, end=1).rows)
    assert not same(symbolic(one, end=2).rows, symbolic(other, end=2).rows)


def test_the_wrist_of_puma200_has_no_common_point_as_printed() -> None:
    """Z49: with d4 = 0 and d5 = c the wrist centre moves with theta4; with d4 = c and d5 = 0 it stands still."""
    printed, conjecture = (
        fold(merge(chain({**TRUTH[name]["compute"], "rows": TRUTH[name]["compute"]["rows"][3:]})), TERMS)
        for name in ("Z49i", "Z49j")
    )
    assert "theta4" in symbols(printed[0][3])
    assert [str(entry) for entry in column(conjecture, 3)] == ["0", "c", "0"]


def test_unimations_zero_of_joint_3_turns_the_signs_of_its_cosines() -> None:
    """W03: theta3 = theta3* + 180° in 0T6, and c23, s23 change their signs."""
    star = symbolic(load_robot("puma560-unimation"))
    turned = {"theta3": Angle.of("theta3") + Angle.in_degrees(180)}
    slides = symbolic(load_robot("puma560"))
    assert same(star.rows, [[substitute(entry, {}, turned) for entry in row] for row in slides.rows])  # type: ignore[arg-type]
    assert str(star.rows[0][3]) == "c1*(a2*c2 - a3*c23 + d4*s23) - d3*s1"


def test_the_named_poses_of_the_puma_mean_the_same_under_both_zeros() -> None:
    """W03: `ready` of the one file is `ready` of the other, in space."""
    one, other = load_robot("puma560"), load_robot("puma560-unimation")
    common = (one.poses.keys() & other.poses.keys()) - {"zero"}
    assert common
    for pose in common:
        for row, wanted in zip(forward(one, pose).rows, forward(other, pose).rows, strict=True):
            assert row == pytest.approx(wanted, abs=1e-12)


def test_the_axes_of_the_pumas_wrist_meet_in_one_point() -> None:
    """W04: the origins of frames 4, 5 and 6 are one, and it does not move with theta4, theta5, theta6."""
    arm = load_robot("puma560")
    centres = [symbolic(arm, end=k).position for k in (4, 5, 6)]
    assert centres[0] == centres[1] == centres[2]
    assert not {"theta4", "theta5", "theta6"} & frozenset().union(*map(symbols, centres[0]))


def test_the_bracket_missing_in_r21_stands_behind_s5_c6() -> None:
    """W18: with it the printed line is r21, and column 1 is a unit vector."""
    line = "s_1[c_{23}(c_4c_5c_6 - s_4s_6) - s_{23}s_5c_6] - c_1(s_4c_5c_6 + c_4s_6)"
    pose = symbolic(load_robot("puma560"))
    assert parse(line) == pose.rows[1][0]
    first = column(pose.rows, 0)
    assert equal(dot(first, first), ONE)
    swapped = [first[0], parse(line.replace("s_4s_6", "s_4s_5")), first[2]]
    assert not equal(dot(swapped, swapped), ONE)
