import numpy as np
import pytest
from numpy.typing import NDArray

from dhcli import forward, forward_batch, load_robot
from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.kinematics.batch import BLOCK
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between
from dhcli.kinematics.moves import Trans
from dhcli.kinematics.robot import Link, Robot
from dhcli.kinematics.values import numbers, parameter_values
from dhcli.notation.tree import ONE, ZERO


@pytest.mark.parametrize("name", ["scara", "puma560", "stanford", "panda"])
def test_a_batch_is_the_plain_fold_row_by_row(name: str) -> None:
    """Every pose of a batch is the pose of its row."""
    robot = load_robot(name)
    poses = np.random.default_rng(1).uniform(-3, 3, (7, len(robot.variables)))
    batch = forward_batch(robot, poses)
    for q, pose in zip(poses, batch, strict=True):
        assert np.allclose(pose, forward(robot, list(q)).matrix, atol=1e-14)


REACH = 1.0
"""At least the reach of PUMA 560 [m]."""


@pytest.mark.parametrize(
    "q",
    [
        np.pi * np.arange(-9, 9, 2).repeat(6).reshape(-1, 6),
        np.pi * (2 * np.random.default_rng(3).integers(-(10**7), 10**7, (200, 6)) + 1.0),
        np.pi + 10.0 ** np.random.default_rng(4).uniform(-17, -2, (200, 6)),
        np.nextafter(np.pi / 2 * np.arange(1, 100, 2), 0).repeat(6).reshape(-1, 6),
        np.random.default_rng(5).uniform(-1e6, 1e6, (200, 6)),
        np.random.default_rng(6).uniform(-1e300, 1e300, (200, 6)),
        10.0 ** np.random.default_rng(7).uniform(-320, -3, (200, 6)),
    ],
    ids=["odd pi", "large odd pi", "near pi", "half pi", "large", "huge", "tiny"],
)
def test_a_batch_loses_no_digits_where_the_half_angle_tangent_has_poles_or_angles_are_large(
    q: NDArray[np.float64],
) -> None:
    """1e-14 of the reach from the plain fold of the unmerged chain, with the sines of the C library."""
    robot = load_robot("puma560")
    lengths = numbers(parameter_values(robot, {}))
    batch = forward_batch(robot, q)
    chain = between(robot, "0", "6")
    for row, pose in zip(q, batch, strict=True):
        plain = fold(chain, Floats({**lengths, **dict(zip(robot.variables, row, strict=True))}))
        assert np.abs(pose - np.array(plain)).max() <= 1e-14 * REACH


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


@pytest.mark.parametrize("rows", [[[0.1, 0.2, 0.3], [0.1]], [["a", "b", "c"]]])
def test_what_is_no_array_of_numbers_is_refused(rows: list[list[float]]) -> None:
    """Rows of different lengths, text."""
    with pytest.raises(RobotError, match="no array of numbers"):
        forward_batch(load_robot("scara"), rows)


def test_a_robot_without_joints_stands_where_it_stands() -> None:
    """One pose for each empty row."""
    still = Robot("still", "", "", Convention.PRODUCT, (), (Link(1, (Trans(ZERO, ZERO, ONE),)),))
    assert forward_batch(still, np.empty((2, 0)))[:, 2, 3].tolist() == [1.0, 1.0]


def test_an_out_of_another_shape_is_refused() -> None:
    """The message names both."""
    with pytest.raises(RobotError, match=r"\(2, 4, 4\) of float64"):
        forward_batch(load_robot("scara"), np.zeros((2, 3)), out=np.zeros((3, 4, 4)))


def test_arguments_that_cannot_be_used_are_refused_in_words() -> None:
    """A list for `out`, an array that nobody may write to, complex numbers, rows of different lengths."""
    robot = load_robot("scara")
    fixed = np.zeros((1, 4, 4))
    fixed.flags.writeable = False
    with pytest.raises(RobotError, match="out is read-only"):
        forward_batch(robot, [[0, 0, 0]], out=fixed)
    with pytest.raises(RobotError, match="out is no numpy array but list"):
        forward_batch(robot, [[0, 0, 0]], out=[1])  # type: ignore[arg-type]
    with pytest.raises(RobotError, match="Q holds complex numbers"):
        forward_batch(robot, np.zeros((1, 3), dtype=complex))
    with pytest.raises(RobotError, match=r"Q is no array of numbers .*rows of 3 numbers, all as long"):
        forward_batch(robot, [[0, 0, 0], [1]])
