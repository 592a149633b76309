"""What can be said of an answer."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from dhcli.checking.diagnosis.result import Diagnosis


class Verdict(Enum):
    """A judgement, with the word and the sign that a person sees."""

    RIGHT = ("RIGHT", "✓")
    EQUIVALENT = ("EQUIVALENT", "≡")
    ROUNDED = ("ROUNDED", "≈")
    CLOSE = ("CLOSE", "~")
    WRONG = ("WRONG", "✗")
    CANNOT_READ = ("CAN'T READ", "?")
    SKIPPED = ("SKIPPED", "–")  # noqa: RUF001  the dash of a blank sheet

    @property
    def word(self) -> str:
        """The word for it."""
        return str(self.value[0])

    @property
    def sign(self) -> str:
        """The sign for it."""
        return str(self.value[1])

    @property
    def passed(self) -> bool | None:
        """Whether it counts as solved; None where nobody can say."""
        if self in (Verdict.RIGHT, Verdict.EQUIVALENT):
            return True
        return False if self in (Verdict.CLOSE, Verdict.WRONG) else None


@dataclass(frozen=True, slots=True)
class CellMark:
    """The judgement of one entry.

    Attributes:
        row: Row from 0.
        column: Column from 0.
        verdict: Right, rounded, close or wrong.
        typed: The entry as it was read.
        expected: The right entry; shown only where the exercise allows.
        note: A counterexample or a remark; may be empty.
        counted: Whether it earns credit; entries that are 0 or 1 for everybody do not.
    """

    row: int
    column: int
    verdict: Verdict
    typed: str
    expected: str
    note: str = ""
    counted: bool = True


@dataclass(frozen=True, slots=True)
class Mark:
    """The judgement of an answer.

    Attributes:
        verdict: The verdict.
        reading: The answer as it was read, for the echo.
        cells: The judgement of each entry, where there are entries.
        remarks: What a person should know, most important first.
        earned: Share of the credit, 0 to 1.
        expected: The right answer as text.
        diagnosis: Why it is wrong, where that was looked for and found.
    """

    verdict: Verdict
    reading: str = ""
    cells: tuple[CellMark, ...] = ()
    remarks: tuple[str, ...] = ()
    earned: float = 0.0
    expected: str = ""
    diagnosis: Diagnosis | None = None
