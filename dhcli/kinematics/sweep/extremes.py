"""Extreme values in a stream of numbers, each with the first place at which it was reached."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

SLACK = 1e-9
"""Part of a value, and at least of a metre, within which two are one: rounding differs from machine to machine."""


class Highest:
    """The highest of the numbers seen so far, and where the first stands that is as high but for rounding.

    Only a number above all before it can be that first one, whatever comes later. So it is enough to keep, of these
    records, those within rounding of the last: when a higher one comes, the first still near it is the answer.
    """

    def __init__(self) -> None:
        """Nothing seen yet."""
        self._records: list[tuple[float, int]] = []

    @property
    def index(self) -> int:
        """Where it stands.

        Raises:
            IndexError: Nothing was seen.
        """
        return self._records[0][1]

    def take(self, values: NDArray[np.float64], first: int) -> None:
        """See more numbers.

        Args:
            values: The numbers, shape (N,), all finite.
            first: Where the first of them stands.
        """
        best = self._records[-1][0] if self._records else -np.inf
        top = float(values.max(initial=-np.inf))
        if top <= best:
            return
        level = top - SLACK * max(1.0, abs(top))
        near = np.flatnonzero(values >= level)
        heights = values[near]
        before = np.maximum.accumulate(np.concatenate(([best], heights[:-1])))
        is_record = heights > before
        self._records = [record for record in self._records if record[0] >= level]
        self._records += zip(heights[is_record].tolist(), (first + near[is_record]).tolist(), strict=True)
