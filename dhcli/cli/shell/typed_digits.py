"""By how much the digits of a pose that was typed leave it open, in whatever way it is given."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from dhcli.errors import DhcliError
from dhcli.regex import regex

_DECIMALS = regex(r"\.([0-9]+)")
"""The decimals of a number."""

_RADIANS = regex(r"\.[0-9]{3,}\s*rad\b")
"""An angle that is rounded, as hardly any has three decimals in radians and no more."""

_FEW, _ROUGH = 2e-4, 2e-3
"""A number leaves an entry open by so much at most where it is rounded: from four decimals on, or three, where the
pose or an angle tells that it is. 0.5 and 0.125 beside such numbers are exact.
"""

Rows = tuple[tuple[float, ...], ...]


def slack_of(texts: Mapping[str, str], rows: Rows, read: Callable[[Mapping[str, str]], Rows], *, rough: bool) -> float:
    """By how much half a unit of the last decimal of a number moves an entry of a pose at most [m, 1].

    Args:
        texts: What was typed, by its parts.
        rows: The pose, shape (4, 4) [m].
        read: The pose that parts say.
        rough: Whether the pose tells that its numbers are rounded, as one whose axes are not square to their digits.

    Returns:
        That; 0 where the numbers are meant as they stand.
    """
    rough = rough or any(map(_RADIANS.search, texts.values()))
    most, moved = _ROUGH if rough else _FEW, [0.0]
    for half, other in _half_a_unit_more(texts):
        try:
            change = _apart(read(other), rows)
        except DhcliError:  # an entry of a matrix may be no other, or it is no pose
            change = half
        moved += [change] if change <= most else []
    return max(moved)


def _half_a_unit_more(texts: Mapping[str, str]) -> Iterator[tuple[float, Mapping[str, str]]]:
    """Half a unit in the last decimal of each number that has some, and the texts with so much more."""
    for name, text in texts.items():
        for found in _DECIMALS.finditer(text):
            more = f"{text[: found.end()]}5{text[found.end() :]}"
            yield 0.5 * 10.0 ** -len(found[1]), {**texts, name: more}


def _apart(one: Rows, other: Rows) -> float:
    return max(abs(a - b) for row, beside in zip(one, other, strict=True) for a, b in zip(row, beside, strict=True))
