"""What a record of a mistake holds."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum
from typing import TypeAlias

from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Setting, Work

Made: TypeAlias = Iterator[tuple[str, Work]]
"""Where a mistake is made, such as `2` or `2 1`, and the work that holds it."""


class Level(IntEnum):
    """At what stage of the work a mistake is made."""

    TABLE = 1
    PRODUCT = 2
    MATRIX = 3


@dataclass(frozen=True, slots=True)
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
    made: Callable[[Work, Setting], Made]
    rank: Rank = Rank.PLACE
    of_values: bool = False
    alone: bool = False
