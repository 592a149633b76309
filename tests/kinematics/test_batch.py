import numpy as np
import pytest

from dhcli import forward, forward_batch, load_robot
from dhcli.errors import RobotError
from dhcli.kinematics.batch import BLOCK


@pytest.mark.parametrize("name", ["scara", "puma560", "stanford", "panda"])
def test_a_batch_is_the_plain_fold_row_by_row(name: str) -> None:
    """Every pose of a batch is the pose of its row."""
    robot = load_robot(name)
    poses = np.random.default_rng(1).uniform(-3, 3, (7, len(robot.variables)))
    batch = forward_batch(robot, poses)
    for q, pose in zip(poses, batch, strict=True):
        assert np.allclose(pose, forward(robot, list(q)).matrix, atol=1e-14)


def test_a_matrix_of_another_width_is_refused() -> None:
    """The message names both shapes."""
    with pytest.raises(RobotError, match="3 joints"):
        forward_batch(load_robot("scara"), np.zeros((2, 4)))


def test_blocks_meet_without_a_seam_and_write_where_they_are_told() -> None:
    """Rows on both sides of a border are those of the plain fold; `out` may be any view of floats."""
    robot = load_robot("puma560")
    poses = np.random.default_rng(2).uniform(-4, 4, (BLOCK + 3, 6))
    wide = np.zeros((BLOCK + 3, 4, 8))
    given = forward_batch(robot, poses, out=wide[:, :, ::2])
    for k in (0, BLOCK - 1, BLOCK, BLOCK + 2):
        assert np.allclose(given[k], forward(robot, list(poses[k])).matrix, atol=1e-14)
    assert np.shares_memory(given, wide)


def test_no_pose_and_poses_that_are_no_numbers() -> None:
    """Nothing in, nothing out; NaN and infinity stay in their row, without a warning."""
    robot = load_robot("puma560")
    assert forward_batch(robot, np.empty((0, 6))).shape == (0, 4, 4)
    given = forward_batch(robot, [[0.1] * 6, [np.inf] * 6, [np.nan] * 6])
    assert np.isfinite(given[0]).all()
    assert np.isnan(given[1:, 0, 0]).all()


def test_an_out_of_another_shape_is_refused() -> None:
    """The message names both."""
    with pytest.raises(RobotError, match=r"\(2, 4, 4\) of float64"):
        forward_batch(load_robot("scara"), np.zeros((2, 3)), out=np.zeros((3, 4, 4)))
