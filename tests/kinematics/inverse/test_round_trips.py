"""Random arms of every class: the joint values that a pose was made from are found again, and nothing else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from dhcli import forward, forward_batch, inverse, inverse_batch, load_robot, manipulability
from dhcli.kinematics.inverse import rule_all
from dhcli.kinematics.inverse.anatomy import NOTHING
from dhcli.kinematics.inverse.planning import find_plan
from dhcli.kinematics.inverse.polishing import product, residuals
from dhcli.kinematics.inverse.prepared import Prepared
from dhcli.kinematics.inverse.question import ask
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.solving import solve
from dhcli.kinematics.inverse.tasks import TASKS
from tests.kinematics.arms import COBOT, numbered_hinges
from tests.kinematics.inverse.arms import CLASSES, Class, measured, odd, random_arm, random_motions
from tests.nightly import NIGHT, in_turn, paired, some

TRIES = np.tile(np.pi * np.array([0.0, 0.5, -0.5, 1.0]), (6, 1))
"""What a free joint would be tried at; none is free at random."""


def lost_and_odd(kind: Class, seed: int, poses: int, by: float = 0.0) -> tuple[int, int]:
    """How many joint vectors are not found again, and how many poses have an odd number of solutions.

    Args:
        kind: The class of the arm.
        seed: Which arm.
        poses: How many poses.
        by: By how much its axes are not quite where the class has them.
    """
    rng = np.random.default_rng(seed)
    arm = random_arm(kind, rng)
    arm = measured(arm, by, rng) if by else arm
    motions, goal = random_motions(arm, poses, rng)
    task = TASKS[kind.task]
    found = run(find_plan(arm), task, goal, TRIES)
    left = residuals(task, arm.home, product(arm, found.motions), goal[found.index])
    assert left.max() <= 1e-12
    gap = found.motions - motions[found.index]
    gap = np.abs(np.where(arm.turning, gap - 2 * np.pi * np.round(gap / (2 * np.pi)), gap)).max(axis=1)
    best = np.full(poses, np.inf)
    np.minimum.at(best, found.index, gap)
    for pose in range(poses):
        own = found.motions[found.index == pose]
        for k, row in enumerate(own):
            apart = own[k + 1 :] - row
            apart = np.where(arm.turning, apart - 2 * np.pi * np.round(apart / (2 * np.pi)), apart)
            assert (np.abs(apart).max(axis=1) > 1e-9).all(), "a solution is given twice"
    return int((best > 1e-6).sum()), odd(kind, arm, found, poses)


@pytest.mark.parametrize("name", some(tuple(CLASSES), 2))
def test_the_original_joint_values_are_among_the_solutions(name: str) -> None:
    """Every solution reaches the pose to 1e-12, none is given twice, and of six joints they are even in number."""
    assert lost_and_odd(CLASSES[name], seed=1, poses=3) == (0, 0)


@pytest.mark.nightly
@pytest.mark.parametrize("name", CLASSES)
def test_the_original_joint_values_are_among_the_solutions_of_many_arms(name: str) -> None:
    """The same for 200 arms of each class, 20 poses each."""
    assert np.sum([lost_and_odd(CLASSES[name], seed=seed, poses=20) for seed in range(200)], axis=0).tolist() == [0, 0]


SLIDES = CLASSES["slides third and last"]


@pytest.mark.parametrize(("seed", "pose", "count"), some([(3, 16, 8), (77, 6, 4), (85, 2, 6)], 2))
def test_a_solution_is_none_the_less_one_for_standing_thousands_of_reaches_out(
    seed: int, pose: int, count: int
) -> None:
    """Two slides make up for each other; without this solution their number would be odd."""
    rng = np.random.default_rng(seed)
    arm = random_arm(SLIDES, rng)
    goal = random_motions(arm, 20, rng)[1][[pose]]
    found = run(find_plan(arm), TASKS["pose"], goal, TRIES)
    out = np.abs(found.motions[:, ~arm.turning]).max(axis=1)
    assert len(out) == count
    assert (out > 1e3).sum() == 1
    left = residuals(TASKS["pose"], arm.home, product(arm, found.motions), goal)
    assert (left <= np.maximum(1e-12, 1e-14 * out)).all()


@pytest.mark.parametrize("out", some([1e2, 1e4, 2e5], 2))
def test_joint_values_are_found_again_however_far_out_the_slides_stand(out: float) -> None:
    """The last slide runs back along the one before at an angle that brings the end home, and no family is claimed."""
    rng = np.random.default_rng(3)
    arm = random_arm(SLIDES, rng)
    motions, _ = random_motions(arm, 1, rng)
    motions[0, [2, 5]] = out, 0.4 - out
    first, last = np.array(arm.axes[2].direction), arm.axes[5]
    back = first + rng.uniform(-0.5, 0.5, 3) / out
    turn = product(replace(arm, axes=arm.axes[3:5]), motions[:, 3:5])[0, :3, :3]
    x, y, z = (turn.T @ back / np.linalg.norm(back)).tolist()
    arm = replace(arm, axes=(*arm.axes[:5], replace(last, direction=(x, y, z))))
    ready = Prepared(find_plan(arm), TASKS["pose"], 0, False, NOTHING)  # noqa: FBT003
    found = solve(ready, product(arm, motions)[0], np.zeros(6))
    gap = found.motions - motions
    gap = np.where(arm.turning, np.abs(np.angle(np.exp(1j * gap))), np.abs(gap) / out)
    assert (gap.max(axis=1) < 1e-9).sum() == 1
    assert len(found.motions) % 2 == 0
    assert not any(found.freedoms)


MEASURED = ("spherical wrist, two parallel", "three parallel, two meet", "spherical wrist, two meet")


@pytest.mark.parametrize(("name", "by"), paired(MEASURED, [1e-8, 1e-6, 1e-4, 1e-3]))
def test_an_arm_as_it_was_built_loses_next_to_nothing(name: str, by: float) -> None:
    """Axes that are only nearly parallel, or nearly meet: none is lost but beside singular poses."""
    arms, poses = (40, 20) if NIGHT else (1, 5)
    lost, _ = np.sum([lost_and_odd(CLASSES[name], seed, poses, by) for seed in range(arms)], axis=0)
    assert lost <= arms * poses // 200


@pytest.mark.parametrize(("name", "seed"), [("spherical wrist, two parallel", 1), ("spherical wrist, two meet", 37)])
def test_an_arm_some_of_whose_axes_count_as_meeting_loses_nothing(name: str, seed: int) -> None:
    """Its own equations hold for some of the axes and not for others, and lead to too few of its solutions."""
    assert lost_and_odd(CLASSES[name], seed, 20, 1e-6) == (0, 0)


@pytest.mark.parametrize(
    ("name", "by", "seed", "pose"),
    in_turn(
        [
            ("puma560", 1e-5, 0, 7),
            ("puma560", 1e-4, 3, 1),
            ("ur5e", 1e-7, 0, 28),
            ("stanford", 1e-7, 3, 9),
            ("stanford", 1e-5, 3, 9),
            ("stanford", 1e-4, 0, 6),
        ],
        0,
        2,
    ),
)
def test_an_arm_as_it_was_built_finds_its_joint_values_again_beside_singular_poses(
    name: str, by: float, seed: int, pose: int
) -> None:
    """The drawn arm could nearly move there without moving its end, so its solutions are far from those wanted."""
    rng = np.random.default_rng(seed)
    arm = measured(ask(load_robot(name), "pose")[0].ready.arm, by, rng)
    motions, goal = random_motions(arm, 30, rng)
    found = run(find_plan(arm), TASKS["pose"], goal[[pose]], TRIES)
    gap = found.motions - motions[pose]
    gap = np.where(arm.turning, np.abs(np.angle(np.exp(1j * gap))), np.abs(gap)).max(axis=1)
    assert (gap < 1e-6).sum() == 1
    assert residuals(TASKS["pose"], arm.home, product(arm, found.motions), goal[[pose]]).max() <= 1e-12
    apart = found.motions[:, None] - found.motions
    apart = np.abs(np.where(arm.turning, np.angle(np.exp(1j * apart)), apart)).max(axis=2)
    assert (apart > 1e-9).sum() == len(gap) * (len(gap) - 1), "a solution is given twice"


def test_joint_values_at_right_angles_are_found_again_though_solutions_share_an_angle() -> None:
    """Roots that have the third joint in common come as one eigenvalue, whose eigenvectors are mixtures of them."""
    rng = np.random.default_rng(0)
    draws = rng.choice([0, np.pi / 2, -np.pi / 2, np.pi / 4, np.pi, 0.3], (300 if NIGHT else 4, 6))
    for q in [(0, 0, 0, 0, -np.pi / 2, 0), (0.3, np.pi, np.pi, 0, np.pi / 2, 0.3), *draws]:
        found = inverse(COBOT, forward(COBOT, list(q)))
        assert len(found)
        if manipulability(COBOT, list(q)) > 1e-6:
            gap = np.abs(np.angle(np.exp(1j * (np.array(found) - q)))).max(axis=1)
            assert (gap < 1e-6).sum() == 1


AT_RIGHT_ANGLES = {
    # where equations vanish: of some three joints; of any three; of two joints, at a double root
    "other three": (
        "0,-90,0 .1,-90,-.15 .3,-90,-.15 .3,0,-.15 0,-90,0 .4,90,0",
        [90, 90, 0, 0.3 * 180 / np.pi, 45, 180],
    ),
    "no three": ("0,90,-.15 .1,0,0 0,-90,-.15 .2,0,0 0,90,-.15 .3,90,.15", [90, -45, 0, -90, 45, 180]),
    "two": (".2,-90,-.15 .4,90,0 .1,0,0 .1,0,.15 .1,-90,.15 .2,90,.15", [45, 135, 180, 45, -45, 135]),
}


@pytest.mark.parametrize("name", AT_RIGHT_ANGLES)
def test_where_equations_vanish_at_right_angles_the_solutions_are_found_by_others(name: str) -> None:
    """In a batch too; each solution reaches the pose, and the original is one."""
    table, degrees = AT_RIGHT_ANGLES[name]
    arm, q = numbered_hinges(table), np.radians(degrees)
    pose = forward(arm, q)
    found = inverse(arm, pose)
    assert manipulability(arm, q) > 1e-6
    assert found.distances(q).min() < 1e-6
    assert len(found) % 2 == 0
    assert np.abs(forward_batch(arm, found.q) - pose.matrix).max() < 1e-11
    many, index = inverse_batch(arm, np.array([pose.matrix, forward(arm, [0.3, 0.4, 0.5, 0.6, 0.7, 0.8]).matrix]))
    assert (index == 0).sum() == len(found)
    assert max(found.distances(other).min() for other in many[index == 0]) < 1e-6


def test_nearly_no_arm_at_right_angles_loses_a_solution() -> None:
    """Arms with twists of 0 and 90 degrees at multiples of 45: regular joint values are among the solutions."""
    rng = np.random.default_rng(7)
    regular = lost = 0
    for _ in range(40 if NIGHT else 2):
        rows = zip(
            rng.choice([0, 0.1, 0.2, 0.3], 6), rng.choice([0, 90, -90], 6), rng.choice([0, 0.15, 0.3], 6), strict=True
        )
        arm = numbered_hinges(" ".join(",".join(map(str, row)) for row in rows))
        draws = rng.integers(-3, 5, (40 if NIGHT else 8, 6)) * np.pi / 4
        for q in draws:
            if manipulability(arm, q) > 1e-6:
                regular += 1
                lost += not inverse(arm, forward(arm, q)).distances(q).min(initial=9) < 1e-6
    assert lost <= regular / 500


def test_where_three_joints_have_no_real_angles_nothing_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """As at poses that an arm with joints to spare does not reach with these held: no roots, and so no rows."""
    eigen = rule_all._eigen

    def complex_roots(pencil: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, vectors = eigen(pencil)
        return values.real + 1j, vectors

    monkeypatch.setattr(rule_all, "_eigen", complex_roots)
    draw = np.random.default_rng(1)
    sides = draw.normal(size=(1, 14, 3, 3, 3)), draw.normal(size=(1, 14, 3, 3))
    at, angles = rule_all.solved(*sides, (0.1, 0.2, 0.3), [True] * 3)
    assert (len(at), [len(angle) for angle in angles]) == (0, [0, 0, 0])
