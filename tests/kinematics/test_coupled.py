"""Variables that move several rows, or share one, and motors that drive joints together."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import (
    Robot,
    forward,
    forward_batch,
    inverse,
    jacobian,
    load_robot,
    sweep,
    symbolic,
    symbolic_jacobian,
    torques,
)
from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.kinematics.actuators import inverse as undone
from dhcli.kinematics.drives import actuators, read_drive
from dhcli.kinematics.inverse.path import follow
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.motors import in_motors
from dhcli.kinematics.values import joint_values, numbers, parameter_values
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from tests.nightly import examples
from tests.row_by_row import row_by_row

DATA = Path(__file__).parents[1] / "data" / "coupled"
PALLETIZER, SCREW = (load_robot(DATA / f"{name}.yaml") for name in ("palletizer", "screw"))
PAIR, BALL_SCREW = (load_robot(DATA / f"{name}.yaml") for name in ("two-and-three", "ball-screw"))
ARMS = [PALLETIZER, SCREW, in_motors(PAIR), in_motors(BALL_SCREW)]
MOTORS = ("m2", "m3", "m4")
IDS = ["palletizer", "screw", "pair", "ball-screw"]


def drawn(robot: Robot, seed: int = 1) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Some values for each variable."""
    return np.random.default_rng(seed).uniform(-1.2, 1.2, len(robot.variables))


def moved(robot: Robot, q: Any) -> np.ndarray[Any, np.dtype[np.float64]]:  # noqa: ANN401
    """The pose by the elementary matrices of the same arm written out by hand."""
    if robot is PALLETIZER:
        j1, j2, j3, j4 = q
        rows = [(j1, 0.8, 0.3, 90), (j2, 0, 1.1, 0), (j3 - j2, 0, 1.2, 0), (-j3, 0, 0, 90), (j4, -0.2, 0, 0)]
        return chained([turn(2, a) @ shift(0, 0, d) @ shift(r, 0, 0) @ turn(0, np.radians(t)) for a, d, r, t in rows])
    if robot is SCREW:
        t1, t2 = q
        return chained([turn(2, t1), shift(0.3, 0, 0), shift(0, 0, 0.005 * t2), turn(2, t2), shift(0.1, 0, 0)])
    if robot.name == "two-and-three":
        t1, j2, j3 = q
        rows = [(t1, 0.4, 0.1, 90), (j2 + np.pi / 2, 0, 0.8, 0), (j2 + j3, 0, 0.7, 0)]
        return chained([turn(2, a) @ shift(0, 0, d) @ shift(r, 0, 0) @ turn(0, np.radians(t)) for a, d, r, t in rows])
    t1, t2, m3, m4 = q
    lead = 0.02 / (2 * np.pi)
    return chained([turn(2, t1), shift(0.4, 0, 0), turn(2, t2), shift(0.3, 0, lead * (m3 - m4)), turn(2, m4)])


def turn(axis: int, angle: float) -> Any:  # noqa: ANN401
    """A rotation about x, y or z."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    pose = np.eye(4)
    pose[i, i] = pose[j, j] = np.cos(angle)
    pose[j, i], pose[i, j] = np.sin(angle), -np.sin(angle)
    return pose


def shift(*by: float) -> Any:  # noqa: ANN401
    """A translation."""
    pose = np.eye(4)
    pose[:3, 3] = by
    return pose


def chained(moves: list[Any]) -> Any:  # noqa: ANN401
    """A product."""
    return np.linalg.multi_dot([np.eye(4), *moves])


@row_by_row("robot", ARMS)
@row_by_row("seed", range(5))
def test_a_pose_is_that_of_the_matrices_written_out(robot: Robot, seed: int) -> None:
    """One at a time, many, and in letters with the numbers put in."""
    q = drawn(robot, seed)
    pose = moved(robot, q)
    assert np.asarray(forward(robot, list(q))) == pytest.approx(pose, abs=1e-14)
    assert forward_batch(robot, np.array([q, q]))[1] == pytest.approx(pose, abs=1e-13)
    over = Floats(numbers({**parameter_values(robot, {}), **joint_values(robot, list(q))}))
    letters = [[over.value(entry) for entry in row] for row in symbolic(robot).rows]
    assert np.array(letters) == pytest.approx(pose[: len(letters)], abs=1e-14)


@pytest.mark.parametrize("robot", ARMS, ids=IDS)
@pytest.mark.parametrize("view", [{}, {"axes": "tool"}, {"start": "1"}, {"axes": "1", "point": ["0.1", "0.2", "0"]}])
def test_a_column_says_how_fast_the_end_moves_with_its_variable(robot: Robot, view: dict[str, Any]) -> None:
    """By differences, in any axes; in letters it is the same, and so it is with a value put in."""
    q = drawn(robot)
    start, axes = view.get("start", robot.frames[1]), view.get("axes", view.get("start", robot.frames[1]))
    point = np.array([*map(float, view.get("point", (0, 0, 0))), 1.0])
    found = jacobian(robot, list(q), **view)
    into = np.asarray(forward(robot, list(q), start=axes, end=start))[:3, :3]
    columns = symbolic_jacobian(robot, **view).joints
    for k, name in enumerate(columns):
        step = np.zeros(len(q))
        step[robot.variables.index(name)] = 1e-6
        low, high = (np.asarray(forward(robot, list(q + s * step), start=start)) for s in (-1, 1))
        rate = (high - low) / 2e-6
        here = np.asarray(forward(robot, list(q), start=start))
        linear = into @ (rate @ point)[:3]
        spin = rate[:3, :3] @ here[:3, :3].T
        angular = into @ np.array([spin[2, 1], spin[0, 2], spin[1, 0]])
        assert found[:, k] == pytest.approx(np.concatenate([linear, angular]), abs=1e-8)
    values = {**parameter_values(robot, {}), **joint_values(robot, list(q))}
    for put in ({}, {robot.variables[-1]: values[robot.variables[-1]]}):
        over = Floats(numbers(values))
        letters = [[over.value(e) for e in row] for row in symbolic_jacobian(robot, put, **view).rows]
        assert np.array(letters) == pytest.approx(found, abs=1e-12)


@pytest.mark.parametrize("robot", ARMS, ids=IDS)
@pytest.mark.parametrize("seed", range(8))
def test_the_values_that_made_a_pose_are_among_those_that_reach_it(robot: Robot, seed: int) -> None:
    """And every one of them reaches it."""
    q = drawn(robot, seed)
    pose = moved(robot, q)
    task = "position" if robot.name == "two-and-three" else "pose"
    found = inverse(robot, pose, task=task)
    assert len(found) >= 1
    for values in found:
        there = moved(robot, values)
        kept = slice(None) if task == "pose" else (slice(0, 3), 3)
        assert there[kept] == pytest.approx(pose[kept], abs=1e-8)
    assert found.nearest(list(q)) == pytest.approx(q, abs=1e-6)


def test_values_near_to_a_wish_are_taken_in_its_turn() -> None:
    """Of a screw there is only one turn; of a motor with whole ratios each."""
    turned = inverse(SCREW, moved(SCREW, [0.2, 9.0]))
    assert [float(row[1]) for row in turned] == pytest.approx([9.0])
    near = inverse(PALLETIZER, moved(PALLETIZER, [0.2, 1.0, 0.3, 0.4]), near=[0.2, 1.0, 0.3, 6.5])
    assert near[0] == pytest.approx([0.2, 1.0, 0.3, 0.4 + 2 * np.pi])


def test_a_pose_that_the_coupling_forbids_is_told_so() -> None:
    """The hand of a palletizer stays level."""
    tilted = chained([moved(PALLETIZER, [0.2, 1.0, 0.3, 0.4]), turn(0, 0.1)])
    found = inverse(PALLETIZER, tilted)
    assert not len(found)
    assert not found.reachable
    loose = inverse(PALLETIZER, chained([shift(1, 0, 0.7), turn(2, 0.3), turn(0, np.pi), turn(0, np.pi)]))
    assert "5 moves" in loose.why


def test_a_variable_that_moves_joints_together_with_others_can_be_held() -> None:
    """A motor held that turns a joint together with another, and one of a palletizer."""
    arm = in_motors(PAIR)
    place = np.array(forward(arm, [0.1, 0.2, 0.3]).matrix, dtype=float)
    found = inverse(arm, place[:3, 3], hold={"J3": 0.3}, task="position")
    assert found.nearest([0.1, 0.2, 0.3]) == pytest.approx([0.1, 0.2, 0.3], abs=1e-9)
    assert found.held == (("J3", 0.3),)
    pose = moved(PALLETIZER, [0.2, 1.0, 0.3, 0.4])
    assert inverse(PALLETIZER, pose, hold={"j2": 1.0}).q == pytest.approx(np.array([[0.2, 1.0, 0.3, 0.4]]))
    assert len(inverse(PALLETIZER, pose, hold={"j4": 0.4})) == 2
    none = inverse(PALLETIZER, pose, hold={"j2": 1.1})
    assert not len(none)
    assert "5 moves had a drive" in none.why


def test_a_position_that_five_moves_reach_in_endless_ways_is_reached_by_their_four_variables() -> None:
    """The last one spins the hand about its own axis and is held; it is said that some may be missing."""
    found = inverse(PALLETIZER, moved(PALLETIZER, [0.2, 1.0, 0.3, 0.4])[:3, 3], task="position")
    assert found.nearest([0.2, 1.0, 0.3, 0.0]) == pytest.approx([0.2, 1.0, 0.3, 0.0], abs=1e-9)
    assert found.remarks[0] == "palletizer has 1 joint more than this needs: held j4 = 0°"
    assert "may not find all" in found.remarks[1]


def test_variables_to_spare_are_held_where_they_stand_in_the_values_given() -> None:
    """Of a palletizer too, whose variables are led."""
    found = inverse(PALLETIZER, "0.2, 1.0, 0.3, 0.4", task="position")
    assert found.nearest([0.2, 1.0, 0.3, 0.4]) == pytest.approx([0.2, 1.0, 0.3, 0.4], abs=1e-9)
    assert found.remarks[0].endswith("held j4 = 22.9183°, as in the joint values given")


@pytest.mark.parametrize("value", [1.0, "1 rad"])
def test_a_variable_that_moves_one_joint_alone_can_be_held(value: float | str) -> None:
    """J2 turns its own joint, and the next one together with J3; each solution has the value, and reaches the place."""
    arm = in_motors(PAIR)
    place = forward(arm, [0.2, 1.0, 0.3])
    found = inverse(arm, place, hold={"J2": value})
    assert len(found)
    assert dict(found.held)["J2"] == pytest.approx(1.0)
    for q in found.q:
        assert q[1] == pytest.approx(1.0, abs=1e-12)
        assert np.array(forward(arm, q.tolist()).matrix, dtype=float) == pytest.approx(np.array(place.matrix), abs=1e-9)


@pytest.mark.parametrize("arm", ARMS[2:], ids=IDS[2:])
def test_a_path_is_followed_by_what_drives_the_joints(arm: Robot) -> None:
    """The values that made it come back, over full turns, too."""
    start = drawn(arm)
    wanted = np.array([start + 0.15 * k for k in range(30)])
    poses = np.array([np.array(forward(arm, row.tolist()).matrix, dtype=float) for row in wanted])
    found = follow(arm, poses, start.tolist())
    assert found.lost == ()
    assert found.q == pytest.approx(wanted, abs=1e-8)


def test_a_path_is_followed_in_the_variables_and_no_coupling_breaks() -> None:
    """Each point has a value for each variable, not for each move, and they lead to the pose."""
    start = [0.2, 1.0, 0.3, 0.4]
    poses = np.array([moved(PALLETIZER, [0.2 + turn, 1.0, 0.3 - turn, 0.4]) for turn in (0.0, 0.05, 0.1)])
    path = follow(PALLETIZER, poses, start)
    assert path.q.shape == (3, 4)
    assert np.array([moved(PALLETIZER, values) for values in path.q.tolist()]) == pytest.approx(poses, abs=1e-8)


def test_a_sweep_by_motors_counts_the_poses_that_its_joints_forbid() -> None:
    """One by one they are as many."""
    arm = in_motors(load_robot("fanuc-like"))
    found = sweep(arm, ["J2=-60°..76° n 9", "J3=-70°..200° n 10"])
    bad = 0
    for j2 in np.linspace(-60, 76, 9):
        bad += sum(not -80 <= j2 + j3 <= 140 for j3 in np.linspace(-70, 200, 10))
    assert 0 < bad < 90
    assert any(warning.startswith(f"{bad} of the 90 poses are beyond") for warning in found.warnings)
    inside = sweep(arm, ["J2=-10°..10° n 5", "J3=-10°..10° n 5"])
    assert not any("of the 25 poses" in warning for warning in inside.warnings)


def test_a_motor_behind_a_ball_screw_is_never_saved_as_a_slide(tmp_path: Path) -> None:
    """By its joints the robot is saved with its motors, which turn when it is loaded again."""
    with pytest.raises(RobotError, match=r"m3 would slide in a file(.|\n)*by its joints"):
        in_motors(BALL_SCREW).save(tmp_path / "motors.yaml")
    BALL_SCREW.save(tmp_path / "joints.yaml")
    assert in_motors(load_robot(tmp_path / "joints.yaml")).joints == in_motors(BALL_SCREW).joints
    in_motors(PAIR).save(tmp_path / "pair.yaml")
    assert load_robot(tmp_path / "pair.yaml").joints == in_motors(PAIR).joints


# --- Motors ----------------------------------------------------------------------------------------------------------

FRACTIONS = st.fractions(min_value=-3, max_value=3, max_denominator=80)


@given(st.lists(st.lists(FRACTIONS, min_size=3, max_size=3), min_size=3, max_size=3))
@examples(1)
def test_ratios_are_undone_exactly_or_one_joint_is_said_to_depend_on_others(rows: list[list[Any]]) -> None:
    """With fractions, so that the product is the identity and not nearly so."""
    table = tuple(map(tuple, rows))
    exact = [[float(x) for x in row] for row in rows]
    try:
        back = undone(table, ("a", "b", "c"))
    except RobotError as error:
        assert "whatever the motors do" in str(error)
        assert abs(np.linalg.det(exact)) < 1e-9
        return
    product = [[sum(x * back[k][j] for k, x in enumerate(row)) for j in range(3)] for row in table]
    assert product == [[int(i == j) for j in range(3)] for i in range(3)]


def test_the_case_that_was_published_for_an_arm_whose_third_motor_keeps_the_forearm_level() -> None:
    """J2 = 31.324°, J3 = -33.342°: the joint between the links stands at -2.018°.

    Source: a maker's controller beside the joint states of its arm, ROS-Industrial, fanuc_experimental.
    """
    driven = PAIR.actuators
    assert driven is not None
    motors = joint_values(in_motors(PAIR), "0, 31.324°, -33.342°")
    assert str(driven.joint_values(motors)["theta3"].degrees) == "-1009/500"  # type: ignore[union-attr]
    assert driven.motor_values(driven.joint_values(motors)) == motors


@pytest.mark.parametrize("robot", [PAIR, BALL_SCREW], ids=["pair", "ball-screw"])
def test_motors_do_the_work_that_joints_do(robot: Robot) -> None:
    """Torques go by the transpose: their power is the same for all rates."""
    driven = robot.actuators
    assert driven is not None
    arm = in_motors(robot)
    m = drawn(arm)
    slopes = np.array(driven.slopes())
    q = slopes @ m + driven.offsets()
    push = (1.0, -2.0, 3.0)
    moment = (0.5, 0.1, -0.7)
    of_motors = torques(arm, list(m), force=push, moment=moment)
    of_joints = torques(robot, list(q), force=push, moment=moment)
    rates = np.random.default_rng(3).normal(size=len(m))
    assert np.dot(of_motors, rates) == pytest.approx(np.dot(of_joints, slopes @ rates))


def test_a_box_of_motor_limits_is_told_for_joint_values_and_that_of_joints_for_motor_values() -> None:
    """Whichever side is typed."""
    values = joint_values(PAIR, "0, 31°, 150°")
    assert not list(warnings(PAIR, values))
    assert list(warnings(PAIR, joint_values(PAIR, "0, 80°, 90°"))) == [
        "J2 is then 80°, outside its limits, -60° to 76°"
    ]
    arm = in_motors(PAIR)
    assert list(warnings(arm, joint_values(arm, "0, 70°, 150°"))) == [
        "theta3 is then 220°, outside its limits, -80° to 200°"
    ]
    pose = forward(arm, [0, np.radians(70), np.radians(150)])
    assert [each.joint for each in inverse(arm, pose, task="pose").beyond[0]] == ["theta3"]
    assert not len(inverse(arm, pose, task="pose", within_limits=True))


def test_poses_by_name_and_a_tool_hold_for_motors_too() -> None:
    """The values are those of the motors that put the joints there."""
    arm = in_motors(PAIR)
    assert np.asarray(forward(arm, "folded")) == pytest.approx(np.asarray(forward(PAIR, "folded")))
    longer = replace(arm, tool=load_robot("planar-2r").links[0].moves[2:3])
    assert len(inverse(longer, forward(arm, "folded"), task="pose")) == 1
    other = arm.copy(parameters={"a2": 0.7})
    assert inverse(other, forward(other, "folded")).nearest("folded") == pytest.approx(
        inverse(arm, forward(arm, "folded")).nearest("folded")
    )


def test_a_robot_without_motors_has_none() -> None:
    """And the hint says where they stand."""
    with pytest.raises(RobotError, match="not known which motors drive it"):
        in_motors(PALLETIZER)


@row_by_row(
    ("text", "turns", "message"),
    [
        ("m2*m3", True, "not linear"),
        ("m2*a2", True, "a2 is a letter"),
        ("m2 + theta3", True, "theta3 is a joint"),
        ("m2 + 1", True, "no angle"),
        ("m2*20 mm", True, "the ratio of m2 is a number"),
        ("m2*5 mm/(1 rad)", False, "no exact number"),
        ("m2 + m2*20 mm/(360°)", False, "turns and slides"),
        ("m2^2", True, "no ratio"),
    ],
)
def test_what_is_no_sum_of_multiples_is_refused(text: str, turns: bool, message: str) -> None:
    """With what would be one."""
    expr = parse(text, Scope(lengths=(*MOTORS, "theta3", "a2")))
    with pytest.raises(RobotError, match=message):
        read_drive(expr, MOTORS, ("theta3",), turns=turns)


def test_motors_and_joints_must_be_as_many_and_each_motor_of_one_kind() -> None:
    """Each slip in words."""
    joints = {"theta2": True, "theta3": True, "d4": False}

    def drive(text: str, *, turns: bool = True) -> Any:  # noqa: ANN401
        return read_drive(parse(text, Scope(lengths=MOTORS)), MOTORS, tuple(joints), turns=turns)

    two = {"theta2": drive("m2"), "theta3": drive("m3 + m2")}
    for motors, drives, message in (
        ({"m2": None}, two, "1 motor, m2, for 2 joints, theta2, theta3"),
        ({"m2": None, "m4": None}, two, "m4 drives no joint"),
        ({"m2": None, "m3": None}, {**two, "theta3": drive("2*m2")}, "m3 drives no joint"),
        (
            {"m2": None, "m3": None},
            {"theta2": drive("m2 - m3"), "theta3": drive("2*m3 - 2*m2")},
            "theta3 = -2.theta2 whatever the motors do",
        ),
        (
            {"m2": None, "m3": None},
            {"theta2": drive("m2 + m3"), "d4": drive("m2", turns=False)},
            "m2 turns for one joint and slides for another",
        ),
    ):
        with pytest.raises(RobotError, match=message):
            actuators(joints, drives, motors)  # type: ignore[arg-type]
