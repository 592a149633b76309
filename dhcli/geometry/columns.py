"""Columns of numbers: what formulas of rotations need of them, by numpy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Column: TypeAlias = NDArray[np.float64]


class Many:
    """The functions of `reals.Reals` for columns of numbers."""

    sin, cos, sqrt = np.sin, np.cos, np.sqrt
    atan2, hypot, copysign = np.arctan2, np.hypot, np.copysign
    where = staticmethod(np.where)

    @staticmethod
    def largest(keys: Sequence[Column], candidates: Sequence[tuple[Column, ...]]) -> tuple[Column, ...]:
        """In each row the candidate that stands where the largest key is."""
        place = np.argmax(np.stack(keys), axis=0)
        return tuple(np.choose(place, parts) for parts in zip(*candidates, strict=True))


MANY = Many()
