"""The way back as code: the function of each language returns every solution that `inverse` finds."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import chain, islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dhcli.kinematics.forward import forward, with_own_values
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive import derive
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import name_of
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.inverse.tasks import TaskName
from dhcli.notation.tree import ZERO, Symbol, add, multiply, negate, power
from dhcli.render.code.inverses import inverse_code
from dhcli.render.code.languages import LANGUAGES
from dhcli.render.code.stages import lengths_used, shared
from dhcli.render.look import Look
from tests.kinematics.arms import robot_once
from tests.nightly import NIGHT, in_turn
from tests.render.code.running import HERE, Call, results

DATA = Path(__file__).parents[2] / "data"
FIVE = (str(DATA / "five-axis.yaml"), str(DATA / "five-joints.yaml"))
FEW = ("planar-2r", "scara-yim", "zhou-3r", "spherical-wrist", "palletizer", *FIVE)
ROBOTS = (*FEW, "cylindrical", "stanford", "puma560", "ur5e")
IN_NUMBERS = ("planar-2r", "stanford") if NIGHT else ("planar-2r", "scara-yim")
Q = (0.4, 0.7, 0.5, -0.6, 0.8, 1.1)


@cache
def derived(name: str, *, in_its_numbers: bool = False) -> Derivation:
    """The derivation of a robot, worked out once; with its letters, or with its lengths in their place."""
    return derive(with_own_values(robot_once(name)) if in_its_numbers else robot_once(name))


@cache
def code(derivation: Derivation, language: str) -> str:
    """The file, which many poses are put into."""
    return inverse_code(derivation, Look(language))


@cache
def room(derivation: Derivation) -> tuple[tuple[int, int], list[float]]:
    """How many solutions of how many joints there may be, and the lengths of the robot, for all languages and poses."""
    robot = derivation.robot
    joints = sum(name_of(step.atom) in robot.variables for step in derivation.steps)
    own = [float(robot.parameters[n].value) for n in lengths_used(derivation)]  # type: ignore[union-attr]  # numbers
    return (shared(derivation).most, joints), own


def call(derivation: Derivation, language: str, pose: np.ndarray, lengths: Sequence[float] = ()) -> Call:
    """The function with a pose, and the lengths that C has no values for by default."""
    shape, own = room(derivation)
    given = [*(lengths or own), 1e-3] if derivation.left else lengths or own
    return Call(code(derivation, language), "inverse", given if language == "c" else lengths, shape, pose.tolist())


@cache
def reached() -> dict[str, Solutions]:
    """What the engine finds for the pose of each robot, for all languages."""
    return {
        name: inverse(robot, forward(robot, Q[: len(robot.variables)]), task=task_of(name))
        for name, robot in ((name, robot_once(name)) for name in ROBOTS)
    }


def task_of(name: str) -> TaskName:
    """Whether the robot reaches places only."""
    return "position" if derived(name).place_only else "pose"


@pytest.fixture(params=HERE, scope="module")
def given(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[Any]]:
    """What a language gives for the calls of all tests here, by one start of it."""
    calls = {what: asked(request.param) for what, asked in ASKED.items()}
    found = iter(results(request.param, [*chain(*calls.values())], tmp_path_factory.mktemp("code")))
    return {what: [*islice(found, len(asked))] for what, asked in calls.items()}


def every_robot(language: str) -> list[Call]:
    """A pose that it reaches, with its letters; some with its numbers in their place."""
    poses = {name: forward(robot_once(name), Q[: len(robot_once(name).variables)]) for name in ROBOTS}
    calls = [call(derived(name), language, pose.matrix) for name, pose in poses.items()]
    return [*calls, *(call(derived(name, in_its_numbers=True), language, poses[name].matrix) for name in IN_NUMBERS)]


def test_every_solution_comes_back(given: dict[str, list[Any]]) -> None:
    """As many as the engine finds, each of them, and each once; with the robot's own lengths, given or put in."""
    for name, rows in zip((*ROBOTS, *IN_NUMBERS), given["every robot"], strict=True):
        found = np.array(rows)
        engine = reached()[name]
        assert len(found) == len(engine), name
        assert max(engine.distances(row).min() for row in found) < 1e-9
        assert max(np.abs(np.exp(1j * found) - np.exp(1j * row)).max(axis=1).min() for row in engine) < 1e-9


@pytest.mark.parametrize("language", [name for name in LANGUAGES if name != "numpy"])
def test_no_line_ends_in_blanks(language: str) -> None:
    """Nor is one of blanks alone, where a language ends no loop by a word."""
    text = code(derived("planar-2r"), language)
    assert [line for line in text.splitlines() if line != line.rstrip()] == []


def out_of_reach(language: str) -> list[Call]:
    """A place that is too far."""
    far = np.eye(4)
    far[0, 3] = 5.0
    return [call(derived("planar-2r"), language, far)]


def test_a_pose_out_of_reach_has_no_solution(given: dict[str, list[Any]]) -> None:
    """And no error of the language."""
    [found] = given["out of reach"]
    assert len(found) == 0


def _beside(pose: np.ndarray, name: str) -> list[np.ndarray]:
    """Poses beside one: lifted, and turned about either axis, by day about one, each by more than the tolerance."""
    lifted = pose.copy()
    lifted[2, 3] += 0.02
    turn = np.array([[1, 0, 0, 0], [0, 0.96, -0.28, 0], [0, 0.28, 0.96, 0], [0, 0, 0, 1]])
    turned = [pose @ turn[np.ix_(axes, axes)] for axes in ((0, 1, 2, 3), (1, 2, 0, 3))]
    return [lifted, *in_turn(turned, FEW.index(name), 2)] if not derived(name).place_only else [lifted]


@cache
def few_can_take() -> list[tuple[str, np.ndarray, int]]:
    """Robots of few joints, poses as they are typed, and how many solutions the engine has, for all languages."""
    found = []
    for name in FEW:
        robot = robot_once(name)
        pose = np.array(forward(robot, Q[: len(robot.variables)]).matrix)
        for target in (pose, *_beside(pose, name)):
            typed = np.round(target, 4) if target is pose else target
            found.append((name, typed, len(inverse(robot, target, task=task_of(name)))))
    return found


def few_joints(language: str) -> list[Call]:
    """Poses for few joints."""
    return [call(derived(name), language, pose) for name, pose, _ in few_can_take()]


def test_a_pose_that_few_joints_cannot_take_has_no_solution(given: dict[str, list[Any]]) -> None:
    """None for what the engine has none for; those of a pose typed with four decimals are as many as of the pose."""
    found = [len(rows) for rows in given["few joints"]]
    assert found == [count for _, _, count in few_can_take()]
    assert found.count(0) >= len(FEW)


def test_the_tolerance_is_an_argument() -> None:
    """With a larger one the arm comes as near as it can; lengths keep their places before it."""
    space: dict[str, Any] = {}
    exec(code(derived("planar-2r"), "python"), space)  # noqa: S102  our own output, as a user runs it
    pose = np.array(forward(robot_once("planar-2r"), Q[:2]).matrix)
    pose[2, 3] = 0.02
    assert space["inverse"](pose) == []
    assert len(space["inverse"](pose, 0.4, 0.3, 0.03)) == len(space["inverse"](pose, tolerance=0.03)) == 2


def test_what_six_joints_reach_is_not_checked_twice() -> None:
    """Nor a position by three: what the formulas find leads back there."""
    assert [name for name in ROBOTS if derived(name).left] == list(FEW)
    assert "tolerance" not in code(derived("cylindrical"), "python")


def roots(language: str) -> list[Call]:
    """A length from its square, which is positive and then negative."""
    rest = add(power(Symbol("px"), 2), negate(power(Symbol("l1"), 2)))
    step = Step("SQUARES", "d3", (), ZERO, power(rest, Fraction(1, 2)), "plus-minus", rest)
    derivation = replace(derived("planar-2r"), robot=robot_once("scara"), steps=(step,))
    far, near = np.eye(4), np.eye(4)
    far[0, 3] = 0.5
    return [call(derivation, language, pose, [0.3]) for pose in (far, near)]


def test_there_is_no_root_of_a_negative_number(given: dict[str, list[Any]]) -> None:
    """None where the square is negative, two where it is not."""
    two, none = given["roots"]
    assert np.allclose(sorted(np.ravel(two)), [-0.4, 0.4])
    assert len(none) == 0


STRETCHED = {
    "planar-2r": (0.3, 0),
    "scara-yim": (0.3, 0, 0.1, 0.2),
    "puma560": (0.3, 0.2, -1.5707963267948966, 0, 0, 0),
}
"""Joint values at which an elbow or a wrist is stretched, where rounding may put a cosine beyond 1."""


SPECIAL = (0.0, math.pi / 2, -math.pi / 2, math.pi, math.pi / 4, 0.7)
"""Angles at which arms are stretched, and their hands stand straight or square."""


@cache
def special_poses() -> list[tuple[str, np.ndarray, Solutions]]:
    """Five-joint arms at right angles and stretched, and the hand of one above its base; with what the engine has."""
    draw, found = random.Random(4), []  # noqa: S311  a fixed seed, for the same poses every time
    for name in FIVE:
        rows = [[draw.choice(SPECIAL) for _ in range(5)] for _ in range(5 if NIGHT else 3)] + [[0.0] * 5]
        if name == FIVE[0]:
            a1, a2, a3, d5 = (float(robot_once(name).parameters[x].value) for x in ("a1", "a2", "a3", "d5"))  # type: ignore[union-attr]  # numbers
            reach = a1 + a2 * math.cos(2.271) + a3 * math.cos(2.271 - 2.386)
            rows.append([0.7, 2.271, -2.386, math.asin(-reach / d5) - 2.271 + 2.386, -0.6])
        for q in rows:
            pose = np.round(np.array(forward(robot_once(name), q).matrix), 13) + 0.0
            found.append((name, pose, inverse(robot_once(name), pose)))
    return found


def special(language: str) -> list[Call]:
    """Special poses of arms with five joints."""
    return [call(derived(name), language, pose) for name, pose, _ in special_poses()]


def test_no_solution_is_missing_at_special_poses_of_five_joints(given: dict[str, list[Any]]) -> None:
    """Each that the engine has, and one of each family; what comes back reaches the pose."""
    for (name, pose, engine), rows in zip(special_poses(), given["special"], strict=True):
        for row in rows:
            assert np.abs(np.array(forward(robot_once(name), list(row)).matrix) - pose).max() < 1e-6, name
        turned = np.exp(1j * np.array(rows)).reshape(-1, 5)
        alone = [q for q, free in zip(engine.q, engine.free, strict=True) if not free]
        assert all(np.abs(turned - np.exp(1j * q)).max(axis=1).min() < 1e-5 for q in alone), (name, pose)
        assert len(rows) >= len(engine) > 0


@cache
def free_sums() -> list[np.ndarray]:
    """Poses of a UR5e, its wrist in line and its elbow nearly stretched."""
    poses = []
    draw = random.Random(5)  # noqa: S311  a fixed seed, for the same poses every time
    while len(poses) < 12:
        q = [draw.uniform(-3, 3) for _ in range(6)]
        q[4] = 0.0
        q[2] = draw.choice((0.2, -0.2))
        poses.append(np.round(np.array(forward(robot_once("ur5e"), q).matrix), 13) + 0.0)
    return poses


def sums(language: str) -> list[Call]:
    """A free sum."""
    return [call(derived("ur5e"), language, pose) for pose in free_sums()]


def test_a_free_sum_is_tried_where_a_later_joint_has_no_value_for_some(given: dict[str, list[Any]]) -> None:
    """Not every sum of the parallel joints is in reach."""
    found = given["sums"]
    for pose, rows in zip(free_sums(), found, strict=True):
        assert len(rows) <= 16
        for row in rows:
            assert np.abs(np.array(forward(robot_once("ur5e"), list(row)).matrix) - pose).max() < 1e-6
    assert sum(len(rows) > 0 for rows in found) == 11  # 10 without


@cache
def singular_poses() -> list[tuple[str, np.ndarray, bool]]:
    """Robots, poses, and whether the engine has a solution, found once for all languages."""
    return [(name, pose, len(inverse(robot_once(name), pose, task=task_of(name))) > 0) for name, pose in _singular()]


def _singular() -> list[tuple[str, np.ndarray]]:
    """Stretched arms, wrists in line, and places on axis 1, which shoulders that are offset cannot reach."""
    found = [(name, np.array(forward(robot_once(name), q).matrix)) for name, q in STRETCHED.items()]
    found += [(name, np.array(forward(robot_once(name), (0,) * 6).matrix)) for name in ("stanford", "ur5e")]
    for name, q in (("puma560", Q), ("stanford", Q), ("cylindrical", Q[:3]), ("planar-2r", Q[:2])):
        pose = np.array(forward(robot_once(name), q).matrix)
        pose[:2, 3] = 0
        found.append((name, pose))
    # of ur5e what stands on axis 1 is not the end but the joint before the last
    pose, last = np.array(forward(robot_once("ur5e"), Q).matrix), robot_once("ur5e").parameters["d6"]
    pose[:2, 3] = float(last.value) * pose[:2, 2]  # type: ignore[union-attr]  # a number
    return [*found, ("ur5e", pose)]


def singular(language: str) -> list[Call]:
    """Singular poses."""
    return [call(derived(name), language, pose) for name, pose, _ in singular_poses()]


def test_singular_poses_are_no_error_and_no_number_is_missing(given: dict[str, list[Any]]) -> None:
    """Every row is finite and reaches the pose; there are some wherever the engine has one, else none."""
    for (name, pose, is_reached), rows in zip(singular_poses(), given["singular"], strict=True):
        robot, task = robot_once(name), task_of(name)
        assert bool(len(rows)) == is_reached, name
        for row in rows:
            gap = np.array(forward(robot, list(row)).matrix) - pose
            assert np.abs(gap[:, 3] if task == "position" else gap).max() < 1e-7, name


def quotients(language: str) -> list[Call]:
    """A length from another that stands below a line, in no loop yet; it is 0 in the second pose."""
    value = multiply(Symbol("l1"), power(add(Symbol("px"), negate(Symbol("py"))), -1))
    step = Step("SLIDE", "d3", (), value)
    derivation = replace(derived("planar-2r"), robot=robot_once("scara"), steps=(step,))
    near = np.eye(4)
    near[0, 3] = 0.5
    return [call(derivation, language, pose, [0.3]) for pose in (near, np.eye(4))]


ASKED: dict[str, Callable[[str], list[Call]]] = {
    "every robot": every_robot,
    "out of reach": out_of_reach,
    "few joints": few_joints,
    "roots": roots,
    "special": special,
    "sums": sums,
    "singular": singular,
    "quotients": quotients,
}


def test_what_would_be_divided_by_0_before_any_choice_has_no_solution(given: dict[str, list[Any]]) -> None:
    """Nor an error of the language."""
    one, none = given["quotients"]
    assert np.allclose(np.ravel(one), [0.6])
    assert len(none) == 0


def test_the_function_says_what_it_takes_and_gives() -> None:
    """The pose, the lengths, and in C room for as many rows as there may be."""
    text = code(derived("planar-2r"), "c")
    assert "int inverse(const double T[4][4], double a1, double a2, double tolerance, double solutions[][2])" in text
    assert "solutions has room for 2 rows" in text
    assert "def inverse(T, a1=0.4, a2=0.3, tolerance=0.001):" in code(derived("planar-2r"), "python")
    assert "function solutions = inverse(T, a1, a2, tolerance)" in code(derived("planar-2r"), "matlab")


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_cosine_is_taken_twice(language: str) -> None:
    """Each of a joint or of a sum has a name."""
    formulas = shared(derived("puma560")).formulas
    turning = [one for one in formulas.definitions if str(one.expr).startswith(("c(", "s(", "cos", "sin"))]
    assert len({one.expr for one in turning}) == len(turning)
    text = code(derived("puma560"), language).partition("Source")[2]
    assert text.count("cos(theta23)") == 1
    assert text.count("sin(theta23)") == 1
