"""Two tables of one arm over each other."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest

from dhcli import load_robot
from dhcli.errors import RobotError
from dhcli.kinematics.robot import Robot
from dhcli.scene.beside import beside_figure
from dhcli.scene.staging import ArmAt
from tests.scene.examples import robot_of

RIGHT = [
    "{a: 0, alpha: 90°, d: 0.4, theta: theta1}",
    "{a: 0.3, alpha: 0, d: 0, theta: theta2}",
    "{a: 0.2, alpha: 0, d: 0, theta: theta3}",
]
NAMES = ["theta1", "theta2", "theta3"]
Q = [0.3, 0.4, 0.5]


def _with(row: int, old: str, new: str) -> Robot:
    rows = RIGHT.copy()
    rows[row] = rows[row].replace(old, new)
    assert rows != RIGHT
    return robot_of(rows, NAMES)


@pytest.mark.parametrize(
    ("row", "old", "new"),
    [(0, "90°", "-90°"), (0, "0.4", "0.5"), (1, "0.3", "0.31"), (1, "alpha: 0", "alpha: 180°"), (2, "d: 0", "d: 0.01")],
)
def test_the_first_frame_that_differs_is_that_of_the_row(row: int, old: str, new: str) -> None:
    """It is named under the picture and has a ring around it, and its axes have their names with a stroke."""
    figure = beside_figure(ArmAt(robot_of(RIGHT, NAMES), Q), _with(row, old, new))
    assert figure.caption.endswith(f"frame {row + 1} is the first that differs")
    assert sum(shape.look == "theirs-mark" for shape in figure.shapes) == 1
    assert {"".join(run.text for run in text.words)[-2:] for text in figure.texts if text.look == "theirs"} == {
        f"{row + 1}′"
    }


def test_the_same_table_differs_nowhere() -> None:
    """Nothing is marked."""
    figure = beside_figure(ArmAt(robot_of(RIGHT, NAMES), Q), robot_of(RIGHT, NAMES))
    assert figure.caption.endswith("no frame differs")
    assert not any(shape.look == "theirs-mark" for shape in figure.shapes)


def test_of_two_conventions_only_the_last_frames_are_compared() -> None:
    """Those before them stand elsewhere in both right tables."""
    modified, standard = load_robot("zhou-3r-modified"), load_robot("zhou-3r")
    assert "no frame differs" in beside_figure(ArmAt(modified, Q), standard).caption
    assert "frame 3 is the first that differs" in beside_figure(ArmAt(modified, Q), _with(0, "90°", "0")).caption


def test_an_arm_with_other_joints_is_refused() -> None:
    """A sliding joint has no angle."""
    with pytest.raises(RobotError, match=r"RRR.*RRP"):
        beside_figure(ArmAt(load_robot("articulated")), load_robot("scara"))


def test_the_same_axes_are_seen_one_under_the_other() -> None:
    """Wide and pale, with a rim around the whole of the narrow arrow, which is painted later."""
    figure = beside_figure(ArmAt(robot_of(RIGHT, NAMES), Q), robot_of(RIGHT, NAMES))
    looks = [shape.look for shape in figure.shapes]
    wide = [shape for shape in figure.shapes if shape.look == "theirs-axis-head"]
    narrow = [shape for shape in figure.shapes if shape.look in ("x-head", "z-head")]
    assert max(k for k, look in enumerate(looks) if look.startswith("theirs-axis")) < looks.index("halo")
    assert len(wide) == len(narrow) > 4
    tips = {tuple(map(round, shape.points[0])): shape for shape in wide}
    for shape in narrow:
        nearest = min(tips, key=lambda tip: math.dist(tip, shape.points[0]))
        rim = tips[nearest].points
        assert all(_is_inside(point, rim) for point in shape.points)


def _is_inside(point: tuple[float, float], corners: Sequence[tuple[float, float]]) -> bool:
    """Whether a point is on the same side of all edges of a triangle."""
    turns = [
        (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
        for a, b in zip(corners, (*corners[1:], corners[0]), strict=True)
    ]
    return all(turn > 0 for turn in turns) or all(turn < 0 for turn in turns)


def test_an_axis_seen_end_on_shows_both_senses() -> None:
    """The cross of one that points away goes on past the circle of one that points at the reader."""
    rows = ["{a: 0.4, alpha: 0, d: 0, theta: theta1}", "{a: 0.3, alpha: 0, d: 0, theta: theta2}"]
    turned = [rows[0].replace("alpha: 0", "alpha: 180°"), rows[1].replace("theta2", "-theta2")]
    names = NAMES[:2]
    figure = beside_figure(ArmAt(robot_of(rows, names), Q[:2]), robot_of(turned, names))
    rings = [shape for shape in figure.shapes if shape.look == "theirs-ring"]
    assert sum(shape.closed for shape in rings) == 3
    assert sum(not shape.closed for shape in rings) == 4, "z1 and z2 point away"
    inner = max(math.dist(shape.points[0], shape.points[10]) for shape in figure.shapes if shape.look == "z-ring")
    assert all(math.dist(*shape.points) > inner for shape in rings if not shape.closed)
