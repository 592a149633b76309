"""The rows that a wrong table is told to look at hold the slip: each cell of every table, changed in the usual ways."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from dhcli import load_exercise
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.tables.answer import own_rows
from dhcli.checking.tables.cells import dh_table_text, on_sheet
from dhcli.kinematics.conventions import Row
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, add, negate, number
from tests.checking.tables.robots_with_tables import NAMES, robot
from tests.nightly import NIGHT, paired, some

ROOT = Path(__file__).parents[3] / "exercises"
TURNS = tuple(map(Angle.in_degrees, (30, 90, 180)))
COMPARED = ("same-motion", "same-robot")
EXERCISES = sorted(
    f"{path.parent.name}/{path.stem}" for path in ROOT.glob("*/*.yaml") if "ask: table " in path.read_text("utf-8")
)


def slips_in(row: Row) -> Iterator[tuple[set[str], Row]]:
    """A row with one slip, and the columns that hold it."""
    for column in ("alpha", "theta"):
        angle: Angle = getattr(row, column)
        for other in (-angle, *(angle + turn for turn in TURNS)):
            yield {column}, replace(row, **{column: other})
    for column in ("a", "d"):
        length = getattr(row, column)
        others = (number(1),) if length == ZERO else (negate(length), ZERO, add(length, length))
        for other in others:
            yield {column}, replace(row, **{column: other})
    yield {"a", "d"}, replace(row, a=row.d, d=row.a)


def looked_at(remark: str) -> list[tuple[set[str], set[int]]]:
    """Columns, or none where all are meant, and rows of `look at d and theta in row 3, and at alpha in row 2`."""
    found = []
    for clause in remark.removeprefix("look at ").removeprefix("the signs of ").split(", and at "):
        match = re.fullmatch(r"(?:(?P<columns>.*) in )?rows? (?P<rows>[\d, and]+)", clause)
        assert match is not None, remark
        columns = set(re.findall(r"alpha|theta|\ba\b|\bd\b", match["columns"] or ""))
        found.append((columns, {int(row) for row in re.findall(r"\d+", match["rows"])}))
    return found


def check_all(exercise: Exercise, part: Part) -> int:
    """The law for a table; how often it was told where to look."""
    assert exercise.robot is not None
    rows, first, judge, seen = own_rows(exercise.robot), exercise.robot.first, Judge(exercise), 0
    every = [(k, held, row) for k, old in enumerate(rows) for held, row in slips_in(old) if row != old]
    for k, held, row in some(every, 29):
        table = on_sheet((*rows[:k], row, *rows[k + 1 :]), exercise)
        mark = judge.mark(part, dh_table_text(table, exercise.robot.columns, exercise.writing))
        for remark in mark.remarks if mark.verdict.passed is False else ():
            if remark.startswith("look at"):
                said = looked_at(remark)
                assert any(first + k in rows and (not columns or columns & held) for columns, rows in said), (
                    exercise.id,
                    first + k,
                    held,
                    mark.remarks,
                )
                seen += 1
    return seen


@pytest.mark.parametrize("name", EXERCISES)
def test_the_slip_stands_where_an_exercise_says_to_look(name: str) -> None:
    """Of every exercise that asks for the table that its robot has."""
    exercise = load_exercise(name)
    for part in exercise.asked:
        if isinstance(part.question, TableQuestion) and exercise.robot is not None:
            own = part.question.convention is exercise.robot.convention
            assert not own or check_all(exercise, part) or not NIGHT


@pytest.mark.parametrize(("name", "compare"), paired(NAMES, COMPARED))
def test_the_slip_stands_where_a_robot_says_to_look(name: str, compare: str) -> None:
    """Of every robot with a table, whatever is compared."""
    exercise = question_about_table(robot(name), robot(name).convention, compare)
    check_all(exercise, exercise.parts[0])


@pytest.mark.parametrize(
    ("name", "table", "look"),
    [
        ("zhou-3r-modified", "0 0 0 θ1; a 0 0 θ2; b 90 0 θ3", "look at alpha in row 3"),
        ("zhou-3r-modified", "0 0 0 θ1; a 0 0 θ2; b 90 0 -θ3", "look at alpha in row 3"),
        ("zhou-3r-modified", "0 0 0 θ1; a 0 0 θ2; b -90 1 θ3", "look at d and theta in row 3"),
        ("scara-standard", "l2 0 l1 θ1+90; 2*l3 0 0 θ2; 0 0 -d3 -90", "look at rows 2 and 3"),
    ],
)
def test_what_stands_before_a_joint_is_told_from_what_stands_behind(name: str, table: str, look: str) -> None:
    """In a modified row alpha and a lead to the joint, d and theta on from it; a slide has no place of its own."""
    exercise = question_about_table(robot(name), robot(name).convention, "same-motion")
    mark = Judge(exercise).mark(exercise.parts[0], table)
    assert mark.remarks[1] == look, mark.remarks
