"""The scene of a robot: its frames, drums and dimensions stand where its table has them."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhcli import forward, load_robot
from dhcli.files.yaml.robots import read_robot
from dhcli.geometry.vectors import Vector, cross, dot, length, minus
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values
from dhcli.notation.angle import Angle
from dhcli.scene.arm import arm_scene
from dhcli.scene.choice import best_pose, with_examples
from dhcli.scene.drawing import Drawing
from dhcli.scene.primitives import Box, Drum, Scene
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.staging import ArmAt
from tests.row_by_row import row_by_row
from tests.scene.examples import ROBOTS

REAL = tuple(name for name in ROBOTS if not name.startswith("dh-link"))
DATA = Path(__file__).parents[1] / "data" / "coupled"
TABLES = tuple(name for name in REAL if load_robot(name).convention is not Convention.PRODUCT)


def _values(name: str, q: list[float]) -> dict[str, object]:
    robot = load_robot(name)
    full, _ = with_examples(robot, {})
    return {**full, **joint_values(robot, q[: len(robot.variables)])}


def _scene(name: str) -> Scene:
    robot = load_robot(name)
    full, _ = with_examples(robot, {})
    return arm_scene(robot, {**full, **best_pose(robot, full)[1]})


def _is_on(point: Vector, start: Vector, direction: Vector) -> bool:
    return length(cross(minus(point, start), direction)) < 1e-9


@pytest.mark.parametrize("name", REAL)
@settings(max_examples=5)
@given(q=st.lists(st.floats(-3, 3), min_size=8, max_size=8))
def test_the_states_of_a_skeleton_are_the_frames_of_forward(name: str, q: list[float]) -> None:
    """A second fold, which keeps every state, agrees with the one."""
    robot = load_robot(name)
    skeleton = Skeleton.of(robot, _values(name, q))  # type: ignore[arg-type]
    joints = q[: len(robot.variables)]
    for frame, state in skeleton.numbered:
        known = forward(robot, joints, start=skeleton.numbered[0][0], end=frame)
        found = skeleton.states[state]
        for column, axis in enumerate((found.x, found.y, found.z, found.origin)):
            assert axis == pytest.approx([row[column] for row in known.rows[:3]], abs=1e-12)


@row_by_row("name", TABLES)
def test_dimensions_stand_where_the_convention_has_them(name: str) -> None:
    """Standard: d along z of the frame before, a along x of its own; modified: a along x before, d along its own z."""
    robot = load_robot(name)
    full, _ = with_examples(robot, {})
    values = {**full, **best_pose(robot, full)[1]}
    skeleton, scene = Skeleton.of(robot, values), arm_scene(robot, values)
    state = dict(skeleton.numbered)
    for link in robot.links:
        before, own = (skeleton.states[state[str(number)]] for number in (link.number - 1, link.number))
        first = state[str(link.number - 1)]
        held = [d for d in scene.dimensions if first <= d.start.state < state[str(link.number)]]
        for dimension in held:
            start, end = scene.point(dimension.start), scene.point(dimension.end)
            if length(minus(end, start)) == 0:
                continue
            letter = dimension.words[-2].text if dimension.words[-1].below else dimension.words[-1].text
            along_z = (link.row is not None and letter[-1] == "d") or _is_on(end, start, before.z)
            if robot.convention is Convention.STANDARD:
                ends = (before.origin, before.z) if along_z else (own.origin, own.x)
            else:
                ends = (own.origin, own.z) if _is_on(start, own.origin, own.z) else (before.origin, before.x)
            assert _is_on(start, *ends)
            assert _is_on(end, *ends)


@row_by_row("name", TABLES)
def test_a_body_stands_on_the_axis_of_its_joint(name: str) -> None:
    """z_{i-1} in the standard convention, z_i in the modified one; sliding along it changes nothing."""
    robot = load_robot(name)
    full, _ = with_examples(robot, {})
    values = {**full, **best_pose(robot, full)[1]}
    skeleton, scene = Skeleton.of(robot, values), arm_scene(robot, values)
    state = dict(skeleton.numbered)
    moved = [link for link, variables in robot.movers.items() if variables]
    for solid, link in zip(scene.solids, moved, strict=True):
        assert isinstance(solid, Drum | Box)
        offset = 0 if robot.convention is Convention.MODIFIED else 1
        frame = skeleton.states[state[str(link - offset)]]
        assert _is_on(scene.point(solid.centre), frame.origin, frame.z)
        assert abs(dot(scene.direction(solid.centre.state, solid.axis), frame.z)) == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("name", REAL)
def test_a_turned_joint_moves_nothing_on_its_own_axis(name: str) -> None:
    """Nor its own drum, wherever that has slid to."""
    robot = load_robot(name)
    full, _ = with_examples(robot, {})
    values = {**full, **best_pose(robot, full)[1]}
    for number, joint in enumerate(robot.joints):
        if joint.kind != "revolute":
            continue
        scene = arm_scene(robot, values)
        moved = Skeleton.of(robot, {**values, joint.name: values[joint.name] + Angle.in_degrees(40)})  # type: ignore[operator]
        solid = scene.solids[number]
        assert isinstance(solid, Drum)
        still = moved.states[solid.centre.state].point(solid.centre.at)
        assert still == pytest.approx(scene.point(solid.centre), abs=1e-12)


@row_by_row("name", REAL)
def test_drums_that_share_a_place_fan_out(name: str) -> None:
    """No middle of a body inside another: of joints at one point the first goes back and the last ahead."""
    scene = _scene(name)
    middles = [scene.point(solid.centre) for solid in scene.solids if isinstance(solid, Drum | Box)]
    for i, one in enumerate(middles):
        for other in middles[i + 1 :]:
            assert math.dist(one, other) > 0.9 * scene.unit


def test_equal_axes_of_coincident_frames_are_one_arrow() -> None:
    """PUMA 560 has z0 and z1 in one place, and x0 and x1 where joint 1 is at zero."""
    names = {"".join(run.text for run in arrow.words) for arrow in _scene("puma560").arrows}
    assert {"z0, z1", "x0, x1", "x5, x6"} <= names


def test_an_arm_in_the_plane_stands_on_a_bearing_and_one_in_space_on_a_plate() -> None:
    """A wrist that is only the end of an arm has a broken stub in its place."""
    assert _scene("planar-2r").plate is None
    assert _scene("planar-2r").pinned
    plate = _scene("puma560").plate
    assert plate is not None
    assert not plate.broken
    wrist = _scene("spherical-wrist").plate
    assert wrist is not None
    assert wrist.broken


def test_the_pose_that_shows_a_robot_best_is_not_its_zero_where_it_has_better_ones() -> None:
    """At zero wrists are straight, sliders in, and links in line."""
    for name, pose in {"puma560": "nominal", "panda": "ready", "stanford": "grasp", "ur5e": "work"}.items():
        robot = load_robot(name)
        assert best_pose(robot, with_examples(robot, {})[0])[0] == pose


def test_joints_that_drives_tie_about_one_axis_are_one_drum_with_the_sum_of_their_angles() -> None:
    """`j3 - j2` in one row of the table is one joint of the arm."""
    robot = load_robot(DATA / "palletizer.yaml")
    drums = [solid.name for solid in arm_scene(robot, ArmAt(robot).values()).solids]
    assert len(drums) == len([link for link in robot.links if link.row and link.row.theta.terms])
    assert any("j2" in name and "j3" in name for name in drums)


AXES = """format: 1
title: Drawn
source: made for a test
convention: axes
variables: [theta1, theta2, theta3]
parameters: {a: 0.4 m, b: 0.3 m}
axes:
  - {theta1: +z, through: (0, 0, 0)}
  - {theta2: +z, through: (a, 0, 0)}
  - {theta3: +y, through: (a + b, 0, 0)}
end: Trans(a + b, 0, 0) Rot(x, -90°)
"""


def _given_otherwise() -> dict[str, Robot]:
    """Robots that no table of the library gives: joint axes, a URDF, a product of moves, one with base and tool."""
    urdf = DATA.parent / "urdf" / "three-joints.urdf"
    placed = load_robot("planar-2r").copy(base="Trans(0, 0, 0.5) Rot(z, 30°)", tool="Trans(0.1, 0, 0)")
    return {
        "axes": read_robot(AXES, "drawn.yaml", "drawn"),
        "urdf": load_robot(urdf, tip="tool0"),
        "product": load_robot("scara"),
        "placed": placed,
    }


@pytest.mark.parametrize("kind", ["axes", "urdf", "product", "placed"])
def test_a_robot_is_drawn_however_it_was_given(kind: str) -> None:
    """Each frame stands where forward has it, base and tool too, and a picture comes of it."""
    robot = _given_otherwise()[kind]
    values = ArmAt(robot).values()
    skeleton = Skeleton.of(robot, values)
    q = {name: values[name] for name in robot.variables}
    names = [name for name, _ in skeleton.numbered]
    assert ("base" in names, "tool" in names) == (bool(robot.base), bool(robot.tool))
    for name, state in skeleton.numbered:
        rows = forward(robot, q, start=names[0], end=name).rows  # type: ignore[arg-type]
        frame = skeleton.states[state]
        for i in range(3):
            known = (frame.x[i], frame.y[i], frame.z[i], frame.origin[i])
            assert known == pytest.approx(rows[i], abs=1e-12)
    figure = Drawing(robot).figure()
    assert len([text for text in figure.texts if text.look in "xz"]) >= 2
    assert sum(isinstance(solid, Drum | Box) for solid in arm_scene(robot, values).solids) == len(robot.variables)
