"""What formulas of rotations need of numbers, so that each is written once: for one, and for many in a column."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol, TypeAlias, TypeVar, cast

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Mask: TypeAlias = bool | NDArray[np.bool_]
    """Whether something holds, for one number or for each of a column."""

R = TypeVar("R", float, "NDArray[np.float64]")
"""One number, or a column of many, shape (N,)."""


class Reals(Protocol[R]):
    """Functions of numbers."""

    def sin(self, angle: R, /) -> R:
        """Sine."""

    def cos(self, angle: R, /) -> R:
        """Cosine."""

    def atan2(self, y: R, x: R, /) -> R:
        """Angle of a vector in the plane."""

    def hypot(self, x: R, y: R, /) -> R:
        """Length of a vector in the plane."""

    def sqrt(self, square: R, /) -> R:
        """Square root."""

    def copysign(self, size: R, sign: R, /) -> R:
        """A number with the sign of another."""

    def where(self, mask: Mask, yes: R | float, no: R | float, /) -> R:
        """One of two numbers; both have been computed."""

    def largest(self, keys: Sequence[R], candidates: Sequence[tuple[R, ...]], /) -> tuple[R, ...]:
        """The candidate that stands where the largest key is."""


class One:
    """One number: Python floats, without importing numpy."""

    sin, cos = staticmethod(math.sin), staticmethod(math.cos)
    atan2, sqrt = staticmethod(math.atan2), staticmethod(math.sqrt)
    copysign = staticmethod(math.copysign)

    @staticmethod
    def hypot(x: float, y: float) -> float:
        """Length of a vector in the plane."""
        return math.hypot(x, y)

    @staticmethod
    def where(mask: Mask, yes: float, no: float) -> float:
        """One of two numbers."""
        return yes if mask else no

    @staticmethod
    def largest(keys: Sequence[float], candidates: Sequence[tuple[float, ...]]) -> tuple[float, ...]:
        """The candidate that stands where the largest key is."""
        return candidates[keys.index(max(keys))]


ONE = One()


def reals_of(number: R) -> Reals[R]:
    """The functions for a number, or for a column of them."""
    if isinstance(number, float | int):
        return cast("Reals[R]", ONE)
    from dhcli.geometry.columns import MANY

    return cast("Reals[R]", MANY)
