"""Rows of joint values as they come out of a file, block by block, with where each of them stands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

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
        q: Joint values of the good rows, shape (N, n); radians and metres.
        rows: For each of them where it stands: the number of its line from 1, of its row in an array from 0.
        bad: What is wrong with the others, up to the first `MOST` cells.
        bad_rows: How many others there are.
        in_radians: For each joint, whether its numbers were taken for radians or metres as they stood.
    """

    q: NDArray[np.float64]
    rows: Sequence[int]
    in_radians: tuple[bool, ...]
    bad: tuple[Problem, ...] = ()
    bad_rows: int = 0


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

    def table(self, width: int) -> NDArray[np.float64]:
        """The good rows, shape (N, width)."""
        return np.array(self.values, dtype=np.float64).reshape(-1, width)


def cell_problem(joint: str, error: CellError, place: Place) -> Problem:
    """What is wrong with the cell of a joint."""
    return Problem(f"{joint} {error.message}", place, error.hint)
