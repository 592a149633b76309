"""The judge: one reading for each answer, whatever is done with it; and what it keeps, it does not work out again."""

from __future__ import annotations

from collections import Counter
from dataclasses import FrozenInstanceError, fields

import pytest

from dhcli import load_exercise
from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.registry import every_kind
from dhcli.checking.verdicts import Verdict


@pytest.fixture
def readings(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often each text is read, by whatever kind of question."""
    counted: Counter[str] = Counter()
    for kind in every_kind():

        def counting(question, case, text, place=None, *, read=kind.read):  # noqa: ANN001, ANN202
            counted[text] += 1
            return read(question, case, text, place)

        monkeypatch.setattr(kind, "read", counting)
    return counted


@pytest.mark.parametrize(
    "name", ["wpi/puma560-links", "yim/planar-in-numbers", "bajd/scara-as-dh-table", "zhou/three-r-arm-tip"]
)
def test_an_answer_is_read_once(name: str, readings: Counter[str]) -> None:
    """Marked, held against a misprint, explained and followed: right, wrong and with a slip, part by part."""
    exercise = load_exercise(name)
    judge = Judge(exercise)
    right = {part.id: judge.expected(part) for part in exercise.parts}
    wrong = {p.id: judge.answer_with(p, s[0].name) for p in exercise.parts if (s := judge.slips(p))}
    assert wrong
    for answers in (right, wrong, {**right, exercise.parts[0].id: wrong.get(exercise.parts[0].id, "1")}):
        typed = {part: f"{text} " for part, text in answers.items()}
        readings.clear()
        sheet = judge.sheet(typed)
        assert Verdict.SKIPPED not in {one.mark.verdict for one in sheet.parts} or answers is wrong
        assert {text: readings[text] for text in typed.values()} == dict(Counter(typed.values()))


def test_a_printed_answer_is_read_once_for_all_students(readings: Counter[str]) -> None:
    """However many wrong answers are held against it."""
    exercise = load_exercise("zhou/three-r-arm-tip")
    part = next(part for part in exercise.parts if part.printed)
    judge = Judge(exercise)
    for number in range(3):
        judge.check(part, judge.answer_with(part, judge.slips(part)[number].name))
    assert part.printed is not None
    assert readings[part.printed.text] == 1


def test_an_exercise_is_data() -> None:
    """Frozen, with slots, and without a place to keep anything in."""
    exercise = load_exercise("wpi/puma560-links")
    before = repr(exercise)
    judge = Judge(exercise)
    for part in exercise.parts:
        judge.check(part, judge.expected(part))
    assert repr(exercise) == before
    assert not hasattr(exercise, "__dict__")
    assert {field.name for field in fields(Exercise)} == set(Exercise.__slots__)
    with pytest.raises(FrozenInstanceError):
        exercise.title = "another"


def test_making_one_mistake_makes_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """By its name the kind of mistake is known; the rest of the catalogue is not gone through."""
    from dhcli.checking.diagnosis import slips

    made: list[str] = []
    called = slips._called
    monkeypatch.setattr(slips, "_called", lambda name: made.append(name) or called(name))
    monkeypatch.setattr(slips, "MISTAKES", ())
    exercise = load_exercise("wpi/puma560-links")
    answer = Judge(exercise).answer_with(exercise.parts[0], "transposed")
    assert made == ["transposed"]
    assert answer
