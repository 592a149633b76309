"""A sheet that was judged: the mark of each part, and what they come to together."""

from __future__ import annotations

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.verdicts import Mark, Verdict, worst
from dhcli.frozen import frozen


@frozen
class PartMark:
    """The judgement of one part."""

    part: Part
    mark: Mark


@frozen
class SheetMark:
    """The judgement of a sheet.

    Attributes:
        exercise: The exercise.
        parts: The parts that were looked at, in order.
        withdrawn: Parts that it answers and that are not asked any more; they neither earn nor cost anything.
        why: Whether a person has asked for the names of slips; else there are only hints.
        walked: Whether it is judged part by part while a person answers, who may type `why` and `hint`.
    """

    exercise: Exercise
    parts: tuple[PartMark, ...]
    why: bool = False
    walked: bool = False
    withdrawn: tuple[Part, ...] = ()

    @property
    def verdict(self) -> Verdict:
        """The verdict of the worst part."""
        return worst(part.mark.verdict for part in self.parts)

    @property
    def earned(self) -> float:
        """Credit earned."""
        return sum(part.mark.earned * part.part.credit for part in self.parts)

    @property
    def credit(self) -> float:
        """Credit there was to earn."""
        return sum(part.part.credit for part in self.parts)
