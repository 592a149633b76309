"""Brackets: what opens and closes them, how deep one is, where they close, and pieces of a text outside them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

OPENING = {"(": ")", "[": "]", "{": "}"}
"""Brackets and what closes them."""

STEPS = {**dict.fromkeys(OPENING, 1), **dict.fromkeys(OPENING.values(), -1)}
"""How much deeper one is behind a bracket."""


def depths(texts: Iterable[str]) -> Iterator[int]:
    """How many brackets are open around each letter of a text, or each token; a bracket stands outside itself."""
    depth = 0
    for text in texts:
        step = STEPS.get(text, 0)
        if step < 0 < depth:
            depth -= 1
        yield depth
        if step > 0:
            depth += 1


def closing(texts: Iterable[str]) -> int:
    """Where the bracket closes with which a text, or tokens, begin; -1 if it does not."""
    depth = 0
    for i, text in enumerate(texts):
        depth += STEPS.get(text, 0)
        if depth == 0:
            return i
    return -1


def split(text: str, signs: str = ",;") -> Iterator[tuple[int, str]]:
    """Pieces between signs, by default commas and semicolons, that stand outside brackets, with their offsets."""
    marks = [i for i, depth in enumerate(depths(text)) if not depth and text[i] in signs]
    for start, end in pairwise((-1, *marks, len(text))):
        yield start + 1, text[start + 1 : end]
