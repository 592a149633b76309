"""Arms in which a variable makes several moves: each pose gives back the values that it was made from."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from dhcli import Robot, forward, forward_batch, inverse, inverse_batch
from dhcli.files.yaml.robots import read_robot
from dhcli.kinematics.inverse.explained import explained
from dhcli.kinematics.inverse.path import follow
from dhcli.kinematics.inverse.solutions import turning_joints
from tests.nightly import NIGHT, in_turn

HEAD = "format: 1\ntitle: {0}\nsource: made for the tests\nconvention: standard\n"

TELESCOPES = {
    "lift": ("q1 q2 d3", "0.35 0 0.3 q1", "0.4 0 0 q2", "0 0 d3 0", "0 0 d3+0.1 0"),
    "ratio-and-offset": ("q1 d3 q2", "0.35 0 0.3 q1", "0.4 0 d3 0", "0.2 0 0.1 q2", "0 0 d3/2+0.1 0", "0.1 0 2*d3 0"),
    "turn-between": ("d1 q2 q3", "0 0 d1 0", "0.2 0 0 q2", "0 0 0.2-2*d1 0", "0.3 0 0 q3", "0.1 0 0 0"),
    "crane": ("q1 d2 q3", "0 90° 0.5 q1", "0 0 d2+0.4 0", "0 0 d2/2 0", "0 -90° d2/4 0", "0.2 0 0 q3"),
    "one-axis-turned-twice": ("q1 d2 q3", "0 0 0.2 2*q1", "0 0 d2 0", "0.4 90° 0 -q1", "0.3 0 0 q3"),
    "portal": ("d1 d2 d3 q4", "0 0 d1 0", "0 90° d1 90°", "0 0 d2 -90°", "0 90° d2 0", "0 0 d3 0", "0 0 d3 0",
               "0 0 0.1 q4"),
    "six": ("d1 q2 q3 q4 q5 q6", "0 0 d1 0", "0.1 0 0 q2", "0 90° d1+0.2 0", "0.6 0 0.1 q3", "0.05 90° 0.4 q4",
            "0 -90° 0.3 q5", "0 0 0.1 q6"),
}  # fmt: skip
"""Variables, and rows of a, alpha, d and theta; moves by one variable come to one motion."""


COUPLED = {
    "level-hand": ("q1 q2 q3", "0 90° 0.4 q1", "0.5 0 0 q2", "0.4 0 0 -q2", "0.3 0 0 q3"),
    "slides-apart": ("q1 d2 q3", "0 90° 0.3 q1", "0 90° d2+0.2 0", "0.1 45° d2/2 30°", "0.2 0 0 q3"),
    "halves": ("q1 q2 d3", "0 0 0.1 q1", "0.5 0 0 q2/2", "0.4 0 0 -q2/2", "0.2 90° 0 q2", "0 0 d3 0"),
    "flat": ("q1 q2 q3", "0.4 0 0 q1", "0.3 0 0 q2", "0.3 0 0 -q2", "0.2 0 0 q3"),
    "folding": ("q1 q2", "0.3 0 0 q1", "0.3 0 0 2*q1", "0.3 0 0 q2", "0.3 0 0 q2"),
    "palletizer": ("q1 q2 q3 q5", "0.1 90° 0.4 q1", "0.6 0 0 q2", "0.5 0 0 q3-q2", "0.1 90° 0 -q3", "0 0 0.1 q5"),
    "lift-to-spare": ("q1 q2 q3 d4 q5", "0.1 90° 0.4 q1", "0.6 0 0 q2", "0.5 0 0 q3-q2", "0.1 90° 0 -q3", "0 0 d4 0",
                      "0 0 d4+0.1 0", "0.05 0 0 q5"),
    "eight-moves": ("q1 q2 q3 q4 q5 q6", "0 90° 0.4 q1", "0.6 0 0 q2", "0.2 0 0 -q2", "0.5 0 0 q3", "0.1 90° 0 -q3",
                    "0 -90° 0.4 q4", "0 90° 0 q5", "0 0 0.1 q6"),
}  # fmt: skip
"""The same of arms whose variables make moves that are not one motion."""


def built(name: str, variables: str, *rows: str) -> Robot:
    """The robot of a table."""
    links = []
    for row in rows:
        a, alpha, d, theta = row.split()
        links.append(f"  - {{a: {a}, alpha: {alpha}, d: {d}, theta: {theta.replace('rad', ' rad')}}}")
    text = HEAD.format(name) + f"variables: [{variables.replace(' ', ', ')}]\nlinks:\n" + "\n".join(links) + "\n"
    return read_robot(text, f"{name}.yaml", name)


def matrix(robot: Robot, q: Any) -> Any:  # noqa: ANN401
    """The pose as an array."""
    return np.array(forward(robot, list(map(float, q))).matrix, dtype=float)


def apart(robot: Robot, rows: Any, q: Any, period: float = 2 * np.pi) -> float:  # noqa: ANN401
    """How far the nearest of some joint values is, angles modulo a period."""
    gap = np.asarray(rows) - q
    gap = np.where(turning_joints(robot), gap - period * np.round(gap / period), gap)
    return float(np.abs(gap).max(axis=1, initial=0.0).min(initial=np.inf))


@pytest.mark.parametrize("name", TELESCOPES)
def test_slides_that_one_variable_makes_are_one_slide(name: str) -> None:
    """The values that made a pose come back, all that come back reach it, and many poses have what each has."""
    robot = built(name, *TELESCOPES[name])
    q = np.random.default_rng(5).uniform(-1.2, 1.2, (12 if NIGHT else 2, len(robot.variables)))
    poses = forward_batch(robot, q)
    values, index = inverse_batch(robot, poses)
    for k, row in enumerate(q):
        found = inverse(robot, poses[k])
        assert apart(robot, found.q, row) < 1e-9
        assert not found.held
        assert not any(found.free)
        assert max(np.abs(matrix(robot, other) - poses[k]).max() for other in found) < 1e-12
        assert np.sort(found.q, axis=0) == pytest.approx(np.sort(values[index == k], axis=0), abs=1e-9)


def test_a_telescope_has_as_many_solutions_as_one_slide_twice_as_fast() -> None:
    """Of six joints, with its branches by name."""
    two = built("six", *TELESCOPES["six"])
    rows = [row.replace("0 0 d1 0", "0 0 2*d1 0").replace("d1+0.2", "0.2") for row in TELESCOPES["six"]]
    one = built("one", *rows)
    pose = forward(two, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    both = inverse(two, pose), inverse(one, pose)
    assert both[0].q == pytest.approx(both[1].q, abs=1e-9)
    assert both[0].branches == both[1].branches


def test_what_is_asked_and_said_of_a_telescope_names_its_own_variables() -> None:
    """One held, one to spare, and a path."""
    robot = built("lift", *TELESCOPES["lift"])
    pose = matrix(robot, [0.3, 0.5, 0.1])
    assert len(inverse(robot, pose, hold={"q2": 0.5})) == 1
    assert len(inverse(robot, pose[:3, 3], task="position")) == 2
    spare = inverse(built("portal", *TELESCOPES["portal"]), [0.3, 0.2, 0.1], task="position")
    assert spare.remarks == ("portal has 1 joint more than this needs: held q4 = 0°",)
    wanted = np.array([[0.3 + 0.1 * k, 0.5, 0.01 * k] for k in range(40)])
    assert follow(robot, forward_batch(robot, wanted), [0.3, 0.5, 0.0]).q == pytest.approx(wanted, abs=1e-9)


@pytest.mark.parametrize("name", COUPLED)
def test_values_that_made_a_pose_of_a_coupled_arm_come_back_at_any_pose(name: str) -> None:
    """At random, and in multiples of 45°, where a family goes through them; what may not be all is said to be so.

    By day half of the arms stand at random, the others in multiples of 45°.
    """
    robot = built(name, *COUPLED[name])
    q = np.random.default_rng(8).uniform(-1.3, 1.3, (6, len(robot.variables)))
    q[4:] = np.where(turning_joints(robot), np.round(q[4:] / (np.pi / 4)) * np.pi / 4, q[4:])
    q = np.array(q if NIGHT else in_turn([q[0], q[5]], [*COUPLED].index(name) + 1, 2))
    poses = forward_batch(robot, q)
    values, index = inverse_batch(robot, poses)
    for k, row in enumerate(q):
        found = inverse(robot, poses[k])
        assert max(np.abs(matrix(robot, other) - poses[k]).max() for other in found) < 1e-12
        assert sorted(np.round(values[index == k], 6).tolist()) == sorted(np.round(found.q, 6).tolist())
        free = [way.joint for ways in found.free for way in ways]
        free += [joint for joint, _ in found.held]
        hold = {joint: float(row[robot.variables.index(joint)]) for joint in free}
        assert apart(robot, inverse(robot, poses[k], hold=hold).q if free else found.q, row) < 1e-6
        assert {way for ways in found.free for each in ways for way in each.joints} <= set(robot.variables)
        assert bool(found.held) is (name == "lift-to-spare")


TWO_ROOTS = "q1 q2 d3", "0.05 -90° 0.45 q1", "0.4 0 0 q2", "0.15 90° 0 -q2+0.25rad", "0 0 d3 0", "0 0 2*d3+0.05 0"


@pytest.mark.parametrize("name", [*COUPLED, "two-roots"])
def test_branches_and_steps_of_a_coupled_arm_name_its_own_variables(name: str) -> None:
    """Each solution of a pose has a name of its own; moves that have no variable are explained by those there are."""
    robot = built(name, *COUPLED.get(name, TWO_ROOTS))
    found = inverse(robot, forward(robot, [0.3, 0.7, 0.2, 0.5, 0.6, 0.4][: len(robot.variables)]))
    assert len(set(found.branches)) == len(found)
    named = {word for branch in found.branches for word in re.findall(r"[a-z]+[0-9]+", branch)}
    assert named <= set(robot.variables)
    how = explained(found)
    told = {step.partition(":")[0] for step in how.steps if found.ready}
    assert told <= {*robot.variables, *(move.partition(" = ")[0] for move in how.moves)}
    assert bool(how.moves) is (found.ready is not None)


def test_the_sign_in_a_name_is_that_of_the_robots_variable() -> None:
    """theta3 is -q2 + 0.25: where the equation rises with theta3 it falls with q2, on both sides of the double root."""
    robot = built("two-roots", *TWO_ROOTS)
    low, high = inverse(robot, forward(robot, [0.1, 0.2, 0.1]))
    assert low[1] < high[1]
    signs = inverse(robot, forward(robot, [0.1, 0.2, 0.1])).branches
    assert [name.rpartition(", ")[2] for name in signs] == ["q2 -", "q2 +"]
    assert inverse(robot, forward(robot, [-0.4, 0.15, 0.3])).branches == signs


def test_a_family_of_a_coupled_arm_is_told_in_its_own_variables() -> None:
    """A wrist whose joints are moved by differences: stretched, the fourth and the sixth make up for each other."""
    rows = "0 90° 0.5 q1", "0.4 0 0 q2", "0 90° 0 q3-q2", "0 -90° 0.4 q4-q5", "0 90° 0 q5", "0 0 0.1 q6-q5"
    robot = built("wrist", "q1 q2 q3 q4 q5 q6", *rows)
    pose = matrix(robot, [0.1, 0.2, 1.3, 0.4, 0.0, 0.6])
    ways = {way for each in inverse(robot, pose).free for way in each}
    assert {(way.joint, way.joints) for way in ways} == {("q4", ("q4", "q6"))}
    held = inverse(robot, pose, hold={"q4": 1.0})
    assert apart(robot, held.q, [0.1, 0.2, 1.3, 1.0, 0.0, 0.0]) < 1e-7


def test_what_is_found_by_trying_is_said_to_be_perhaps_not_all() -> None:
    """And of an arm that is solved for move by move nothing of the kind."""
    tried, solved = (built(name, *COUPLED[name]) for name in ("flat", "level-hand"))
    pose = matrix(tried, [0.3, 0.5, 0.1])
    assert inverse(tried, pose).remarks == (
        "4 moves by 3 variables: looked for from 144 places, which may not find all",
    )
    assert inverse(solved, forward(solved, [0.3, 0.5, 0.1])).remarks == ()
    far, inside = pose.copy(), pose.copy()
    far[0, 3] += 2
    inside[:2, 3] = 0.3 * pose[:2, 0]
    assert "nothing that was tried leads there" in inverse(tried, inside).why
    assert inverse(tried, far).why.startswith("the point is 3.103 m from the first joint, and the links laid")
    pose[2, 3] = 0.1
    assert inverse(tried, pose).why == "z must be 0 m, is 0.1 m"


def test_solutions_of_a_flat_coupled_arm_are_those_of_its_geometry() -> None:
    """Of a rhombus that keeps the hand parallel: the wrist is on a circle about the end of the upper arm.

    With u = q2 and the hand at angle q1 + q3, the point less the hand is 0.4 and 0.3 along q1, and 0.3 along q1 + q2.
    """
    robot = built("flat", *COUPLED["flat"])
    for q1, u, q3 in np.random.default_rng(2).uniform(-1.5, 1.5, (6 if NIGHT else 3, 3)):
        pose = matrix(robot, [q1, u, q3])
        x, y = pose[:2, 3] - 0.2 * pose[:2, 0]
        cosine = (x * x + y * y - 0.7**2 - 0.3**2) / (2 * 0.7 * 0.3)
        wanted = []
        for turn in (np.arccos(cosine), -np.arccos(cosine)):
            first = np.arctan2(y, x) - np.arctan2(0.3 * np.sin(turn), 0.7 + 0.3 * np.cos(turn))
            wanted.append([first, turn, np.arctan2(pose[1, 0], pose[0, 0]) - first])
        found = inverse(robot, pose).q
        assert len(found) == 2
        assert max(apart(robot, found, row) for row in np.array(wanted)) < 1e-9


def test_variables_to_spare_of_a_coupled_arm_are_held_and_may_be_chosen() -> None:
    """By a position alone the hand is free, and its family is sampled."""
    robot = built("flat", *COUPLED["flat"])
    place = matrix(robot, [0.3, 1.9, 0.1])[:3, 3]
    found = inverse(robot, place, task="position")
    assert found.remarks[0] == "flat has 1 joint more than this needs: held q3 = 0°"
    assert apart(robot, inverse(robot, place, task="position", hold={"q2": 1.9}).q, [0.3, 1.9, 0.1]) < 1e-9
    many = inverse(robot, place, task="position", family=5)
    assert len(np.unique(np.round(many.q[:, 2], 6))) > 1
    for q in many:
        assert matrix(robot, q)[:3, 3] == pytest.approx(place, abs=1e-12)


@pytest.mark.parametrize("name", in_turn([*COUPLED], 1, 2))
def test_a_path_of_an_arm_with_more_moves_than_variables_stays_on_its_branch(name: str) -> None:
    """The values that it was made from come back; of an arm with a joint to spare, with that one held."""
    robot = built(name, *COUPLED[name])
    begin, end = np.array([[0.3, 0.9, 0.2, 0.5, 0.6, 0.4], [0.8, 1.3, 0.5, 0.3, 1.0, 0.9]])[:, : len(robot.variables)]
    q = begin + np.linspace(0, 1, 30)[:, None] * (end - begin)
    hold = {"d4": float(q[0, 3])} if name == "lift-to-spare" else None
    q[:, 3:4] = q[:1, 3:4] if hold else q[:, 3:4]
    path = follow(robot, forward_batch(robot, q), q[0], hold=hold)
    assert np.abs(path.q - q).max() < 1e-9
    assert (path.lost, path.jumps, path.singular) == ((), (), ())


def test_a_path_of_a_palletizer_goes_round_twice_jumps_and_goes_on_behind_poses_out_of_reach() -> None:
    """As of every other arm: turns are counted, what is lost is told, and so is a step that no branch makes."""
    robot = built("palletizer", *COUPLED["palletizer"])
    q = np.array([0.2, 1.3, -0.3, 0.0]) + np.linspace(0, 1, 60)[:, None] * [4 * np.pi, -0.4, 0.2, -9.0]
    poses = forward_batch(robot, q)
    poses[20:23, 2, 3] += 3
    path = follow(robot, poses, q[0])
    assert path.lost == (20, 21, 22)
    assert np.abs(np.delete(path.q - q, [20, 21, 22], axis=0)).max() < 1e-9
    apart_ = follow(robot, forward_batch(robot, np.vstack([q[:10], q[40:45]])), q[0])
    assert apart_.jumps == (10,)


def test_a_path_may_hold_a_variable_that_moves_joints_together_with_others() -> None:
    """q2 turns the second joint against the floor; the hand makes up for it."""
    robot = built("rods", "q1 q2 q3", "0.4 0 0 q1", "0.3 0 0 q2-q1", "0.2 0 0 q3")
    q = np.array([0.3, 0.8, 0.2]) + np.linspace(0, 1, 20)[:, None] * [0.5, 0.0, 0.3]
    places = forward_batch(robot, q)[:, :3, 3]
    assert follow(robot, places, q[0], task="position", hold={"q2": 0.8}).q == pytest.approx(q, abs=1e-9)


def test_what_coupling_keeps_is_a_reason_and_what_nearly_reaches_is_told() -> None:
    """A palletizer's hand hangs straight down though five moves of their own could tilt it."""
    robot = built("palletizer", *COUPLED["palletizer"])
    pose = matrix(robot, [0.3, 1.1, -0.2, 0.4])
    for degrees in (10, 0.2):
        turn = np.radians(degrees)
        tilted = pose.copy()
        tilted[:3, 1:3] = pose[:3, 1:3] @ [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
        found = inverse(robot, tilted)
        assert f"the last z axis always points along -z, yours is {degrees}° off" in found.why
        if degrees < 1:
            assert found.closest is not None
            assert np.abs(matrix(robot, found.closest) - tilted).max() < 0.005
        else:
            assert found.closest is None
