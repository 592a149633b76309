"""Poses: products whose frames must meet, points, inverses, and how a pose shows itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dhcli.errors import NotationError, RobotError
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.entries import rounded
from dhcli.kinematics.forward import factors, forward, symbolic, textbook_form
from dhcli.kinematics.moves import read_chain, spelled
from dhcli.kinematics.pose import Pose
from tests.row_by_row import row_by_row


def test_the_inner_frames_of_a_product_must_be_the_same() -> None:
    """T_01 @ T_12 is T_02, and T_01 @ T_23 is refused."""
    arm = load_robot("puma560")
    one, two, three = (symbolic(arm, start=k, end=k + 1) for k in range(3))
    assert ((one @ two).name, (one @ two @ three).name) == ("T_02", "T_03")
    with pytest.raises(RobotError, match="T_01 ends in frame 1, T_23 starts from 2"):
        one @ three


def test_a_point_has_three_coordinates() -> None:
    """T_ab @ p_b is p_a; four are not guessed at."""
    pose = Pose(textbook_form(read_chain("Trans(8, -6, 14) Rot(z, 90°)")), "0", "1")
    assert [str(entry) for entry in pose @ read_chain("Trans(1, 2, 3)")[0].offset] == ["6", "-5", "17"]  # type: ignore[union-attr]
    with pytest.raises(RobotError, match="a point has three coordinates, not 4"):
        forward(load_robot("scara"), "zero") @ [1, 2, 3, 1]


def test_the_inverse_changes_the_frames() -> None:
    """And twice the inverse is the pose itself."""
    pose = forward(load_robot("scara"), [0.3, 0.5, 0.1])
    assert (pose.inverse().reference, pose.inverse().frame) == ("3", "0")
    assert np.array(pose.inverse().inverse()) == pytest.approx(np.array(pose))
    assert pose.matrix @ pose.inverse().matrix == pytest.approx(np.eye(4))


def test_a_pose_is_read_by_numpy_and_sympy() -> None:
    """Numbers as floats, symbols as objects; sympy gets symbols it may use."""
    pose = forward(load_robot("scara"), "zero")
    assert np.asarray(pose).dtype == np.float64
    assert pose.matrix.tolist() == [[1, 0, 0, 0], [0, 1, 0, 0.5], [0, 0, 1, 0.4], [0, 0, 0, 1]]
    terms = symbolic(load_robot("scara"))
    assert np.asarray(terms).dtype == object
    assert str(terms.to_sympy()[2, 3]) == "-d3 + l1"
    assert pose.to_sympy().shape == (4, 4)


def test_a_pose_shows_itself() -> None:
    """With its name and its frames, in columns; LaTeX for a notebook."""
    pose = symbolic(load_robot("planar-2r"))
    assert repr(pose) == (
        "T_02:\n"
        "c12  -s12  0  a1*c1 + a2*c12\n"
        "s12   c12  0  a1*s1 + a2*s12\n"
        "  0     0  1               0\n"
        "  0     0  0               1"
    )
    assert pose._repr_latex_().startswith("$\\displaystyle \\begin{bmatrix} c_{12} & -s_{12} & 0 & a_{1} c_{1}")
    assert Pose(pose.rows, "0", "12").name == "T_{0,12}"
    assert Pose(pose.rows, title="A_1").name == "A_1"


@row_by_row(
    ("value", "digits", "text"),
    [
        (0.30000000000000004, 4, "0.3"),
        (-0.0, 4, "0"),
        (6.1e-17, 4, "0"),
        (-6.1e-17, 4, "0"),
        (1.0, 4, "1"),
        (100.0, 0, "100"),
        (0.00005, 4, "0.0001"),
        (-2.5, 1, "-2.5"),
        (float("nan"), 4, "nan"),
        (float("inf"), 4, "inf"),
    ],
)
def test_numbers_are_rounded_for_people(value: float, digits: int, text: str) -> None:
    """No trailing zeros, no minus zero, and zeros before the point stay."""
    assert rounded(value, digits) == text


def test_the_factors_of_a_link_are_its_four_elementary_matrices() -> None:
    """In the order of the convention, named as they are typed."""
    standard, modified = load_robot("dh-link"), load_robot("dh-link-modified")
    assert [pose.title for pose in factors(standard, standard.links[0], {})] == [
        "Rot(z, theta_i)", "Trans(0, 0, d_i)", "Trans(a_i, 0, 0)", "Rot(x, alpha_i)"
    ]  # fmt: skip
    assert [pose.title for pose in factors(modified, modified.links[0], {})] == [
        "Rot(x, alpha_{i-1})", "Trans(a_{i-1}, 0, 0)", "Trans(0, 0, d_i)", "Rot(z, theta_i)"
    ]  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        "Rot(z, theta1 + theta2 - 90°)",
        "Rot(x, alpha/2)",
        "Rot(y, 2*theta1 + 0.25 rad)",
        "Trans(a1/2, -d3, sqrt(2)*l1)",
        "Trans(0.432, a1*(b + c), -(a1 - b))",
        "[0 0 1 a1+b; -1 0 0 6; 0 -1 0 -11; 0 0 0 1]",
        "[cos(phi) -sin(phi) 0 0; sin(phi) cos(phi) 0 -d3; 0 0 1 1/3; 0 0 0 1]",
    ],
)
def test_a_move_is_spelled_so_that_it_can_be_typed_again(text: str) -> None:
    """`spelled` is the inverse of reading."""
    (move,) = read_chain(text)
    assert read_chain(spelled(move)) == (move,)


def test_a_pose_says_its_orientation() -> None:
    """As the formulas of `orientation` do, in radians; a quarter turn about z."""
    pose = forward(load_robot("scara"), [np.pi / 4, np.pi / 4, 0])
    assert (pose.rpy.roll, pose.rpy.pitch, pose.rpy.yaw) == pytest.approx((0, 0, np.pi / 2))
    turn = pose.quaternion
    assert (turn.w, turn.x, turn.y, turn.z) == pytest.approx((0.5**0.5, 0, 0, 0.5**0.5))
    assert pose.axis_angle.axis == (0, 0, 1)
    assert pose.axis_angle.angle == pytest.approx(np.pi / 2)


def test_a_pose_in_symbols_gives_numbers_where_it_holds_none() -> None:
    """The same as the pose in numbers; with a symbol left, the error names it and what to call."""
    robot = load_robot("puma560")
    lengths = {"a2": 0.4, "a3": 0.02, "d3": 0.15, "d4": 0.43}
    exact = symbolic(robot, ["30°", 0, 0.5, 0, 0, 0], parameters=lengths)
    assert exact.matrix == pytest.approx(forward(robot, ["30°", 0, 0.5, 0, 0, 0], parameters=lengths).matrix)
    assert np.array(exact, dtype=float) == pytest.approx(exact.matrix)
    assert exact.quaternion.w > 0
    for ask in (lambda pose: pose.matrix, lambda pose: pose.rpy, lambda pose: np.array(pose, dtype=float)):
        with pytest.raises(RobotError, match=r"T_06 is in symbols: a2, .*forward\(robot, q\).*to_sympy"):
            ask(symbolic(robot))


def test_numbers_and_symbols_do_not_meet_in_a_product() -> None:
    """And the error says which is which."""
    robot = load_robot("scara")
    with pytest.raises(RobotError, match="T_03 is in numbers, T_30 in symbols"):
        forward(robot, [0, 0, 0]) @ symbolic(robot).inverse()


def test_a_point_may_be_typed_where_the_pose_is_in_symbols() -> None:
    """With names, units and numbers; what is no length is refused."""
    pose = symbolic(load_robot("scara"), start=2)
    assert [str(entry) for entry in pose @ (0, 0.25, "a6 + 30mm")] == ["0", "1/4 + l3", "0.03 + a6 - d3"]
    with pytest.raises(NotationError, match="a length is wanted"):
        pose @ (0, 0, "30°")
    with pytest.raises(RobotError, match="None is no coordinate"):
        pose @ (0, 0, None)  # type: ignore[operator]
    with pytest.raises(RobotError, match="three numbers"):
        forward(load_robot("scara"), "zero") @ (0, 0, "a6")


def test_many_points_are_one_product() -> None:
    """Each as by itself; an array of another shape is refused."""
    pose = forward(load_robot("puma560"), "ready")
    points = np.random.default_rng(2).normal(size=(5, 3))
    assert pose @ points == pytest.approx(np.array([pose @ point for point in points]))
    with pytest.raises(RobotError, match=r"points have the shape \(N, 3\), not \(5, 4\)"):
        pose @ np.zeros((5, 4))


def test_values_are_put_into_sympy_by_its_own_symbols() -> None:
    """`sympy_symbols` has them by name; other symbols of that name are strangers."""
    pose = symbolic(load_robot("planar-2r"))
    put_in = pose.to_sympy().subs({pose.sympy_symbols["theta1"]: 0, pose.sympy_symbols["theta2"]: 0})
    assert str(put_in[0, 3]) == "a1 + a2"
    assert sorted(pose.sympy_symbols) == ["a1", "a2", "theta1", "theta2"]


@pytest.mark.parametrize("other", [3, None, 2.5, object(), load_robot("scara")])
def test_what_is_neither_a_pose_nor_a_point_is_refused_in_words(other: Any) -> None:  # noqa: ANN401  anything else
    """With what would be taken."""
    pose = forward(load_robot("scara"), [0.1, 0.2, 0.05])
    with pytest.raises(RobotError, match="takes a pose or a point, not") as caught:
        pose @ other
    assert caught.value.problems[0].hint.endswith("@ (0, 0, 0.1), or the pose behind")
