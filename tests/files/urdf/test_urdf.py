"""URDF read and written: against the XML walked by numpy alone, and against what other programs make of it."""

from __future__ import annotations

import math
import random
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from dhcli.errors import DhcliError, FileError, RobotError
from dhcli.files.urdf.numbers import round_degrees
from dhcli.files.urdf.robots import read_urdf
from dhcli.files.urdf.writing import urdf_text
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.files.yaml.writing import described_text
from dhcli.kinematics.describe.asked import Asked, Form
from dhcli.kinematics.describe.description import describe
from dhcli.kinematics.forward import forward
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values
from tests.coupled import COUPLED
from tests.nightly import NIGHT
from tests.row_by_row import row_by_row

DATA = Path(__file__).parents[2] / "data" / "urdf"
THREE = (DATA / "three-joints.urdf").read_text("utf-8")
ROBOTS = sorted(path.stem for path in (Path(__file__).parents[3] / "robots").glob("*.yaml"))
EXPORTED = [name for name in ROBOTS if not name.startswith("dh-link") and name not in ("assembly-blocks", *COUPLED)]


def turned(axis: np.ndarray, angle: float) -> np.ndarray:
    """Rodrigues' formula as a 4x4 matrix."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    pose = np.eye(4)
    pose[:3, :3] += math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    return pose


def placed(xyz: list[float], rpy: list[float]) -> np.ndarray:
    """Where an origin puts a frame."""
    roll, pitch, yaw = rpy
    x, y, z = np.eye(3)
    pose = turned(z, yaw) @ turned(y, pitch) @ turned(x, roll)
    pose[:3, 3] = xyz
    return pose


def walked(text: str, tip: str, q: list[float]) -> np.ndarray:
    """The pose of a link, from the numbers as they stand in the XML."""
    joints = {joint.find("child").get("link"): joint for joint in ET.fromstring(text).iter("joint")}  # noqa: S314
    way = []
    while tip in joints:
        way.insert(0, joints[tip])
        tip = joints[tip].find("parent").get("link")
    pose, values = np.eye(4), iter(q)
    for joint in way:
        origin, axis = joint.find("origin"), joint.find("axis")
        given = {} if origin is None else origin.attrib
        three = [[float(x) for x in given.get(key, "0 0 0").split()] for key in ("xyz", "rpy")]
        pose = pose @ placed(*three)
        about = np.array([float(x) for x in (axis.get("xyz") if axis is not None else "1 0 0").split()])
        kind = joint.get("type")
        if kind in ("revolute", "continuous"):
            pose = pose @ turned(about, next(values))
        elif kind == "prismatic":
            pose[:3, 3] += pose[:3, :3] @ (about / np.linalg.norm(about)) * next(values)
    return pose


def drawn_urdf(draw: random.Random, count: int) -> str:
    """A chain with joints of all kinds, axes anywhere, numbers with all digits."""
    lines = ['<robot name="drawn"><link name="l0"/>']
    for k in range(1, count + 1):
        kind = draw.choice(("revolute", "continuous", "prismatic", "fixed")) if k > 1 else "revolute"
        xyz, axis = ([draw.uniform(-1, 1) for _ in range(3)] for _ in range(2))
        rpy = [draw.uniform(-3, 3) for _ in range(3)]
        if draw.random() < 0.5:
            axis = list(draw.choice(((0, 0, 1), (1, 0, 0), (0, -1, 0), (0, 0, -2))))
        said = ["{!r} {!r} {!r}".format(*three) for three in (xyz, rpy, axis)]
        lines.append(
            f'<link name="l{k}"/><joint name="j{k}" type="{kind}"><parent link="l{k - 1}"/><child link="l{k}"/>'
            f'<origin xyz="{said[0]}" rpy="{said[1]}"/><axis xyz="{said[2]}"/>'
            '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        )
    return "".join([*lines, "</robot>"])


@pytest.mark.parametrize("seed", range(25 if NIGHT else 10))
def test_a_drawn_chain_moves_as_its_xml_says(seed: int) -> None:
    """To 1e-14 of its size, and as a table to 1e-12."""
    draw = random.Random(seed)  # noqa: S311  the same chains every time
    text = drawn_urdf(draw, 7)
    robot = read_urdf(text, "drawn.urdf", "drawn")
    q = [draw.uniform(-1, 1) for _ in robot.variables]
    expected = walked(text, "l7", q)
    assert np.abs(forward(robot, q).matrix - expected).max() < 1e-13
    table = describe(robot, Asked("standard", steps=True))
    assert np.abs(forward(table.robot, q, start="base", end="tool").matrix - expected).max() < 1e-11


def test_typed_right_angles_are_right_angles_and_can_be_kept() -> None:
    """By how much the tip moves is said, and is true."""
    robot = load_robot(DATA / "three-joints.urdf", tip="tool0")
    assert robot.remarks[0].startswith(
        "taken for multiples of 15°: 3 of 12 angles (1.5708 -> 90°); the tip moves by at most "
    )
    typed = load_robot(DATA / "three-joints.urdf", tip="tool0", as_typed=True)
    q = [0.3, -1.1, 0.5]
    assert np.abs(forward(typed, q).matrix - walked(THREE, "tool0", q)).max() < 1e-15
    gap = np.linalg.norm(np.subtract(forward(robot, q).position, forward(typed, q).position))
    assert 0 < gap < 11e-6


def test_limits_and_names_of_joints_are_kept() -> None:
    """A continuous joint has no limits."""
    robot = load_robot(DATA / "three-joints.urdf", tip="tool0")
    assert robot.variables == ("theta1", "theta2", "d3")
    assert set(robot.limits) == {"theta1", "d3"}
    assert robot.called == {"theta1": "shoulder", "theta2": "elbow", "d3": "slide"}


def test_joints_have_the_names_of_the_file_too() -> None:
    """Before all others: a joint called q1 is that joint, and not the first one."""
    robot = load_robot(DATA / "three-joints.urdf", tip="tool0")
    named = forward(robot, {"slide": 0.2, "elbow": -1.1, "shoulder": 0.3})
    assert named.rows == forward(robot, [0.3, -1.1, 0.2]).rows
    other = read_urdf(THREE.replace('name="slide"', 'name="q1"'), "x", "x", tip="tool0")
    assert joint_values(other, "q1=0.2") == joint_values(other, "d3=0.2")
    for wrong, hint in (("elbw", "did you mean elbow"), ("thta2", "did you mean theta2"), ("foo", "known: theta1")):
        with pytest.raises(RobotError, match=f"no joint {wrong} .*{hint}"):
            joint_values(robot, f"{wrong}=0.2")


def test_no_variable_has_the_name_of_another_joint() -> None:
    """`theta1=0.3` would be the second joint, by its name, and is the first variable."""
    text = THREE.replace('"shoulder"', '"turret_axis"').replace('"elbow"', '"theta1"')
    robot = read_urdf(text, "x", "x", tip="tool0")
    assert robot.called == {"phi1": "turret_axis", "phi2": "theta1", "s3": "slide"}
    assert (
        forward(robot, {"turret_axis": 0.3, "theta1": -1.1, "slide": 0.2}).rows == forward(robot, [0.3, -1.1, 0.2]).rows
    )


@pytest.mark.parametrize("form", ["standard", "modified", "axes", "screws", "body-screws", "product"])
def test_a_description_keeps_the_names_of_the_joints(form: Form) -> None:
    """Through a file, and on to a URDF."""
    robot = load_robot(DATA / "three-joints.urdf", tip="tool0")
    again = read_robot(described_text(describe(robot, Asked(form))), "x", "arm")
    assert again.called == robot.called
    assert joint_values(again, "elbow=0.2") == joint_values(again, "theta2=0.2")
    assert [name for name in ("shoulder", "elbow", "slide") if f'<joint name="{name}"' not in urdf_text(again)] == []


def test_names_of_joints_that_mean_two_are_told() -> None:
    """Where a file says them; each with its line."""
    file = (
        "format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [q1, q2, q3]\ncalled:\n"
        "  q1: elbow\n  q2: elbow\n  q3: q1\n  q4: wrist\nlinks: ['Rot(z, q1)', 'Rot(y, q2)', 'Rot(z, q3)']\n"
    )
    with pytest.raises(FileError) as caught:
        read_robot(file, "f", "arm")
    assert str(caught.value).splitlines() == [
        "f:8:3: q2: elbow would be q2 and q1 (give each joint a name of its own)",
        "f:9:3: q3: q1 would be q3 and q1 (give each joint a name of its own)",
        "f:10:3: called: q4 is not a joint variable (did you mean q3 or q2 or q1?)",
    ]


def test_a_rounded_turn_at_the_tip_is_told_by_the_turn() -> None:
    """It moves the tip by nothing, and turns it."""
    robot = read_urdf(
        with_change("3.1416", "3.14").replace("1.5708", "0.3").replace("1.57079", "0.3"), "x", "x", tip="tool0"
    )
    (remark,) = robot.remarks
    assert "1 of 12 angles (3.14 -> 180°)" in remark
    assert [*warnings(robot, {})] == [remark]


def test_another_base_and_tip_are_another_chain() -> None:
    """From the upper arm to the camera."""
    robot = load_robot(DATA / "three-joints.urdf", base="upper", tip="camera")
    whole = walked(THREE, "camera", [0.0, 0.4, 0.2])
    above = walked(THREE, "upper", [0.0])
    assert np.abs(forward(robot, [0.4, 0.2]).matrix - np.linalg.inv(above) @ whole).max() < 1e-4


@row_by_row(
    ("text", "degrees"),
    [
        ("1.5708", 90),
        ("-1.57", -90),
        ("3.14", 180),
        ("3.14159265", 180),
        ("0.7854", 45),
        ("1.57079", 90),
        ("0.2618", 15),
        ("1.5", None),
        ("0.26", None),
        ("0.1", None),
        ("1.571", 90),
        ("1.6", None),
        ("1.57079632679e0", 90),
    ],
)
def test_only_what_was_typed_as_a_round_angle_is_taken_for_one(text: str, degrees: int | None) -> None:
    """Within the last digit, and never far."""
    assert round_degrees(text) == degrees


@row_by_row("name", EXPORTED)
def test_a_written_urdf_moves_as_the_robot(name: str) -> None:
    """Read by dhcli and walked by numpy, base to tool."""
    robot = load_robot(name)
    text = urdf_text(robot)
    draw = random.Random(name)  # noqa: S311  the same poses every time
    q = [draw.uniform(-1, 1) for _ in robot.variables]
    expected = forward(robot, q, start="base", end="tool").matrix
    order = read_urdf(text, "x.urdf", name, tip="tool0")
    chain_order = [robot.variables.index(joint) for joint in _joint_names(text)]
    ordered = [q[i] for i in chain_order]
    assert np.abs(walked(text, "tool0", ordered) - expected).max() < 1e-12
    assert np.abs(forward(order, ordered).matrix - expected).max() < 1e-12


def _joint_names(text: str) -> list[str]:
    return [joint.get("name", "") for joint in ET.fromstring(text).iter("joint") if joint.get("type") != "fixed"]  # noqa: S314


def test_a_variable_that_counts_in_other_units_is_refused() -> None:
    """A URDF has no joint that turns twice as far as its value."""
    text = (
        "format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [q1]\nlinks:\n"
        "  - Rot(z, 2*q1) * Trans(1, 0, 0)\n"
    )
    with pytest.raises(DhcliError, match="moves its joint by 2"):
        urdf_text(read_robot(text, "x", "x"))


def with_change(old: str, new: str) -> str:
    """The URDF with one thing changed."""
    assert old in THREE
    return THREE.replace(old, new, 1)


@row_by_row(
    ("text", "said"),
    [
        (THREE, "has 2 tips: which one?"),
        (with_change('type="revolute"', 'type="floating"'), "is floating, which is no joint of one variable"),
        (with_change('type="revolute"', 'type="hinge"'), "there is no type hinge (write revolute)"),
        (with_change('type="prismatic"', 'type="Linear"'), "there is no type Linear (write prismatic)"),
        (with_change('<parent link="upper"/>', '<parent link="uper"/>'), "its parent uper is no link"),
        (with_change('<parent link="upper"/>', ""), "joint elbow has no <parent link=...>"),
        (with_change('<child link="fore"/>', '<child link="base_link"/>'), "is below itself: a loop"),
        (with_change('<child link="fore"/>', '<child link="upper"/>'), "is moved by shoulder already: a loop"),
        (with_change('<link name="fore"/>', '<link name="upper"/>'), "two links called upper"),
        (with_change('xyz="0 0 0.3"', 'xyz="0 0"'), "three numbers are wanted"),
        (with_change('xyz="0 0 0.3"', 'xyz="0,0,0.25"'), "wanted, not '0,0,0.25' (write xyz=\"0 0 0.25\")"),
        (with_change('<axis xyz="0 0 1"/>', '<axis xyz="0 1"/>'), "wanted, not '0 1' (write xyz=\"0 0 1\")"),
        (with_change('rpy="0 0 0"', 'rpy="-pi/2 0 0"'), "'-pi/2' is no number (write -1.5708)"),
        (with_change('rpy="0 0 0"', 'rpy="90deg 0 0"'), "'90deg' is no number (write 1.5708)"),
        (with_change('rpy="0 0 0"', 'rpy="up 0 0"'), "rpy: 'up' is no number"),
        (with_change('xyz="0 0 0.3"', 'xyz="0 0 nan"'), "'nan' is no number"),
        (with_change('xyz="0 0 0.3"', 'xyz="0 0 ${h}"'), "this is a xacro"),
        (with_change("<robot", "<xacro:robot"), "this is a xacro"),
        (with_change('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>'), "an axis of length zero"),
        (
            with_change('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><mimic joint="shoulder"/>'),
            "shoulder, which follows it",
        ),
        (
            with_change('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><mimic joint="slide"/>'),
            "follows slide, which slides",
        ),
        (with_change('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><mimic joint="x"/>'), "not on this chain"),
        (with_change('<?xml version="1.0"?>', '<!DOCTYPE r [<!ENTITY a "b">]>'), "a DOCTYPE is not read"),
        ("<svg/>", "<svg> is no URDF"),
        ("<sdf/>", "this is an SDF"),
        ("<robot name='x'>", "is no XML: no element found (is the file cut off? <robot> has no end)"),
        ("<robot name='a&b'/>", "is &amp;"),
        ("<robot name='x'/>", "has no link"),
        ("<robot name='x'>" + "<a>" * 200 + "</a>" * 200 + "</robot>", "deeper than"),
    ],
)
def test_what_is_wrong_with_a_urdf_is_said(text: str, said: str) -> None:
    """With its line where it has one, and never a traceback."""
    tip = None if text == THREE else "tool0" if "tool0" in text else None
    with pytest.raises(FileError) as caught:
        read_urdf(text, "arm.urdf", "arm", tip=tip)
    assert said in str(caught.value)


@pytest.mark.parametrize(("limit", "is_told"), [("170", True), ("-170", True), ("18.8", False), ("1e16", False)])
def test_limits_that_are_hardly_radians_are_told(limit: str, is_told: bool) -> None:
    """Beyond three turns, unless they stand for none."""
    text = THREE.replace('lower="-3.14" upper="3.14"', f'lower="{min(0, float(limit))}" upper="{max(0, float(limit))}"')
    said = [one for one in read_urdf(text, "x", "x", tip="tool0").remarks if one.startswith("limits of shoulder: ")]
    assert bool(said) is is_told


def test_all_that_is_wrong_with_its_numbers_and_types_is_said_at_once() -> None:
    """Each at its tag, with the line."""
    text = THREE.replace('xyz="0 0 0.3"', 'xyz="0 0 0,3"').replace("continuous", "continous").replace("0.4 0 0", "0.4")
    with pytest.raises(FileError) as caught:
        read_urdf(text, "arm.urdf", "arm", tip="tool0")
    said = [(problem.message, problem.hint) for problem in caught.value.problems]
    assert said == [
        ("xyz: '0,3' is no number", "write 0.3"),
        ("joint elbow: there is no type continous", "did you mean continuous?"),
        ("xyz: three numbers are wanted, not '0.4'", 'write xyz="0 0 0.1"'),
    ]
    places = [problem.place for problem in caught.value.problems]
    assert all(place is not None and place.text[(place.column or 1) - 1] == "<" for place in places)


def test_numbers_in_degrees_and_millimetres_are_pointed_at() -> None:
    """They are read as they stand, in radians and metres."""
    robot = read_urdf(
        with_change('xyz="0 0.1 0" rpy="1.5708 0 0"', 'xyz="0 100 0" rpy="90 0 0"'), "x", "x", tip="tool0"
    )
    assert [remark for remark in robot.remarks if "elbow" in remark] == [
        "rpy of elbow: 90 is more than a turn; angles are in radians, and 90° is 1.5708",
        "xyz of elbow: 100 is longer than any arm; lengths are in metres, and 300 mm is 0.3",
    ]
    assert not any("elbow" in remark for remark in load_robot(DATA / "three-joints.urdf", tip="tool0").remarks)


def test_what_is_left_out_is_said_once_and_what_nobody_can_see_never() -> None:
    """Limits of 0 to 0, as exporters write them; right angles with all their digits."""
    text = THREE.replace('lower="-3.14" upper="3.14"', 'lower="0" upper="0"').replace('upper="0.5"', 'upper="0"')
    text = (
        text.replace("1.5708", "1.57079632679").replace("1.57079 ", "1.57079632679 ").replace("3.1416", "3.14159265359")
    )
    robot = read_urdf(text, "x", "x", tip="tool0")
    assert robot.remarks == ("the limits of shoulder, slide are left out: lower is not below upper",)
    assert list(warnings(robot, {})) == []
    assert robot.limits == {}
    bare = read_urdf(THREE.replace('lower="-3.14" upper="3.14" ', ""), "x", "x", tip="tool0")
    assert "theta1" not in bare.limits
    assert "shoulder" not in " ".join(bare.remarks)


def test_fixed_shifts_one_behind_the_other_are_one() -> None:
    """As a base on a stand; what slides stays apart."""
    text = with_change('<parent link="base_link"/>', '<parent link="stand"/>')
    stand = '<link name="stand"/><joint name="on" type="fixed"><parent link="base_link"/><child link="stand"/>'
    text = text.replace('<link name="upper"/>', stand + '<origin xyz="0.1 0 0.05"/></joint><link name="upper"/>')
    robot = read_urdf(text, "x", "x", tip="tool0")
    assert robot.links[0].product == "Trans(0.1, 0, 0.35) * Rot(z, theta1)"
    assert robot.links[2].product.count("Trans") == 3
    q = [0.3, -1.1, 0.5]
    assert np.abs(forward(robot, q).matrix - walked(text, "tool0", q)).max() < 2e-5


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ({"tip": "tool"}, "did you mean tool0"),
        ({"base": "hand", "tip": "upper"}, "upper is not below hand"),
        ({"base": "bse_link"}, "did you mean base_link"),
        ({"tip": "base_link"}, "base_link is the base itself (--tip tool0, camera)"),
    ],
)
def test_links_that_are_not_there_are_told_with_the_nearest(words: dict[str, str], said: str) -> None:
    """By name."""
    with pytest.raises(DhcliError) as caught:
        load_robot(DATA / "three-joints.urdf", **words)
    assert said in str(caught.value)


def test_a_chain_of_fixed_joints_has_its_place_too() -> None:
    """Nothing moves, and the tip is not at the base."""
    robot = load_robot(DATA / "three-joints.urdf", base="hand", tip="tool0", as_typed=True)
    above = walked(THREE, "hand", [0.0, 0.0, 0.0])
    expected = np.linalg.inv(above) @ walked(THREE, "tool0", [0.0, 0.0, 0.0])
    assert robot.variables == ()
    assert np.abs(forward(robot, []).matrix - expected).max() < 1e-12


@pytest.mark.parametrize("encoding", ["ISO-8859-1", "UTF-16", "utf-8"])
def test_names_are_read_as_they_stand_whatever_encoding_the_first_line_names(encoding: str) -> None:
    """The text was decoded before."""
    head = f'<?xml version="1.0" encoding="{encoding}"?>'
    text = THREE.replace('<?xml version="1.0"?>', head).replace('"tool0"', '"töol"')
    assert read_urdf(text, "arm.urdf", "arm", tip="töol").pattern == "RRP"


def test_a_file_of_100_mb_is_refused_unread(tmp_path: Path) -> None:
    """By its size."""
    path = tmp_path / "big.urdf"
    with path.open("wb") as stream:
        stream.seek(100_000_000)
        stream.write(b">")
    with pytest.raises(FileError, match=r"is 100 MB, more than the 20 MB"):
        load_robot(path)


def test_a_robot_file_has_no_links_to_choose_from() -> None:
    """A tip is for URDF."""
    with pytest.raises(FileError, match="only a URDF has links"):
        load_robot("scara", tip="tool0")


def test_a_robot_of_a_urdf_is_a_robot() -> None:
    """What a caller sees."""
    assert isinstance(load_robot(str(DATA / "three-joints.urdf"), tip="camera"), Robot)


ELBOW = """rpy="1.5708 0 0"/>
    <axis xyz="0 0 1"/>"""


@pytest.mark.parametrize("follower", ["elbow", "slide"])
def test_a_joint_that_follows_another_moves_with_it(follower: str) -> None:
    """By its factor and offset, with the narrower of the two limits; ik finds the variables that are left."""
    mimic = '<mimic joint="shoulder" multiplier="-0.5" offset="0.1"/>'
    if follower == "elbow":
        text = with_change(ELBOW, ELBOW + mimic + '<limit lower="-0.9" upper="1.1"/>').replace("continuous", "revolute")
    else:
        text = with_change('<axis xyz="0 0 -1"/>', f'<axis xyz="0 0 -1"/>{mimic}')
    arm, plain = read_urdf(text, "a", "a", tip="tool0"), read_urdf(THREE, "a", "a", tip="tool0")
    q = [0.15, 0.2]
    low, high = (value.constant() for value in arm.limits["theta1"])  # type: ignore[union-attr]
    if follower == "elbow":
        assert (low, high) == pytest.approx((-2, 2))
        moved = [q[0], 0.1 - 0.5 * q[0], q[1]]
    else:
        assert (low, high) == pytest.approx((-0.8, 0.2))
        moved = [q[0], q[1], 0.1 - 0.5 * q[0]]
    assert len(arm.variables) == 2
    pose = np.asarray(forward(plain, moved))
    assert np.asarray(forward(arm, q)) == pytest.approx(pose, abs=1e-15)
    assert inverse(arm, pose).nearest(q) == pytest.approx(q)


HAND = """<robot name="hand"><link name="palm"/><link name="left"/><link name="right"/><link name="tip"/>
<joint name="one" type="revolute"><parent link="palm"/><child link="left"/><axis xyz="0 0 1"/>
<limit lower="0" upper="0.8"/></joint>
<joint name="two" type="revolute"><parent link="palm"/><child link="right"/><origin xyz="0.1 0 0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1"/><mimic joint="one" multiplier="-2" offset="0.1"/></joint>
<joint name="three" type="revolute"><parent link="right"/><child link="tip"/><origin xyz="0.2 0 0"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3"/><mimic joint="one" multiplier="1" offset="0.3"/></joint></robot>"""


def test_a_finger_that_follows_the_other_one_has_a_variable_of_its_own() -> None:
    """Which is told; what follows the same finger beside the chain goes with it, one freedom as before."""
    arm = read_urdf(HAND, "hand.urdf", "hand", tip="tip")
    assert arm.variables == ("theta1",)
    assert arm.remarks == ("two follows one, which is not on this chain: it has a variable of its own",)
    for one in (0.1, 0.4):
        two, three = 0.1 - 2 * one, 0.3 + one
        wanted = [0.1 + 0.2 * np.cos(two), 0.2 * np.sin(two), 0]
        pose = np.asarray(forward(arm, [two]))
        assert pose[:3, 3] == pytest.approx(wanted, abs=1e-12)
        assert np.arctan2(pose[1, 0], pose[0, 0]) == pytest.approx(two + three)
        assert inverse(arm, pose).nearest([two]) == pytest.approx([two])


def test_numbers_typed_in_decimals_are_shown_in_decimals() -> None:
    """Of a joint that follows another, of a skew axis, and of one that slides along a diagonal; they move as before."""
    text = with_change(ELBOW, ELBOW + '<mimic joint="shoulder" multiplier="0.35" offset="0.125"/>')
    text = text.replace('<axis xyz="0 0 -1"/>', '<axis xyz="0.707107 0 -0.707107"/>')
    arm = read_urdf(text, "a", "a", tip="tool0")
    products = " ".join(link.product for link in arm.links)
    assert "0.35*theta1 + 0.125 rad" in products
    assert "sqrt(2)*d2/2" in products
    follower = '<mimic joint="slide" multiplier="2" offset="0.05"/>'
    slides = SLIDES.format(axis="0 0 1", follower=follower), SLIDES.format(axis="0.12 0.34 0.93", follower=follower)
    shown = [read_urdf(each, "a", "a") for each in slides]
    assert "2*d1 + 0.05" in shown[0].links[1].product
    along = np.array([0.12, 0.34, 0.93]) / np.linalg.norm([0.12, 0.34, 0.93])
    assert np.asarray(forward(shown[1], [0.2]))[:3, 3] == pytest.approx(0.65 * along, abs=1e-15)
    assert "sqrt" not in shown[1].links[1].product
    tilted = read_urdf(THREE.replace('<axis xyz="0 0 1"/>', '<axis xyz="0 0.6 0.8"/>', 1), "a", "a", tip="tool0")
    assert "0 -0.8 0.6 0; 0 0.6 0.8 0" in tilted.links[0].product


SLIDES = """<robot name="lift"><link name="a"/><link name="b"/><link name="c"/>
<joint name="slide" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="{axis}"/>
<limit lower="0" upper="0.3"/></joint>
<joint name="more" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="{axis}"/>
<limit lower="0" upper="0.7"/>{follower}</joint></robot>"""


LEVELLED = """
format: 1
title: An arm that keeps its hand level
source: a test
convention: product
variables: [theta1, theta2, d3]
links:
  - Rot(z, theta1)
  - Rot(x, -theta2)
  - Trans(0, d3, 0)
  - Trans(0, 0.2, 0) * Rot(x, theta2)
  - Trans(0, 0, 2*d3) * Trans(0, 0.1, 0)
"""


def test_joints_that_are_written_keep_their_order() -> None:
    """Of those that share a variable the first leads, so that values in a row mean what they meant."""
    arm = read_robot(LEVELLED, "levelled.yaml", "levelled")
    again = read_urdf(urdf_text(arm), "a.urdf", "a", tip="tool0")
    q = (0.3, 0.4, 0.2)
    assert again.pattern == arm.pattern
    assert np.asarray(forward(again, q)) == pytest.approx(np.asarray(forward(arm, q)), abs=1e-12)
