"""Robots: every rule that a description can break, and what a valid one knows of itself."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction
from typing import Any

import pytest

from dhcli import forward_batch, sweep
from dhcli.checking.written import answer_scope
from dhcli.errors import RobotError, UnknownNameError
from dhcli.files.yaml.robots import load_robot
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.forward import forward, symbolic
from dhcli.kinematics.frames import between, ends, frame
from dhcli.kinematics.moves import Fixed, inverse, read_chain
from dhcli.kinematics.robot import Link, Robot
from dhcli.kinematics.validity import InvalidRobotError
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle
from dhcli.notation.tree import number
from tests.row_by_row import row_by_row

METRE = number(1)


def link(number_: int, a: str, alpha: str, d: str, theta: str) -> Link:
    """A row of a standard table."""
    row = Row(parse(a), to_angle(parse(alpha)), parse(d), to_angle(parse(theta)))
    return Link(number_, moves_of(row, Convention.STANDARD), row)


def robot(**changes: Any) -> Robot:  # noqa: ANN401
    """An arm that turns and slides, with something changed."""
    description: dict[str, Any] = {
        "name": "arm",
        "title": "An arm",
        "source": "made up",
        "convention": Convention.STANDARD,
        "variables": ("theta1", "d2"),
        "links": (link(1, "a1", "90°", "0", "theta1"), link(2, "0", "0", "d2", "0")),
        "parameters": {"a1": METRE},
    }
    return Robot(**{**description, **changes})


def product(*texts: str, **changes: Any) -> Robot:  # noqa: ANN401
    """The same arm as products of moves."""
    links = tuple(Link(i, read_chain(text), None, text) for i, text in enumerate(texts, 1))
    return robot(convention=Convention.PRODUCT, links=links, **changes)


def findings(**changes: Any) -> list[str]:  # noqa: ANN401
    """What is wrong with a robot, as `where: message (hint)`."""
    with pytest.raises(InvalidRobotError) as caught:
        robot(**changes)
    return told(caught.value)


def told(error: InvalidRobotError) -> list[str]:
    """The findings of an error as text."""
    return [f"{'.'.join(map(str, f.where))}: {f.message}" + f" ({f.hint})" * bool(f.hint) for f in error.findings]


def test_a_right_robot_exists() -> None:
    """The description that the others spoil."""
    arm = robot()
    assert [(joint.name, joint.kind, joint.link) for joint in arm.joints] == [
        ("theta1", "revolute", 1),
        ("d2", "prismatic", 2),
    ]
    assert (arm.pattern, arm.frames) == ("RP", ("base", "0", "1", "2", "tool"))
    usual = {"t1": "theta1", "th1": "theta1", "D2": "d2", "A1": "a1"}
    assert arm.scope.aliases == {"q1": "theta1", "q2": "d2", **usual}


def test_beside_a_t1_that_is_no_angle_t2_is_none() -> None:
    """A time, or a thickness; and where lengths are called A1 too, A2 is not a2."""
    arm = robot(parameters={"a1": METRE, "t3": METRE, "A7": METRE})
    assert arm.scope.aliases == {"q1": "theta1", "q2": "d2", "th1": "theta1", "D2": "d2", "T3": "t3"}
    assert {"t1", "A1"}.isdisjoint(answer_scope(robot(), ("t", "A")).aliases)


@row_by_row(
    ("changes", "expected"),
    [
        (
            {"parameters": {"a1": METRE, "pi": METRE}},
            "parameters.pi: pi has a meaning of its own (choose another name)",
        ),
        (
            {"parameters": {"a1": METRE, "mm": METRE}},
            "parameters.mm: mm has a meaning of its own (choose another name)",
        ),
        ({"parameters": {"a1": METRE, "a_1": METRE}}, "parameters.a_1: a_1 is used twice (a1 is declared already)"),
        (
            {"parameters": {"a1": METRE, "theta_1": None}},
            "parameters.theta_1: theta_1 is used twice (theta1 is declared already)",
        ),
        ({"parameters": {"a2": METRE}}, "links.0: a1 is not declared (did you mean theta1 or a2?)"),
        (
            {"variables": ("theta1", "d2", "d9")},
            "variables.2: d9 moves no link (use it in a row, or make it a parameter)",
        ),
        (
            {"links": (link(1, "a1", "90°", "d2", "theta1"),)},
            "links.0: one link has two variables, theta1 and d2 (give each joint a link of its own)",
        ),
        (
            {"links": (link(1, "a1", "0", "d2", "0"), link(2, "0", "0", "d2", "0"))},
            "links.1: d2 is used twice (it moves link 1 already)",
        ),
        (
            {"links": (link(1, "a1", "0", "0", "theta1"), link(2, "0", "0", "d2^2", "0"))},
            "links.1.d: d2^2 is not affine in d2 (write a multiple of d2 plus a constant)",
        ),
        (
            {"links": (link(1, "a1", "0", "0", "theta1"), link(2, "0", "0", "1/d2", "0"))},
            "links.1.d: 1/d2 is not affine in d2 (write a multiple of d2 plus a constant)",
        ),
        (
            {"links": (link(1, "theta1", "0", "0", "theta1"), link(2, "a1", "0", "d2", "0"))},
            (
                "links.0.a: theta1 stands for an angle and for a length"
                " (a joint turns or slides; a screw has a lead: p*theta1)"
            ),
        ),
        (
            {"links": (link(1, "a1", "0", "sqrt(-1)", "theta1"), link(2, "0", "0", "d2", "0"))},
            "links.0: sqrt(-1) is not a real number",
        ),
        (
            {"base": read_chain("Rot(z, theta1)")},
            "base: theta1 is a joint variable, and base does not move (make it a link)",
        ),
        ({"tool": read_chain("Trans(0, 0, a2)")}, "tool: a2 is not declared (did you mean a1?)"),
        (
            {"base": read_chain("[1 0 0 0; 0 2 0 0; 0 0 1 0; 0 0 0 1]")},
            (
                "base: column 2 is not a unit vector"
                " (its first three columns must be perpendicular unit vectors, right-handed)"
            ),
        ),
        (
            {"limits": {"theta9": (Angle(), Angle())}},
            "limits.theta9: theta9 is not a joint variable (did you mean theta1?)",
        ),
        (
            {"limits": {"theta1": (Angle(), Angle())}},
            "limits.theta1: the lower limit is not below the upper one (write [lowest, highest])",
        ),
        (
            {"limits": {"theta1": (number(0), number(1))}},
            "limits.theta1: theta1 turns, and 0 is not an angle (write 90° or 1.57 rad)",
        ),
        (
            {"limits": {"d2": (Angle(), Angle.in_degrees(9))}},
            "limits.d2: d2 slides, and an angle is no length (write 300 mm or 0.3 m)",
        ),
        ({"poses": {"up": (Angle(),)}}, "poses.up: 1 value for 2 joints (one for each of theta1, d2)"),
        (
            {"poses": {"up": (number(1), number(1))}},
            "poses.up: theta1 turns, and 1 is not an angle (write 90° or 1.57 rad)",
        ),
        (
            {"poses": {"up": (Angle(), Angle.in_degrees(90))}},
            "poses.up: d2 slides, and an angle is no length (write 300 mm or 0.3 m)",
        ),
    ],
)
def test_a_broken_rule_is_found(changes: dict[str, Any], expected: str) -> None:
    """Each rule once: where, what, and what would be right."""
    assert expected in findings(**changes)


def test_all_broken_rules_are_told_at_once() -> None:
    """Not one after the other."""
    found = findings(parameters={"a2": METRE}, tool=read_chain("Trans(0, 0, b)"), limits={"d3": (Angle(), Angle())})
    assert [text.split(":")[0] for text in found] == ["links.0", "tool", "limits.d3"]


@pytest.mark.parametrize("name", ["scara", "puma560", "stanford"])
def test_a_robot_can_be_copied_and_sent_to_another_process(name: str) -> None:
    """Equal to itself, and with mappings that cannot be changed."""
    arm = load_robot(name)
    for other in (copy.deepcopy(arm), pickle.loads(pickle.dumps(arm))):  # noqa: S301  our own
        assert other == arm
        with pytest.raises(TypeError):
            other.parameters["a1"] = METRE  # type: ignore[index]


def test_an_offset_a_sign_and_a_factor_are_affine() -> None:
    """`theta1/2 + 90°` and `2*d2 - a1` are joints like any other."""
    arm = robot(links=(link(1, "0", "0", "a1", "theta1/2 + 90°"), link(2, "0", "0", "2*d2 - a1", "0")))
    assert [joint.kind for joint in arm.joints] == ["revolute", "prismatic"]


def test_a_product_may_hold_several_moves_of_one_joint() -> None:
    """Two sliding parts that one variable moves."""
    assert product("Rot(z, theta1)", "Trans(d2, 0, 0) Rot(x, 90°) Trans(0, d2, a1)").pattern == "RP"
    with pytest.raises(InvalidRobotError) as caught:
        product("Rot(z, theta1)", "Trans(d2^2, 0, a1)")
    assert told(caught.value) == ["links.1: d2^2 is not affine in d2 (write a multiple of d2 plus a constant)"]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("[1 0 0 5; 0 1 0 6; 0 0 1 7; 0 0 0 1]", ""),
        ("[0.866 -0.5 0 0; 0.5 0.866 0 0; 0 0 1 0; 0 0 0 1]", ""),
        ("[√3/2 -1/2 0 0; 1/2 √3/2 0 0; 0 0 1 0; 0 0 0 1]", ""),
        ("[cos(phi) -sin(phi) 0 0; sin(phi) cos(phi) 0 0; 0 0 1 0; 0 0 0 1]", ""),
        ("[0.85 -0.5 0 0; 0.5 0.85 0 0; 0 0 1 0; 0 0 0 1]", "column 1 is not a unit vector"),
        ("[cos(phi) sin(phi) 0 0; sin(phi) cos(phi) 0 0; 0 0 1 0; 0 0 0 1]", "columns 1 and 2 are not perpendicular"),
        ("[1 0 0 0; 0 1 0 0; 0 0 -1 0; 0 0 0 1]", "the columns are left-handed"),
        ("[0 1 0 0; 1 0 0 0; 0 0 1 0; 0 0 0 1]", "the columns are left-handed"),
    ],
)
def test_a_matrix_that_is_no_rotation_says_why(text: str, fault: str) -> None:
    """In words; three decimals are near enough, symbols must hold for all values."""
    (move,) = read_chain(text)
    assert isinstance(move, Fixed)
    assert not_a_rotation(move.rows) == fault


def test_the_lists_of_a_robot_cannot_be_changed() -> None:
    """A robot that exists stays valid."""
    arm = robot()
    with pytest.raises(TypeError):
        arm.parameters["a1"] = None  # type: ignore[index]
    with pytest.raises(AttributeError):
        arm.name = "other"  # type: ignore[misc]


def test_frames_have_the_numbers_of_their_links() -> None:
    """The wrist's links are 4, 5, 6, so its frames are 3 to 6."""
    wrist = load_robot("spherical-wrist")
    assert wrist.frames == ("base", "3", "4", "5", "6", "tool")
    assert ends(wrist, None, None) == ("3", "6")
    assert (frame(wrist, 4), frame(wrist, " TOOL ")) == ("4", "tool")
    assert {alias for alias, name in wrist.scope.aliases.items() if name == "theta4"} == {"q4", "t4", "th4"}


@pytest.mark.parametrize("name", [7, "2", "x", "", -1])
def test_a_frame_that_is_not_there_names_those_that_are(name: str | int) -> None:
    """All of them."""
    with pytest.raises(UnknownNameError, match=f"spherical-wrist has no frame {name} ") as caught:
        frame(load_robot("spherical-wrist"), name)
    assert caught.value.problems[0].hint == "frames: base, 3, 4, 5, 6, tool"


def test_base_and_tool_are_reached_by_their_names_only() -> None:
    """0 to n by default; 0T7 of the 6R arm is the pose of its tool."""
    arm = load_robot("zhou-6r")
    assert symbolic(arm).frame == "6"
    assert symbolic(arm, end="tool").name == "T_{0,tool}"
    assert between(arm, "6", "tool") == arm.tool
    based = robot(base=read_chain("Trans(0, 0, a1)"))
    assert str(symbolic(based, start="base", end=0).rows[2][3]) == "a1"
    assert symbolic(based).rows[2][3] == number(0)


def test_backwards_is_the_inverse() -> None:
    """From a later frame to an earlier one."""
    arm = load_robot("puma560")
    assert between(arm, "6", "0") == inverse(between(arm, "0", "6"))
    there, back = forward(arm, "ready"), forward(arm, "ready", start=6, end=0)
    for row, wanted in zip((there @ back).rows, ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)), strict=True):
        assert row == pytest.approx(wanted, abs=1e-12)


def test_frames_between_frames_cancel() -> None:
    """T_13 = T_12 T_23: the moves are those of the two parts."""
    arm = load_robot("puma560")
    assert between(arm, "1", "3") == (*between(arm, "1", "2"), *between(arm, "2", "3"))
    assert between(arm, "2", "2") == ()


def test_an_arm_of_halves_keeps_them_exact() -> None:
    """theta1/2 stays a fraction of an angle."""
    arm = robot(links=(link(1, "a1", "0", "0", "theta1/2"), link(2, "0", "0", "d2", "0")))
    assert symbolic(arm, {"theta1": Angle.in_degrees(120)}).rows[0][0] == number(Fraction(1, 2))


def test_a_robot_shows_itself_in_one_line_and_may_be_a_key() -> None:
    """Equal ones are one key."""
    arm = load_robot("puma560")
    assert repr(arm) == "<Robot puma560: PUMA 560, modified DH, 6 joints RRRRRR>"
    assert {arm: 1}[load_robot("puma560")] == 1
    assert len({arm, load_robot("scara"), load_robot("scara")}) == 2


@pytest.mark.parametrize("ask", [forward, symbolic, lambda robot: forward_batch(robot, []), sweep])
def test_a_name_is_no_robot(ask: Any) -> None:  # noqa: ANN401
    """And the hint says how to get one."""
    with pytest.raises(RobotError, match=r"a Robot is wanted, not 'scara' \(load_robot\('scara'\) loads one\)"):
        ask("scara")
