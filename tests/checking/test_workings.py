"""What stands beside the matrices of a solution: answers to be copied, products and tables, for every exercise."""

from __future__ import annotations

import re

import pytest

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.cell import CellQuestion
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.symbolic import same
from dhcli.checking.verdicts import Verdict
from dhcli.checking.workings import MOST_DECIMALS
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.kinematics.conventions import Convention
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_length
from dhcli.notation.writer import write, write_angle
from tests.judging import expected, mark, shortest, solution
from tests.nightly import in_turn
from tests.row_by_row import row_by_row

EXERCISES = [entry.name for entry in entries(Kind.EXERCISES)]


def parts(name: str) -> list[tuple[Exercise, Part]]:
    """The parts of an exercise that ask for a matrix or a piece of one."""
    exercise = load_exercise(name)
    return [(exercise, part) for part in exercise.parts if isinstance(part.question, MatrixQuestion)]


def lines_after(exercise: Exercise, part: Part, head: str) -> list[str]:
    """The lines below one that says what follows."""
    for step in solution(exercise, part):
        first, *rest = step.text.split("\n")
        if first == head:
            return rest
    return []


@pytest.mark.parametrize("name", in_turn(EXERCISES, 0, 3))
def test_the_answer_that_a_solution_shows_is_right_when_it_is_copied(name: str) -> None:
    """In few decimals, a column in one pair of brackets."""
    for exercise, part in parts(name):
        shown = shortest(exercise, part)
        assert mark(exercise, part, shown).verdict is Verdict.RIGHT, part.id
        assert all(len(digits) <= MOST_DECIMALS for digits in re.findall(r"\.(\d+)", shown)), part.id
        assert isinstance(part.question, MatrixQuestion)
        if part.question.shape == (3, 1):
            assert not shown.startswith("[[")


def test_a_small_value_keeps_the_digits_that_it_needs() -> None:
    """Six decimals of a millionth would be wrong."""
    text = "format: 1\ntitle: x\nsource: x\ntask: x\nnumeric: true\ntolerance: {position: 1e-9}\nparts:\n"
    exercise = read_exercise(text + "  - {id: a, ask: 'position of product \"Trans(0.0000012345, 2, 0)\"'}\n", "x", "x")
    assert shortest(exercise, exercise.parts[0]) == "[0.0000012345, 2, 0]"


@pytest.mark.parametrize("name", in_turn(EXERCISES, 1, 3))
def test_the_product_of_a_point_is_the_answer(name: str) -> None:
    """Each line holds: what is multiplied gives what stands behind it, in symbols exactly."""
    for exercise, part in parts(name):
        assert isinstance(part.question, MatrixQuestion)
        lines = lines_after(exercise, part, "The matrix times this column:")
        assert [line[:4] for line in lines] == (
            ["x = ", "y = ", "z = "] if part.question.piece in ("point", "vector") else []
        )
        for line in lines:
            sides = [to_length(parse(side, exercise.scope)) for side in line.split(" = ")[1:]]
            left, right = sides[0], sides[-1]
            if exercise.numeric:
                assert Floats().value(left) == pytest.approx(Floats().value(right), rel=1e-3, abs=2e-2)
            else:
                assert same(left, right, {})


@row_by_row("name", in_turn(EXERCISES, 2, 3))
def test_a_table_is_shown_row_by_row(name: str) -> None:
    """With the four values named, their equals signs below each other."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        if isinstance(part.question, TableQuestion):
            lines = lines_after(exercise, part, "Row by row:")
            assert exercise.robot is not None
            assert len(lines) == len(exercise.robot.links)
            assert len({tuple(match.start() for match in re.finditer("=", line)) for line in lines}) == 1
            for column in exercise.robot.columns:
                assert all(f" {column} = " in line for line in lines)


@row_by_row("name", in_turn(EXERCISES, 0, 3))
def test_each_cell_of_a_table_is_found_on_the_way(name: str) -> None:
    """The steps say each x axis with its four cells, and those are the cells of the answer."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        robot = exercise.robot
        is_table = isinstance(part.question, TableQuestion) and robot is not None
        if not is_table or robot is None or exercise.also or robot.convention is not part.question.convention:
            continue
        steps = solution(exercise, part)
        if "dh-link" in robot.name:
            continue
        told = "\n".join(step.text for step in steps)
        for number, link in enumerate(robot.links, robot.first):
            assert link.row is not None
            back = number - (robot.convention is Convention.MODIFIED)
            assert f"a{back} = {write(link.row.a)}, α{back} = {write_angle(link.row.alpha)}" in told
            assert f"d{number} = {write(link.row.d)}, θ{number} = {write_angle(link.row.theta)}" in told
        assert told.index("1  z axes: DH1: ") < told.index("\n3  x axes: ") < told.index("\n4  Each row leads")


@row_by_row("name", in_turn(EXERCISES, 1, 3))
def test_a_cell_of_a_table_is_found_in_its_step(name: str) -> None:
    """The one that has the cell, in either convention."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        robot = exercise.robot
        if isinstance(part.question, CellQuestion) and robot is not None:
            column, number = part.question.column, int(part.question.link)
            number -= robot.convention is Convention.MODIFIED and column in ("a", "alpha")
            head = {"alpha": "α", "theta": "θ"}.get(column, column)
            _, step, _ = solution(exercise, part)
            assert f"{head}{number} = {expected(exercise, part)}" in step.text
