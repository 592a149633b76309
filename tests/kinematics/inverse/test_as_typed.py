"""Poses typed with four decimals, which an arm of few joints meets nearly."""

from __future__ import annotations

import numpy as np
import pytest

from dhcli import forward, inverse, load_robot
from dhcli.kinematics.inverse.as_typed import as_typed
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.robot import Robot

ARMS = ("articulated", "planar-2r", "scara", "spherical-wrist", "zhou-3r", "cylindrical", "palletizer")


def typed(robot: Robot, pose: np.ndarray, decimals: int) -> Solutions:
    """The answer for a pose of few decimals."""
    few = np.round(pose, decimals)
    return as_typed(inverse(robot, few), few, 0.5 * 10.0**-decimals, {})


@pytest.mark.parametrize("name", ARMS)
def test_a_pose_of_few_decimals_has_the_solutions_of_the_pose_that_was_meant(name: str) -> None:
    """As many, each beside its own; and the last digit of the pose comes back from each."""
    robot = load_robot(name)
    pose = np.array(forward(robot, (0.35, 0.97, 0.61, 0.82)[: len(robot.variables)]).matrix)
    meant = inverse(robot, pose)
    for decimals in (4, 3):
        found = typed(robot, pose, decimals)
        assert len(found) == len(meant)
        assert max(found.distances(row).min() for row in meant) < 100 * 10.0**-decimals
        for row in found:
            assert np.abs(np.array(forward(robot, row.tolist()).matrix) - pose).max() < 5 * 10.0**-decimals


def test_that_the_nearest_pose_was_taken_is_said() -> None:
    """And how far it is."""
    robot = load_robot("zhou-3r")
    found = typed(robot, np.array(forward(robot, [0.3, 0.9, 0.2]).matrix), 4)
    assert found.remarks[0].startswith(
        "the arm takes no pose with exactly these digits; the nearest is taken, an entry of"
    )


def test_a_pose_that_its_digits_do_not_reach_has_no_solution_as_before() -> None:
    """Two units of the last digit are no rounding any more; nor is anything of a pose that is exact."""
    robot = load_robot("planar-2r")
    pose = np.array(forward(robot, [0.3, 0.9]).matrix)
    pose[2, 3] = 0.0005
    assert len(typed(robot, pose, 4)) == 0
    assert len(as_typed(inverse(robot, pose), pose, 0.0, {})) == 0
    assert len(typed(robot, pose, 3)) == 1
