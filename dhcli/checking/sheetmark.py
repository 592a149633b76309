"""A whole sheet judged: every part, the credit earned, and the verdict on all of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.marking import mark
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import Place, UnknownNameError, did_you_mean

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
    """

    exercise: Exercise
    parts: tuple[PartMark, ...]

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
    return SheetMark(
        exercise,
        tuple(
            PartMark(part, mark(exercise, part, answers.get(part.id, ""), places.get(part.id)))
            for part in exercise.parts
            if only in (None, part.id)
        ),
    )
