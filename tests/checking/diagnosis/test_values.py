"""Slips in a single value, in a cell of a table, and in the moves of a link."""

from __future__ import annotations

from fractions import Fraction

import pytest

from dhcli import check, load_exercise
from dhcli.checking.diagnosis.mistakes.values import IN_VALUES
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.cell import CellQuestion
from dhcli.checking.kinds.factors import FactorsQuestion
from dhcli.checking.kinds.registry import read_question
from dhcli.checking.kinds.scalar import ScalarQuestion
from dhcli.checking.verdicts import Verdict
from dhcli.notation.angle import Angle
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Number
from tests.judging import answer_with, checked, mark, slips
from tests.nightly import some

EXERCISES = (
    "elementary-rotations",
    "scara-as-dh-table",
    "scara-home-pose",
    "puma560-actuators",
    "puma560-table",
    "puma560-unimation-zero",
    "counting-freedoms",
    "dh-factors",
    "scara-in-numbers",
    "modified-link-matrix",
    "three-r-arm-modified",
)


@pytest.mark.parametrize("name", EXERCISES)
def test_each_slip_in_a_value_a_cell_or_a_move_is_named(name: str) -> None:
    """The answer that it leads to is wrong, and it stands among its causes; the right answer has none."""
    exercise = load_exercise(name)
    parts = [p for p in exercise.parts if isinstance(p.question, (ScalarQuestion, CellQuestion, FactorsQuestion))]
    assert parts
    for part in parts:
        every = slips(exercise, part)
        assert every
        for slip in some(every, 3):
            answer = answer_with(exercise, part, slip.name)
            judged = mark(exercise, part, answer)
            assert judged.verdict in (Verdict.WRONG, Verdict.CLOSE), slip.name
            found = checked(exercise, part, answer).diagnosis
            assert found is not None
            assert slip.name in found.ids


@pytest.mark.parametrize(
    ("name", "part", "answer", "slips_named"),
    [
        ("dh-factors", "order", "Rot(x, alpha_i) Trans(a_i,0,0) Trans(0,0,d_i) Rot(z, theta_i)", ("convention",)),
        ("dh-factors", "order", "Rot(z, theta_i) Trans(0,0,d_i) Rot(x, alpha_i)", ("factor-missing 3",)),
        ("counting-freedoms", "gruebler", "lambda*(n - j) + f*j", ("term-forgotten 1",)),
        ("scara-home-pose", "factors", "Rot(z, theta2) Trans(0, l2, 0)", ("order-reversed",)),
        ("puma560-table", "upper", "a3", ("neighbour 4",)),
        ("puma560-table", "upper", "-a2", ("a-sign 3",)),
        ("puma560-table", "forearm", "0", ("d-forgotten 4", "neighbour 5")),
        ("elementary-rotations", "angle_zy", "90 - alpha", ("term-sign alpha",)),
        ("elementary-rotations", "angle_zy", "-alpha", ("sin-cos",)),
        ("counting-freedoms", "gruebler", "lambda*(n - j + 1) + j*f", ("term-sign 1",)),
        ("scara-in-numbers", "turn", "90°", ("term-sign theta4",)),
    ],
)
def test_a_slip_typed_by_hand_has_its_name(name: str, part: str, answer: str, slips_named: tuple[str, ...]) -> None:
    """Several that give the same answer are all named."""
    found = check(load_exercise(name), part, answer).diagnosis
    assert found is not None
    assert found.ids == slips_named


def test_a_value_that_no_slip_explains_gets_no_name() -> None:
    """Never a guess."""
    assert check(load_exercise("elementary-rotations"), "angle_zy", "17°").diagnosis is None


@pytest.mark.parametrize(
    ("answer", "slip"),
    [("0.15", "sin-cos"), ("0.0463", "angle-unit"), ("1000*a*cos(theta)", "in-mm"), ("-0.2598", "value-sign")],
)
def test_a_value_in_numbers(answer: str, slip: str) -> None:
    """0.3 cos 30°: by the sine, with the calculator in radians, in millimetres, with the other sign."""
    given = {"theta": Angle.in_degrees(30), "a": Number(Fraction(3, 10))}
    question = read_question("scalar a*cos(theta)", Scope(angles=("theta",), lengths=("a",)))
    exercise = Exercise("e", "", "", "", (Part("x", question),), given=given, numeric=True)
    found = check(exercise, "x", answer).diagnosis
    assert found is not None
    assert slip in found.ids


def test_every_record_of_a_value_can_be_told() -> None:
    """Words and hint of each differ, and are filled in."""
    assert len({mistake.id for mistake in IN_VALUES}) == len(IN_VALUES)
    for mistake in IN_VALUES:
        assert "{" not in mistake.words.format(where="a1")
        assert mistake.hint not in ("", mistake.words)
