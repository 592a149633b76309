"""Random directions and places, the same for the same seed."""

from __future__ import annotations

import math
from random import Random
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhcli.geometry.twists import Array


class Draws:
    """A source of them; numpy's own takes as long to import as a small linkage to judge."""

    def __init__(self, seed: int) -> None:
        """Begin anew, with the numbers that belong to a seed."""
        self._draw = Random(seed)  # noqa: S311  no secret

    def normal(self, *shape: int) -> Array:
        """Normally distributed numbers with mean 0 and deviation 1, in an array of a shape."""
        return np.array([self._draw.gauss() for _ in range(math.prod(shape))]).reshape(shape)

    def shuffled(self, rows: Array) -> Array:
        """The rows of an array in another order."""
        return np.asarray(rows)[self._draw.sample(range(len(rows)), len(rows))]
