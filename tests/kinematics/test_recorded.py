"""What is recorded for a robot and played again says what the fold says, and is no more than a process can hold."""

from __future__ import annotations

import gc
import math
import pickle
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import Pose, Robot, forward, jacobian, load_robot
from dhcli.errors import DhcliError, RobotError
from dhcli.kinematics import recorded
from dhcli.kinematics.forward import numeric_pose
from dhcli.kinematics.frames import ends
from dhcli.kinematics.values import joint_values, parameter_values
from dhcli.kinematics.velocity.form import Form
from dhcli.kinematics.velocity.jacobian import numeric_jacobian
from dhcli.kinematics.velocity.view import MotionView
from tests.kinematics.arms import moving_robots, with_values
from tests.row_by_row import row_by_row


def folded(robot: Robot, q: Sequence[float], start: str | None = None, end: str | None = None) -> Pose[float]:
    """The pose without anything recorded."""
    return numeric_pose(robot, {**parameter_values(robot, {}), **joint_values(robot, q)}, *ends(robot, start, end))


@pytest.mark.parametrize("name", moving_robots())
def test_a_pose_that_is_played_is_the_pose_of_the_fold(name: str) -> None:
    """Every robot, three views, values among them zeros: to the last digit or the one before it."""
    robot = load_robot(name)
    robot = robot.copy(parameters=with_values(robot))
    rng = np.random.default_rng(1)
    for frames in ((None, None), ("base", "tool"), (robot.frames[-2], robot.frames[1])):
        for zeros in (0.0, 0.3, 1.0):
            q = (rng.uniform(-3, 3, len(robot.variables)) * (rng.random(len(robot.variables)) >= zeros)).tolist()
            plain = folded(robot, q, *frames)
            again = [forward(robot, q, start=frames[0], end=frames[1]) for _ in range(2)]
            for pose in again:
                assert np.abs(pose.matrix - plain.matrix).max() <= 4e-16 * max(1.0, np.abs(plain.matrix).max())
                assert (pose.reference, pose.frame, pose.joints) == (plain.reference, plain.frame, plain.joints)


def test_a_pose_that_is_played_is_a_pose_like_any_other() -> None:
    """Made without a look at its numbers: equal to one that was looked at, with the same hash and text, and copied."""
    robot = load_robot("scara")
    played = [forward(robot, [0.3, 0.5, 0.1], start=1) for _ in range(3)][-1]
    made = Pose(played.rows, "1", "3", joints=robot.writing)
    assert played == made
    assert (hash(played), repr(played), played.latex(), played.title) == (hash(made), repr(made), made.latex(), "")
    assert pickle.loads(pickle.dumps(played)) == made  # noqa: S301  our own
    assert replace(played, frame="tool").frame == "tool"
    assert played @ played.inverse() == made @ made.inverse()


@pytest.mark.parametrize("name", ["planar-2r", "scara", "puma560", "stanford", "panda"])
def test_a_jacobian_that_is_played_is_that_of_the_fold(name: str) -> None:
    """The first time and every other, in other axes and by parts; what is no number is refused every time."""
    robot = load_robot(name)
    q = np.random.default_rng(2).uniform(-3, 3, len(robot.variables)).tolist()
    for part, axes in (("all", None), ("linear", "1"), ("angular", "0")):
        view, form = MotionView.of(robot, axes=axes), Form(part)  # type: ignore[arg-type]
        wanted = numeric_jacobian(robot, {**parameter_values(robot, {}), **joint_values(robot, q)}, view, form).matrix
        for _ in range(3):
            assert np.abs(jacobian(robot, q, part=part, axes=axes) - wanted).max() <= 4e-16  # type: ignore[arg-type]
    for bad in (math.nan, math.inf):
        for _ in range(3):
            with pytest.raises(RobotError, match="not a number that a joint can have"):
                jacobian(robot, [bad, *q[1:]])


@given(st.lists(st.floats(-1e300, 1e300) | st.integers(-(10**400), 10**400), min_size=3, max_size=3))
def test_no_values_are_too_large_to_be_answered(q: list[float]) -> None:
    """The recording and the fold say the same, or refuse alike."""
    robot = load_robot("scara")
    forward(robot, [0.1, 0.2, 0.3])
    answers = []
    for ask in (forward, folded):
        try:
            answers.append(ask(robot, q).rows)
        except RobotError as error:
            answers.append(str(error))
    assert answers[0] == answers[1]


@row_by_row("bad", [math.nan, math.inf, -math.inf])
@row_by_row("joint", [0, 2, 5])
def test_a_value_that_is_no_number_is_refused_wherever_it_stands(bad: float, joint: int) -> None:
    """Also at a joint behind the frame that is asked for, the first time and every other."""
    robot = load_robot("puma560")
    q = [0.1] * 6
    q[joint] = bad
    for _ in range(3):
        with pytest.raises(RobotError, match=rf"theta{joint + 1} = {bad} is not a number"):
            forward(robot, q, end=2)
        forward(robot, [0.1] * 6, end=2)


@pytest.mark.parametrize("q", [[0.1], [0.1] * 4, ["a", 0, 0], [None, 0, 0], [[0.1], 0, 0], 5, [1j, 0, 0]])
def test_what_is_no_row_of_numbers_is_refused_as_before(q: object) -> None:
    """A recording never takes what the general way would not."""
    robot = load_robot("scara")
    errors = []
    for ask in (folded, forward, forward, forward):
        with pytest.raises(DhcliError) as caught:
            ask(robot, q)  # type: ignore[arg-type]
        errors.append(str(caught.value))
    assert len(set(errors)) == 1


def test_arrays_tuples_and_numpy_numbers_are_played_too() -> None:
    """The same pose for each, and floats in it, not numbers of numpy."""
    robot = load_robot("scara")
    q = [0.3, 0.5, 0.1]
    poses = [
        forward(robot, kind)
        for kind in (q, tuple(q), np.array(q), list(np.array(q)), {"theta1": 0.3, "theta2": 0.5, "d3": 0.1})
    ]
    assert len({pose.rows for pose in poses}) == 1
    assert {type(entry) for pose in poses for row in pose.rows for entry in row} == {float}
    assert forward(robot, [0, 1, 0]) == folded(robot, [0, 1, 0])
    assert forward(robot, np.array([1, 2, 0])) == folded(robot, [1, 2, 0])


def test_other_lengths_are_not_those_that_were_recorded() -> None:
    """By parameters, and in a copy."""
    robot = load_robot("planar-2r")
    for _ in range(3):
        assert forward(robot, [0.0, 0.0]).position[0] == pytest.approx(0.7)
        assert forward(robot, [0.0, 0.0], parameters={"a2": 1.0}).position[0] == pytest.approx(1.4)
        assert forward(robot.copy(parameters={"a2": 2.0}), [0.0, 0.0]).position[0] == pytest.approx(2.4)


def test_a_length_without_a_value_is_asked_for_every_time() -> None:
    """Nothing is recorded that cannot be computed."""
    robot = load_robot("dh-link")
    assert None in robot.parameters.values()
    for _ in range(3):
        with pytest.raises(RobotError, match="no value"):
            forward(robot, [0.1] * len(robot.variables))


def test_what_is_recorded_is_bounded_over_all_robots(monkeypatch: pytest.MonkeyPatch) -> None:
    """The oldest goes, from robots that live; one that went is recorded again, and robots may be thrown away."""
    monkeypatch.setattr(recorded, "MOST", 5)
    monkeypatch.setattr(recorded, "_KEPT", type(recorded._KEPT)())
    arm = load_robot("planar-2r")
    robots = [replace(arm, name=f"arm {k}") for k in range(20)]
    for robot in robots:
        for _ in range(3):
            assert forward(robot, [0.3, 0.5]) == folded(robot, [0.3, 0.5])
    assert sum(len(robot.recorded) for robot in robots) == 5
    assert forward(robots[0], [0.3, 0.5]) == folded(robots[0], [0.3, 0.5])
    del robots[1:], robot
    gc.collect(1)  # the young, as these are; what other tests keep is much, and old
    for k in range(20):
        forward(replace(arm, name=f"other {k}"), [0.3, 0.5])
    assert len(recorded._KEPT) == 5


def test_a_robot_that_is_loaded_again_is_the_same_until_its_file_changes(tmp_path: Path) -> None:
    """And with it what was recorded; under another path it is a robot of its own, which says where it stands."""
    text = (load_robot("planar-2r").path or tmp_path).read_text("utf-8")
    path, other = tmp_path / "arm.yaml", tmp_path / "arm.yml"
    path.write_text(text, "utf-8")
    other.write_text(text, "utf-8")
    first = load_robot(path)
    assert load_robot(path) is first
    assert load_robot(other) == first
    assert load_robot(other).path == other
    path.write_text(text.replace("title: ", "title: longer "), "utf-8")
    assert load_robot(path).title == f"longer {first.title}"
