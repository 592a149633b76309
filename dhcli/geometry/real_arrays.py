"""Arrays that a program gives: real numbers all of them, or it is told what they are instead."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.arrays import library_of
from dhcli.errors import RobotError

if TYPE_CHECKING:
    from numpy.typing import NDArray


def real_numbers(given: object, otherwise: RobotError) -> NDArray[np.float64]:
    """What is given as an array of float64; the same one where it is such already.

    Args:
        given: An array, or what numpy makes one of.
        otherwise: What is raised of something that holds no numbers.

    Raises:
        RobotError: It holds no numbers, or complex ones, numpy's mask hides some of them, or an array of another
            library keeps them to itself.
    """
    try:
        array = np.asanyarray(given)
        if array.dtype.kind == "c":
            raise RobotError("complex numbers are given, not real ones", "array.real, if that is what is meant")
        if array.dtype.kind in "mM":  # times, which numpy would count
            raise otherwise
        if type(array) is not np.ndarray and np.ma.is_masked(array):
            raise RobotError("a mask hides some of the numbers", "array.filled(numpy.nan), or only rows without")
        return np.asarray(array, dtype=np.float64)
    except (TypeError, ValueError, OverflowError, RuntimeError) as error:
        if library := library_of(given):  # which is asked for a derivative, or traced, or has its numbers elsewhere
            message = f"an array of {library} does not give its numbers: {error!s:.90}"
            raise RobotError(
                message, "an array of numpy is wanted: of a tensor, tensor.detach().cpu().numpy()"
            ) from None
        raise otherwise from None
