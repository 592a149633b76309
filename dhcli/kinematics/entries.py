"""Numbers as people are shown them."""

from __future__ import annotations

DIGITS = 4
"""Decimals that a person is shown unless they ask for more."""


def rounded(value: float, digits: int = DIGITS) -> str:
    """A number for people: rounded, no trailing zeros, no minus zero."""
    if value != value or value in (float("inf"), float("-inf")):  # noqa: PLR0124  NaN
        return str(value)
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def small_length(value: float) -> str:
    """A length [m] in the unit in which it is told best: `11 µm`, `160 µm`, `1.2 mm`, `0.3 m`."""
    for unit, size in (("µm", 1e-6), ("mm", 1e-3)):
        if value < 1000 * size:
            return f"{value / size:.3g} {unit}"
    return f"{value:.3g} m"
