"""Ranges as people write them."""

from __future__ import annotations

import pytest

from dhcli import load_robot
from dhcli.errors import DhcliError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.sweep.ranges import read_over
from tests.row_by_row import row_by_row

PI = 3.141592653589793


@row_by_row(
    ("text", "expected"),
    [
        ("theta1=-90°..90° step 5°", ("theta1", -PI / 2, PI / 2, 37)),
        ("q1=-90deg..90deg n 3", ("theta1", -PI / 2, PI / 2, 3)),
        ("θ1 = -pi .. pi step pi/4", ("theta1", -PI, PI, 9)),
        ("theta1=-pi..pi step 5°", ("theta1", -PI, PI, 73)),
        ("theta_2=0..90° step 45°", ("theta2", 0, PI / 2, 3)),
        ("theta1=90°..-90° step -5°", ("theta1", PI / 2, -PI / 2, 37)),
        ("theta1=90°..-90° n 5", ("theta1", PI / 2, -PI / 2, 5)),
        ("d3=0..0.2 n 11", ("d3", 0, 0.2, 11)),
        ("d3=0..0.2 step 0.02", ("d3", 0, 0.2, 11)),
        ("d3=0mm..20cm step 5mm", ("d3", 0, 0.2, 41)),
        ("d3=0..sqrt(2)/2 n 2", ("d3", 0, 2**0.5 / 2, 2)),
        ("theta1=0..1 step 0.3", ("theta1", 0, 0.9, 4)),
        ("theta1=0..1 step 0.333333333", ("theta1", 0, 1, 4)),
        ("theta1=0...5 n 3", ("theta1", 0, 0.5, 3)),
        ("theta1=-1..1", ("theta1", -1, 1, None)),
        ("theta1=30°", ("theta1", PI / 6, PI / 6, 1)),
    ],
)
def test_a_range_is_read(text: str, expected: tuple[str, float, float, int | None]) -> None:
    """In any unit, upwards and downwards; the end is there if a step misses it by a hair only."""
    over = read_over(load_robot("scara"), text)
    assert over.first is not None
    assert over.last is not None
    assert (over.name, over.count) == (expected[0], expected[3])
    assert (in_floats(over.first), in_floats(over.last)) == pytest.approx(expected[1:3], rel=1e-15)


def test_a_joint_alone_has_its_own_limits() -> None:
    """Which the grid knows."""
    over = read_over(load_robot("scara"), "q2")
    assert (over.name, over.first, over.last, over.count) == ("theta2", None, None, None)


def test_a_joint_with_a_count_has_its_own_limits_too() -> None:
    """In so many values."""
    over = read_over(load_robot("puma560"), "q1 n 300")
    assert (over.name, over.first, over.last, over.count) == ("theta1", None, None, 300)
    with pytest.raises(DhcliError, match=r"range:6: 'x' is not a number of values"):
        read_over(load_robot("puma560"), "q1 n x")


def test_bare_numbers_are_degrees_where_it_is_said() -> None:
    """Of joints that turn; those that slide stay in metres."""
    robot = load_robot("scara")
    over = read_over(robot, "theta1=-90..90 step 45", bare="deg")
    assert over.count == 5
    assert over.last is not None
    assert in_floats(over.last) == PI / 2
    assert read_over(robot, "d3=0..2 step 1", bare="deg").count == 3


@row_by_row(
    ("text", "said"),
    [
        ("", "a joint is missing"),
        ("=1..2", "a joint is missing"),
        ("theta9=0..1", "scara has no joint theta9"),
        ("theta1=", "a value is missing here"),
        ("theta1=..1", "a value is missing here"),
        ("theta1=0..", "a value is missing here"),
        ("theta1=0..1 step", "a value is missing here"),
        ("theta1=0..1 n", "'' is not a number of values"),
        ("theta1=0..1 n 0", "n 0 is no value"),
        ("theta1=0..1 n 1", "n 1 is one value"),
        ("theta1=0..1 n 2.5", "'2.5' is not a number of values"),
        ("theta1=0..1 n -3", "'-3' is not a number of values"),
        ("theta1=0..1 n ³", "'³' is not a number of values"),
        ("theta1=0..1 step 0", "the step of theta1 is 0"),
        ("theta1=0°..1° step 0°", "the step of theta1 is 0°"),
        ("theta1=0..1 step -0.1", "write step 0.1"),
        ("theta1=1..0 step 0.1", "write step -0.1"),
        ("theta1=0..1 step 2", "longer than the way from 0 to 1"),
        ("theta1=30°..30° step 1°", "theta1 begins and ends at 30°"),
        ("theta1=0..0 n 5", "one value is written theta1=0"),
        ("theta1=a..b", "a is not a name that is known here"),
        ("theta1=nan..1", "nan"),
        ("theta1=0..1 by 0.1", "by is not a name that is known here (a range looks like theta1=-90°..90° step 5°)"),
        ("theta1=-90:5:90", "a range looks like theta1=-90°..90° step 5°"),
        ("d3=0..1 step=0.1", "a range looks like d3=0..0.2 n 11"),
        ("0..1 n 3", "there is no = in this range"),
        ("theta1 0..1", "there is no = in this range"),
        ("theta1=0..1mm", "mm is a unit of length"),
        ("d3=0..30°", "unit of angle"),
        ("d3=0..10^400 n 3", "is not"),
        ("theta1=-90..90° step 5°", "-90 has no unit"),
        ("theta1=-90°..90° step 5", "5 has no unit"),
        ("d3=100..200mm n 3", "100 has no unit"),
        ("theta1=0°..90 n 3", "90 has no unit"),
        ("theta1=-90..0° n 3", "-90 has no unit"),
        ("theta1=0..1 step 0.5°", "1 has no unit"),
        ("d3=0mm..100 n 3", "100 has no unit"),
        ("theta1=0..1 n 1000001", "1,000,001 values, more than the 1,000,000"),
        ("theta1=0..1 n 1000000000000", "1,000,000,000,000 values"),
        ("theta1=0..1 step 1e-50", "about 10^50 values"),
    ],
)
def test_what_is_no_range_is_refused_in_words(text: str, said: str) -> None:
    """What is wrong, or what would be right."""
    with pytest.raises(DhcliError) as caught:
        read_over(load_robot("scara"), text)
    assert said in str(caught.value)


def test_the_place_is_the_column_of_the_piece_that_is_wrong() -> None:
    """Counted in the text as it was typed."""
    with pytest.raises(DhcliError) as caught:
        read_over(load_robot("scara"), "d3 = 0 .. 30° n 3")
    (problem,) = caught.value.problems
    assert problem.place is not None
    assert (problem.place.column, problem.place.text) == (11, "d3 = 0 .. 30° n 3")
