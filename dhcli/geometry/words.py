"""An orientation in plain words, where it is plain; a file of its own because every numeric pose is shown with it."""

from __future__ import annotations

from collections.abc import Sequence

TINY = 1e-12
"""How far direction cosines may be from 0 for an axis to lie along another; some roundings of a product.

They are looked at, and not the one that is 1: a tilt of 1e-5 rad takes only 5e-11 from that.
"""


def in_words(rotation: Sequence[Sequence[float]]) -> tuple[str, ...]:
    """Axes that point along an axis of the reference: `x' points along +y`; empty where none does.

    Args:
        rotation: Direction cosines, shape (3, 3).
    """
    said = []
    for k, name in enumerate("xyz"):
        column = [row[k] for row in rotation]
        for i, (value, along) in enumerate(zip(column, "xyz", strict=True)):
            if all(abs(other) < TINY for j, other in enumerate(column) if j != i):
                said.append(f"{name}' points along {'+' if value > 0 else '-'}{along}")
    return tuple(said)
