"""Mistakes in a value, a cell of a table or the moves of a link: the part asked again with the mistake.

Whoever has made the mistake answers another question rightly; so the answer is judged as an answer to that one, with
the same care for spelling, units and digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Generic, TypeVar

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Reading
from dhcli.errors import NotationError
from dhcli.frozen import frozen

T = TypeVar("T")


@frozen
class Alternative(Generic[T]):
    """A mistake, and the question that it answers rightly.

    Attributes:
        slip: The mistake.
        answer: What a student with this mistake types.
        accepts: Whether what was read in an answer is right as an answer to the other question, be it rounded.
    """

    slip: Slip
    answer: str
    accepts: Callable[[T], bool]

    def fits(self, reading: Reading[T] | None) -> bool:
        """Whether an answer is right there."""
        try:
            return reading is not None and self.accepts(reading.value)
        except (UnreadableError, NotationError):  # right in another unit
            return False


def changing(
    case: Case, found: Iterable[Alternative[T]], reading: Reading[T] | None = None, *, distinct: bool = False
) -> Iterator[Alternative[T]]:
    """The mistakes that change the answer to a part.

    Args:
        case: The part.
        found: Mistakes in it.
        reading: Only those that lead to this answer; all by default.
        distinct: Whether of mistakes that are the same only the first counts.
    """
    right: Reading[T] | None = _read(case, case.part.question.expected(case))
    known: list[Alternative[T]] = []
    for one in found:
        if (reading is not None and not one.fits(reading)) or one.fits(right):
            continue
        if distinct:
            typed: Reading[T] | None = _read(case, one.answer)
            if any(other.fits(typed) for other in known):
                continue
            known.append(one)
        yield one


def answer_of(found: Iterable[Alternative[T]], name: str) -> str | None:
    """The answer of a mistake, by its name; None if it is not among them."""
    return next((one.answer for one in found if one.slip.name == name), None)


def _read(case: Case, text: str) -> Reading[T] | None:
    try:
        return Reading(text, case.part.question.read(case, text))
    except (UnreadableError, NotationError):
        return None
