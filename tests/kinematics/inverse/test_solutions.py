"""What is asked and what is answered: names, turns, limits, held joints, families, and what is not a pose."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from dhcli import Solutions, follow, forward, forward_batch, inverse, inverse_batch, load_robot
from dhcli.errors import RobotError, UnknownNameError
from dhcli.kinematics.inverse import batch
from dhcli.kinematics.inverse.branches import Told, with_values
from dhcli.kinematics.inverse.tasks import TaskName
from dhcli.kinematics.inverse.turns import limits_of
from tests.kinematics.arms import numbered_hinges
from tests.nightly import NIGHT
from tests.row_by_row import row_by_row


def solved(name: str, q: object, **asked: object) -> Solutions:
    """Solutions for where some joint values stand."""
    robot = load_robot(name)
    return inverse(robot, forward(robot, q), **asked)  # type: ignore[arg-type]


def test_puma_has_eight_solutions_each_with_a_name_of_its_own() -> None:
    """Shoulder, elbow and wrist are told apart in all combinations."""
    found = solved("puma560", [0.3, -0.5, 0.7, 1, 0.8, -2])
    words = [
        f"shoulder {s}, elbow {e}, wrist {w}"
        for s, e, w in product(("left", "right"), ("up", "down"), ("flip", "noflip"))
    ]
    assert sorted(found.branches) == sorted(words)


def test_names_of_branches_go_with_the_arm_and_not_with_the_order_of_roots() -> None:
    """Along a way through poses without a singular one each branch keeps its name, and moves little at each step."""
    robot = load_robot("puma560")
    start, end = np.array([0.3, -0.5, 0.7, 1, 0.8, -2]), np.array([0.6, -0.3, 0.5, 0.7, 1.1, -1.5])
    before: dict[str, np.ndarray] = {}
    for t in np.linspace(0, 1, 20):
        found = inverse(robot, forward(robot, list(start + t * (end - start))))
        now = dict(zip(found.branches, found.q, strict=True))
        for branch, q in before.items():
            way = now[branch] - q
            assert np.abs(way - 2 * np.pi * np.round(way / (2 * np.pi))).max() < 0.2
        before = now


def test_the_zero_pose_of_puma_has_its_elbow_up() -> None:
    """Upper arm level, forearm hanging down: the elbow is above the line from shoulder to wrist."""
    found = solved("puma560", "zero", near="zero")
    assert np.allclose(found[0], 0, atol=1e-9)
    assert "elbow up" in found.branches[0]


def test_planar_arm_reaches_a_point_with_elbow_up_and_down() -> None:
    """A positive theta2 has the elbow below the line, as books draw it."""
    found = solved("planar-2r", [0.3, 0.5], task="position")
    assert {b: np.sign(q[1]) for b, q in zip(found.branches, found.q, strict=True)} == {"elbow up": -1, "elbow down": 1}


@pytest.mark.parametrize(
    ("name", "q", "task", "count"),
    [
        ("zhou-6r", [0.3, -0.5, 0.7, 1, 0.8, -2], "pose", 8),
        ("stanford", [0.3, -0.5, 0.7, 1, 0.8, -2], "pose", 8),
        ("ur5e", [0.3, -0.5, 0.7, 1, 0.8, -2], "pose", 8),
        ("ur5e", "work", "pose", 8),
        ("puma560", "zero", "pose", 7),
        ("cylindrical-wrist", [0.3, 0.2, 0.5, 0.1, 0.2, 0.3], "pose", 4),
        ("scara-yim", [0.3, 0.5, 0.1, 0.2], "pose", 2),
        ("articulated", [0.3, 0.2, 0.5], "position", 4),
        ("scara", [0.3, 0.5, 0.1], "position", 2),
    ],
)
def test_as_many_solutions_as_the_arm_has(name: str, q: object, task: str, count: int) -> None:
    """The counts of the literature; of a family one member counts."""
    found = solved(name, q, task=task)
    assert len(found) == count
    assert len(set(found.branches)) == count


def test_an_aligned_wrist_is_a_family_and_not_a_number_at_random() -> None:
    """theta4 + theta6 is fixed, theta4 is 0, or where it is wanted near to."""
    found = solved("spherical-wrist", [0.3, 0.0, 0.5])
    assert np.allclose(found.q, [[0, 0, 0.8]])
    assert [way.relation for way in found.free[0]] == ["theta4 + theta6 = 45.8366°, any theta4"]
    near = solved("spherical-wrist", [0.3, 0.0, 0.5], near=[0.2, 0, 0.1])
    assert np.allclose(near.q, [[0.2, 0, 0.6]])


def test_a_wrist_turned_back_fixes_the_difference() -> None:
    """At theta5 = 180° the outer axes are opposite."""
    found = solved("spherical-wrist", [0.3, np.pi, 0.5])
    assert found.free[0][0].relation == f"theta4 - theta6 = {np.degrees(-0.2):g}°, any theta4".replace(
        "-11.4592", "-11.4592"
    )


def test_an_arm_whose_inner_joints_must_move_too_says_which() -> None:
    """UR5e with theta5 = 0: four parallel axes, no simple sum."""
    found = solved("ur5e", [0.3, -0.5, 0.7, 1, 0, -2])
    relations = {way.relation for ways in found.free for way in ways}
    assert relations == {"theta2, theta3, theta4, theta6 move together, any theta2"}


def test_a_joint_that_is_held_keeps_its_value() -> None:
    """Holding the joint of a family gives its other members."""
    found = solved("spherical-wrist", [0.3, 0.0, 0.5], hold={"theta4": "10°"})
    assert np.allclose(found.q, [[np.radians(10), 0, 0.8 - np.radians(10)]])
    assert found.held == (("theta4", pytest.approx(np.radians(10))),)


def test_a_spare_joint_is_held_and_told() -> None:
    """Panda has seven joints: theta7 stands where it is wanted near to, and the original is found."""
    found = solved("panda", "ready", near="ready")
    assert np.allclose(found[0], [0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4], atol=1e-9)
    assert found.remarks == ("panda has 1 joint more than this needs: held theta7 = 45°",)


@pytest.mark.parametrize("task", ["pose", "position", "axis", "orientation", "direction"])
@pytest.mark.parametrize("name", ["panda", "puma560", "ur5e", "scara"])
def test_joint_values_to_reach_are_among_the_solutions(name: str, task: TaskName) -> None:
    """Whatever the task leaves over is held at them; a matrix of the same pose holds it at 0."""
    robot = load_robot(name)
    q = (np.arange(len(robot.variables)) * 0.37 - 0.9).tolist()
    found = inverse(robot, dict(zip(robot.variables, q, strict=True)), task=task)
    assert found.distances(q).min() < 1e-6
    if found.held:
        assert dict(found.held) == pytest.approx({key: q[robot.variables.index(key)] for key in dict(found.held)})
        assert found.remarks[-1].endswith(", as in the joint values given")
        by_matrix = inverse(robot, forward(robot, q), task=task)
        assert "as in" not in by_matrix.remarks[-1]


def test_a_named_pose_is_reached_and_a_joint_held_by_hand_stands_where_it_is_wanted() -> None:
    """`hold` and `near` say more than the pose does."""
    robot = load_robot("panda")
    assert inverse(robot, "ready").distances("ready").min() < 1e-6
    assert dict(inverse(robot, "ready", hold={"theta7": 0.1}).held) == {"theta7": pytest.approx(0.1)}
    assert dict(inverse(robot, "ready", near=[0.0] * 7).held) == {"theta7": 0.0}


@pytest.mark.parametrize(
    "table", ["panda", ".2,-90,-.15 .4,90,0 .1,0,0 .1,0,.15 .1,-90,.15 .2,90,.15", ".1,90,0 .2,0,.15 0,90,0 .3,-90,0"]
)
def test_a_batch_finds_what_single_poses_have(table: str) -> None:
    """At right angles: where a joint to spare has to be held elsewhere than at 0, and at singular poses."""
    robot = load_robot(table) if "," not in table else numbered_hinges(table)
    q = np.random.default_rng(5).integers(-3, 5, (12 if NIGHT else 6, len(robot.variables))) * np.pi / 4
    poses = forward_batch(robot, q)
    values, index = inverse_batch(robot, poses)
    assert set(index.tolist()) == set(range(len(poses)))
    for k, pose in enumerate(poses):
        assert (index == k).sum() == len(inverse(robot, pose))
    assert np.abs(forward_batch(robot, values) - poses[index]).max() < 1e-10


def test_a_family_of_a_spare_joint_is_sampled() -> None:
    """Each sample gives solutions, and each of them reaches the pose."""
    robot = load_robot("panda")
    pose = forward(robot, "ready")
    found = inverse(robot, pose, family=8)
    assert len({round(q[6], 6) for q in found}) > 3
    for q in found:
        assert np.abs(forward(robot, list(q)).matrix - pose.matrix).max() < 1e-11


def test_a_pose_inside_the_limits_is_reached_inside_them_with_a_joint_to_spare_held_elsewhere() -> None:
    """One by one and many at once: each pose of a Panda's that joint values inside its limits made."""
    robot = load_robot("panda")
    low, high = limits_of(robot).T
    poses = forward_batch(robot, low + (high - low) * np.random.default_rng(3).random((40 if NIGHT else 8, 7)))
    many, index = inverse_batch(robot, poses, within_limits=True)
    assert set(index.tolist()) == set(range(len(poses)))
    assert ((many >= low - 1e-9) & (many <= high + 1e-9)).all()
    assert np.abs(forward_batch(robot, many) - poses[index]).max() < 1e-10
    for k, pose in enumerate(poses[:3]):
        found = inverse(robot, pose, within_limits=True)
        assert found.within_limits.all()
        assert len(found) == (index == k).sum()


def test_solutions_outside_limits_are_marked_or_left_out() -> None:
    """The joint and by how much; `within_limits` leaves them out."""
    found = solved("puma560", "ready")
    marked = [(b.joint, round(float(np.degrees(b.by)), 6)) for beyond in found.beyond for b in beyond]
    assert marked == [("theta4", 10.0)] * 3
    assert len(solved("puma560", "ready", within_limits=True)) == len(found) - 3 == found.within_limits.sum()


def test_limits_that_exclude_everything_are_named() -> None:
    """The pose can be reached, and the answer says what keeps it from being."""
    robot = load_robot("puma560")
    found = inverse(robot, forward(robot, [0, 0, 1.2, 0, 0, 0]), hold={"theta3": 1.2}, within_limits=True)
    assert found.reachable
    assert not len(found)
    assert "theta3 23.75° above" in found.why


def test_every_turn_that_the_limits_allow_is_given_on_request() -> None:
    """UR5e's joints turn twice: up to two values of each angle, and never one outside."""
    few, many = solved("ur5e", "work"), solved("ur5e", "work", all_turns=True)
    assert len(many) > len(few)
    assert many.within_limits.all()
    assert np.abs(many.q).max() <= 2 * np.pi + 1e-9
    assert {tuple(np.round(np.cos(q), 6)) for q in many} == {tuple(np.round(np.cos(q), 6)) for q in few}


def test_solutions_are_sorted_by_what_they_should_be_near_to() -> None:
    """And `nearest` is the first of them then."""
    q = [0.3, -0.5, 0.7, 1, 0.8, -2]
    found = solved("puma560", q, near=q)
    assert np.allclose(found[0], q)
    assert (np.diff(np.linalg.norm(found.q - q, axis=1)) >= -1e-9).all()
    assert np.allclose(found.nearest(q), q)


def test_solutions_are_an_array_to_numpy() -> None:
    """Shape, indices, slices, a loop."""
    found = solved("scara-yim", [0.3, 0.5, 0.1, 0.2])
    assert np.asarray(found).shape == (2, 4)
    assert found[0].shape == (4,)
    assert found[:, 2].shape == (2,)
    assert len(list(found)) == 2


def test_solutions_show_themselves_as_a_table() -> None:
    """Degrees, metres, branch, limits."""
    assert repr(solved("scara-yim", [0.3, 0.5, 0.1, 0.2])).splitlines()[1].split() == [
        "1", "17.1887°", "28.6479°", "0.1", "11.4592°", "elbow", "right", "ok",
    ]  # fmt: skip


def test_links_base_and_tool_may_be_the_ends() -> None:
    """Any two frames of the robot, in either direction."""
    robot = load_robot("puma560")
    q = [0.3, -0.5, 0.7, 1, 0.8, -2]
    for start, end in (("base", "tool"), (3, 6), (6, 0)):
        found = inverse(robot, forward(robot, q, start=start, end=end), start=start, end=end)
        for row in found:
            reached = forward(robot, list(row), start=start, end=end).matrix
            assert np.abs(reached - forward(robot, q, start=start, end=end).matrix).max() < 1e-11
        assert len(found)


def test_a_pose_typed_with_few_digits_is_put_right_and_told() -> None:
    """The nearest rotation, and by how much it differs."""
    robot = load_robot("puma560")
    typed = np.round(forward(robot, [0.3, -0.5, 0.7, 1, 0.8, -2]).matrix, 4)
    found = inverse(robot, typed)
    assert len(found) == 8
    assert found.remarks[0].startswith("the direction cosines were no rotation; the nearest one was taken")


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda t: t * [1.1, 1, 1, 1], "no rotation: the nearest one differs by 0.09"),
        (lambda t: t * [-1, 1, 1, 1], "left-handed"),
        (lambda t: t * [1, 1, 1, np.nan], "not a number"),
        (lambda t: t.T, "last row"),
        (lambda t: t[:3], "an array of the shape"),
        (lambda t: "abc", "no pose"),
        (lambda t: np.add(t, np.outer([1e13, 0, 0, 0], [0, 0, 0, 1])), "farther away"),
    ],
)
def test_what_is_no_pose_is_refused(change: object, said: str) -> None:
    """With what is wrong with it."""
    robot = load_robot("puma560")
    with pytest.raises(RobotError, match=said):
        inverse(robot, change(forward(robot, [0.3, -0.5, 0.7, 1, 0.8, -2]).matrix))  # type: ignore[operator]


@row_by_row("name", ["scara", "palletizer"])
@row_by_row(
    ("options", "said"),
    [
        ({"hold": 3}, "hold says what a joint is held at, by its name, and 3 does not"),
        ({"hold": np.zeros(3)}, "hold says what a joint is held at"),
        ({"tolerance": "small"}, "tolerance is 0 or a positive number, not 'small'"),
        ({"tolerance": -1e-9}, "tolerance is 0 or a positive number"),
        ({"task": ["pose"]}, r"there is no task \['pose'\]"),
    ],
)
def test_what_no_question_can_be_asked_with_is_refused(name: str, options: dict[str, object], said: str) -> None:
    """By each way to ask, also of arms whose joints move one another; such a one follows nothing."""
    robot = load_robot(name)
    q = [0.1] * len(robot.variables)
    pose = forward(robot, q)
    ways = [lambda: inverse(robot, pose, **options), lambda: inverse_batch(robot, [pose.matrix], **options)]
    if name == "scara":
        ways.append(lambda: follow(robot, [pose.matrix], q, **options))
    for ask in ways:
        with pytest.raises((RobotError, UnknownNameError), match=said):
            ask()


def test_unknown_names_are_refused_with_the_nearest_one() -> None:
    """A joint that does not exist, a task that does not."""
    robot = load_robot("puma560")
    with pytest.raises(RobotError, match="theta9"):
        inverse(robot, np.eye(4), hold={"theta9": 1})
    with pytest.raises(UnknownNameError, match="position"):
        inverse(robot, np.eye(4), task="positon")  # type: ignore[arg-type]


def test_a_robot_without_a_joint_has_nothing_to_compute() -> None:
    """Blocks put together do not move."""
    with pytest.raises(RobotError, match="no joint moves the end"):
        inverse(load_robot("assembly-blocks"), np.eye(4))


def test_a_length_without_value_is_asked_for() -> None:
    """As `forward` asks."""
    with pytest.raises(RobotError, match="have no value"):
        inverse(load_robot("dh-link"), np.eye(4))


def test_a_batch_takes_the_nearest_or_one_of_each_pose() -> None:
    """One row a pose, none where it is out of reach."""
    robot = load_robot("puma560")
    q = [0.3, -0.5, 0.7, 1, 0.8, -2]
    poses = np.stack([forward(robot, q).matrix] * 3)
    poses[1, 0, 3] = 9
    nearest, index = inverse_batch(robot, poses, each="nearest", near=q)
    assert index.tolist() == [0, 2]
    assert np.allclose(nearest, [q, q])
    one, index = inverse_batch(robot, poses, each="first")
    assert index.tolist() == [0, 2]
    inside, _ = inverse_batch(robot, poses, within_limits=True)
    assert len(inside) < 16
    assert len(one) == 2


@pytest.mark.parametrize("threads", [2, 5])
def test_threads_find_the_same_to_the_last_digit(threads: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """More blocks than threads, of an arm and of one whose rows share a joint, which is computed by another arm."""
    monkeypatch.setattr(batch, "BLOCK", 20)
    q = np.random.default_rng(3).uniform(-1, 1, (120, 4))
    for robot in (load_robot("scara-yim"), load_robot("palletizer")):
        poses = forward_batch(robot, q[:, : len(robot.variables)])
        alone = inverse_batch(robot, poses)
        shared = inverse_batch(robot, poses, threads=threads)
        assert len(alone[1]) >= 120
        assert all(np.array_equal(one, other) for one, other in zip(alone, shared, strict=True))


def test_what_is_no_number_of_threads_is_refused() -> None:
    """Before anything is computed."""
    with pytest.raises(RobotError, match="threads is a number from 1, not 0"):
        inverse_batch(load_robot("planar-2r"), np.empty((0, 3)), task="position", threads=0)


def test_an_empty_batch_is_an_empty_answer() -> None:
    """No poses, no rows."""
    found, index = inverse_batch(load_robot("puma560"), np.empty((0, 4, 4)))
    assert found.shape == (0, 6)
    assert index.shape == (0,)


def test_a_family_is_told_though_rounding_has_left_one_of_its_members_beside_it() -> None:
    """A wrist 1e-9 from straight: a straight one reaches the pose as well, as far as floats tell."""
    robot = load_robot("zhou-6r")
    q = np.array([-135.0, -90.0, -90.0, 180.0, 0.0, -135.0]) * np.pi / 180 + 1e-9 * np.array([1, -1, 1, -1, 1, -1])
    found = inverse(robot, forward(robot, list(q)))
    assert [way.joint for ways in found.free for way in ways] == ["theta4"]
    held = inverse(robot, forward(robot, list(q)), hold={"theta4": float(q[3])})
    assert held.distances(list(q)).min() < 1e-7


def test_a_point_that_few_values_of_the_joints_held_reach_is_reached_all_the_same() -> None:
    """The Stanford hand stands on its own base only where the wrist is turned just so."""
    robot = load_robot("stanford")
    found = inverse(robot, (0, 0, 0), task="position")
    assert len(found)
    for q in found:
        assert np.allclose(forward(robot, list(q)).position, 0, atol=1e-12)
    assert {name for name, _ in found.held} == {"theta4", "theta5", "theta6"}


def test_a_family_says_at_how_many_of_its_values_there_are_solutions() -> None:
    """A coarse family of the Panda's may hold few or none."""
    q = [0, 0.2, 0.3, -1, 0.2, 1, 0.3]
    for family in (2, 3, 6, 24):
        found = solved("panda", q, family=family)
        held = {round(value, 9) for value in found.q[:, 6].tolist()}
        count = str(len(held)) if held else "none"
        assert f"theta7 sampled at {family} values, {count} of them with solutions" in found.remarks[0]
        assert len(found) or "other values of theta7 reach it" in found.why


def test_a_value_that_only_rounding_makes_differ_names_no_branch() -> None:
    """As of a slide that is held at 0; the joint that stands elsewhere is named."""
    q = np.array([[1e-17, 0.3, 0.2], [-0.0, 0.3 + 1e-15, 0.5]])
    told = Told(("x", "theta2", "lift"), np.array([False, True, False]), q, {})
    assert with_values(told, [["wrist flip"], ["wrist flip"]]) == (
        "wrist flip, lift = 0.2 m",
        "wrist flip, lift = 0.5 m",
    )


def test_the_nearest_pose_is_looked_for_behind_few_poses_of_a_batch(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is beyond reach tells nothing for its time; joints to spare are held elsewhere for every pose."""
    robot = load_robot("panda")
    poses = forward_batch(robot, np.random.default_rng(1).uniform(-2, 2, (12, 7)))
    asked = list[object]()
    monkeypatch.setattr(batch, "nearest_to", lambda *given: (asked.append(given), (np.zeros(7), np.inf, np.inf))[1])
    assert set(inverse_batch(robot, poses)[1].tolist()) == set(range(12))
    beyond = np.array(poses)
    beyond[:, :3, 3] *= 1.25
    for most, wanted in ((0, 0), (12, range(2, 13))):
        asked.clear()
        monkeypatch.setattr(batch, "NEAREST", most)
        inverse_batch(robot, beyond)
        assert len(asked) in ([wanted] if isinstance(wanted, int) else wanted)
