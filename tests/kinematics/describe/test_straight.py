"""Axes that are nearly parallel, or nearly meet, taken as such on request; and how far the tip moves by that."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest

from dhcli.errors import RobotError
from dhcli.files.yaml.robots import read_robot
from dhcli.files.yaml.writing import described_text
from dhcli.geometry.vectors import cross, dot, length, plus
from dhcli.kinematics.describe.asked import FORMS, Asked
from dhcli.kinematics.describe.description import describe, known_values
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, drawing_of, same_direction
from dhcli.kinematics.describe.straight import straightened
from dhcli.kinematics.robot import Robot
from dhcli.notation.tree import ONE, ZERO, Number
from tests.kinematics.describe.test_tables import end_by_screws, nasty_arm
from tests.nightly import NIGHT, cases_for_nights, in_turn
from tests.row_by_row import row_by_row

WITHIN = 0.02
"""The arms made by chance have neighbours that are a hundredth from parallel."""

MEASURED = """
format: 1
title: An arm as it was measured
source: made up, in the manner of a calibrated UR5e
convention: standard
variables: [theta1, theta2, theta3, theta4, theta5, theta6]
links:
  - {a: 0.00003, alpha: 90.0016°, d: 0.1627, theta: theta1}
  - {a: -0.42497, alpha: 0.00005 rad, d: 574.321, theta: theta2 + 0.0001 rad}
  - {a: -0.39223, alpha: -0.00007 rad, d: -574.2, theta: theta3}
  - {a: 0.00002, alpha: 89.999°, d: 0.0132, theta: theta4}
  - {a: 0.00001, alpha: -90.002°, d: 0.0997, theta: theta5}
  - {a: 0, alpha: 0, d: 0.0996, theta: theta6}
"""


def measured() -> Robot:
    """An arm whose second and third axes are 0.003° from parallel, their common normal 574 m away."""
    return read_robot(MEASURED, "measured.yaml", "measured")


def drawn(robot: Robot) -> Drawing:
    """A robot drawn with all joints at zero."""
    return drawing_of(robot.chain, robot.variables, known_values(robot))


def gaps(before: Drawing, after: Drawing, q: dict[str, float]) -> tuple[float, float]:
    """How far the tip is off, and by which angle it is turned [m, rad]."""
    one, two = end_by_screws(before, q), end_by_screws(after, q)
    turned = one[:3, :3].T @ two[:3, :3]
    angle = 2 * math.asin(min(1.0, float(np.linalg.norm(turned - np.eye(3))) / math.sqrt(8)))
    return float(np.linalg.norm(one[:3, 3] - two[:3, 3])), angle


@pytest.mark.parametrize("seed", cases_for_nights(range(1000), *range(15)))
def test_the_tip_is_never_farther_off_than_is_said(seed: int) -> None:
    """Arms of every kind at poses drawn, all turns and slides within the limits, by exponentials of their axes."""
    draw = random.Random(seed)  # noqa: S311  the same arms every time
    arm = nasty_arm(draw)
    stroke = Number(Fraction(7, 10))
    slides = {line.name: (Number(Fraction(-7, 10)), stroke) for line in arm.lines if not line.turns}
    straight, told = straightened(arm, WITHIN, slides)
    for _ in range(30):
        q = {
            line.name: draw.uniform(-math.pi, math.pi) if line.turns else draw.uniform(-0.7, 0.7) for line in arm.lines
        }
        tip, turn = gaps(arm, straight, q)
        assert tip <= told.tip + 1e-12
        assert turn <= told.turn + 1e-7  # the root of a rounding
    assert bool(told.changes) == (told.tip + told.turn > 0)
    assert set(told.strokes) <= {line.name for line in arm.lines if line.pitch}


@row_by_row("seed", in_turn(range(40), 0, 2))
def test_no_neighbours_are_left_that_are_nearly_parallel_or_nearly_meet(seed: int) -> None:
    """They are so to the last digit, or not within the angle; and straightening once more finds nothing."""
    arm = nasty_arm(random.Random(seed))  # noqa: S311  the same arms every time
    straight, _ = straightened(arm, WITHIN, {})
    lines = [Line("base", (0.0, 0.0, 1.0), {}), *straight.lines]
    for first, second in pairwise(lines):
        u, v = first.direction, second.direction
        if same_direction(u, v, WITHIN):
            assert length(cross(u, v)) < 1e-15
        elif first.through is not None and second.through is not None:
            gap = plus(second.through.get(ONE, (0.0,) * 3), first.through.get(ONE, (0.0,) * 3), -1)
            passed = abs(dot(gap, cross(u, v))) / length(cross(u, v))
            assert passed < 1e-12 or passed > 1e-3
    assert straightened(straight, WITHIN, {})[1].changes == ()


def test_what_is_said_can_happen() -> None:
    """A second axis tilted by δ, the tip a metre from it: half a turn takes it 2 δ away, and that is the bound."""
    tilt = 1e-3
    second = Line("q2", (0.0, math.sin(tilt), math.cos(tilt)), {ONE: (0.3, 0.0, 0.0)})
    arm = Drawing((Line("q1", (0.0, 0.0, 1.0), {}), second), Frame(origin={ONE: (0.3, 0.6, 0.8)}))
    straight, told = straightened(arm, 2e-3, {})
    assert [change.joint for change in told.changes] == ["q2"]
    assert told.tip == pytest.approx(2 * tilt, rel=1e-9)
    assert told.turn == pytest.approx(2 * tilt, rel=1e-9)
    worst = max(gaps(arm, straight, {"q1": 0.3, "q2": math.tau * k / 360})[0] for k in range(360))
    assert worst == pytest.approx(told.tip, rel=0.3)


def test_a_wrist_whose_axes_nearly_meet_gets_its_centre() -> None:
    """Three axes through one point, up to tenths of a millimetre."""
    lines = (
        Line("q1", (0.0, 0.0, 1.0), {ONE: (1.0, 0.0, 0.0)}),
        Line("q2", (0.0, 1.0, 0.0), {ONE: (1.0002, 0.0, 0.5)}),
        Line("q3", (1.0, 0.0, 0.0), {ONE: (1.0, 0.0001, 0.5003)}),
    )
    straight, told = straightened(Drawing(lines, Frame(z=(1.0, 0.0, 0.0), origin={ONE: (1.2, 0, 0.5)})), 1e-3, {})
    assert [(change.joint, round(change.shifted, 9)) for change in told.changes] == [
        ("q2", 0.0002),
        ("q3", round(math.hypot(0.0001, 0.0003), 9)),
    ]
    assert "through the point where q1 and q2 meet" in told.changes[1].said
    for line in straight.lines:
        centre = plus((1.0, 0.0, 0.5), line.through[ONE], -1)  # type: ignore[index]
        assert length(cross(centre, line.direction)) < 1e-15


@pytest.mark.parametrize("form", FORMS)
def test_a_measured_arm_gets_the_table_that_was_meant(form: str) -> None:
    """No length is 574 m any more; its file says that it is not the same robot, and moves as far off as is said."""
    robot = measured()
    found = describe(robot, Asked(form, straighten=1e-4))  # type: ignore[arg-type]
    assert found.given is robot
    assert found.straightened is not None
    assert {change.joint for change in found.straightened.changes} >= {"theta2", "theta3", "theta4", "theta5"}
    assert found.straightened.tip < 0.5e-3
    assert found.proof.error < 1e-13
    text = described_text(found)
    assert "574" not in text
    again = read_robot(text, "again.yaml", "again")
    assert "not the same robot" in again.notes
    draw = random.Random(4)  # noqa: S311  the same poses every time
    worst, ends = 0.0, (drawn(robot), drawn(again))
    for _ in range(200 if NIGHT else 60):
        q = {name: draw.uniform(-math.pi, math.pi) for name in robot.variables}
        tip, turn = gaps(*ends, q)
        worst = max(worst, tip)
        assert turn <= found.straightened.turn + 1e-7
    assert 0.1 * found.straightened.tip < worst <= found.straightened.tip


def test_an_arm_without_near_misses_stays_what_it_is() -> None:
    """It is said that nothing is done, and the proof is exact."""
    robot = read_robot(MEASURED.replace("574.321", "0").replace("-574.2", "0"), "x.yaml", "x")
    found = describe(robot, Asked("modified", straighten=1e-9))
    assert found.straightened is not None
    assert found.straightened.changes == ()
    assert found.straightened.lines() == (
        "no axes are nearly parallel, or nearly meet, within 1e-09 rad: nothing is changed",
    )


@pytest.mark.parametrize("within", [0.0, -1e-4, 0.1, math.nan, math.inf])
def test_an_angle_that_is_no_near_miss_is_refused(within: float) -> None:
    """Up to 5° axes may have been meant to be parallel."""
    with pytest.raises(RobotError, match="above 0 and up to 5°"):
        describe(measured(), Asked("standard", straighten=within))


def test_a_joint_that_slides_without_limits_is_taken_to_slide_as_far_as_the_robot_is_large() -> None:
    """And that is said, for its tilt counts for each metre."""
    tilt = 1e-3
    slide = Line("d1", (0.0, math.sin(tilt), math.cos(tilt)), None, turns=False)
    arm = Drawing((slide,), Frame(origin={ONE: (0.0, 0.0, 2.0)}))
    _, told = straightened(arm, 2e-3, {})
    assert told.strokes == {"d1": 2.0}
    assert told.tip == pytest.approx(2 * tilt, rel=1e-5)
    assert told.turn == 0.0
    assert "d1 sliding 2 m at most" in told.lines()[0]
    assert straightened(arm, 2e-3, {"d1": (ZERO, ONE)})[1].tip == pytest.approx(tilt, rel=1e-5)
