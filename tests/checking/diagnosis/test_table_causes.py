"""Slips in a DH table that is drawn with other frames, or whose joints are counted otherwise, than the solution's."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from dhcli import check, load_exercise
from dhcli.checking.diagnosis.slips import table_candidates
from dhcli.checking.exercise import Exercise
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.tables.cells import dh_table_text
from dhcli.checking.verdicts import Verdict
from dhcli.kinematics.conventions import Row
from dhcli.notation.angle import Angle
from tests.checking.tables.robots_with_tables import flip_x, flip_z, robot
from tests.judging import checked
from tests.nightly import in_turn

SLIPS = {
    "puma560": ("alpha-forgotten 4", "a-forgotten 3", "d-forgotten 4", "a-d-swapped 3", "alpha-sign 4"),
    "stanford": ("alpha-forgotten 2", "d-sign 6", "d-forgotten 2"),
    "zhou-3r": ("alpha-forgotten 2", "a-forgotten 1"),
}


def drawn_otherwise(rows: tuple[Row, ...], name: str, how: str) -> tuple[Row, ...]:
    """The same robot in another drawing."""
    convention = robot(name).convention
    if how == "x1 and z2 the other way":
        return flip_z(flip_x(rows, 0, convention), 1, convention)
    theta = rows[1].theta
    turned = -theta if how == "joint 2 counts the other way" else theta + Angle.in_degrees(90)
    return (rows[0], replace(rows[1], theta=turned), *rows[2:])


@cache
def with_slips(name: str) -> tuple[Exercise, dict[str, tuple[Row, ...]]]:
    """The question about the table of a robot, and the table that each slip leads to."""
    exercise = question_about_table(robot(name), robot(name).convention)
    question = exercise.parts[0].question
    assert isinstance(question, TableQuestion)
    return exercise, {
        one.slips[0].name: tuple(step.row for step in one.work.steps if step.row is not None)
        for one in table_candidates(exercise, question.convention)
    }


DRAWN = ("x1 and z2 the other way", "joint 2 counts the other way", "joint 2 counts from elsewhere")


@pytest.mark.parametrize("name", SLIPS)
@pytest.mark.parametrize("how", DRAWN)
def test_a_slip_is_named_whatever_frames_are_drawn(name: str, how: str) -> None:
    """By the robot that the table describes, not by its cells."""
    exercise, rows = with_slips(name)
    for slip in in_turn(SLIPS[name], DRAWN.index(how), 3):
        text = dh_table_text(drawn_otherwise(rows[slip], name, how), robot(name).columns, robot(name).writing)
        mark = checked(exercise, exercise.parts[0], text)
        assert mark.verdict is Verdict.WRONG
        assert mark.diagnosis is not None, (slip, text)
        assert slip in mark.diagnosis.ids


def test_rows_that_changed_places_are_named_though_the_joints_come_in_another_order() -> None:
    """The joints of a spherical wrist: a slip is looked for in every row where their order is not the robot's."""
    exercise = question_about_table(robot("puma560"), robot("puma560").convention)
    text = "[0 0 0 θ1; -90 0 0 θ2; 0 a2 d3 θ3; -90 a3 d4 θ4; -90 0 0 θ6; 90 0 0 θ5]"
    mark = check(exercise, "table", text)
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids


def test_a_table_of_another_robot_has_no_cause() -> None:
    """A twist that nobody gets wrong like this."""
    exercise = question_about_table(robot("puma560"), robot("puma560").convention)
    text = "[0 0 0 θ1; 35 0 0 θ2; 0 a2 d3 θ3; 20 a3 d4 θ4; 90 0 0 θ5; -90 0 0 θ6]"
    assert check(exercise, "table", text).diagnosis is None


@pytest.mark.parametrize(
    ("name", "answer", "cause", "words"),
    [
        (
            "wpi/puma560-table",
            "0 0 0 θ1; -90 0 0 θ2; 0 a2 d3 θ3; 90 a3 d4 θ4; -90 0 0 θ5; 90 0 0 θ6",
            "alpha-sign 4, 5 and 6",
            "the sign of alpha in rows 4, 5 and 6 is turned round",
        ),
        (
            "planar-two-links",
            "0 0 a1 theta1; 0 0 a2 theta2",
            "a-d-swaps",
            "a and d have changed places in every row",
        ),
        (
            "bajd/scara-as-dh-table",
            "l2 0 l1 θ1; l3 0 0 θ2; 0 0 -d3 0",
            "offset-forgotten 1 + theta-forgotten 3",
            "the offset in row 1 is forgotten and theta of row 3, which stands still, is forgotten",
        ),
        (
            "wpi/puma560-table",
            "0 0 0 θ1; 90 0 0 θ2; 0 a2 0 θ3; -90 a3 d4 θ4; 90 0 0 θ5; -90 0 0 θ6",
            "alpha-sign 2 + d-forgotten 3",
            "the sign of alpha in row 2 is turned round and d of row 3 is forgotten",
        ),
    ],
)
def test_slips_in_several_rows_are_named(name: str, answer: str, cause: str, words: str) -> None:
    """One kind of slip in some rows, or two kinds in a row each."""
    found = check(load_exercise(name), "table", answer).diagnosis
    assert found is not None
    assert found.ids == (cause,)
    assert found.names == (words,)
    assert not any("{" in hint for hint in found.hints)


def test_of_slips_with_the_same_motion_the_one_in_the_cells_typed_is_named() -> None:
    """In the table of a wrist two slips can move alike; the cells tell which of them was made."""
    exercise = load_exercise("yim/three-axis-wrist")
    part = exercise.part("table")
    question = part.question
    assert isinstance(question, TableQuestion)
    assert exercise.robot is not None
    for candidate in table_candidates(exercise, question.convention):
        rows = [step.row for step in candidate.work.steps if step.row is not None]
        judged = checked(exercise, part, dh_table_text(rows, exercise.robot.columns, exercise.writing))
        if judged.verdict is Verdict.WRONG:
            assert judged.diagnosis is not None
            # with the twists of rows 4 and 6 swapped it is the right table in the other convention, which is said first
            assert judged.diagnosis.ids in ((candidate.slips[0].name,), ("convention",))
