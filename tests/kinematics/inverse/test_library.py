"""Every robot of the library, in ordinary poses, at right angles, and beside singular poses."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from dhcli import Robot, Solutions, forward, forward_batch, inverse, inverse_batch, load_robot
from dhcli.files.library.entries import Kind, entries
from dhcli.kinematics.inverse.polishing import polished
from dhcli.kinematics.inverse.question import ask
from dhcli.kinematics.inverse.solutions import turning_joints
from tests.nightly import NIGHT, in_turn, paired

NAMES = [entry.name for entry in entries(Kind.ROBOTS) if entry.origin == "built-in"]
MOVING = [name for name in NAMES if load_robot(name).variables]
ENOUGH = [name for name in MOVING if name != "panda"]
"""Robots that have no joint to spare."""


@cache
def ready(name: str) -> tuple[Robot, dict[str, float | str]]:
    """A robot, and values for the lengths and angles that its file leaves open."""
    robot = load_robot(name)
    open_ones = [parameter for parameter, value in robot.parameters.items() if value is None]
    return robot, {p: "30°" if p in robot.angles else 0.3 + 0.05 * k for k, p in enumerate(open_ones)}


def gap(robot: Robot, one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The way from one joint vector to another, angles modulo a turn."""
    way = other - one
    return np.where(turning_joints(robot), way - 2 * np.pi * np.round(way / (2 * np.pi)), way)


@cache
def most(name: str) -> int:
    """As many solutions as a robot has in any of some ordinary poses."""
    robot, parameters = ready(name)
    q = np.random.default_rng(5).uniform(-1.5, 1.5, (20, len(robot.variables)))
    return max(
        len(inverse(robot, forward(robot, list(row), parameters=parameters), parameters=parameters)) for row in q
    )


def are_apart(solutions: Solutions) -> bool:
    """Whether no two solutions are one."""
    return all(np.sort(solutions.distances(list(row)))[1:2].min(initial=1.0) > 1e-6 for row in solutions.q)


def is_among(robot: Robot, parameters: dict[str, float | str], q: np.ndarray, solutions: Solutions) -> bool:
    """Whether joint values are among solutions, or floats cannot tell them from one.

    Beside a singular pose the arm moves far while its end moves less than rounding: then all between the two reaches
    the pose as well, as it stands or within a tenth of the way. Beside two at once, such as a slide of a micrometre in
    front of a wrist that is folded, rounding of the pose turns joints by a radian: where as many solutions are found as
    the robot has anywhere, all of them apart, none is lost.
    """
    if not len(solutions):
        return False
    distances = solutions.distances(list(q))
    k = int(np.argmin(distances))
    if distances[k] < 1e-7 or (len(solutions) == most(robot.name) and are_apart(solutions)):
        return True
    if distances[k] > 0.1:
        return False
    question, _ = ask(robot, "pose", parameters=parameters)
    way = gap(robot, q, solutions.q[k])
    between = question.motions(q + np.array([[0.25], [0.5], [0.75]]) * way)
    pose = forward(robot, list(q), parameters=parameters).matrix
    if np.abs(forward_batch(robot, between, parameters=parameters) - pose).max() < 1e-14:
        return True
    goal = question.ready.arm.goal(pose[None])
    led, left = polished(question.ready.arm, question.ready.task, between, np.repeat(goal, 3, axis=0))
    return bool(left.max() < 1e-14 and np.abs(led - between).max() < 0.1 * np.abs(way).max())


def is_covered(robot: Robot, parameters: dict[str, float | str], q: np.ndarray, hold: dict[str, float]) -> bool:
    """Whether joint values are among the solutions, or in a family that is told, which holding its joint shows."""
    pose = forward(robot, list(q), parameters=parameters)
    solutions = inverse(robot, pose, parameters=parameters, hold=hold)
    for k in range(len(solutions)):
        reached = forward(robot, list(solutions.q[k]), parameters=parameters).matrix
        assert np.abs(reached - pose.matrix).max() < 3e-12
    if is_among(robot, parameters, q, solutions):
        return True
    free = {way.joint for ways in solutions.free for way in ways}
    values = dict(zip(robot.variables, q.tolist(), strict=True))
    return len(hold) < 3 and any(is_covered(robot, parameters, q, {**hold, j: values[j]}) for j in sorted(free))


@pytest.mark.parametrize("name", MOVING)
def test_joint_values_at_random_are_found_again(name: str) -> None:
    """In a batch: every solution reaches its pose, the original is among them; a spare joint is held where it was."""
    robot, parameters = ready(name)
    rng = np.random.default_rng(1)
    q = rng.uniform(-2, 2, (100, len(robot.variables)))
    hold = {}
    if name == "panda":
        q[:, 6] = 0.4
        hold = {"theta7": 0.4}
    poses = forward_batch(robot, q, parameters=parameters)
    found, index = inverse_batch(robot, poses, parameters=parameters, hold=hold)
    assert np.abs(forward_batch(robot, found, parameters=parameters) - poses[index]).max() < 3e-12
    best = np.full(len(q), np.inf)
    np.minimum.at(best, index, np.abs(gap(robot, q[index], found)).max(axis=1))
    assert best.max() < 1e-6


@pytest.mark.parametrize("name", in_turn(MOVING, 0, 2))
def test_one_pose_has_the_solutions_that_a_batch_has(name: str) -> None:
    """Both ways in give the same joint values, in whatever order."""
    robot, parameters = ready(name)
    q = np.random.default_rng(2).uniform(-1.5, 1.5, len(robot.variables))
    pose = forward(robot, list(q), parameters=parameters)
    hold = {"theta7": 0.4} if name == "panda" else {}
    single = np.asarray(inverse(robot, pose, parameters=parameters, hold=hold))
    many, _ = inverse_batch(robot, pose.matrix, parameters=parameters, hold=hold)
    assert len(single) == len(many)
    for row in single:
        assert np.abs(gap(robot, many, row)).max(axis=1).min() < 1e-7


def round_values(robot: Robot, rng: np.random.Generator, beside: float) -> np.ndarray:
    """Joint values in multiples of 45° and round lengths, or a little beside them."""
    angles = np.pi / 4 * rng.integers(-3, 5, len(robot.variables))
    lengths = rng.choice([0.0, 0.1, -0.1, 0.3], len(robot.variables))
    q = np.where(turning_joints(robot), angles, lengths)
    return q + beside * rng.choice([-1.0, 1.0], len(q))


@pytest.mark.parametrize("name", in_turn(ENOUGH, 1, 2))
def test_multiples_of_45_degrees_lose_nothing(name: str) -> None:
    """Most of these poses are singular in one way or in several: the original is a solution, or in a family told."""
    robot, parameters = ready(name)
    rng = np.random.default_rng(3)
    for _ in range(400 if NIGHT else 3):
        q = round_values(robot, rng, 0.0)
        assert is_covered(robot, parameters, q, {}), q.tolist()


SINGULAR = ENOUGH if NIGHT else ["puma560", "ur5e", "stanford", "spherical-wrist", "planar-2r"]


@pytest.mark.parametrize(("name", "beside"), paired(SINGULAR, [1e-9, 1e-6, 1e-3]))
def test_beside_a_singular_pose_nothing_is_lost(name: str, beside: float) -> None:
    """The original is a solution as near as floats can tell."""
    robot, parameters = ready(name)
    rng = np.random.default_rng(4)
    cases = 100 if NIGHT else 4
    lost = [
        q for q in (round_values(robot, rng, beside) for _ in range(cases)) if not is_covered(robot, parameters, q, {})
    ]
    assert len(lost) <= cases // 50, lost
