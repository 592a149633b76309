"""The judge of an exercise by short names; each exercise keeps its judge, so that a test works nothing out twice."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.marked import SheetMark
from dhcli.checking.returned import Shown
from dhcli.checking.variants import vary as judge_of_variant
from dhcli.checking.verdicts import Mark
from dhcli.errors import Place


class _Same:
    """An exercise that equals itself only, so that it can be a key."""

    def __init__(self, exercise: Exercise) -> None:
        self.exercise = exercise

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other.exercise is self.exercise

    def __hash__(self) -> int:
        return id(self.exercise)


@lru_cache(maxsize=500)
def _judge_of(same: _Same) -> Judge:
    return Judge(same.exercise)


def judge_of(exercise: Exercise) -> Judge:
    """The judge that an exercise has kept."""
    return _judge_of(_Same(exercise))


def case_of(exercise: Exercise, part: Part) -> Case:
    """A part with what was worked out for it."""
    return Case(part, judge_of(exercise).memo)


def mark(exercise: Exercise, part: Part, answer: str, place: Place | None = None) -> Mark:
    """An answer judged."""
    return judge_of(exercise).mark(part, answer, place)


def checked(exercise: Exercise, part: Part, answer: str) -> Mark:
    """An answer judged, with the slip behind it."""
    return judge_of(exercise).check(part, answer)


def mark_sheet(
    exercise: Exercise,
    answers: Mapping[str, str],
    places: Mapping[str, Place] | None = None,
    only: str | None = None,
) -> SheetMark:
    """A sheet judged."""
    return judge_of(exercise).sheet(answers, places, only)


def expected(exercise: Exercise, part: Part, style: str = "short") -> str:
    """The right answer."""
    return judge_of(exercise).expected(part, style)


def solution(exercise: Exercise, part: Part) -> tuple[Shown, ...]:
    """A solution, step by step."""
    return judge_of(exercise).solution(part)


def slips(exercise: Exercise, part: Part) -> tuple[Slip, ...]:
    """Every single mistake."""
    return judge_of(exercise).slips(part)


def hidden(exercise: Exercise, part: Part) -> tuple[Slip, ...]:
    """Mistakes that do not show."""
    return judge_of(exercise).hidden(part)


def answer_with(exercise: Exercise, part: Part, name: str) -> str:
    """The answer of somebody with a mistake."""
    return judge_of(exercise).answer_with(part, name)


def vary(exercise: Exercise, seed: str) -> Exercise:
    """The exercise with the numbers of a seed."""
    return judge_of_variant(judge_of(exercise), seed).exercise


def shortest(exercise: Exercise, part: Part) -> str:
    """The right answer as a solution shows it."""
    return part.question.shortest(case_of(exercise, part))
