"""Why a pose is not reached, which part of it is, and how near the arm comes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from dhcli import Robot, forward, inverse, load_robot, manipulability
from dhcli.kinematics.inverse import choosing, reasons


def test_too_far_is_said_with_both_lengths() -> None:
    """The distance asked for, and the links laid end to end."""
    robot = load_robot("puma560")
    pose = forward(robot, "ready").matrix
    pose[0, 3] = 3
    found = inverse(robot, pose)
    assert not found.reachable
    assert not len(found)
    assert "m from the first joint, and the links laid end to end are" in found.why
    assert "the position alone: not" in found.why


def test_an_arm_that_cannot_tilt_says_so_and_what_it_can_reach() -> None:
    """SCARA's last axis is vertical; the position alone has two solutions; the nearest pose is as far off as tilted."""
    robot = load_robot("scara")
    tilt = np.eye(4)
    tilt[1:3, 1:3] = [[np.cos(0.2), -np.sin(0.2)], [np.sin(0.2), np.cos(0.2)]]
    found = inverse(robot, forward(robot, [0.1, 0.2, 0.3]).matrix @ tilt)
    assert "the last z axis always points along +z, yours is 11.46° off" in found.why
    assert "the position alone: 2 solutions" in found.why
    assert "11.46° away" in found.why


def test_a_plane_arm_says_which_height_it_must_have() -> None:
    """Planar 2R moves in one plane."""
    robot = load_robot("planar-2r")
    x, y, z = forward(robot, [0.3, 0.5]).position
    point = [x, y, z + 0.1]
    found = inverse(robot, point, task="position")
    assert "z must be 0 m, is 0.1 m" in found.why


def test_the_last_axis_that_is_always_level_is_told_from_one_that_is_tilted() -> None:
    """Of an arm whose z axis can go round in a level plane only."""
    robot = load_robot("articulated")
    found = inverse(robot, np.eye(4))
    assert "the last z axis of this arm is always level, yours is tilted by 90°" in found.why


@pytest.mark.parametrize("name", ["puma560", "ur5e", "scara", "planar-2r"])
def test_the_nearest_pose_is_as_far_away_as_is_said(name: str) -> None:
    """The joint values offered take the end there; nothing at random comes nearer."""
    robot = load_robot(name)
    point = np.array([1.9, 0.4, 0.0])
    found = inverse(robot, point, task="position", near=None)
    reached = np.array(forward(robot, list(found.closest)).position)
    distance = np.linalg.norm(reached - point)
    assert f"{distance:.4g} m away" in found.why
    rng = np.random.default_rng(1)
    for q in rng.uniform(-3, 3, (200, len(robot.variables))):
        assert np.linalg.norm(np.array(forward(robot, list(q)).position) - point) > distance - 1e-6


def test_at_the_edge_of_reach_two_solutions_become_one() -> None:
    """A hair inside there are two, at the edge one, a hair outside none."""
    robot = load_robot("planar-2r")
    reach = np.linalg.norm(forward(robot, [0, 0]).position)
    counts = [len(inverse(robot, [reach * (1 + by), 0, 0], task="position")) for by in (-1e-3, -1e-9, 0.0, 1e-9, 1e-3)]
    assert counts == [2, 2, 1, 0, 0]


def test_a_place_too_near_to_the_first_axis_has_a_reason_too_where_the_wrist_is_left_free() -> None:
    """PUMA's shoulder offset keeps its wrist centre from axis 1: the joints of the wrist, held, have no part in it."""
    found = inverse(load_robot("puma560"), (0, 0, 0.2), task="position")
    assert "theta2 has no real value: a cosine in its equation would be 1.5" in found.why
    assert "the nearest pose reached is 0.15 m away" in found.why
    # an arm whose held joints would change the answer has no such equation
    assert "no real value" not in inverse(load_robot("ur5e"), (1.3, 0, 0.1), task="position").why


@pytest.mark.parametrize(
    ("rows", "q"),
    [
        (
            [
                *((0.4, 0, -0.15, "q1"), (0.4, "-90°", 0, "q2"), (0.3, 0, 0, "q3")),
                *((0, "90°", 0, "q4"), (0, "-90°", -0.15, "q5"), (0.1, "90°", "q6", 0)),
            ],
            [math.pi / 4, math.pi / 4, math.pi / 2, 0, 0, 0.3],
        ),
        (
            [
                *((0, "90°", 0, "q1"), (0.1, 0, 0, "q2"), (0, "-90°", 0, "q3")),
                *((0.4, "90°", -0.15, "q4"), (0.4, "-90°", 0, "q5"), (0.4, "-90°", -0.15, "q6")),
            ],
            [-math.pi / 2, math.pi / 4, -math.pi / 2, 0, math.pi, math.pi / 4],
        ),
    ],
)
def test_no_pose_at_which_an_arm_stands_is_out_of_reach(rows: list[tuple[object, ...]], q: list[float]) -> None:
    """Where so much is singular that no equation tells anything, the search for the nearest pose finds it."""
    arm = Robot.from_dh(rows, variables=[f"q{i}" for i in range(1, 7)])  # type: ignore[arg-type]
    pose = forward(arm, q)
    assert manipulability(arm, q) < 1e-12
    found = inverse(arm, pose)
    assert len(found) > 0
    for one in found:
        assert np.allclose(forward(arm, list(one)).matrix, pose.matrix, atol=1e-11)


@pytest.mark.parametrize("name", ["scara", "puma560", "ur5e", "panda"])
def test_a_pose_out_of_reach_is_told_with_few_steps(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The nearest pose is looked for once, until no step comes nearer; the plans for its parts were found before."""
    counted, cost = list[int](), reasons._cost
    monkeypatch.setattr(reasons, "_cost", lambda *args: (counted.append(1), cost(*args))[1])
    monkeypatch.setattr(choosing, "find_plan", None)
    far = np.eye(4)
    far[:3, 3] = 5, 0.3, 0.4
    found = inverse(load_robot(name), far)
    assert "the position alone: not; the orientation alone: in many ways" in found.why
    assert len(counted) <= 90
