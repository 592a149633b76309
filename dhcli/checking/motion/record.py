"""What a record of a mistake in the columns of a Jacobian holds."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import TypeAlias

from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.motion.columns import Columns
from dhcli.frozen import frozen

Made: TypeAlias = Iterator[tuple[str, Columns]]
Maker: TypeAlias = Callable[[Columns], Made]


class Stage(IntEnum):
    """The stages of the work, of which a later one keeps what went wrong in an earlier one."""

    FRAMES = 0
    COLUMNS = 1
    SIGNS = 2
    WRITING = 3
    ORDER = 4


@frozen
class ColumnMistake:
    """A kind of mistake in columns.

    Attributes:
        id: The name under which exercises ask for it.
        words: What has happened, `{where}` for the joint or frame.
        hint: Where to look, without the answer.
        made: Every way to make it, each with its place.
        stage: When it is made: in choosing frames and points, in the columns, or in writing them down.
        rank: How soon it is named.
    """

    id: str
    words: str
    hint: str
    made: Maker
    stage: Stage
    rank: Rank = Rank.PLACE


class ColumnCatalogue:
    """Mistakes in the order in which they are tried and named; each is put in beside what makes it."""

    def __init__(self) -> None:
        """Begin without any."""
        self._mistakes: list[ColumnMistake] = []

    def __call__(
        self, name: str, words: str, hint: str, rank: Rank = Rank.WHOLE, *, stage: Stage = Stage.COLUMNS
    ) -> Callable[[Maker], Maker]:
        """Put in the mistake that a function makes."""

        def taken(made: Maker) -> Maker:
            self._mistakes.append(ColumnMistake(name, words, hint, made, stage, rank))
            return made

        return taken

    def __iter__(self) -> Iterator[ColumnMistake]:
        return iter(self._mistakes)
