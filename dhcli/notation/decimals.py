"""Many numbers as decimal text, and read from it, to the last bit: by orjson where it is installed, else by Python.

What is written and what is read does not depend on that: only how long it takes. (Of a number of more than 700 digits
in the very middle of two floats orjson may read the one, Python the other.)
"""

from __future__ import annotations

from contextlib import suppress
from functools import cache
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from dhcli.regex import regex

if TYPE_CHECKING:
    from numpy.typing import NDArray

_LEAST, _MOST = 1e-4, 1e16
"""Between these Python writes no exponent."""

_WHOLE_ZERO = regex(r"-0[ ,]")
"""A zero with a sign and without a point: for JSON a whole number, which has none."""


def spelled(numbers: NDArray[np.float64]) -> list[object]:
    """Numbers of any shape as Python writes them, each as short as it can be without losing a bit.

    Returns:
        For each of them something that `str` makes its text of; zero has no sign.
    """
    flat = numbers.ravel() + 0.0
    orjson = quick_json()
    if orjson is None or not flat.size:
        plain: list[object] = flat.tolist()
        return plain
    texts: list[object] = orjson.dumps(flat, option=orjson.OPT_SERIALIZE_NUMPY)[1:-1].decode().split(",")
    size = np.abs(flat)
    # orjson writes 1e-7 and 0.00001 where Python writes 1e-07 and 1e-05, and null for what is not finite
    for k in np.flatnonzero(~((size >= _LEAST) & (size < _MOST)) & (size != 0)).tolist():
        texts[k] = repr(float(flat[k]))
    return texts


def read_decimals(text: str) -> NDArray[np.float64]:
    """The numbers in a text, with a comma after each of them.

    Args:
        text: Digits, points, signs, exponents, blanks and commas, nothing else.

    Raises:
        ValueError: Something between commas is no number.
    """
    with suppress(ValueError, OverflowError):  # `+1`, `.5` and `007` are numbers, and no JSON
        found = np.array(read_json(f"[{text[:-1]}]"), dtype=np.float64)
        if found.all() or not _WHOLE_ZERO.search(text):
            return found
    return np.array([*map(float, text[:-1].split(","))], dtype=np.float64)


def read_json(text: str) -> Any:  # noqa: ANN401  whatever stands there
    """What a JSON text holds; a number that is too large is infinite or none, NaN is none.

    Raises:
        ValueError: It is no JSON.
        RecursionError: It has brackets in brackets in brackets.
    """
    if (orjson := quick_json()) is not None:
        return orjson.loads(text)
    import json  # what holds no JSON needs none

    return json.loads(text, parse_constant=_refuse)


@cache
def quick_json() -> Any:  # noqa: ANN401  a module, or None
    """The module orjson, None where it is not installed."""
    try:
        import orjson
    except ImportError:
        return None
    return orjson


def _refuse(constant: str) -> NoReturn:
    raise ValueError(constant)
