"""Numbers behind their names: the name says where a number belongs, in whatever order they stand."""

from __future__ import annotations

from functools import cache
from itertools import permutations
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.exercise import Exercise
from dhcli.checking.kinds.made import question_about
from dhcli.checking.named import XYZ, in_order
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.files.yaml.robots import load_robot
from dhcli.notation.angle import Angle
from dhcli.notation.scope import OPEN
from tests.judging import checked, judge_of

GIVEN: dict[str, tuple[Any, ...]] = {
    "planar-2r": (Angle.in_degrees(30), Angle.in_degrees(45)),
    "articulated": (Angle.in_degrees(30), Angle.in_degrees(50), Angle.in_degrees(-20)),
}
LISTS = [
    ("articulated", "position of pose 0..3", ("x", "y", "z")),
    ("articulated", "position of pose 0..3", ("p_x", "p_y", "p_z")),
    ("articulated", "position of pose 0..3", (r"p_{x}", r"p_{y}", r"p_{z}")),
    ("articulated", "velocity of 0..3 with rates (0.2, 0.1, -0.3)", ("v_x", "v_y", "v_z")),
    ("articulated", "velocity of 0..3 with rates (0.2, 0.1, -0.3)", ("ẋ", "ẏ", "ż")),
    ("articulated", "velocity of 0..3 with rates (0.2, 0.1, -0.3)", (r"\dot x", r"\dot{y}", r"\dot{z}")),
    ("articulated", "torques for (3, 5, 20) of 0..3", ("tau1", "tau2", "tau3")),
    ("articulated", "torques for (3, 5, 20) of 0..3", ("τ_1", "τ_2", "τ_3")),
    ("articulated", "joint rates for (0.1, 0.2, 0.3) of 0..3", ("theta1'", "theta2'", "theta3'")),
    ("articulated", "joint rates for (0.1, 0.2, 0.3) of 0..3", (r"\dot{\theta}_1", r"\dot{\theta}_{2}", r"\dot q_3")),
    ("articulated", "joint rates for (0.1, 0.2, 0.3) of 0..3", ("dθ1/dt", "dθ2/dt", "dθ3/dt")),
    ("articulated", "column 1 of jacobian linear of 0..3", ("J11", "J21", "J31")),
    ("articulated", "column 2 of jacobian of 0..3", ("vx", "vy", "vz", "wx", "ω_y", "omega_z")),
    ("planar-2r", "rpy of rotation from rpy(10°, 20°, 30°)", ("roll", "pitch", "yaw")),
    ("planar-2r", "rpy of rotation from rpy(10°, 20°, 30°)", ("Roll", "Pitch", "Yaw")),
    ("planar-2r", "euler zyz of rotation from rpy(10°, 20°, 30°)", ("φ", "θ", "ψ")),
    ("planar-2r", "quaternion of rotation from rpy(10°, 20°, 30°)", ("qw", "qx", "qy", "qz")),
    ("planar-2r", "quaternion of rotation from rpy(10°, 20°, 30°)", ("q0", "q1", "q2", "q3")),
]


@cache
def asked(robot: str, ask: str) -> Exercise:
    """A question in numbers."""
    arm = load_robot(robot)
    return question_about(arm, ask, numeric=True, given=dict(zip(arm.variables, GIVEN[robot], strict=True)))


def told(ask: str, answer: str, robot: str = "planar-2r") -> Mark:
    """What is said of an answer."""
    exercise = asked(robot, ask)
    return checked(exercise, exercise.parts[0], answer)


def numbers_of(robot: str, ask: str) -> list[str]:
    """The right numbers as they may be typed."""
    exercise = asked(robot, ask)
    text = judge_of(exercise).expected(exercise.parts[0])
    return [number.strip("[] ") for number in text.split(",")]


@pytest.mark.parametrize(("robot", "ask", "names"), LISTS)
@given(data=st.data())
def test_the_order_of_named_numbers_does_not_matter(
    robot: str, ask: str, names: tuple[str, ...], data: st.DataObject
) -> None:
    """Each name before its own number is right in every order; a name before the number of another is not."""
    numbers = numbers_of(robot, ask)
    order = data.draw(st.permutations(range(len(names))))
    pieces = [f"{names[k]} = {numbers[k]}" for k in order]
    between = data.draw(st.sampled_from((", ", "; ", "\n", " ")))
    assert told(ask, between.join(pieces), robot).verdict is Verdict.RIGHT
    one, two = data.draw(st.sampled_from([(i, k) for i in order for k in order if numbers[i] != numbers[k]]))
    called = [names[{one: two, two: one}.get(k, k)] for k in order]
    swapped = [f"{name} = {numbers[k]}" for name, k in zip(called, order, strict=True)]
    assert told(ask, between.join(swapped), robot).verdict in (Verdict.WRONG, Verdict.CLOSE)


@pytest.mark.parametrize(
    "answer",
    [
        "yaw 30°, pitch 20, roll 10",
        "roll 10 pitch 20 yaw 30",
        "roll 10°\npitch 20°\nyaw 30°",
        "the yaw is 30°, the pitch is 20° and the roll is 10°",
        "(yaw, pitch, roll) = (30°, 20°, 10°)",
        "[roll, pitch, yaw]^T = [10°, 20°, 30°]",
        "Rz = 30, Ry = 20, Rx = 10",
        "yaw: 30; pitch: 20; roll: 10",
    ],
)
def test_names_are_read_as_people_write_them(answer: str) -> None:
    """Without a sign, with words between them, as a list before that of the numbers."""
    assert told("rpy of rotation from rpy(10°, 20°, 30°)", answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize("answer", ["60°, (0, 0, 1)", "angle = 60°, axis = (0, 0, 1)", "θ = pi/3; k = [0; 0; 1]"])
def test_an_angle_may_stand_before_its_axis(answer: str) -> None:
    """A bracket of three is the axis, wherever it stands."""
    assert told("axis-angle of rotation from Rot([0, 0, 1], 60°)", answer).verdict is Verdict.RIGHT


def test_a_rotation_vector_may_be_in_degrees_where_it_says_so() -> None:
    """A number that writes its unit is believed."""
    ask = "rotation-vector of rotation from Rot([0, 0, 1], 60°)"
    assert told(ask, "0, 0, 60°").verdict is Verdict.RIGHT
    assert told(ask, "0, 0, 60").verdict is Verdict.WRONG


@pytest.mark.parametrize(
    ("answer", "remark"), [("x = 1, y = 2, x = 3", "x stands there twice"), ("y = 1, z = 2", "x is missing")]
)
def test_a_name_that_is_missing_or_stands_twice_is_told(answer: str, remark: str) -> None:
    """Nobody can say where the numbers belong."""
    mark = told("position of pose 0..2", answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert mark.remarks == (remark,)


def test_a_jacobian_is_read_entry_by_entry() -> None:
    """In any order; one that lacks is told."""
    ask = "jacobian linear of 0..2"
    rows = [
        row.split(", ")
        for row in judge_of(asked("planar-2r", ask)).expected(asked("planar-2r", ask).parts[0])[2:-2].split("], [")
    ]
    entries = [f"J_{{{r + 1}{c + 1}}} = {entry}" for r, row in enumerate(rows) for c, entry in enumerate(row)]
    assert told(ask, ", ".join(reversed(entries))).verdict is Verdict.RIGHT
    assert (
        told(
            ask, "\n".join(entries).replace("J_{11}", "J_{1}").replace("J_{12}", "J_{11}").replace("J_{1}", "J_{12}")
        ).verdict
        is Verdict.WRONG
    )
    assert told(ask, "; ".join(entries[1:])).remarks == ("entry (1,1) is missing",)


def test_names_of_an_arm_are_factors_and_not_labels() -> None:
    """`d3 2` is a product where there is a d3, and so is a formula that begins with a function."""
    for text in ("d3 2, x 3", "cos 1, sin 2, 3", "2, 3, 4", "x1 = x2", ""):
        assert in_order(text, (XYZ,), OPEN) == text


def test_every_order_of_three_gives_the_same_list() -> None:
    """The law behind it."""
    for order in permutations(range(3)):
        text = ", ".join(f"{'xyz'[k]}={k},5" for k in order)
        assert in_order(text, (XYZ,), OPEN) == "0,5; 1,5; 2,5"


FIRST, WHOLE, SPACE = "column 1 of jacobian of 0..2", "jacobian of 0..2", "column 1 of jacobian space of 0..2"
LINEAR, ANGULAR = "-a1*s1 - a2*s12, a1*c1 + a2*c12, 0", "0, 0, 1"
UPPER, LOWER = "-a1*s1-a2*s12 -a2*s12; a1*c1+a2*c12 a2*c12; 0 0", "0 0; 0 0; 1 1"


@pytest.mark.parametrize(
    ("ask", "answer", "verdict"),
    [
        (FIRST, f"v = ({LINEAR}), ω = ({ANGULAR})", Verdict.RIGHT),
        (FIRST, f"ω = ({ANGULAR})\nv = ({LINEAR})", Verdict.RIGHT),
        (FIRST, f"J_w = [{ANGULAR.replace(',', ';')}]; J_v = [{LINEAR.replace(',', ';')}]", Verdict.RIGHT),
        (FIRST, f"ω = ({LINEAR}), v = ({ANGULAR})", Verdict.WRONG),
        (FIRST, f"v = ({LINEAR}), v = ({ANGULAR})", Verdict.CANNOT_READ),
        (SPACE, "ω = (0, 0, 1), v = (0, 0, 0)", Verdict.RIGHT),
        (SPACE, "v = [0 0 0]^T, ω = [0 0 1]^T", Verdict.RIGHT),
        (SPACE, "v = (0, 0, 1), ω = (0, 0, 0)", Verdict.WRONG),
        (WHOLE, f"Jv = [{UPPER}], Jw = [{LOWER}]", Verdict.RIGHT),
        (WHOLE, f"Jω = [{LOWER}]\nJv = [{UPPER}]", Verdict.RIGHT),
        (WHOLE, f"Jω = [{UPPER}]\nJv = [{LOWER}]", Verdict.WRONG),
        (
            WHOLE,
            "J_v = [[-a1*s1-a2*s12, -a2*s12], [a1*c1+a2*c12, a2*c12], [0, 0]]; J_w = [[0, 0], [0, 0], [1, 1]]",
            Verdict.RIGHT,
        ),
        ("position of pose 0..2", "p1 = (1, 2, 3), p2 = (a1*c1 + a2*c12, a1*s1 + a2*s12, 0)", Verdict.CANNOT_READ),
        ("rotation of pose 0..2", "A = [1 0 0; 0 1 0; 0 0 1]; R = [c12 -s12 0; s12 c12 0; 0 0 1]", Verdict.CANNOT_READ),
        (
            "rotation of pose 0..2",
            "R = A B = [c1 -s1 0; s1 c1 0; 0 0 1] [c2 -s2 0; s2 c2 0; 0 0 1] = [c12 -s12 0; s12 c12 0; 0 0 1]",
            Verdict.RIGHT,
        ),
    ],
)
def test_halves_of_a_jacobian_stand_where_their_names_say(ask: str, answer: str, verdict: Verdict) -> None:
    """One above the other, whichever is written first; two answers with names of their own are none."""
    exercise = question_about(load_robot("planar-2r"), ask, numeric=False, given={})
    assert checked(exercise, exercise.parts[0], answer).verdict is verdict
