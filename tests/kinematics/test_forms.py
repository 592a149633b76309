"""Many poses said in other ways: the law is that each row is what one pose by itself would say."""

import math

import numpy as np
import pytest

from dhcli.errors import RobotError
from dhcli.kinematics.forms import FORMS, axis_angles, locked, quaternions
from dhcli.kinematics.forms import roll_pitch_yaw as rows_of_rpy
from dhcli.kinematics.orientation import axis_angle, quaternion, roll_pitch_yaw
from dhcli.kinematics.placement import FORMS as SINGLE
from dhcli.kinematics.pose import Pose


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


def _alone(pose: np.ndarray, form: str) -> list[float]:
    """What `fk` says of one pose."""
    single = Pose(tuple(map(tuple, pose.tolist())))
    match form:
        case "matrix":
            return [entry for row in single.rows[:3] for entry in row]
        case "position":
            return list(single.position)
        case "rpy":
            said = roll_pitch_yaw(single)
            return [said.roll, said.pitch, said.yaw]
        case "quaternion":
            turn = quaternion(single)
            return [turn.w, turn.x, turn.y, turn.z]
        case _:
            turned = axis_angle(single)
            return [*turned.axis, turned.angle]


@pytest.mark.parametrize("form", FORMS)
def test_every_row_is_what_one_pose_would_say(form: str) -> None:
    """Half turns and pitch at ±90° included."""
    expected = np.array([_alone(pose, form) for pose in POSES])
    assert np.allclose(FORMS[form](POSES), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_no_pose_is_no_row(form: str) -> None:
    """With as many columns as ever."""
    assert FORMS[form](np.empty((0, 4, 4))).shape == (0, FORMS[form](POSES).shape[1])


def test_a_batch_knows_every_form_that_one_pose_knows() -> None:
    """By the same names."""
    assert set(FORMS) == set(SINGLE)


def test_the_poles_of_pitch_are_found() -> None:
    """As many as one by one."""
    alone = [roll_pitch_yaw(Pose(tuple(map(tuple, pose.tolist())))).locked for pose in POSES]
    assert locked(POSES).tolist() == alone
    assert sum(alone) == 32


def test_poses_of_another_shape_are_refused() -> None:
    """One pose has properties of its own; poses in a list are many."""
    assert quaternions([np.eye(4), np.eye(4)]).tolist() == [[1, 0, 0, 0]] * 2  # type: ignore[arg-type]
    for say in (quaternions, axis_angles, rows_of_rpy):
        with pytest.raises(RobotError, match=r"poses have the shape \(N, 4, 4\), not \(4, 4\)"):
            say(np.eye(4))
