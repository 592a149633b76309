"""Brackets: what opens and closes them, how deep one is behind each, and pieces of a text outside them."""

from __future__ import annotations

from collections.abc import Iterator

OPENING = {"(": ")", "[": "]", "{": "}"}
"""Brackets and what closes them."""

STEPS = {**dict.fromkeys(OPENING, 1), **dict.fromkeys(OPENING.values(), -1)}
"""How much deeper one is behind a bracket."""


def split(text: str) -> Iterator[tuple[int, str]]:
    """Pieces between commas and semicolons that stand outside brackets, with their offsets."""
    start, depth = 0, 0
    for i, letter in enumerate(text):
        depth += STEPS.get(letter, 0)
        if depth == 0 and letter in ",;":
            yield start, text[start:i]
            start = i + 1
    yield start, text[start:]
