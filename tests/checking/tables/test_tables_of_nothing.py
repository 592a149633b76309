"""Tables with cells that are no numbers, or far beyond any robot: they agree with nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli import check, load_exercise, load_robot
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.tables.marking import mark_table
from dhcli.checking.tables.typed_rows import read_table
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.kinematics.conventions import COLUMNS, Convention

ROOT = Path(__file__).parents[3] / "exercises"
WITH_TABLES = sorted(
    f"{path.parent.name}/{path.stem}" for path in ROOT.glob("*/*.yaml") if "ask: table " in path.read_text("utf-8")
)
PUMA = "zhou/puma200-table"


def table_of(name: str) -> tuple[Exercise, Part, list[list[str]]]:
    """An exercise, its part with a table, and the cells of the right one; of a tableless robot those of a test."""
    exercise = load_exercise(name)
    part = next(part for part in exercise.parts if isinstance(part.question, TableQuestion))
    trial = next(one.answer for one in exercise.trials if one.part == part.id and one.verdict == "RIGHT")
    right = Judge(exercise).mark(part, trial).reading
    return exercise, part, [row.split(", ") for row in right.strip("[]").split("], [")]


def text_of(cells: list[list[str]]) -> str:
    """Cells as an answer."""
    return "; ".join(", ".join(row) for row in cells)


def test_many_exercises_ask_for_a_table() -> None:
    """Else the tests below would be about nothing."""
    assert len(WITH_TABLES) >= 15


@pytest.mark.parametrize("nothing", ["sqrt(-1)", "acos(2)", "asin(3)", "sqrt(-2)*10"])
@pytest.mark.parametrize("name", WITH_TABLES)
def test_lengths_that_are_no_numbers_are_not_read(name: str, nothing: str) -> None:
    """In every constant length of the table; it earned the full credit once."""
    exercise, part, cells = table_of(name)
    columns = exercise.robot.columns if exercise.robot else COLUMNS
    variables = exercise.robot.variables if exercise.robot else ()
    for row in cells:
        for index, column in enumerate(columns):
            moves = any(variable in row[index] for variable in variables)
            if column in ("a", "d") and row[index] != "0" and not moves:
                row[index] = nothing
    if not any(nothing in row for row in cells):
        cells[0][columns.index("a")] = nothing  # a robot without a constant length
    mark = check(exercise, part.id, text_of(cells))
    assert mark.verdict is Verdict.CANNOT_READ
    assert mark.remarks[0].endswith("is not a finite number; a length is one")
    assert mark.earned == 0


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        ("1e60^5", "row 1, alpha: 1e60^5 is more than 100 turns; an angle of a table is within one"),
        ("1e19", "row 1, alpha: 1e19 is more than 100 turns; an angle of a table is within one"),
        ("-1e19 rad", "row 1, alpha: -1e19 rad is more than 100 turns; an angle of a table is within one"),
        ("360e17", "row 1, alpha: 360e17 is more than 100 turns; an angle of a table is within one"),
    ],
)
def test_an_angle_of_many_turns_is_no_twist_of_zero(cell: str, said: str) -> None:
    """Floats so large hold no degrees any more."""
    table = f"0, {cell}, 0, θ1; 0, -90°, d, θ2; b, 0, -a, θ3; 0, -90°, 0, θ4; 0, 90°, c, θ5; 0, 90°, 0, θ6"
    mark = check(load_exercise(PUMA), "table", table)
    assert (mark.verdict, mark.remarks) == (Verdict.CANNOT_READ, (said,))


def test_some_turns_are_taken_off_exactly() -> None:
    """Ten turns more are the same twist, ten turns and a degree another."""
    table = "0, {}, 0, θ1; 0, -90°, d, θ2; b, 0, -a, θ3; 0, -90°, 0, θ4; 0, 90°, c, θ5; 0, 90°, 0, θ6"
    exercise = load_exercise(PUMA)
    assert check(exercise, "table", table.format("3600")).verdict is Verdict.RIGHT
    assert check(exercise, "table", table.format("3601")).verdict is Verdict.WRONG


@pytest.mark.parametrize("far", ["1e9", "1e7", "-1e12", "1e9 + 1e9*a"])
def test_a_base_far_away_makes_no_wrong_table_right(far: str) -> None:
    """Beside 1e9 m the lengths of the robot were less than what floats leave over."""
    for compare in ("same-motion", "same-robot"):
        for change in (("-a, θ3", "a, θ3"), ("b, 0", "a, 0"), ("0, 90°, c", "0, 90°, b"), ("0, -90°, 0", "0, 80°, 0")):
            table = "0, 0, 0, θ1; 0, -90°, d, θ2; b, 0, -a, θ3; 0, -90°, 0, θ4; 0, 90°, c, θ5; 0, 90°, 0, θ6"
            mark = _marked(table.replace(*change).replace("0, 0, 0, θ1", f"0, 0, {far}, θ1"), compare)
            assert mark.verdict is Verdict.WRONG, (far, change)
            assert mark.remarks[0].startswith("your lengths are a million times those of the robot")


def test_a_base_some_way_off_is_still_a_freedom_and_still_hides_nothing() -> None:
    """A robot on a tower of a kilometre."""
    table = "0, 0, 1000, θ1; 0, -90°, d, θ2; b, 0, -a, θ3; 0, -90°, 0, θ4; 0, 90°, c, θ5; 0, 90°, 0, θ6"
    mark = _marked(table, "same-robot")
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks[0].startswith("your frame 0 sits elsewhere along z0")
    assert _marked(table.replace("-a", "a"), "same-robot").verdict is Verdict.WRONG


def _marked(text: str, compare: str) -> Mark:
    exercise = question_about_table(load_robot("puma200"), Convention.MODIFIED)
    rows = read_table(text, exercise.robot)
    return mark_table(exercise, Convention.MODIFIED, rows, compare)
