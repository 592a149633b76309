"""Poses of special values at which equations vanish or have roots that come several times: nothing is lost there."""

from __future__ import annotations

import numpy as np
import pytest

from dhcli import forward, inverse
from dhcli.files.yaml.robots import read_robot
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.robot import Robot
from tests.nightly import NIGHT

HALF, WHOLE = np.pi / 2, np.pi


def drawn(convention: str, rows: str) -> Robot:
    """A robot from rows of alpha [degrees], a, d and theta; each is a joint's."""
    cells = [row.split() for row in rows.split(", ")]
    names = [next(x for x in ("d", "theta") if x in "".join(row)) + str(k) for k, row in enumerate(cells, 1)]
    links = [
        f"  - {{alpha: {alpha}°, a: {a}, d: {d.replace('d', name)}, theta: {theta.replace('theta', name)}}}"
        for (alpha, a, d, theta), name in zip(cells, names, strict=True)
    ]
    head = (
        f"format: 1\ntitle: drawn\nsource: for the tests\nconvention: {convention}\nvariables: [{', '.join(names)}]\n"
    )
    return read_robot(head + "links:\n" + "\n".join(links) + "\n", "drawn.yaml", "drawn")


LOST = {
    # a resultant with a root that comes four times
    "fourfold": (
        "modified",
        "0 0 0 theta-90°, 90 0.3 0 theta+180°, 0 0.2 0 theta, 90 0.4 0.3 theta+180°, 90 0.3 0.2 theta+90°",
        (WHOLE, 0, WHOLE, 0, 0),
    ),
    # a resultant that vanishes whatever the joint
    "silent": (
        "modified",
        "0 0.4 0.1 theta+90°, -90 0.2 0 theta+90°, 90 0.1 0 theta+180°, 0 0 d 90°, -90 0.1 0.2 theta+180°",
        (WHOLE, WHOLE, 0, 0.3, 0),
    ),
    # three joints at once, of which roots come twice, and four times
    "twofold, three joints": (
        "modified",
        "180 0 .1 theta+90°, -90 0 .1 theta-90°, 90 .4 .2 theta, 90 .2 .2 theta, 90 .3 0 theta, 90 .3 .1 theta+180°",
        (0, HALF, -HALF, 0, WHOLE, HALF),
    ),
    "fourfold, three joints": (
        "modified",
        "180 0 0.2 theta+180°, -90 0 0.1 theta, 0 0.2 0 theta, -90 0.1 0 theta, -90 0 0.2 theta, -90 0 0.1 theta",
        (-HALF, -HALF, 0, 0, WHOLE, 0),
    ),
    # the one equation of a joint vanishes, which others determine together with it
    "together": (
        "standard",
        "90 0 0.1 theta+90°, -90 0.4 0.2 theta-90°, 0 0.1 0.1 theta+90°, -90 0.1 0.1 theta+90°, 0 0.4 0 theta",
        (np.pi / 6, HALF, np.pi / 6, HALF, WHOLE),
    ),
    # one equation, of two numbers, is all that is left of a joint
    "one equation": (
        "standard",
        "-90 .2 .3 theta+90°, 180 .1 .1 theta-90°, -90 .3 .2 theta-180°, 0 .3 .2 theta-180°, 0 .2 d 90°, 90 0 .3 theta",
        (0, WHOLE, HALF, HALF, 0.3, 0),
    ),
    # roots that lead into several families, in each of which other joints stand
    "several families": (
        "modified",
        "-90 0 .1 theta+180°, 90 .4 0 theta+180°, 90 .2 d 0, 90 .2 0 theta, -90 .1 .2 theta, 90 .1 d 90°",
        (-HALF, HALF, 0.3, HALF, 0, 0.2),
    ),
    "families that cross": (
        "modified",
        "-90 .1 .1 theta+180°, -90 0 0 theta, 90 0 0 theta, 90 .4 d 0, -90 0 0 theta+90°, -90 .4 .1 theta+90°",
        (-HALF, WHOLE, HALF, 0.1, HALF, -HALF),
    ),
    # a resultant that vanishes for the joints of the plan, and not for others
    "silent, and a double root": (
        "standard",
        "90 .1 0 theta+180°, 90 .2 .2 theta+180°, 0 .4 0 theta, 0 0 .3 theta+180°, 90 .2 0 theta+180°, 90 .1 0 theta",
        (-HALF, WHOLE, WHOLE, HALF, HALF, -HALF),
    ),
    # three joints at once, of which equations vanish for these, any others, and where more than six are left
    "double, other three joints": (
        "modified",
        "90 0 0 theta-90°, -90 0 .2 theta-90°, 0 .4 0 theta, -90 .1 0 theta+90°, 90 0 0 theta-90°, 0 .2 d 90°",
        (0, WHOLE, HALF, -HALF, 0, 0.1),
    ),
    "double, no three joints": (
        "modified",
        "90 .1 0 theta+90°, 90 0 .3 theta, 0 .4 d 0, 90 0 .1 theta, 90 .2 0 theta+90°, -90 .1 .1 theta",
        (HALF, WHOLE, 0, HALF, -HALF, HALF),
    ),
    "more equations left": (
        "standard",
        "0 .1 .3 theta, -90 .2 .3 theta, -90 .2 .2 theta, -90 0 .3 theta, 90 .1 0 theta, 90 .2 .3 theta",
        (WHOLE, HALF, 0, WHOLE, 0, -HALF),
    ),
    # a resultant with a root that comes six times
    "sixfold": (
        "modified",
        "0 .2 .3 theta, 90 .4 0 theta, 0 0 0 theta-90°, 90 0 0 theta+180°, -90 .2 0 theta, -90 .2 .1 theta-90°",
        (0, HALF, 0, HALF, WHOLE, WHOLE),
    ),
    # roots that meet, of which one way to take joints loses what another one finds
    "half seen": (
        "modified",
        "90 0 0 theta, 90 .2 0 theta-90°, -90 .4 .3 theta+180°, 0 .4 d 90°, -90 0 0 theta-90°, 90 0 .3 theta",
        (HALF, WHOLE, 0, 0.3, HALF, -HALF),
    ),
}


@pytest.mark.parametrize("name", LOST)
def test_joint_values_of_a_special_pose_are_among_its_solutions(name: str) -> None:
    """Or in one of its families, which goes through them; every solution reaches the pose."""
    convention, rows, q = LOST[name]
    robot = drawn(convention, rows)
    assert is_found(robot, np.array(q))


def is_found(robot: Robot, q: np.ndarray) -> bool:
    """Whether joint values are among the solutions of where they stand, as they are or in a family."""
    pose = np.round(np.array(forward(robot, q.tolist()).matrix), 14) + 0.0
    found = inverse(robot, dict(zip(robot.variables, q.tolist(), strict=True)))  # joints to spare stand there
    for row in found.q:
        assert np.abs(np.array(forward(robot, row.tolist()).matrix) - pose).max() < 1e-9
    return is_covered(robot, pose, q, found, {})


def is_covered(robot: Robot, pose: np.ndarray, q: np.ndarray, found: Solutions, held: dict[str, float]) -> bool:
    """Whether joint values are among solutions, or a member of their families; where these cross, of one after another.

    A family is gone through by holding the joints that its members differ in where the values have them.
    """
    if found.distances(q.tolist()).min(initial=9) < 1e-5:
        return True
    own = dict(zip(robot.variables, q.tolist(), strict=True))
    spare = {name: own[name] for name, _ in found.held}
    for ways in found.free:
        more = spare | {way.joint: own[way.joint] for way in ways} | held
        if ways and more.keys() > held.keys():
            there = inverse(robot, pose, hold=more)
            if is_covered(robot, pose, q, there, more):
                return True
    return False


MEETING = {
    "three times": ("-90 .2 .2 theta, 90 .4 0 theta, 90 .4 .3 theta, 90 .3 0 theta, 90 .1 .3 theta", (0, 0, 2, 0, 2)),
    "four times": (
        "90 .3 .2 theta, 90 .3 .2 theta, 0 .4 .1 theta, 90 .4 .2 theta, 0 .4 .2 theta, 90 .2 .3 theta",
        (-1, 0, 0, 0, -1, 2),
    ),
    "more often": (
        "-90 .3 0 theta, 0 .2 0 theta, -90 .2 0 theta, 0 .4 .2 theta, 90 .3 .1 theta, -90 .4 .3 theta",
        (0, -1, 1, 2, -1, 1),
    ),
}


@pytest.mark.parametrize("name", MEETING)
def test_where_many_roots_meet_there_is_one_solution(name: str) -> None:
    """As exact as others, though each root by itself is exact to a third of the digits, or fewer."""
    rows, quarters = MEETING[name]
    robot, q = drawn("standard", rows), HALF * np.array(quarters)
    found = inverse(robot, forward(robot, q.tolist()))
    assert found.distances(q.tolist()).min() < 1e-6
    for k, row in enumerate(found.q):
        others = np.abs(np.angle(np.exp(1j * (np.delete(found.q, k, axis=0) - row)))).max(axis=1)
        assert others.min(initial=9) > 1e-3


def test_no_arm_at_right_angles_loses_its_own_joint_values() -> None:
    """Arms of five and six joints, one of which may slide, drawn at right angles, at multiples of them."""
    rng = np.random.default_rng(2)
    lost, arms = 0, 60 if NIGHT else 3
    for _ in range(arms):
        count, slide = int(rng.integers(5, 7)), int(rng.integers(0, 12))
        rows = []
        for k in range(count):
            alpha, a, d = rng.choice([0, 90, -90, 90, -90]), rng.choice([0, 0, 0.1, 0.2]), rng.choice([0, 0, 0.1, 0.3])
            rows.append(f"{alpha} {a} d 0" if k == slide else f"{alpha} {a} {d} theta")
        robot = drawn("standard", ", ".join(rows))
        for _ in range(4):
            q = rng.choice([0, HALF, -HALF, WHOLE], count)
            q[slide : slide + 1] = 0.2
            lost += not is_found(robot, q)
    assert not lost


def test_a_joint_of_a_family_may_be_held_beside_joints_to_spare() -> None:
    """As one is told to: theta5 and theta6 turn about one axis, and with theta1 held they still do."""
    robot = drawn("modified", "0 0 0 theta, -90 0 0 theta, 90 0 .3 theta, 90 .4 .2 theta, -90 .2 0 theta, 0 0 .2 theta")
    pose = forward(robot, [0, 0, HALF, 0.4, 0.7, 0])
    (ways,) = {row.joint for rows in inverse(robot, pose).free for row in rows}
    found = inverse(robot, pose, hold={ways: 0.25})
    assert dict(found.held).keys() == {ways, "theta6"}
    assert found.distances([0.25, 0, HALF - 0.25, 0.4, 0.7, 0]).min() < 1e-9


def test_a_joint_read_off_alone_does_not_keep_the_others_from_being_found() -> None:
    """Two pairs of parallel axes and a slide: behind theta6 no three joints follow from two others, with it they do."""
    rows = "0 0.1 0 theta, -60 0.2 0.3 theta, 30 0 d 90°, 0 0.2 0.3 theta, 90 0.2 0.3 theta, 60 0 0 theta"
    robot = drawn("standard", rows)
    draw = np.random.default_rng(0)
    for _ in range(4 if NIGHT else 2):
        q = draw.uniform(-3, 3, 6)
        q[2] = draw.uniform(-0.4, 0.4)
        assert is_found(robot, q)
