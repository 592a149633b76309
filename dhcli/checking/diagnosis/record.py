"""The record of a mistake, whatever it is made in: the work for a matrix, a Jacobian's columns, a value, a frame."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Generic, TypeVar

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.frozen import frozen

M = TypeVar("M")
"""What makes a mistake in every way there is: where, such as `2` or `2 1`, and what holds it then."""


@frozen
class Mistake(Generic[M]):
    """A kind of mistake.

    Attributes:
        id: The name under which exercises ask for it.
        words: What has happened, `{where}` for the place, such as `1,4 a2*c2`; also `{row}`, `{entry}` and `{term}`,
            its first number, its first word and the rest.
        hint: Where to look, without the answer.
        made: What makes it.
        level: At what stage of the work it is made, of which a later one keeps what went wrong in an earlier one.
        rank: How soon it is named.
        of_values: Whether the values given go into how it is made, not only into what comes of it.
        alone: Whether it is made in otherwise right work only, never in a pair.
    """

    id: str
    words: str
    hint: str
    made: M
    level: int = 0
    rank: Rank = Rank.PLACE
    of_values: bool = False
    alone: bool = False

    def slip(self, where: str, **others: int) -> Slip:
        """The mistake in its place; the others are what its words say besides."""
        return _slip(self.id, self.words, self.hint, self.rank, where, **others)


@lru_cache(4096)
def _slip(name: str, words: str, hint: str, rank: Rank, where: str, **others: int) -> Slip:
    """Made once: of two mistakes at once, each is made with each."""
    entry, _, term = where.partition(" ")
    place = {"where": where, "row": entry.split(",")[0].split(".")[0], "entry": entry, "term": term, **others}
    return Slip(f"{name} {where}".strip(), words.format(**place), hint.format(**place), rank)


class Catalogue(list[Mistake[M]]):
    """Mistakes in the order in which they are tried and named; each is put in beside what makes it."""

    def __init__(self, level: int = 0, rank: Rank = Rank.PLACE) -> None:
        """Begin without any.

        Args:
            level: The level of those that do not say another.
            rank: Their rank.
        """
        super().__init__()
        self._level = level
        self._rank = rank

    def __call__(  # noqa: PLR0913  what a record holds
        self,
        name: str,
        words: str,
        hint: str,
        *,
        level: int | None = None,
        rank: Rank | None = None,
        of_values: bool = False,
        alone: bool = False,
    ) -> Callable[[M], M]:
        """Put in the mistake that a function makes."""
        level = self._level if level is None else level
        rank = self._rank if rank is None else rank

        def taken(made: M) -> M:
            self.append(Mistake(name, words, hint, made, level, rank, of_values, alone))
            return made

        return taken
