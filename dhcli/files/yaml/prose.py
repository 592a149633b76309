"""Prose of exercise files folded to a width: lines of one paragraph flow together, lines that stand alone stay so."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from dhcli.safe import one_line

_ENDS = (".", ":", ";", "?", "!")
"""What a line of its own ends in; any other line goes on below."""


def folded(text: str, width: int, first: str = "", rest: str = "") -> list[str]:
    """A text in lines of at most a width; words are kept whole, however long.

    Args:
        text: The text. A line that ends a sentence, and one that is indented or begins with a dash, ends or begins a
            paragraph; so does an empty line, which is kept.
        width: Columns.
        first: What stands before its first line.
        rest: What stands before every other line.
    """
    lines: list[str] = []
    for paragraph in _paragraphs(text):
        indent = paragraph[: len(paragraph) - len(paragraph.lstrip())]
        lines += textwrap.wrap(
            paragraph.strip(),
            width,
            initial_indent=(rest if lines else first) + indent,
            subsequent_indent=rest + indent,
            break_long_words=False,
            break_on_hyphens=False,
        ) or [""]
    return lines


def _paragraphs(text: str) -> Iterator[str]:
    paragraph = ""
    for line in map(one_line, text.strip("\n").splitlines()):
        alone = not line.strip() or line.startswith((" ", "-", "*"))
        if paragraph and alone:
            yield paragraph
            paragraph = ""
        paragraph = f"{paragraph} {line.strip()}" if paragraph else line.rstrip()
        if not line.strip() or paragraph.endswith(_ENDS):
            yield paragraph
            paragraph = ""
    if paragraph:
        yield paragraph
