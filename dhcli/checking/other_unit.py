"""Answers in another unit than that of the sheet: right throughout, or where they have lengths."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from dhcli.checking.entries import Entries
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.verdicts import AGREEING, IN_OTHER_UNIT, CellMark, Mark, Verdict
from dhcli.frozen import frozen

RADIANS = "radians"

_CLEAR = 10
"""Tolerances above which a length is right in another unit by no chance: near zero many are."""


class WrongUnitError(UnreadableError):
    """An answer that is right throughout in another unit."""

    def __init__(self, unit: str, own: str, how: str = "", *, wanted: str = "") -> None:
        """Say which unit it is in, behind it its power and how right it is there if not quite, and what is wanted."""
        in_degrees = "bare angles are in degrees: write rad behind them"
        wanted = wanted or (in_degrees if unit == RADIANS else f"this sheet is in {own}")
        super().__init__(f"right in {unit}{how}; {wanted}")
        self.unit = unit


@frozen
class InUnit:
    """An answer read in another unit than that of the sheet.

    Attributes:
        unit: The unit.
        entries: The answer in metres, its bare lengths in that unit.
        mark: The judgement of it.
    """

    unit: str
    entries: Entries
    mark: Mark


def is_clear(length: float, limit: float) -> bool:
    """Whether a length, which may be off by a limit, is right in another unit by no chance."""
    return abs(length) > _CLEAR * limit


def refuse_right_in(units: Iterable[str], own: str, is_right: Callable[[str], bool]) -> None:
    """Refuse an answer that is right in one of the units that may have been meant, instead of that of the sheet.

    Raises:
        WrongUnitError: It is.
    """
    for unit in filter(is_right, units):
        raise WrongUnitError(unit, own)


def plainly_in(
    others: Iterable[InUnit], cells: Sequence[CellMark], lengths: Sequence[tuple[float, float]]
) -> InUnit | None:
    """The first unit in which the lengths of a wrong answer plainly are.

    That is where a length that is not near zero is right there and not here, and none is right here alone.

    Args:
        others: The answer in each of the units that may have been meant.
        cells: The judgement of its entries in the unit of the sheet.
        lengths: For each the right value and what it may be off; twice 0 where that decides nothing.
    """

    def is_plain(other: InUnit) -> bool:
        found = False
        for here, there, (right, limit) in zip(cells, other.mark.cells, lengths, strict=True):
            is_here, is_there = here.verdict in AGREEING, there.verdict in AGREEING
            if is_here and not is_there and abs(right) > limit:
                return False
            found = found or (is_there and not is_here and is_clear(right, limit))
        return found

    return next(filter(is_plain, others), None)


def judged_in(other: InUnit, mark: Mark, own: str, power: str = "") -> Mark:
    """The judgement of a wrong answer whose lengths are plainly in another unit: what else is wrong is said in that.

    Args:
        other: The answer in that unit.
        mark: The judgement of it in the unit of the sheet.
        own: The unit of the sheet.
        power: The power of the unit in the answer: `²`.

    Raises:
        WrongUnitError: Nothing else is wrong.
    """
    there = other.mark
    if there.verdict in AGREEING:
        digits = ", to the digits typed" if there.verdict is Verdict.ROUNDED else ""
        raise WrongUnitError(other.unit, own, f"{power}{digits}")
    cells = tuple(replace(cell, expected=one.expected) for cell, one in zip(there.cells, mark.cells, strict=True))
    remark = f"{IN_OTHER_UNIT}{other.unit}; this sheet is in {own}: the rest is judged in {other.unit}"
    return replace(mark, verdict=Verdict.WRONG, cells=cells, remarks=(remark, *there.remarks))
