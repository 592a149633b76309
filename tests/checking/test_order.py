"""What is kept of an exercise for a whole class changes no mark: an answer is judged alike whatever came before it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli import load_robot
from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.files.yaml.linkages import load_linkage
from dhcli.notation.angle import Angle

POSE = (
    "{}*[c12/0.999 -s12/0.999 0 a1*c1+a2*c12; s12/0.999 c12/0.999 0 a1*s1+a2*s12; 0 0 1/0.999 0; 0 0 0 1/0.999]",
    ("0.999", "999/1000"),
)
TABLE = ("[{}*a1 0 0 theta1; a2 0 0 theta2]", ("0.9999", "9999/10000"))


def asked(ask: str, **given: Angle) -> Exercise:
    """A question about two links in a plane, in letters or in numbers."""
    return question_about(load_robot("planar-2r"), ask, numeric=bool(given), given=given)


def marks(exercise: Exercise, answers: list[str]) -> list[Mark]:
    """The marks of some answers, one after the other by the same judge."""
    judge = Judge(exercise)
    return [judge.mark(exercise.parts[0], answer) for answer in answers]


@pytest.mark.parametrize(("ask", "answer"), [("pose 0..2", POSE), ("table standard", TABLE)])
def test_decimals_and_fractions_are_judged_and_shown_as_typed(ask: str, answer: tuple[str, tuple[str, str]]) -> None:
    """Numbers that are equal, of which a decimal may be a rounded one."""
    exercise, both = asked(ask), [answer[0].format(number) for number in answer[1]]
    alone = [*marks(exercise, both[:1]), *marks(exercise, both[1:])]
    assert marks(exercise, both) == alone
    assert marks(exercise, both[::-1]) == alone[::-1]
    assert alone[0].reading != alone[1].reading


def test_of_two_tables_the_rounded_one_alone_is_the_robot() -> None:
    """As a decimal it may be off by a little, as a fraction it is another length."""
    assert [mark.verdict for mark in marks(asked("table standard"), [TABLE[0].format(n) for n in TABLE[1]])] == [
        Verdict.EQUIVALENT,
        Verdict.WRONG,
    ]


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        ("cell a 1", "0.31"),
        ("velocity 0..2 with rates (1, 2)", "-0.97, 1.33, 0"),
    ],
)
def test_each_of_two_parts_is_explained_within_its_own_tolerance(ask: str, answer: str) -> None:
    """They ask the same, and one wants it finer."""
    one = asked(ask, theta1=Angle.in_degrees(20), theta2=Angle.in_degrees(30))
    parts = [
        replace(one.parts[0], id=name, tolerance=Tolerance(rotation=size, position=size))
        for name, size in (("fine", 1e-6), ("coarse", 0.02))
    ]
    exercise = replace(one, parts=tuple(parts))
    alone = [Judge(exercise).check(part, answer) for part in parts]
    for order in (parts, parts[::-1]):
        judge = Judge(exercise)
        found = {part.id: judge.check(part, answer) for part in order}
        assert [found[part.id] for part in parts] == alone
    assert [mark.diagnosis is None for mark in alone] == [True, False]


def test_a_count_whose_name_is_that_of_a_convention_takes_nothing_from_a_table() -> None:
    """Parts are named as a lecturer likes."""
    table = asked("table standard")
    (count,) = asked("count mobility planar-four-bar").parts
    count = replace(count, id="standard", question=replace(count.question, found=load_linkage("planar-four-bar")))
    judge = Judge(replace(table, parts=(count, *table.parts)))
    assert judge.check(count, "3").verdict is Verdict.WRONG
    (part,) = table.parts
    answers = [judge.answer_with(part, slip.name) for slip in judge.slips(part)]
    found = [judge.check(part, answer) for answer in answers]
    assert any(mark.diagnosis for mark in found)
    assert found == [Judge(table).check(part, answer) for answer in answers]
