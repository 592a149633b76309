"""What a student got for a sheet."""

from __future__ import annotations

from dataclasses import replace

from dhcli.checking.verdicts import Verdict
from dhcli.errors import Place, Problem
from dhcli.frozen import frozen


@frozen
class PartGrade:
    """What a student got for one part.

    Attributes:
        part: Its id.
        verdict: The verdict.
        earned: Credit earned.
        credit: Credit there was to earn.
        reading: The answer as it was read.
        remarks: What the student should know, and where to look.
        slips: Names of the mistakes that explain the answer, each by itself, the likeliest first.
        other_unit: The unit in which all of the answer is right, where nothing else is wrong with it.
    """

    part: str
    verdict: Verdict
    earned: float
    credit: float
    reading: str = ""
    remarks: tuple[str, ...] = ()
    slips: tuple[str, ...] = ()
    other_unit: str = ""


@frozen
class Graded:
    """A sheet with its grades, or with what kept it from being graded.

    Attributes:
        sheet: Its path below the folder of the class.
        student: Whose it is.
        exercise: Id of the exercise; as the sheet says if it was not graded.
        variant: What the numbers were drawn with.
        parts: The grades of the parts; none if it was not graded.
        problems: Why it was not graded.
    """

    sheet: str
    student: str
    exercise: str = ""
    variant: str = ""
    parts: tuple[PartGrade, ...] = ()
    problems: tuple[Problem, ...] = ()

    @property
    def earned(self) -> float:
        """Credit earned."""
        return sum(part.earned for part in self.parts)

    @property
    def credit(self) -> float:
        """Credit there was to earn."""
        return sum(part.credit for part in self.parts)

    @property
    def other_unit(self) -> str:
        """The unit that some or all of its answers are in, where nothing else is wrong with any of them; else empty."""
        units = {part.other_unit for part in self.parts if part.other_unit}
        fine = {Verdict.RIGHT, Verdict.EQUIVALENT, Verdict.ROUNDED, Verdict.SKIPPED}
        return units.pop() if len(units) == 1 and all(p.other_unit or p.verdict in fine for p in self.parts) else ""


def failed(row: Graded, *problems: Problem) -> Graded:
    """The row of a sheet that was not graded; places without their line of text, which may be long."""
    placed = (
        replace(problem, place=problem.place and Place(row.sheet, problem.place.line, problem.place.column))
        for problem in problems
    )
    return replace(row, problems=tuple(placed))
