"""What can be said of an answer."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from enum import Enum

from dhcli.checking.diagnosis.result import Diagnosis
from dhcli.errors import plural
from dhcli.frozen import frozen


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


WORST_FIRST = (
    Verdict.CANNOT_READ,
    Verdict.WRONG,
    Verdict.CLOSE,
    Verdict.ROUNDED,
    Verdict.SKIPPED,
    Verdict.EQUIVALENT,
    Verdict.RIGHT,
)
COUNTED = " comes out when "
"""What a remark says between a number and the slip that gives it."""

HALF_TURN_OFF = "elsewhere it is half a turn off, as atan loses the quadrants on the left"
"""What is said of a formula with atan for atan2; it names the slip, wherever in the formula that stands."""

TO_DIGITS = "right to the digits typed; more digits are wanted"
APPROXIMATE = "right approximately: decimals stand where an exact value is"
"""Of a number that is rounded, and of a formula with one."""

TOO_FEW = "right to the digits typed, which are too few to judge"
"""How the remark begins that is made of 0.4 for 0.449."""

INVERSE = "this is the inverse: it shows the reference from the frame"
TRANSPOSED = "the rotation is transposed: its columns, not its rows, are the axes of the frame described"
"""What is seen without a search; where the slip is found it has its name there."""

IN_OTHER_UNIT = "the lengths are in "
"""How the remark begins that the rest of an answer is judged in another unit than that of the sheet."""

UNSOLVED = (Verdict.WRONG, Verdict.CLOSE)

AGREEING = (Verdict.RIGHT, Verdict.ROUNDED)
"""A number that is right to the digits typed."""


def too_few(decimals: int | None) -> str:
    """What is said of an answer that is too short, where so many decimals are asked for, if any are."""
    return f"{TOO_FEW}: write {'three digits or more' if decimals is None else plural(decimals, 'decimal')}"


def worst(verdicts: Iterable[Verdict]) -> Verdict:
    """An answer is as good as its worst entry, a sheet as its worst part; nothing at all is skipped."""
    return min(verdicts, key=WORST_FIRST.index, default=Verdict.SKIPPED)


@frozen
class CellMark:
    """The judgement of one entry.

    Attributes:
        row: Row from 0.
        column: Column from 0.
        verdict: Right, rounded, close or wrong.
        typed: The entry as it was read.
        expected: The right entry; shown only where the exercise allows.
        note: A counterexample or a remark; may be empty.
        counted: Whether it earns credit; entries that are 0, or 1 for everybody, only cost something.
    """

    row: int
    column: int
    verdict: Verdict
    typed: str
    expected: str
    note: str = ""
    counted: bool = True


@frozen
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
        other_unit: The unit in which all of it is right, where nothing else is wrong with it.
        found: Of the moves of a link, the share that is right whatever their order; 0 for everything else.
    """

    verdict: Verdict
    reading: str = ""
    cells: tuple[CellMark, ...] = ()
    remarks: tuple[str, ...] = ()
    earned: float = 0.0
    expected: str = ""
    diagnosis: Diagnosis | None = None
    other_unit: str = ""
    found: float = 0.0

    @property
    def is_too_short(self) -> bool:
        """Whether it agrees with what is right as far as it was typed, and is no proof that somebody worked it out."""
        return self.has_few_digits and not self.is_in_other_unit

    @property
    def has_few_digits(self) -> bool:
        """The same of what is judged in another unit than that of the sheet, too."""
        return any(remark.startswith(TOO_FEW) for remark in self.remarks)

    @property
    def is_in_other_unit(self) -> bool:
        """Whether its entries are judged in another unit than that of the sheet."""
        return bool(self.remarks) and self.remarks[0].startswith(IN_OTHER_UNIT)

    def with_digits_told(self) -> Mark:
        """One that is too short as what it is, ROUNDED, entry by entry; it has earned no more by that."""
        if not self.is_too_short:
            return self
        rounded = Verdict.ROUNDED
        cells = tuple(c if c.verdict is Verdict.RIGHT else replace(c, verdict=rounded, note="") for c in self.cells)
        return replace(self, verdict=rounded, cells=cells)
