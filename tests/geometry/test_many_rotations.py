"""Many poses said in other ways: the law is that each row is what one pose by itself would say."""

import math

import numpy as np
import pytest

from dhcli.errors import RobotError
from dhcli.geometry.euler import ORDERS, Order, RollPitchYaw
from dhcli.geometry.many import axis_angles, quaternions, roll_pitch_yaw, rotations, table
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from tests.row_by_row import row_by_row


def _rotation(axis: int, angle: float) -> np.ndarray:
    """A rotation about an axis, exact for multiples of 90°."""
    cos, sin = (round(f(angle), 15) for f in (math.cos, math.sin))
    turn = np.eye(4)
    i, k = (axis + 1) % 3, (axis + 2) % 3
    turn[i, i] = turn[k, k] = cos
    turn[i, k], turn[k, i] = -sin, sin
    return turn


def _poses() -> np.ndarray:
    """All turns by right angles about x, y, z, where every special case is, and random ones."""
    quarter = [k * math.pi / 2 for k in range(4)]
    poses = [_rotation(2, a) @ _rotation(1, b) @ _rotation(0, c) for a in quarter for b in quarter for c in quarter]
    random = np.random.default_rng(3)
    poses += [_rotation(2, a) @ _rotation(1, b) @ _rotation(0, c) for a, b, c in random.uniform(-4, 4, (200, 3))]
    poses += [_rotation(axis, math.pi) for axis in range(3)]
    batch = np.array(poses)
    batch[:, :3, 3] = random.normal(size=(len(batch), 3))
    return batch


POSES = _poses()


FORMS = [RollPitchYaw, Quaternion, AxisAngle, RotationVector]


@pytest.mark.parametrize("form", FORMS)
def test_every_row_is_what_one_pose_would_say(form: type[RollPitchYaw[float]]) -> None:
    """Half turns and pitch at ±90° included."""
    expected = np.array([form.of(pose[:3, :3].tolist()).numbers for pose in POSES])
    assert np.allclose(table(form, POSES), expected, rtol=0, atol=1e-12)


@row_by_row("order", ORDERS)
def test_every_order_says_of_many_what_it_says_of_one(order: Order) -> None:
    """Its angles, the other triple, where they are locked, and the matrices back."""
    many = order.of(rotations(POSES))
    alone = [order.of(pose[:3, :3].tolist()) for pose in POSES]
    assert np.allclose(many.angles, np.transpose([one.angles for one in alone]), rtol=0, atol=1e-12)
    assert np.allclose(many.other.angles, np.transpose([one.other.angles for one in alone]), rtol=0, atol=1e-12)
    assert np.asarray(many.locked).tolist() == [one.locked for one in alone]
    assert np.allclose(np.array(many.rotation()), np.moveaxis(POSES[:, :3, :3], 0, -1), rtol=0, atol=1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_no_pose_is_no_row(form: type[RollPitchYaw[float]]) -> None:
    """With as many columns as ever."""
    assert table(form, np.empty((0, 4, 4))).shape == (0, table(form, POSES).shape[1])


def test_the_poles_of_pitch_are_found() -> None:
    """As many as one by one."""
    alone = [RollPitchYaw.of(pose[:3, :3].tolist()).locked for pose in POSES]
    assert np.asarray(RollPitchYaw.of(rotations(POSES)).locked).tolist() == alone
    assert sum(alone) == 32


def test_poses_of_another_shape_are_refused() -> None:
    """One pose has properties of its own; poses in a list are many."""
    assert quaternions([np.eye(4), np.eye(4)]).tolist() == [[1, 0, 0, 0]] * 2  # type: ignore[arg-type]
    for say in (quaternions, axis_angles, roll_pitch_yaw):
        with pytest.raises(RobotError, match=r"poses have the shape \(N, 4, 4\), not \(4, 4\)"):
            say(np.eye(4))
