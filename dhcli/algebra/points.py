"""Sample points: values of names, drawn by a seed, the same for everybody and on every machine; drawn here alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

GENERAL = (0.2, 1.3)
"""Angles [rad] and lengths [m] at which nothing happens to vanish or to agree."""


def general(names: Iterable[str], seed: int) -> Iterator[dict[str, float]]:
    """Points at which nothing is special, one after the other.

    Args:
        names: The names that need a value; their order does not matter.
        seed: The same seed gives the same points.
    """
    return draws(dict.fromkeys(sorted(names), GENERAL), seed)


def draws(ranges: Mapping[str, tuple[float, float]], seed: int) -> Iterator[dict[str, float]]:
    """Points within ranges, one after the other.

    Args:
        ranges: The lowest and the highest value of each name, in the order in which they are drawn.
        seed: The same seed gives the same points.
    """
    from random import Random  # slow to import, and most verdicts need no point

    draw = Random(seed)  # noqa: S311  the same points every time
    while True:
        yield {name: draw.uniform(low, high) for name, (low, high) in ranges.items()}
