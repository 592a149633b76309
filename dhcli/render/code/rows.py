"""Rows of numbers as text for programs: what the columns are called, and how JSON Lines nests them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from dhcli.frozen import frozen
from dhcli.render.code.matrices import csv_line

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FORMATS = ("csv", "jsonl", "npy")
"""The formats of rows; the last one is no text."""


@frozen
class Group:
    """Numbers of a row that belong together, such as a position.

    Attributes:
        key: What JSON Lines calls them.
        heads: What CSV calls each of them.
        body: How JSON Lines writes them, with `%s` in the place of each number.
        is_whole: Whether they are written without a point, such as the number of a line.
    """

    key: str
    heads: tuple[str, ...]
    body: str
    is_whole: bool = False

    @classmethod
    def listed(cls, key: str, heads: Iterable[str]) -> Group:
        """Numbers in a list: `[0.1, 0.2, 0.3]`."""
        heads = tuple(heads)
        return cls(key, heads, f"[{', '.join(['%s'] * len(heads))}]")

    @classmethod
    def named(cls, key: str, heads: Mapping[str, str]) -> Group:
        """Numbers by name: `{"roll": 0.1, "pitch": 0.2}`; the heads of CSV by those names."""
        return cls(key, tuple(heads.values()), _object([Group(name, (), "%s") for name in heads]))

    @classmethod
    def within(cls, key: str, groups: Iterable[Group]) -> Group:
        """Groups under one key; the heads get it as a prefix: `T_01_p_x`."""
        groups = tuple(groups)
        return cls(key, tuple(f"{key}_{head}" for group in groups for head in group.heads), _object(groups))


@frozen
class Layout:
    """What stands in each row.

    Attributes:
        groups: The numbers in the order of the columns.
        shape: Shape of one row in .npy; one number after the other by default.
    """

    groups: tuple[Group, ...]
    shape: tuple[int, ...] = ()

    @property
    def heads(self) -> tuple[str, ...]:
        """The names of the columns."""
        return tuple(head for group in self.groups for head in group.heads)

    @property
    def width(self) -> int:
        """How many columns there are in text."""
        return len(self.heads)


class RowText:
    """Writes blocks of rows as text, every number as short as it can be without losing a bit.

    Attributes:
        heading: What stands above the rows.
    """

    def __init__(self, layout: Layout, format_: str) -> None:
        """Write in one of the formats `csv` and `jsonl`."""
        self.heading = csv_line(layout.heads) if format_ == "csv" else ""
        whole = [group.is_whole for group in layout.groups for _ in group.heads]
        self._whole = [k for k, is_whole in enumerate(whole) if is_whole]
        self._row = (",".join(["%s"] * layout.width) if format_ == "csv" else _object(layout.groups)) + "\n"

    def lines(self, block: NDArray[np.float64]) -> str:
        """A line for each row.

        Args:
            block: Finite numbers, shape (N, width).
        """
        from dhcli.notation.decimals import spelled  # numpy

        numbers = spelled(block)
        for k in self._whole:
            numbers[k :: block.shape[1]] = map(int, block[:, k])
        return (self._row * len(block)) % tuple(numbers)  # one template for all rows: twice as fast as row by row


def _object(groups: Iterable[Group]) -> str:
    """A JSON object as a template; a key may hold any letter, also the sign of a template."""
    import json  # rows of CSV need none

    members = (f"{json.dumps(group.key).replace('%', '%%')}: {group.body}" for group in groups)
    return "{" + ", ".join(members) + "}"
