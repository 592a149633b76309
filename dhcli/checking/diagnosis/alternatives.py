"""Mistakes in a value, a cell of a table or the moves of a link: the part asked again with the mistake.

Whoever has made the mistake answers another question rightly; so the answer is judged as an answer to that one, with
the same care for spelling, units and digits.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator
from typing import ClassVar, Generic, TypeVar

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Question
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading
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


class AlternativesQuestion(Question[T]):
    """A question of which whoever has made a mistake answers another one rightly.

    Attributes:
        has_one_name: Whether in symbols mistakes that are the same have one name; in numbers they only happen to agree.
    """

    __slots__ = ()

    has_one_name: ClassVar[bool] = True

    @abstractmethod
    def alternatives(self, case: Case, name: str = "") -> Iterable[Alternative[T]]:
        """Every mistake with its question; those of one name, where only they are looked for."""

    def slips(self, case: Case) -> Iterable[Slip]:
        """Those that change the answer."""
        return (one.slip for one in self._changing(case))

    def answer_with(self, case: Case, name: str) -> str | None:
        """What is typed with a mistake."""
        changed = changing(case, self.alternatives(case, name))
        return next((one.answer for one in changed if one.slip.name == name), None)

    def causes(self, case: Case, reading: Reading[T]) -> Causes:
        """The mistakes that lead to an answer."""
        return tuple((one.slip,) for one in self._changing(case, reading))

    def _changing(self, case: Case, reading: Reading[T] | None = None) -> Iterator[Alternative[T]]:
        every = case.memo.of(("alternatives", self, case.tolerance), lambda: tuple(self.alternatives(case)))
        return changing(case, every, reading, distinct=self.has_one_name and not case.exercise.numeric)


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


def _read(case: Case, text: str) -> Reading[T] | None:
    try:
        return Reading(text, case.part.question.read(case, text))
    except (UnreadableError, NotationError):
        return None
