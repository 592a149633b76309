"""The highest of many numbers that come part by part, and which of them it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

SLACK = 1e-9
"""Part of a value, and at least of a metre, within which two are one: rounding differs from machine to machine."""

Record: TypeAlias = tuple[float, int]
"""A number that is above all before it, and where it stands."""


class Highest:
    """The highest of the numbers taken so far, and where the first stands that is as high but for rounding.

    Only a number above all before it can be that first one, whatever comes later. So it is enough to keep, of these
    records, those within rounding of the last: when a higher one comes, the first still near it is the answer.
    """

    def __init__(self, sign: int) -> None:
        """Nothing taken yet; the sign is -1 for the lowest."""
        self._sign = sign
        self._records: list[Record] = []

    @property
    def index(self) -> int:
        """Where it stands.

        Raises:
            IndexError: Nothing was taken.
        """
        return self._records[0][1]

    def records(self, values: NDArray[np.float64], first: int) -> list[Record]:
        """Those of more numbers that may have to be taken; that takes nothing yet, so threads may ask at once.

        Args:
            values: The numbers, shape (N,), at least one, all finite; they come after all that were taken.
            first: Where the first of them stands.
        """
        best = self._best
        top = float(values.max()) if self._sign > 0 else -float(values.min())
        if top <= best:
            return []
        level = _level(top)
        near = np.flatnonzero(values >= level if self._sign > 0 else values <= -level)
        heights = values[near] * self._sign
        before = np.maximum.accumulate(np.concatenate(([best], heights[:-1])))
        is_record = heights > before
        return list(zip(heights[is_record].tolist(), (first + near[is_record]).tolist(), strict=True))

    def take(self, records: Sequence[Record]) -> None:
        """Take the records of the numbers that follow."""
        best = self._best
        higher = [record for record in records if record[0] > best]
        if higher:
            level = _level(higher[-1][0])
            self._records = [record for record in (*self._records, *higher) if record[0] >= level]

    @property
    def _best(self) -> float:
        return self._records[-1][0] if self._records else -np.inf


def _level(top: float) -> float:
    """What is as high but for rounding."""
    return top - SLACK * max(1.0, abs(top))
