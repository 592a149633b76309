"""A path of poses followed on one branch."""

from __future__ import annotations

import numpy as np
import pytest

from dhcli import follow, forward_batch, load_robot
from dhcli.errors import RobotError

START = np.array([0.3, -0.5, 0.7, 1.0, 0.8, -2.0])
END = np.array([0.9, -0.2, 0.3, 1.6, 1.2, -1.0])


def test_a_path_stays_on_the_branch_that_it_begins_on() -> None:
    """The joint values that it was made from come back, each of the eight branches was there to choose from."""
    robot = load_robot("puma560")
    q = START + np.linspace(0, 1, 50)[:, None] * (END - START)
    path = follow(robot, forward_batch(robot, q), START)
    assert np.abs(path.q - q).max() < 1e-9
    assert (path.lost, path.jumps, path.singular) == ((), (), ())


def test_angles_are_counted_on_over_full_turns() -> None:
    """A joint that goes round twice does not spring back."""
    robot = load_robot("planar-2r")
    q = np.stack([np.linspace(0, 4 * np.pi, 80), np.full(80, 0.5)], axis=1)
    path = follow(robot, forward_batch(robot, q), [0, 0.5], task="position")
    assert np.abs(path.q - q).max() < 1e-9
    assert path.jumps == ()


def test_the_wrist_passes_its_singular_pose_without_turning_at_random() -> None:
    """theta5 goes through 0: the pose there is told as singular, and theta4 stays where it is."""
    robot = load_robot("puma560")
    q = np.tile(START, (41, 1))
    q[:, 4] = np.linspace(-0.4, 0.4, 41)
    path = follow(robot, forward_batch(robot, q), q[0])
    assert np.abs(path.q - q).max() < 1e-6
    assert path.singular == (20,)
    assert path.jumps == ()


def test_poses_out_of_reach_are_told_and_left_open() -> None:
    """The path goes on behind them."""
    robot = load_robot("planar-2r")
    q = np.stack([np.linspace(0, 1, 30), np.full(30, 0.5)], axis=1)
    poses = forward_batch(robot, q)
    poses[10:12, 0, 3] += 5
    path = follow(robot, poses, [0, 0.5], task="position")
    assert path.lost == (10, 11)
    assert np.isnan(path.q[10:12]).all()
    assert np.abs(np.delete(path.q - q, [10, 11], axis=0)).max() < 1e-9


def test_a_jump_to_another_branch_is_told() -> None:
    """Two pieces of a path that no branch joins."""
    robot = load_robot("puma560")
    pieces = [START + np.linspace(0, 0.2, 20)[:, None] * (END - START), END + np.linspace(0, 0.1, 20)[:, None]]
    path = follow(robot, forward_batch(robot, np.vstack(pieces)), START)
    assert path.jumps == (20,)


def test_a_path_needs_joint_values_to_begin_with() -> None:
    """They choose the branch."""
    with pytest.raises(RobotError, match="begin near to"):
        follow(load_robot("puma560"), np.eye(4)[None], None)


@pytest.mark.parametrize("seed", [0, 1, 4])
def test_an_arm_with_a_joint_to_spare_goes_on_where_it_cannot_stand_still(seed: int) -> None:
    """A path of a Panda on which its last joint would have to jump to another value: it moves along instead."""
    rng = np.random.default_rng(seed)
    robot = load_robot("panda")
    first = np.array([0, -0.3, 0, -1.8, 0, 1.6, 0.8]) + rng.uniform(-0.5, 0.5, 7)
    last = first + rng.uniform(-1.2, 1.2, 7)
    poses = forward_batch(robot, first + np.linspace(0, 1, 200)[:, None] * (last - first))
    path = follow(robot, poses, first.tolist())
    assert path.lost == path.jumps == ()
    assert np.abs(np.diff(path.q, axis=0)).max() < 0.25
    assert np.abs(forward_batch(robot, path.q) - poses).max() < 1e-11
    held = follow(robot, poses[:20], first.tolist(), hold={"theta7": float(first[6])})
    assert np.ptp(held.q[:, 6]) == 0  # where it is said it stands still
