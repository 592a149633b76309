"""Which grid is meant by what was asked."""

from __future__ import annotations

import pytest

from dhcli import load_robot
from dhcli.errors import RobotError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Value
from dhcli.kinematics.sweep.grid import Grid
from dhcli.kinematics.sweep.plan import LARGEST, MODEST, plan, remarks
from dhcli.kinematics.sweep.ranges import read_over
from dhcli.kinematics.sweep.target import target_of
from dhcli.kinematics.values import joint_values
from tests.row_by_row import row_by_row

PI = 3.141592653589793


def _planned(name: str, *overs: str, q: str | None = None) -> tuple[Grid, list[str]]:
    robot = load_robot(name)
    target = target_of(robot)
    held: dict[str, Value] = joint_values(robot, q)
    grid = plan(target, [read_over(robot, text) for text in overs], held)
    return grid, list(remarks(target, grid))


def _swept(grid: Grid) -> list[tuple[str, float, float, int]]:
    return [(axis.name, in_floats(axis.first), in_floats(axis.last), axis.count) for axis in grid.swept]


def test_joints_without_limits_are_swept_over_a_whole_turn() -> None:
    """In steps of 2°, where two of them are a modest grid."""
    grid, said = _planned("planar-2r")
    assert _swept(grid) == [("theta1", -PI, PI, 181), ("theta2", -PI, PI, 181)]
    assert not said


def test_a_joint_that_may_turn_further_is_swept_over_one_turn() -> None:
    """The limits of a UR5e are two turns, which come by every place twice."""
    grid, _ = _planned("ur5e", "q1", "q2=-360°..360° n 5")
    assert _swept(grid) == [("theta1", -PI, PI, 181), ("theta2", -2 * PI, 2 * PI, 5)]


def test_joints_with_limits_are_swept_over_them_unless_they_do_not_move_the_point() -> None:
    """PUMA's wrist stands still: it does not move its centre."""
    grid, said = _planned("puma560")
    assert [axis.name for axis in grid.swept] == ["theta1", "theta2", "theta3"]
    assert in_floats(grid.swept[1].first) == pytest.approx(-225 * PI / 180)
    assert [axis.name for axis in grid.held] == ["theta4", "theta5", "theta6"]
    assert not said


@pytest.mark.parametrize("name", ["planar-2r", "puma560", "panda", "ur5e", "articulated", "zhou-3r"])
def test_a_grid_that_nobody_made_finer_is_modest(name: str) -> None:
    """And fine enough to be one: a quarter turn is among the values of a whole one."""
    grid, _ = _planned(name)
    assert grid.count <= MODEST
    assert all(axis.count >= 5 and axis.count % 4 == 1 for axis in grid.swept)


def test_joints_that_are_given_a_value_stand_still() -> None:
    """Whether by --q or by a range of one value; the others are swept, or stand at 0."""
    grid, _ = _planned("puma560", q="q1=30°")
    assert [axis.name for axis in grid.swept] == ["theta2", "theta3"]
    grid, _ = _planned("puma560", "q1=30°", "q2")
    assert [axis.name for axis in grid.swept] == ["theta2"]
    assert in_floats(grid.at(0)["theta1"]) == pytest.approx(PI / 6)
    assert in_floats(grid.at(0)["theta3"]) == 0


def test_a_range_wins_over_a_value() -> None:
    """A named pose says where the others stand."""
    grid, _ = _planned("puma560", "theta1=0..1 n 3", q="ready")
    assert _swept(grid) == [("theta1", 0, 1, 3)]
    assert in_floats(grid.at(2)["theta2"]) == pytest.approx(-PI / 2)


def test_open_counts_share_what_the_others_leave() -> None:
    """121 * 121 * 61 is below a million, 181 * 181 * 61 is not."""
    grid, _ = _planned("scara", "theta1", "theta2", "d3=0..0.2 n 61")
    assert [axis.count for axis in grid.axes] == [121, 121, 61]


@row_by_row(
    ("name", "overs", "q", "said"),
    [
        ("scara", (), None, "say it: --over theta1 --over theta2 --over d3=0..0.2"),
        ("scara", ("theta1=0..1", "d3"), None, "say it: --over d3=0..0.2"),
        ("cartesian", (), None, "d1, d2, d3 of cartesian have no limits"),
        ("planar-2r", ("theta1", "q1"), None, "theta1 is given twice"),
        ("planar-2r", ("theta1=1",), None, "nothing to sweep"),
        ("planar-2r", (), "up", "nothing to sweep"),
        ("assembly-blocks", (), None, "has no joint"),
        ("puma560", tuple(f"q{k}=0..1 n 100" for k in range(1, 7)), None, "leave out theta4, theta5, theta6"),
        ("puma560", tuple(f"q{k}=0..1 n 10000" for k in range(1, 4)), None, "3 joints may take 1000 values each"),
    ],
)
def test_what_is_no_grid_is_refused_in_words(name: str, overs: tuple[str, ...], q: str | None, said: str) -> None:
    """With what would be right."""
    with pytest.raises(RobotError) as caught:
        _planned(name, *overs, q=q)
    assert said in str(caught.value)


def test_a_grid_that_is_too_large_is_refused_with_its_number() -> None:
    """10^12 poses; 10^9 are just not too many."""
    with pytest.raises(RobotError, match="1,000,000,000,000 poses, more than the 1,000,000,000"):
        _planned("puma560", *(f"q{k}=0..1 n 10000" for k in range(1, 4)))
    grid, _ = _planned("puma560", *(f"q{k}=0..1 n 1000" for k in range(1, 4)))
    assert grid.count == LARGEST


@pytest.mark.parametrize(
    ("name", "overs", "said"),
    [
        ("planar-2r", ("theta1=-90..90 n 3",), "theta1 = 90 rad is more than a turn; did you mean 90°, or --deg?"),
        ("puma560", ("theta1=0..170° n 3",), "theta1 = 170° is outside its limits, -160° to 160°"),
        ("puma560", ("theta1", "theta5 = 0..1 n 4"), "theta5 does not move this point: each position comes 4 times"),
        ("panda", ("theta1",), "theta4 = 0° is outside its limits"),
    ],
)
def test_what_a_person_should_know_is_said(name: str, overs: tuple[str, ...], said: str) -> None:
    """Though it is computed."""
    _, remarks_ = _planned(name, *overs)
    assert any(said in remark for remark in remarks_), remarks_
