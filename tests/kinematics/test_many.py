"""Poses of several frames for many joint values: the same as one by one."""

import numpy as np
import pytest

from dhcli import forward, load_robot
from dhcli.errors import RobotError, UnknownNameError
from dhcli.kinematics.frames import View
from dhcli.kinematics.many import PoseRows, is_real
from dhcli.kinematics.values import parameter_values

SCARA = load_robot("scara")
LENGTHS = parameter_values(SCARA, {})


@pytest.mark.parametrize(
    ("start", "end", "inverse", "every", "frames"),
    [
        (None, None, False, False, [("0", "3")]),
        (None, None, True, False, [("3", "0")]),
        ("1", "tool", False, True, [("1", "2"), ("1", "3"), ("1", "tool")]),
        ("1", "3", True, True, [("3", "2"), ("3", "1")]),
        ("2", "2", False, True, [("2", "2")]),
    ],
)
def test_the_frames_are_those_of_fk(
    start: str | None, end: str | None, inverse: bool, every: bool, frames: list[tuple[str, str]]
) -> None:
    """Forwards, backwards, each on the way; a frame seen from itself is one as well."""
    view = View.of(SCARA, start, end, inverse=inverse)
    assert [(each.reference, each.frame) for each in (view.on_the_way(SCARA) if every else (view,))] == frames


def test_each_frame_has_its_poses_and_each_pose_its_forms() -> None:
    """Frame by frame, form by form."""
    frames = (("0", "1"), ("3", "base"))
    wanted = PoseRows(SCARA, tuple(View(*pair) for pair in frames), LENGTHS, ("position", "matrix"))
    q = np.random.default_rng(4).uniform(-1, 1, (5, 3))
    poses = wanted.poses(q)
    said = wanted.said(poses)
    assert said.shape == (5, 30)
    for row, pose, numbers in zip(q, poses, said, strict=True):
        expected = [forward(SCARA, list(row), start=start, end=end).matrix for start, end in frames]
        assert np.allclose(pose, expected, rtol=0, atol=1e-14)
        assert np.array_equal(numbers, np.concatenate([np.append(one[:3, 3], one[:3]) for one in pose]))


def test_a_row_counts_as_locked_once() -> None:
    """However many of its frames are, and only where roll and yaw are asked for."""
    wrist = load_robot("spherical-wrist")
    frames = View.of(wrist).on_the_way(wrist)
    lengths = parameter_values(wrist, {"d6": 0.1})
    q = np.array([[0, 0, 0], [0, np.pi / 2, 0], [0.3, 0.4, 0.5]])
    alone = PoseRows(wrist, frames[-1:], lengths, ("rpy",))
    assert alone.locked(alone.poses(q)) == {"rpy": 1}
    every = PoseRows(wrist, frames, lengths, ("rpy", "position"))
    poses = [
        [forward(wrist, list(row), start=view.start, end=view.end, parameters={"d6": 0.1}) for view in frames]
        for row in q
    ]
    count = sum(any(pose.rpy.locked for pose in row) for row in poses)
    assert every.locked(every.poses(q)) == {"rpy": count}
    assert PoseRows(wrist, frames, lengths, ("position",)).locked(every.poses(q)) == {}


def test_rows_that_are_no_numbers_are_told_apart() -> None:
    """By any entry of any frame."""
    wanted = PoseRows(SCARA, (View("0", "1"), View("0", "3")), LENGTHS)
    poses = wanted.poses(np.array([[0.1, 0.2, 0.3], [0.1, np.nan, 0.3], [0.1, 0.2, np.inf]]))
    assert is_real(poses).tolist() == [True, False, False]
    assert is_real(wanted.poses(np.array([[0.1, 0.2, 1e300]] * 2))).all()  # whose squares are too large for a number


def test_what_no_row_can_have_is_refused_before_there_is_one() -> None:
    """A form that is not known, a length without a value, a robot without a joint."""
    with pytest.raises(UnknownNameError, match="did you mean rpy"):
        PoseRows(SCARA, (View("0", "3"),), LENGTHS, ("rpyy",))
    link = load_robot("dh-link")
    with pytest.raises(RobotError, match="a_i"):
        PoseRows(link, (View.of(link),), {})
    blocks = load_robot("assembly-blocks")
    with pytest.raises(RobotError, match="no joint"):
        PoseRows(blocks, (View.of(blocks),), {})
