"""How names are set in a figure: a letter with its index below the line."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeAlias

from dhcli.notation.names import GREEK, parts
from dhcli.regex import regex

_LETTERS = {name: letter for letter, name in reversed(GREEK.items())}
_NAME = regex(r"[A-Za-z]+\d*(?:_(?:\{[^}]*\}|\w+))?")
_OTHER_WORDS = frozenset({"sqrt", "pi", "cos", "sin", "tan", "atan", "atan2", "acos", "asin"})


class Run(NamedTuple):
    """A piece of a label.

    Attributes:
        text: Its letters.
        below: Whether it is an index.
    """

    text: str
    below: bool = False


Words: TypeAlias = tuple[Run, ...]


def named(name: str) -> Words:
    """A name: `theta1` is θ with the index 1, `d_f` is d with the index f."""
    stem, index = parts(name)
    runs = (Run(_LETTERS.get(stem, stem)), Run(index.replace("-", "−"), below=True))
    return tuple(run for run in runs if run.text)


def spelled(text: str) -> Words:
    """A short formula such as `-a3` or `2*l1`, its names with their indices."""
    runs: list[Run] = []
    start = 0
    for match in _NAME.finditer(text):
        runs.append(Run(_plain(text[start : match.start()])))
        runs += (Run("π" if match[0] == "pi" else match[0]),) if match[0] in _OTHER_WORDS else named(match[0])
        start = match.end()
    runs.append(Run(_plain(text[start:])))
    return tuple(run for run in runs if run.text)


def joined(words: Iterable[Words]) -> Words:
    """Several names in a row: x₀, x₁."""
    runs: list[Run] = []
    for each in words:
        runs += (Run(", "), *each) if runs else each
    return tuple(runs)


def plain(words: Words) -> str:
    """A label on one line, without indices below it."""
    return "".join(run.text for run in words)


def in_line(name: str) -> str:
    """A name in a sentence: `theta1` is θ1, `joint_1` stays."""
    stem, _ = parts(name)
    return f"{_LETTERS[stem]}{name.removeprefix(stem)}" if stem in _LETTERS else name


def _plain(text: str) -> str:
    return text.replace("-", "−").replace("*", "·").replace(" ", "")
