"""Sample points: values of names, drawn by a seed, the same for everybody and on every machine; drawn here alone."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import islice
from typing import TypeAlias

from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import symbols_in, walk

Reach: TypeAlias = Mapping[str, tuple[float, float]]
"""The lowest and the highest value of some names, in radians and metres."""

GENERAL = (0.2, 1.3)
"""Angles [rad] and lengths [m] at which nothing happens to vanish or to agree; lengths are positive."""

CIRCLE = (-math.pi, math.pi)
"""Angles all round the circle, where sines and cosines have both signs."""

EITHER_SIDE = (-1.3, 1.3)
"""Coordinates and displacements, which have both signs."""

WHOLE = (3.0, 12.0)
"""What counts links, joints or freedoms of a small mechanism: whole numbers."""

COUNT = 40
"""Points at which expressions are compared that no residue can hold."""

SEED = 20


def general(names: Iterable[str], seed: int) -> Iterator[dict[str, float]]:
    """Points at which nothing is special, one after the other.

    Args:
        names: The names that need a value; their order does not matter.
        seed: The same seed gives the same points.
    """
    return draws(dict.fromkeys(sorted(names), GENERAL), seed)


def all_round(expressions: Iterable[Expr], reach: Reach | None) -> Iterator[dict[str, float]]:
    """Forty points for some expressions, angles all round the circle.

    Args:
        expressions: Trees whose names need a value.
        reach: What is known of a name; others are angles where they stand in a cosine, else positive lengths.
    """
    trees = tuple(expressions)
    names = symbols_in(trees)
    angles = {name for tree in trees for node in walk(tree) if type(node) is Trig for name in node.angle.names}
    known = reach or {}
    ranges = {name: known.get(name, CIRCLE if name in angles else GENERAL) for name in sorted(names)}
    return islice(draws(ranges, SEED), COUNT)


def draws(ranges: Reach, seed: int) -> Iterator[dict[str, float]]:
    """Points within ranges, one after the other.

    Args:
        ranges: The lowest and the highest value of each name, in the order in which they are drawn.
        seed: The same seed gives the same points.
    """
    from random import Random  # slow to import, and most verdicts need no point

    draw = Random(seed)  # noqa: S311  the same points every time
    while True:
        yield {name: draw.uniform(low, high) for name, (low, high) in ranges.items()}
