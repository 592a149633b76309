"""Tables with cells that are no numbers, or far beyond any robot: they agree with nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli import check, load_exercise, load_robot
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.kinematics.conventions import COLUMNS, Convention
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[3] / "exercises"
WITH_TABLES = sorted(
    f"{path.parent.name}/{path.stem}" for path in ROOT.glob("*/*.yaml") if "ask: table " in path.read_text("utf-8")
)
PUMA = "zhou/puma200-table"
TABLE = "0, 0, 0, θ1; 0, -90°, d, θ2; b, 0, -a, θ3; 0, -90°, 0, θ4; 0, 90°, c, θ5; 0, 90°, 0, θ6"


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


@row_by_row("nothing", ["sqrt(-1)", "acos(2)"])
@row_by_row("name", WITH_TABLES)
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
    assert "is not a real number" in mark.remarks[0]
    assert mark.earned == 0


@pytest.mark.parametrize("length", ["sqrt(a - b - 10)", "sqrt(-a^2 - 1)"])
def test_a_length_of_letters_that_is_never_real_is_not_read(length: str) -> None:
    """Whatever the lengths of the robot are."""
    mark = check(load_exercise(PUMA), "table", TABLE.replace("0, 90°, c", f"0, 90°, {length}"))
    assert mark.verdict is Verdict.CANNOT_READ
    assert "is not a finite number; a length is one" in mark.remarks[0]


def test_a_length_that_is_real_elsewhere_only_is_wrong() -> None:
    """At the lengths of the robot there is no root of d - b, at others there is."""
    assert check(load_exercise(PUMA), "table", TABLE.replace("0, 90°, c", "0, 90°, sqrt(d - b)")).verdict in (
        Verdict.WRONG,
        Verdict.CANNOT_READ,
    )


@pytest.mark.parametrize("cell", ["1e60^5", "1e19", "-1e19 rad", "360e17"])
def test_an_angle_of_many_turns_is_no_twist_of_zero(cell: str) -> None:
    """Floats so large hold no degrees any more."""
    mark = check(load_exercise(PUMA), "table", TABLE.replace("0, 0, 0, θ1", f"0, {cell}, 0, θ1"))
    assert mark.verdict is Verdict.CANNOT_READ


def test_some_turns_are_taken_off_exactly() -> None:
    """Ten turns more are the same twist, ten turns and a degree another."""
    table = TABLE.replace("0, 0, 0, θ1", "0, {}, 0, θ1")
    exercise = load_exercise(PUMA)
    assert check(exercise, "table", table.format("3600")).verdict is Verdict.RIGHT
    assert check(exercise, "table", table.format("3601")).verdict is Verdict.WRONG


@pytest.mark.parametrize("far", ["1e9", "1e7", "-9e7", "1e7 + 1e7*a"])
def test_a_base_far_away_makes_no_wrong_table_right(far: str) -> None:
    """Beside 1e9 m the lengths of the robot were less than what floats leave over."""
    for compare in ("same-motion", "same-robot"):
        for change in (("-a, θ3", "a, θ3"), ("b, 0", "a, 0"), ("0, 90°, c", "0, 90°, b"), ("0, -90°, 0", "0, 80°, 0")):
            mark = _marked(TABLE.replace(*change).replace("0, 0, 0, θ1", f"0, 0, {far}, θ1"), compare)
            assert mark.verdict in (Verdict.WRONG, Verdict.CANNOT_READ), (far, change)
            if mark.verdict is Verdict.WRONG:
                assert mark.remarks[0].startswith("your lengths are a million times those of the robot")


def test_a_base_some_way_off_is_still_a_freedom_and_still_hides_nothing() -> None:
    """A robot on a tower of a kilometre."""
    table = TABLE.replace("0, 0, 0, θ1", "0, 0, 1000, θ1")
    mark = _marked(table, "same-robot")
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks[0].startswith("your frame 0 sits elsewhere along z0")
    assert _marked(table.replace("-a", "a"), "same-robot").verdict is Verdict.WRONG


def _marked(text: str, compare: str) -> Mark:
    exercise = question_about_table(load_robot("puma200"), Convention.MODIFIED, compare)
    return Judge(exercise).mark(exercise.parts[0], text)
