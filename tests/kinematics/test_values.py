"""What people give for joints and lengths, in every form; what is missing, and what is out of reach."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from dhcli import in_numbers, limits_of, list_robots
from dhcli.errors import DhcliError, NotationError, Place, RobotError
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import forward, symbolic
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Value, given_parameters, joint_values, numbers, parameter_values
from dhcli.notation.angle import Angle
from dhcli.notation.tree import number
from tests.row_by_row import row_by_row


@pytest.fixture
def scara() -> Robot:
    """Bajd's arm: theta1 and theta2 turn, d3 slides."""
    return load_robot("scara")


def degrees(value: int) -> Angle:
    """An exact angle."""
    return Angle.in_degrees(value)


def radians(value: str) -> Angle:
    """An angle in bare radians, exactly as typed."""
    return Angle(radians=Fraction(value))


def metres(value: str) -> Value:
    """A length."""
    return number(Fraction(value))


@row_by_row(
    ("given", "values"),
    [
        ("0.3, 30°, 432mm", (radians("0.3"), degrees(30), metres("0.432"))),
        ("-0.3,0.5,1e-1", (radians("-0.3"), radians("0.5"), metres("0.1"))),
        ("pi/2, -π/4, 12 cm", (degrees(90), degrees(-45), metres("0.12"))),
        ("90deg, 1 rad, 10in", (degrees(90), radians("1"), metres("0.254"))),
        ("[0.1, 0.2, 0.3]", (radians("0.1"), radians("0.2"), metres("0.3"))),
        ("0.1; 0.2; 0.3", (radians("0.1"), radians("0.2"), metres("0.3"))),
        ("0 30° 432mm", (degrees(0), degrees(30), metres("0.432"))),
        ("[ 0.1 -0.2 .3 ]", (radians("0.1"), radians("-0.2"), metres("0.3"))),
        ("0,1 0,2 0,3", (radians("0.1"), radians("0.2"), metres("0.3"))),
        ("0,1; 0,2;0,3", (radians("0.1"), radians("0.2"), metres("0.3"))),
        ("0.1;0,2;0.3;", (radians("0.1"), radians("0.2"), metres("0.3"))),
        ("q1=0.1 d3=0.3 q2=pi/2", (radians("0.1"), degrees(90), metres("0.3"))),
        ("theta1=30°, theta2=0, d3=0", (degrees(30), degrees(0), metres("0"))),
        ("q3=0.1, q1=30°, θ2=-90°", (degrees(30), degrees(-90), metres("0.1"))),
        ("\\theta_1 = 1, theta_2 = 2, d_3 = 3", (radians("1"), radians("2"), metres("3"))),
        ("elbow", (degrees(0), degrees(90), metres("0"))),
        (" pick ", (degrees(30), degrees(45), metres("0.1"))),
        ([0.5, "30°", "120 mm"], (radians("0.5"), degrees(30), metres("0.12"))),
        ((degrees(30), 0, 2), (degrees(30), degrees(0), metres("2"))),
        ({"theta2": "90°", "q1": 1, "d3": 0.25}, (radians("1"), degrees(90), metres("0.25"))),
        (np.array([0.5, 0.25, 2]), (radians("0.5"), radians("0.25"), metres("2"))),
    ],
)
def test_joints_are_given_in_any_form(scara: Robot, given: object, values: tuple[Value, ...]) -> None:
    """Text, list, mapping, pose, array; bare numbers are radians and metres, exactly."""
    found = joint_values(scara, given)  # type: ignore[arg-type]
    assert tuple(found[name] for name in scara.variables) == values


def test_a_float_is_the_decimal_that_was_typed(scara: Robot) -> None:
    """0.1 is a tenth in symbols too, not the binary fraction nearest to it."""
    assert joint_values(scara, [0.1, 0, 0.25]) == {"theta1": radians("0.1"), "theta2": Angle(), "d3": metres("0.25")}
    pose = symbolic(scara, [0.1, 0.30000000000000004, 0.25])
    assert str(pose.rows[2][3]) == "l1 - 0.25"
    assert "cos(0.30000000000000004)" in str(pose.rows[0][0])


def test_some_joints_may_be_left_open(scara: Robot) -> None:
    """Assignments need not name all, and nothing gives nothing."""
    assert joint_values(scara, "theta2=90°") == {"theta2": degrees(90)}
    assert joint_values(scara, {"d3": 1}) == {"d3": metres("1")}
    assert joint_values(scara, None) == {}


def test_bare_numbers_may_be_degrees(scara: Robot) -> None:
    """`--deg` turns revolute joints only; a unit that is written wins."""
    values = joint_values(scara, "30, 1 rad, 0.1", bare="deg")
    assert tuple(values.values()) == (degrees(30), radians("1"), metres("0.1"))
    assert joint_values(scara, [30, 60, 0.5], bare="deg")["theta2"] == degrees(60)


@row_by_row(
    ("given", "message"),
    [
        ("0.1,0.2", "q: scara has 3 joints, 2 values given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ("1,2,3,4", "q: scara has 3 joints, 4 values given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ("", "q: scara has 3 joints, 0 values given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ("[]", "q: scara has 3 joints, 0 values given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ("0.1 0.2", "q: scara has 3 joints, 1 value given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ("30 deg 20", "q: scara has 3 joints, 1 value given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ("0 0 30mm/", "q:10: the end where a number, a name or a bracket was expected"),
        ([[0, 0, 0]] * 3, "theta1 wants one number, not [0, 0, 0] (forward_batch takes a row for each pose)"),
        ([None, 0, 0], "theta1 wants one number, not None"),
        ([1 + 0j, 0, 0], "theta1 wants one number, not (1+0j)"),
        ("elbw", "q: scara has no pose called elbw (did you mean elbow?)"),
        ("30mm,0,0", "q:1: mm is a unit of length, an angle is wanted, and theta1 turns (write 30° or 0.5 rad)"),
        (
            "[0, 0, 30°]",
            "q:8: deg is a unit of angle, a length is wanted, and d3 slides (write 0.4 m or 400 mm)",
        ),
        ("0.3,0.5,x", "q:9: x is not a name that is known here"),
        ("nan,0,0", "q:1: nan is no number that a robot can have"),
        ("inf,0,0", "q:1: inf is no number that a robot can have"),
        ("0,0,1/0", "q:6: a division by zero"),
        ("0.1,,0.2", "q:5: the end where a number, a name or a bracket was expected"),
        ("theta1=1, q1=2", "q:11: theta1 is given twice"),
        ("theta1=1, 2", "q:11: 2 has no name (write q1=0.3, q2=0.5, or only values)"),
        ("q1=0, q7=3", "q:7: scara has no joint q7 (known: theta1, theta2, d3)"),
        ("thta1=3", "q:1: scara has no joint thta1 (did you mean theta1 or theta2?)"),
        (
            "q1=0, theta2 = 3mm",
            "q:16: mm is a unit of length, an angle is wanted, and theta2 turns (write 30° or 0.5 rad)",
        ),
        ([1, 2], "scara has 3 joints, 2 values given (wanted: theta1 [rad], theta2 [rad], d3 [m])"),
        ([math.nan, 0, 0], "theta1 = nan is not a number that a joint can have"),
        ([0, 0, -math.inf], "d3 = -inf is not a number that a joint can have"),
        ({"tool": 1}, "scara has no joint tool (known: theta1, theta2, d3)"),
    ],
)
def test_a_wrong_value_is_told_with_its_column(scara: Robot, given: object, message: str) -> None:
    """What, where, and what would be right."""
    with pytest.raises(DhcliError) as caught:
        joint_values(scara, given)  # type: ignore[arg-type]
    assert str(caught.value) == message


def test_an_error_in_an_option_shows_the_whole_text(scara: Robot) -> None:
    """So that a marker under it points at the right letter."""
    with pytest.raises(NotationError) as caught:
        joint_values(scara, "q1=0, q2=x", place=Place("--q"))
    assert caught.value.problems[0].place == Place("--q", None, 10, "q1=0, q2=x")


def test_a_robot_without_a_joint_takes_no_value() -> None:
    """The assembly of blocks."""
    blocks = load_robot("assembly-blocks")
    assert joint_values(blocks, []) == {}
    with pytest.raises(RobotError, match="assembly-blocks has 0 joints, 1 value given"):
        joint_values(blocks, "0.3")


def test_lengths_are_those_of_the_file_unless_given(scara: Robot) -> None:
    """With their units; a bare length is metres."""
    assert parameter_values(scara, {})["l1"] == metres("0.4")
    found = parameter_values(scara, {"l1": "25 cm", "l_2": 2, "l3": metres("1/2")})
    assert found == {"l1": metres("0.25"), "l2": metres("2"), "l3": metres("0.5")}
    assert given_parameters(scara, {"l1": 1}) == {"l1": metres("1")}


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"l9": 1}, "scara has no length called l9 (did you mean l3 or l2 or l1?)"),
        ({"theta1": 1}, "theta1 is a joint of scara (write --q theta1=...)"),
        ({"l1": "30°"}, "l1:1: deg is a unit of angle, a length is wanted, for l1 (write 0.4 m or 400 mm)"),
        ({"l1": math.nan}, "l1 = nan is not a number that a joint can have"),
    ],
)
def test_a_wrong_length_is_told(scara: Robot, given: dict[str, object], message: str) -> None:
    """Unknown, a joint, of the wrong kind, not a number."""
    with pytest.raises(DhcliError) as caught:
        given_parameters(scara, given)  # type: ignore[arg-type]
    assert str(caught.value).replace("l1: deg", "l1:1: deg") == message


def test_a_constant_angle_needs_its_unit() -> None:
    """A bare number in an angle of the table is the first slip, so it is refused."""
    link = load_robot("dh-link")
    assert given_parameters(link, {"alpha_i": "30°"}) == {"alpha_i": degrees(30)}
    with pytest.raises(NotationError, match="the angle 30 has no unit"):
        given_parameters(link, {"alpha_i": "30"})


def test_what_is_missing_is_named_all_at_once(scara: Robot) -> None:
    """Joints and lengths, each with the option that gives it."""
    with pytest.raises(RobotError) as caught:
        forward(scara, "theta2=0")
    assert str(caught.value).startswith("no value for theta1, d3 (--q takes theta1 [rad], theta2 [rad], d3 [m]")
    with pytest.raises(RobotError) as caught:
        forward(load_robot("dh-link"))
    assert [problem.message for problem in caught.value.problems] == [
        "no value for theta_i",
        "a_i, alpha_i, d_i of dh-link have no value",
    ]
    assert caught.value.problems[1].hint == "give one: --set a_i=0.4 --set alpha_i=30° --set d_i=0.4"


def test_only_what_the_asked_frames_need_must_be_given(scara: Robot) -> None:
    """The second link alone needs neither theta1 nor d3."""
    assert forward(scara, "theta2=90°", start=1, end=2).rows[0] == (0.0, -1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("q", "expected"),
    [
        ("0,0,0,0,0,0", []),
        ("160°,0,0,0,0,0", []),
        ("-160.0001°,0,0,0,0,0", ["theta1 = -160.0001° is outside its limits, -160° to 160°"]),
        ("170°,60°,0,0,0,0", ["theta1 = 170° is outside its limits, -160° to 160°",
                             "theta2 = 60° is outside its limits, -225° to 45°"]),
        ("0,0,0,0,0,7", ["theta6 = 7 rad is more than a turn; did you mean 7°, or --deg?",
                         "theta6 = 401.1° is outside its limits, -266° to 266°"]),
        ("0,0,0,0,0,6.2", ["theta6 = 355.2° is outside its limits, -266° to 266°"]),
        ("0,0,0,0,0,400°", ["theta6 = 400° is outside its limits, -266° to 266°"]),
    ],
)  # fmt: skip
def test_a_joint_out_of_reach_is_warned_of(q: str, expected: list[str]) -> None:
    """By its name, with its limits; a bare number beyond a turn asks whether degrees were meant."""
    puma = load_robot("puma560")
    assert list(warnings(puma, joint_values(puma, q))) == expected


def test_a_sliding_joint_is_never_beyond_a_turn(scara: Robot) -> None:
    """Seven metres are seven metres."""
    assert list(warnings(scara, joint_values(scara, [0, 0, 7]))) == []


def test_values_are_floats_for_the_arithmetic_of_floats(scara: Robot) -> None:
    """Exact angles stay exact, lengths become metres."""
    assert numbers(joint_values(scara, "90°, 0.5, 120mm")) == {
        "theta1": degrees(90),
        "theta2": radians("0.5"),
        "d3": 0.12,
    }


def test_symbolic_puts_in_exactly_what_is_given(scara: Robot) -> None:
    """One joint and one length become numbers, the rest stays."""
    pose = symbolic(scara, "theta1=90°", parameters={"l1": 0})
    assert [str(entry) for entry in pose.position] == ["-l2 - l3*c2", "-l3*s2", "-d3"]
    assert str(symbolic(load_robot("puma560"), "theta4=0", parameters={"a3": 0, "d3": "150 mm"}).rows[0][3]) == (
        "c1*(a2*c2 - d4*s23) - 0.15*s1"
    )


@pytest.mark.parametrize("name", list_robots())
def test_what_a_file_says_is_there_in_numbers(name: str) -> None:
    """Limits and named poses as arrays of radians and metres, and exact ones shown as they are written."""
    robot = load_robot(name)
    bounds = limits_of(robot)
    assert bounds.shape == (len(robot.variables), 2)
    for variable, row in zip(robot.variables, bounds, strict=True):
        texts = tuple(map(str, robot.limits.get(variable, ())))
        read = [
            in_numbers(robot, dict.fromkeys(robot.variables, text))[robot.variables.index(variable)] for text in texts
        ]
        assert row.tolist() == (read or [-math.inf, math.inf])
        assert repr(robot.limits.get(variable, ())) == f"({', '.join(texts)})"
    for pose, values in robot.poses.items():
        written = dict(zip(robot.variables, map(str, values), strict=True))
        assert in_numbers(robot, pose).tolist() == in_numbers(robot, written).tolist()
        assert forward(robot, in_numbers(robot, pose)).matrix == pytest.approx(forward(robot, pose).matrix, abs=1e-12)


def test_numbers_of_what_is_no_robot_are_refused() -> None:
    """A name is none, and a joint without a value has none."""
    with pytest.raises(DhcliError, match="a Robot is wanted, not 'puma560'"):
        limits_of("puma560")  # type: ignore[arg-type]
    with pytest.raises(DhcliError, match="a Robot is wanted, not 'puma560'"):
        in_numbers("puma560", [0])  # type: ignore[arg-type]
    with pytest.raises(DhcliError, match="no value for theta2"):
        in_numbers(load_robot("planar-2r"), {"theta1": 1})
