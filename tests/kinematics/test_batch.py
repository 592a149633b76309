import numpy as np
import pytest

from dhcli import forward, forward_batch, load_robot
from dhcli.errors import RobotError


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
