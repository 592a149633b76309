"""Poses typed with four decimals, which an arm of few joints meets nearly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from dhcli import forward, inverse
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.inverse.as_typed import as_typed, at_limits, poses_as_typed, slack_of
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from tests.kinematics.arms import robot_once
from tests.nightly import in_turn, some

ARMS = ("articulated", "planar-2r", "scara", "spherical-wrist", "zhou-3r", "cylindrical", "palletizer")


def typed(robot: Robot, pose: np.ndarray, decimals: int) -> Solutions:
    """The answer for a pose of few decimals."""
    few = np.round(pose, decimals)
    return as_typed(inverse(robot, few), few, 0.5 * 10.0**-decimals, {})


@pytest.mark.parametrize("name", ARMS)
def test_a_pose_of_few_decimals_has_the_solutions_of_the_pose_that_was_meant(name: str) -> None:
    """As many, each beside its own; and the last digit of the pose comes back from each."""
    robot = robot_once(name)
    pose = np.array(forward(robot, (0.35, 0.97, 0.61, 0.82)[: len(robot.variables)]).matrix)
    meant = inverse(robot, pose)
    for decimals in in_turn((4, 3), ARMS.index(name), 2):
        found = typed(robot, pose, decimals)
        assert len(found) == len(meant)
        assert max(found.distances(row).min() for row in meant) < 100 * 10.0**-decimals
        for row in found:
            assert np.abs(np.array(forward(robot, row.tolist()).matrix) - pose).max() < 5 * 10.0**-decimals


def test_that_the_nearest_pose_was_taken_is_said() -> None:
    """And how far it is."""
    robot = robot_once("zhou-3r")
    found = typed(robot, np.array(forward(robot, [0.3, 0.9, 0.2]).matrix), 4)
    assert found.remarks[0].startswith(
        "the arm takes no pose with exactly these digits; the nearest is taken, an entry of"
    )


def test_a_pose_that_its_digits_do_not_reach_has_no_solution_as_before() -> None:
    """Two units of the last digit are no rounding any more; nor is anything of a pose that is exact."""
    robot = robot_once("planar-2r")
    pose = np.array(forward(robot, [0.3, 0.9]).matrix)
    pose[2, 3] = 0.0005
    assert len(typed(robot, pose, 4)) == 0
    assert len(as_typed(inverse(robot, pose), pose, 0.0, {})) == 0
    assert len(typed(robot, pose, 3)) == 1


@pytest.mark.parametrize("name", in_turn(ARMS, 0, 3))
def test_rows_of_few_decimals_have_the_pose_that_a_single_one_has(name: str) -> None:
    """Those that the arm takes as they are, or that are exact, are left as they are."""
    robot = robot_once(name)
    exact = np.array(forward(robot, (0.35, 0.97, 0.61, 0.82)[: len(robot.variables)]).matrix)
    poses = np.array([exact, np.round(exact, 4), np.round(exact, 4) + np.eye(4, k=3) * 0.7])
    alone = [inverse(robot, pose) for pose in poses]
    lost = [k for k, found in enumerate(alone) if not len(found)]
    taken = poses_as_typed(robot, poses, lost, "pose", {})
    assert set(taken) == {k for k in lost if len(as_typed(alone[k], poses[k], slack_of(poses[k], "pose"), {}))}
    for k, pose in taken.items():
        assert np.abs(pose - poses[k]).max() < 2e-4
        assert len(inverse(robot, pose))


def test_the_digits_of_a_row_say_how_much_they_leave_open() -> None:
    """Half a unit of the last; nothing where they are all there are, or plain, as 0.125 of a pose that is exact."""
    turned = np.array(forward(robot_once("planar-2r"), [0.3, 0.9]).matrix)
    plain = np.eye(4)
    plain[0, 3] = 0.125
    decimals = [slack_of(np.round(turned, n), "pose") for n in (3, 4, 6)]
    assert decimals == pytest.approx([5e-4, 5e-5, 5e-7])
    assert slack_of(turned, "pose") == slack_of(plain, "pose") == 0.0
    turned[:3, 3] = np.round(turned[:3, 3], 4)  # as a row of a position and a quaternion has it
    assert slack_of(turned, "pose") == pytest.approx(5e-5)


def test_an_arm_with_joints_enough_is_not_asked_again() -> None:
    """A pose out of its reach is so by more than digits."""
    far = np.round(np.array(forward(robot_once("puma560"), "ready").matrix), 4) + np.eye(4, k=3) * 3.1234
    assert poses_as_typed(robot_once("puma560"), far[None], [0], "pose", {}) == {}


@pytest.mark.parametrize("name", ["puma560", "panda", "articulated-within"])
def test_a_joint_at_its_limit_is_there_to_the_digits_typed(name: str) -> None:
    """The digits leave it beyond by some thousandths of a degree; what is beyond by three degrees stays so."""
    robot = robot_once(name.removesuffix("-within"))
    if name.endswith("-within"):
        robot = replace(robot, limits={robot.variables[1]: (Angle.in_degrees(-20), Angle.in_degrees(40))})
    pairs = [(name, *map(in_floats, robot.limits[name])) for name in robot.limits]
    seen = 0
    for joint, low, high in some(pairs, 2):
        q = dict(zip(robot.variables, (0.31, 0.42, -0.53, -0.64, 0.75, 0.86, 0.97), strict=False))
        for at in (low, high, high + np.radians(3)):
            q[joint] = at
            few = np.round(np.array(forward(robot, q).matrix), 4)
            hold = {"theta7": q["theta7"]} if "theta7" in q and joint != "theta7" else {}
            found = as_typed(inverse(robot, few, hold=hold), few, 5e-5, {"hold": hold})
            taken = at_limits(found, few, 5e-5, {"hold": hold})
            k = int(np.argmin(found.distances(q)))
            if found.distances(q)[k] > 0.01:
                continue
            beyond = {each.joint for each in taken.beyond[k]}
            before = {each.joint for each in found.beyond[k]}
            assert beyond == (before if at > high else before - {joint})
            seen += before != beyond
            assert all(set(now) <= set(then) for now, then in zip(taken.beyond, found.beyond, strict=True))
    assert seen
