"""What a record of a mistake holds."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import TypeAlias

from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Setting, Work
from dhcli.frozen import frozen

Made: TypeAlias = Iterator[tuple[str, Work]]
"""Where a mistake is made, such as `2` or `2 1`, and the work that holds it."""


Maker: TypeAlias = Callable[[Work, Setting], Made]


class Level(IntEnum):
    """At what stage of the work a mistake is made."""

    TABLE = 1
    PRODUCT = 2
    MATRIX = 3


@frozen
class Mistake:
    """A kind of mistake.

    Attributes:
        id: The name under which exercises ask for it.
        level: At what stage it is made.
        words: What has happened, `{where}` for the place, such as `1,4 a2*c2`; also `{row}`, `{entry}` and `{term}`,
            its first number, its first word and the rest.
        hint: Where to look, without the answer.
        made: Every way to make it in a work.
        rank: How soon it is named.
        of_values: Whether the values given go into how it is made, not only into what comes of it.
        alone: Whether it is made in otherwise right work only, never in a pair.
    """

    id: str
    level: Level
    words: str
    hint: str
    made: Maker
    rank: Rank = Rank.PLACE
    of_values: bool = False
    alone: bool = False


class Catalogue:
    """Mistakes of one level, in the order in which they are tried and named; each is put in beside what makes it."""

    def __init__(self, level: Level) -> None:
        """Begin without any."""
        self._level = level
        self._mistakes: list[Mistake] = []

    def __call__(
        self,
        name: str,
        words: str,
        hint: str,
        *,
        rank: Rank = Rank.PLACE,
        of_values: bool = False,
        alone: bool = False,
    ) -> Callable[[Maker], Maker]:
        """Put in the mistake that a function makes."""

        def taken(made: Maker) -> Maker:
            self._mistakes.append(Mistake(name, self._level, words, hint, made, rank, of_values, alone))
            return made

        return taken

    def __iter__(self) -> Iterator[Mistake]:
        return iter(self._mistakes)
