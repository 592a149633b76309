"""Rows as they come out of a file, joint values or poses, block by block, with where each of them stands."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np

from dhcli.errors import Place, Problem
from dhcli.files.rows.cells import CellError
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from numpy.typing import NDArray

MOST = 20
"""Bad cells that are told apart; of more, only the number of their rows is known."""


@frozen
class Block:
    """Some rows.

    Attributes:
        values: The good rows: joint values, shape (N, n), poses (N, 4, 4) or positions (N, 3); radians and metres.
        rows: For each of them where it stands: the number of its line from 1, of its row in an array from 0.
        in_radians: For each joint, whether its numbers were taken for radians or metres as they stood.
        bad: What is wrong with the others, up to the first `MOST` cells.
        bad_rows: How many others there are.
    """

    values: NDArray[np.float64]
    rows: Sequence[int]
    in_radians: tuple[bool, ...] = ()
    bad: tuple[Problem, ...] = ()
    bad_rows: int = 0


class Columns(Protocol):
    """What the columns of a table hold."""

    @property
    def width(self) -> int:
        """How many columns there are, also of what nobody asks for."""

    @property
    def names(self) -> Mapping[int, str]:
        """What each column holds that is asked for."""

    @property
    def in_radians(self) -> tuple[bool, ...]:
        """For each joint, whether its numbers are taken as they are."""

    def values(self, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """What the rows are read for.

        Args:
            table: Numbers as they stand in the columns, shape (N, width).
        """

    def void(self, table: NDArray[np.float64]) -> tuple[Sequence[int], str]:
        """Which rows of a table of finite numbers are none all the same, and why."""


class Table(Protocol):
    """What a table is read for."""

    @property
    def wanted(self) -> Sequence[str]:
        """What there should be a column for."""

    def is_known(self, head: str) -> bool:
        """Whether the head of a column names what is asked for; with or without a unit."""

    def in_order(self, width: int, whole: Place, /) -> Columns:
        """The columns of a table without a header.

        Args:
            width: How many cells its first row has.
            whole: Where that stands.
        """

    def columns(self, heads: Sequence[str], places: Sequence[Place], whole: Place) -> Columns:
        """The columns of a table with a header.

        Args:
            heads: The head of each column.
            places: Where each of them stands.
            whole: Where all of them stand.
        """


class Sieve:
    """Parts good rows from bad ones, one by one.

    Attributes:
        values: The numbers of the good rows.
        rows: Where they stand.
        bad: What is wrong with the others, up to the first `MOST`.
        bad_rows: How many others there are.
    """

    def __init__(self) -> None:
        """No row has come yet."""
        self.values: list[Sequence[float]] = []
        self.rows: list[int] = []
        self.bad: list[Problem] = []
        self.bad_rows = 0

    def good(self, row: int, values: Sequence[float]) -> None:
        """Take a row that is as it should be."""
        self.values.append(values)
        self.rows.append(row)

    def refuse(self, problems: Sequence[Problem]) -> None:
        """Leave a row out."""
        self.bad_rows += 1
        self.bad += problems[: MOST - len(self.bad)]

    def block(self, columns: Columns, place_of: Callable[[int], Place]) -> Block:
        """The rows so far."""
        table = np.array(self.values, dtype=np.float64).reshape(-1, columns.width)
        return sifted(table, self.rows, columns, place_of, self)


def sifted(
    table: NDArray[np.float64],
    rows: Sequence[int],
    columns: Columns,
    place_of: Callable[[int], Place],
    sieve: Sieve | None = None,
) -> Block:
    """A block of a table of finite numbers, shape (N, width), without those of its rows that say nothing."""
    sieve = sieve or Sieve()
    void, message = columns.void(table)
    for k in void:
        sieve.refuse([Problem(message, place_of(rows[k]))])
    if len(void):
        table = np.delete(table, void, axis=0)
        rows = np.delete(rows, void).tolist()
    return Block(columns.values(table), rows, columns.in_radians, tuple(sieve.bad), sieve.bad_rows)


def cell_problem(name: str, error: CellError, place: Place) -> Problem:
    """What is wrong with the cell of a joint, or of something else by its name."""
    return Problem(f"{name} {error.message}", place, error.hint)
