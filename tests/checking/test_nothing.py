"""Answers made of nothing are wrong, and exact ones are exact."""

from __future__ import annotations

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import load_exercise
from tests.checking.mutated_kinds import MATRICES, cells_of, exercise_of, written
from tests.judging import expected, mark
from tests.row_by_row import row_by_row

ZERO = "1e6*(0.1*(c1 + 1) - 0.1*(1 + c1))"


@row_by_row("kind", MATRICES)
@row_by_row("nothing", [ZERO, "1e6*(0.10 - 0.09)", "1000*(0.1*c1 - 0.1*s1)", "sqrt(-1)", "acos(2)"])
def test_decimals_are_no_blank_cheque(kind: str, nothing: str) -> None:
    """A zero made of decimals, or what is no number, is not approximately everything, in any kind of matrix."""
    exercise, part = exercise_of(MATRICES[kind])
    rows = cells_of(expected(exercise, part))
    blind = [[cell if cell in ("0", "1") else nothing for cell in row] for row in rows]
    judged = mark(exercise, part, written(blind))
    assert judged.verdict in (Verdict.WRONG, Verdict.CANNOT_READ)
    assert judged.earned == 0


def test_a_blind_sheet_of_zeros_earns_nothing_in_a_real_exercise() -> None:
    """Every symbolic matrix of the PUMA's exercise."""
    exercise = load_exercise("wpi/puma560-links")
    for part in exercise.parts:
        judged = mark(exercise, part, written([[ZERO.replace("c1", "cos(theta1)")] * 4] * 3 + [["0", "0", "0", "1"]]))
        assert judged.earned == 0, part.id


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("0.866*a1", Verdict.ROUNDED),
        ("0.87*a1", Verdict.ROUNDED),
        ("0.90*a1", Verdict.WRONG),
        ("(0.433 + 0.433)*a1", Verdict.ROUNDED),
        ("1000*0.001*a1*cos(30°)", Verdict.RIGHT),
        ("1000*(0.9 - 0.8)*a1", Verdict.WRONG),
    ],
)
def test_decimals_are_worth_their_digits(answer: str, verdict: Verdict) -> None:
    """As much as their last digit leaves open, and no more than a twentieth of the truth in all."""
    exercise, part = exercise_of("scalar sqrt(3)/2*a1")
    assert mark(exercise, part, answer).verdict is verdict


@row_by_row(
    ("answer", "verdict"),
    [
        ("6", Verdict.RIGHT),
        ("6.0", Verdict.RIGHT),
        ("2*3", Verdict.RIGHT),
        ("M = 6", Verdict.RIGHT),
        ("7 = 6", Verdict.CANNOT_READ),
        ("1+6 = 6", Verdict.CANNOT_READ),
        ("5.9999999999999999", Verdict.CANNOT_READ),
        ("6 + 1e-20", Verdict.CANNOT_READ),
        ("7", Verdict.WRONG),
    ],
)
def test_a_count_is_exactly_a_whole_number(answer: str, verdict: Verdict) -> None:
    """And no equation between numbers."""
    exercise, part = exercise_of("count mobility 6R", robot=None)
    assert mark(exercise, part, answer).verdict is verdict


@row_by_row("ask", ["scalar cos(theta1)", "entry 1 1 of link 1"])
@row_by_row(
    ("answer", "verdict"),
    [
        ("sqrt(3)/2", Verdict.RIGHT),
        ("cos(30°)", Verdict.RIGHT),
        ("cos(pi/6)", Verdict.RIGHT),
        ("0.8660", Verdict.ROUNDED),
        ("8660/10000", Verdict.ROUNDED),
        ("13/15", Verdict.ROUNDED),
        ("cos(0.5236)", Verdict.ROUNDED),
        ("866025403784438647/10^18", Verdict.ROUNDED),
        ("0.5", Verdict.WRONG),
    ],
)
def test_exact_means_exact(ask: str, answer: str, verdict: Verdict) -> None:
    """Whatever spelling hides a decimal, in matrices and in single values."""
    exercise, part = exercise_of(ask, given={"theta1": "30°"}, numeric=True, exact=True)
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("Rot(z, 30°) Trans(0.4, 0, 0)", Verdict.RIGHT),
        ("Rot(z, pi/6) Trans(2/5, 0, 0)", Verdict.RIGHT),
        ("Rot(z, 0.5236 rad) Trans(0.4, 0, 0)", Verdict.ROUNDED),
        ("Rot(z, 30°) Trans(0.4001, 0, 0)", Verdict.ROUNDED),
    ],
)
def test_exact_moves_are_exact(answer: str, verdict: Verdict) -> None:
    """Within the tolerance is not enough."""
    exercise, part = exercise_of("factors 1", given={"theta1": "30°"}, numeric=True, exact=True)
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [("45°", Verdict.RIGHT), ("pi/4", Verdict.RIGHT), ("atan2(2, 2)", Verdict.RIGHT), ("0.7854 rad", Verdict.ROUNDED)],
)
def test_exact_angles_are_exact_modulo_a_turn(answer: str, verdict: Verdict) -> None:
    """A multiple of π is exact, radians with four digits are not."""
    given = {"px": "1 m", "py": "1 m"}
    exercise, part = exercise_of("scalar atan2(py, px)", robot=None, given=given, numeric=True, exact=True)
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize(
    ("answer", "verdict"), [("a1*c1", Verdict.RIGHT), ("(a1 + 0.02)*c1", Verdict.WRONG), ("0.4*c1", Verdict.RIGHT)]
)
def test_the_digits_of_given_values_are_no_digits_typed(answer: str, verdict: Verdict) -> None:
    """A length of 0.4 m stands in the task, and is exact."""
    exercise, part = exercise_of("entry 1 4 of link 1", given={"a1": "0.4 m"})
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [("10*c1 - 20*s1", Verdict.WRONG), ("10.35*c1 - 20*s1", Verdict.ROUNDED), ("10.346*c1 - 20*s1", Verdict.RIGHT)],
)
def test_digits_count_in_the_unit_of_the_sheet(answer: str, verdict: Verdict) -> None:
    """Ten millimetres are not ten to half a millimetre, but two decimals are two decimals."""
    exercise, part = exercise_of('entry 1 4 of product "Rot(z, theta1) Trans(10.346, 20, 0)"', unit="mm")
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [("six", Verdict.RIGHT), ("F = Six.", Verdict.RIGHT), ("seven", Verdict.WRONG), ("many", Verdict.CANNOT_READ)],
)
def test_a_count_may_be_a_number_word(answer: str, verdict: Verdict) -> None:
    """Up to twelve, as a sentence has it."""
    exercise, part = exercise_of("count mobility 6R", robot=None)
    assert mark(exercise, part, answer).verdict is verdict
