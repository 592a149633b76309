"""Verdicts against an oracle of floats: answers made by a seed, a share of them in ordinary runs, all at night."""

from __future__ import annotations

import zlib
from pathlib import Path
from random import Random

import pytest

from dhcli.checking.judge import check
from dhcli.checking.verdicts import Verdict
from tests.checking.mutated_kinds import FILES, KINDS, Answer, exercise_of
from tests.checking.mutations import MUTATIONS, torn
from tests.cli.running import run
from tests.judging import checked, mark
from tests.nightly import NIGHT, in_turn
from tests.row_by_row import row_by_row

MANY = 2000 if NIGHT else 8


def answers(kind: str, how_many: int) -> list[Answer]:
    """Answers of one kind, the same ones each time, no text twice."""
    draw = Random(zlib.crc32(kind.encode()))  # noqa: S311  the same each time
    found = (KINDS[kind](draw) for _ in range(how_many))
    return list({answer.text + answer.exercise.unit: answer for answer in found}.values())


@pytest.mark.parametrize("kind", KINDS)
def test_no_verdict_is_wrong(kind: str) -> None:
    """Right where an answer agrees with the truth all round the circle, and nowhere else."""
    wrong = []
    for answer in answers(kind, MANY):
        judged = mark(answer.exercise, answer.part, answer.text)
        if judged.verdict.word not in answer.fair:
            wrong.append((answer.made, answer.text, judged.verdict.word, sorted(answer.fair), judged.remarks))
    assert wrong == []


@row_by_row("kind", KINDS)
def test_torn_text_is_judged_or_refused_and_never_a_bug(kind: str) -> None:
    """Whatever characters are lost or put in, there is a verdict, and its explanation."""
    draw = Random(5)  # noqa: S311  the same each time
    for answer in answers(kind, MANY // 5):
        text = torn(answer.text, draw)
        assert isinstance(checked(answer.exercise, answer.part, text).verdict, Verdict), text


HARD = (
    "sqrt(" * 25 + "a1 + 1" + ")" * 25,
    "(a1 + 10^100)^64",
    "10^-300*a1",
    "1/(a1 - a1)",
    "atan2(0, 0)*a1",
    "sqrt(acos(2))",
    "cos(1e17)",
    "acos(c1) + a1",
    "theta1*atan2(1, 2)",
    "atan2(a1 mm, 3)",
    "(10 mm)^2",
    "10 mm/(3 mm)",
    "a1*90°",
    "tan(90°)",
)
"""What has no value, two dimensions, or numbers that no float holds."""
HARD_ASKED = ("position of link 1", "scalar atan2(a1, a2)", "scalar 2*a1", "cell a 1", "factors 1")


@pytest.mark.parametrize("unit", ["m", "mm"])
@pytest.mark.parametrize(("turn", "ask"), [*enumerate(HARD_ASKED)])
def test_hard_formulas_are_judged_or_refused_and_never_a_bug(turn: int, ask: str, unit: str) -> None:
    """In symbols and in numbers; by day each text in one or two of them."""
    for numeric in (True, False):
        exercise, part = exercise_of(ask, unit=unit, numeric=numeric, given={"theta1": "35°"} if numeric else None)
        for text in in_turn(HARD, turn + (unit == "mm"), len(HARD_ASKED)):
            forms = {"position": f"[{text}, {text}, 0]", "factors": f"Trans({text}, 0, 0)"}
            typed = forms.get(ask.partition(" ")[0], text)
            judged = checked(exercise, part, typed)
            assert judged.verdict in (Verdict.WRONG, Verdict.CANNOT_READ), (text, judged.verdict)


@pytest.mark.parametrize("kind", ["entry in symbols", "position in numbers", "angle", "cell of a length", "count"])
def test_the_verdict_is_the_same_in_every_format_and_by_library(kind: str, tmp_path: Path) -> None:
    """A table for people, JSON for programs, and a call."""
    for answer in answers(kind, 12 if NIGHT else 2):
        path = tmp_path / "x.yaml"
        path.write_text(FILES[id(answer.exercise)], "utf-8")
        word = check(answer.exercise, "a", answer.text).verdict.word
        for_programs = run("check", str(path), "--part", "a", f"--answer={answer.text}", "--format", "json")
        for_people = run("check", str(path), "--part", "a", f"--answer={answer.text}")
        assert for_programs.envelope["data"]["verdict"] == word
        assert word in for_people.out
        assert for_people.code == for_programs.code == (0 if word == "RIGHT" else 2 if word == "CAN'T READ" else 1)


def test_every_mutation_changes_something() -> None:
    """So that none is in the list for nothing."""
    text = "a1*cos(theta1) + a2*sin(theta1 + theta2)"
    draw = Random(1)  # noqa: S311  the same each time
    same = [kind for kind, change in MUTATIONS.items() if all(change(text, draw) == text for _ in range(5))]
    assert same == []
