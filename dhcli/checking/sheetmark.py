"""A whole sheet judged: every part, the credit earned, and the verdict on all of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from dhcli.checking.diagnosis.diagnosis import diagnosed
from dhcli.checking.diagnosis.following import follows
from dhcli.checking.diagnosis.result import Diagnosis
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.marking import mark
from dhcli.checking.questions import TableQuestion
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import Place, UnknownNameError, did_you_mean

UNSOLVED = (Verdict.WRONG, Verdict.CLOSE)

WORST_FIRST = (
    Verdict.CANNOT_READ,
    Verdict.WRONG,
    Verdict.CLOSE,
    Verdict.ROUNDED,
    Verdict.SKIPPED,
    Verdict.EQUIVALENT,
    Verdict.RIGHT,
)
"""A sheet is as good as its worst part."""


@dataclass(frozen=True, slots=True)
class PartMark:
    """The judgement of one part."""

    part: Part
    mark: Mark


@dataclass(frozen=True, slots=True)
class SheetMark:
    """The judgement of a sheet.

    Attributes:
        exercise: The exercise.
        parts: The parts that were looked at, in order.
        why: Whether a person has asked for the names of slips; else there are only hints.
    """

    exercise: Exercise
    parts: tuple[PartMark, ...]
    why: bool = False

    @property
    def verdict(self) -> Verdict:
        """The verdict of the worst part."""
        return min((part.mark.verdict for part in self.parts), key=WORST_FIRST.index, default=Verdict.SKIPPED)

    @property
    def earned(self) -> float:
        """Credit earned."""
        return sum(part.mark.earned * part.part.credit for part in self.parts)

    @property
    def credit(self) -> float:
        """Credit there was to earn."""
        return sum(part.part.credit for part in self.parts)


def mark_sheet(
    exercise: Exercise,
    answers: Mapping[str, str],
    places: Mapping[str, Place] | None = None,
    only: str | None = None,
) -> SheetMark:
    """Judge the answers of a sheet; a part without an answer is skipped.

    Args:
        exercise: The exercise.
        answers: Text by part.
        places: Where each answer stands, for errors.
        only: The one part to look at; all by default.

    Raises:
        UnknownNameError: An answer, or the part asked for, belongs to no part of the exercise.
    """
    known = [part.id for part in exercise.parts]
    for name in (*answers, *((only,) if only else ())):
        if name not in known:
            raise UnknownNameError(f"{exercise.id} has no part {name}", did_you_mean(name, known) or ", ".join(known))
    places = places or {}
    marks: dict[str, Mark] = {}
    for part in exercise.parts:
        text = answers.get(part.id, "")
        judged = diagnosed(exercise, part, text, mark(exercise, part, text, places.get(part.id)))
        if judged.verdict in UNSOLVED:
            own = {name: answers[name] for name, one in marks.items() if _differs(exercise.part(name), one)}
            used = follows(exercise, part, {**own, part.id: text})
            judged = _followed(judged, used, is_right=all(marks[name].verdict not in UNSOLVED for name in used))
        marks[part.id] = judged
    return SheetMark(
        exercise, tuple(PartMark(part, marks[part.id]) for part in exercise.parts if only in (None, part.id))
    )


def _differs(part: Part, judged: Mark) -> bool:
    """Whether later parts may follow from an answer otherwise than from the solution: wrong, or a table of its own."""
    own_table = isinstance(part.question, TableQuestion) and judged.verdict.passed is True and bool(judged.remarks)
    return judged.verdict in UNSOLVED or own_table


def _followed(judged: Mark, parts: tuple[str, ...], *, is_right: bool) -> Mark:
    """A wrong answer that is right from earlier ones: its credit is earned, the slip is where it was made."""
    if not parts:
        return judged
    whose = f"right from your {' and '.join(parts)}"
    remark = f"{whose}, which has other frames" if is_right else f"{whose}: the slip is there"
    remark += "; this part keeps its credit"
    return replace(judged, earned=1.0, remarks=(remark,), diagnosis=Diagnosis(follows=parts))
