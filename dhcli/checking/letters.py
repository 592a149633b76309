"""Numbers where letters were asked: the slip of whoever puts the robot's own lengths into a formula."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Memo
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading
from dhcli.checking.verdicts import UNSOLVED, Verdict
from dhcli.errors import DhcliError
from dhcli.kinematics.robot import Value
from dhcli.notation.names import canonical
from dhcli.notation.quantity import value_text
from dhcli.regex import regex

NAME = "numbers-for-letters"
_MEASURE = regex(r"(?<![\w.])(?:\d+[.,]\d+|\.\d+|[1-9]\d{1,5})(?![\w.])")
"""A number that may be a length, and is no factor of a formula."""
_WORD = regex(r"[^\W\d_]+\w*")
_NOISE = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789", "_{}\\ ")


def numbers_for_letters(case: Case, text: str) -> Causes:
    """The slip of an answer that is right once the robot's lengths, of which no letter stands in it, have their values.

    A letter that stands in the answer keeps standing for any length, so that one for another is not taken for this.

    Args:
        case: The part that is answered.
        text: The answer, wrong as it stands.
    """
    exercise = case.exercise
    if exercise.numeric or exercise.robot is None or not any(letter.isdigit() for letter in text):
        return ()
    plain, lengths = text.translate(_NOISE).lower(), exercise.robot.scope.lengths
    left = {
        name: value
        for name, value in exercise.known.items()
        if name in lengths and name not in exercise.given and canonical(name).translate(_NOISE).lower() not in plain
    }
    if not left:
        return ()
    given = {**exercise.given, **left}
    there = case.memo.recent("in the robot's numbers", tuple(left), lambda: Memo(replace(exercise, given=given)))
    for unit in (exercise.unit, *exercise.other_units):
        if _is_right(Case(case.part, there.in_unit(unit)), text):
            return ((_slip(case, left, unit, text),),)
    also = _causes(Case(case.part, there), text) if _MEASURE.search(text) else ()
    return tuple((_slip(case, left, exercise.unit, text), *slips) for slips in also if len(slips) == 1)


def _is_right(case: Case, text: str) -> bool:
    try:
        mark = case.part.question.mark(case, Reading(text, case.part.question.read(case, text)))
    except (UnreadableError, DhcliError):
        return False
    return mark.verdict not in (*UNSOLVED, Verdict.SKIPPED)


def _causes(case: Case, text: str) -> Causes:
    """The slips that an answer has besides."""
    question = case.part.question
    try:
        return question.causes(case, Reading(text, question.read(case, text)))
    except (UnreadableError, DhcliError):
        return ()


def _slip(case: Case, left: Mapping[str, Value], unit: str, text: str) -> Slip:
    asked = set(_WORD.findall(case.part.question.expected(case)))
    values = {name: value_text(value, unit) for name, value in left.items() if name in asked}
    typed = (f": {value} for {name}" for name, value in values.items() if value.split()[0] in text)
    words = f"the robot's numbers stand for its letters{next(typed, '')}"
    return Slip(NAME, words, "are letters or numbers asked for?", Rank.WHOLE)
