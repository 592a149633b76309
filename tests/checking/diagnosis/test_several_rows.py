"""Slips in several rows at once, and in the frames: each answer is that of another robot, worked out by itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest

from dhcli import load_exercise, load_robot
from dhcli.checking.exercise import Exercise
from dhcli.checking.kinds.made import question_about
from dhcli.kinematics.conventions import Row, moves_of
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, negate
from tests.judging import checked, expected

Rows = list[Row]


@cache
def asked(name: str, start: str = "0", end: str = "", *, numeric: bool = False) -> Exercise:
    """The pose of a frame of a robot."""
    return about(load_robot(name), start, end, numeric=numeric)


def about(robot: Robot, start: str, end: str, *, numeric: bool) -> Exercise:
    """The same of any robot."""
    angles = ("25°", "37°", "49°", "62°", "71°", "16°")
    given = joint_values(robot, ",".join(angles[: len(robot.joints)])) if numeric else {}
    return question_about(robot, f"pose {start}..{end or robot.frames[-2]}", numeric=numeric, given=given)


def with_rows(robot: Robot, change: Callable[[Rows], Rows]) -> Robot:
    """The robot of another table."""
    rows = change([link.row for link in robot.links if link.row is not None])
    links = tuple(
        replace(link, row=row, moves=moves_of(row, robot.convention))
        for link, row in zip(robot.links, rows, strict=True)
    )
    return replace(robot, links=links)


def shifted(rows: Rows) -> Rows:
    """Alpha and a one row further down."""
    before = [Row(ZERO, Angle(), ZERO, Angle()), *rows]
    return [replace(row, a=other.a, alpha=other.alpha) for row, other in zip(rows, before, strict=False)]


def lengths_swapped(rows: Rows) -> Rows:
    """Lengths a of rows 2 and 3 in each other's row."""
    return [*rows[:1], replace(rows[1], a=rows[2].a), replace(rows[2], a=rows[1].a), *rows[3:]]


def twist_too_low(rows: Rows) -> Rows:
    """Alpha of row 1 in row 2."""
    return [replace(rows[0], alpha=rows[1].alpha), replace(rows[1], alpha=rows[0].alpha), *rows[2:]]


CHANGES: tuple[tuple[str, Callable[[Rows], Rows], str], ...] = (
    ("ur5e", lambda rows: [replace(row, a=negate(row.a)) for row in rows], "a-signs"),
    ("ur5e", lambda rows: [replace(row, theta=-row.theta) for row in rows], "theta-signs"),
    ("ur5e", lambda rows: [replace(row, d=negate(row.d)) for row in rows], "d-signs"),
    ("ur5e", shifted, "shifted a+alpha down"),
    ("ur5e", lengths_swapped, "a-swapped 2 and 3"),
    ("ur5e", twist_too_low, "alpha-swapped 1 and 2"),
)


@pytest.mark.parametrize("numeric", [False, True])
@pytest.mark.parametrize(("name", "change", "slip"), CHANGES)
def test_a_slip_in_several_rows_has_one_name(
    name: str, change: Callable[[Rows], Rows], slip: str, *, numeric: bool
) -> None:
    """Whatever the rows between them."""
    exercise = asked(name, numeric=numeric)
    other = about(with_rows(load_robot(name), change), "0", "", numeric=numeric)
    found = checked(exercise, exercise.part("pose"), expected(other, other.parts[0])).diagnosis
    assert found is not None
    assert found.ids == (slip,)


@pytest.mark.parametrize("numeric", [False, True])
@pytest.mark.parametrize(("start", "end"), [("1", "6"), ("0", "3"), ("0", "5")])
def test_the_pose_of_another_frame_is_named_by_its_frames(start: str, end: str, *, numeric: bool) -> None:
    """T_16 for T_06, and T_03."""
    exercise, other = asked("puma560", numeric=numeric), asked("puma560", start, end, numeric=numeric)
    found = checked(exercise, exercise.part("pose"), expected(other, other.parts[0])).diagnosis
    assert found is not None
    assert found.ids == (f"other-frames {start} {end}",)
    assert found.names == (f"this is the pose of frame {end} seen from frame {start}",)


def test_another_link_is_named() -> None:
    """A_2 where A_1 was asked."""
    exercise, other = asked("puma560", "2", "3"), asked("puma560", "3", "4")
    found = checked(exercise, exercise.part("pose"), expected(other, other.parts[0])).diagnosis
    assert found is not None
    assert found.ids == ("other-frames 3 4",)


@pytest.mark.parametrize("taken", ["theta2", "theta4"])
def test_the_angle_of_another_joint_is_named(taken: str) -> None:
    """theta2 for theta3."""
    exercise = asked("ur5e", numeric=True)
    other = replace(exercise, given={**exercise.given, "theta3": exercise.given[taken]})
    found = checked(exercise, exercise.part("pose"), expected(other, other.parts[0])).diagnosis
    assert found is not None
    assert found.ids == (f"theta-other 3 {taken}",)


def test_a_value_of_a_joint_that_is_left_out_is_no_sine_for_a_cosine() -> None:
    """At a drawn angle of 90° both give the same; what is plain is named alone."""
    robot = load_robot("ur5e")
    given = joint_values(robot, "25°,90°,49°,62°,71°,16°")
    exercise = question_about(robot, "pose 0..6", numeric=True, given=given)
    other = question_about(robot, "pose 0..6", numeric=True, given={**given, "theta2": Angle()})
    found = checked(exercise, exercise.part("pose"), expected(other, other.parts[0])).diagnosis
    assert found is not None
    assert found.ids == ("theta-zero 2",)


@pytest.mark.parametrize("name", ["zhou/three-r-arm-tip", "zhou/six-r-hand", "yim/planar-two-links"])
def test_zeros_are_no_product_entry_by_entry(name: str) -> None:
    """Nobody has multiplied anything."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        rows, columns = part.question.blank(exercise)
        zeros = "[" + "; ".join([" ".join("0" * columns)] * rows) + "]"
        judged = checked(exercise, part, zeros).diagnosis
        assert judged is None or "element-wise" not in judged.ids
