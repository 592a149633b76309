"""The text of a program taken apart without running any of it: statements, calls, arguments, brackets."""

from __future__ import annotations

import re
from collections.abc import Iterator

from dhcli.frozen import frozen
from dhcli.notation import brackets

_OPERATORS = frozenset("+-*/^")


@frozen
class Statement:
    """One statement.

    Attributes:
        line: Where it begins, from 1.
        text: Its text on one line, without comments.
    """

    line: int
    text: str


@frozen
class Call:
    """One call."""

    name: str
    args: tuple[str, ...]
    start: int
    end: int


def statements(text: str) -> Iterator[Statement]:
    """The statements of a program in MATLAB or Python; one goes on while a bracket is open."""
    depth, start, kept = 0, 1, ""
    for number, line in enumerate(text.split("\n"), 1):
        code = without_comment(line)
        goes_on = code.rstrip().endswith(("...", "\\"))
        code = code.rstrip().removesuffix("...").removesuffix("\\")
        if not kept.strip():
            start = number
        for letter, quoted in quoting(code):
            depth = max(0, depth + (not quoted) * brackets.STEPS.get(letter, 0))
            if letter == ";" and not quoted and not depth:
                if kept.strip():
                    yield Statement(start, kept.strip())
                kept, start = "", number
            else:
                kept += letter
        if depth or goes_on:
            kept += "\n" if depth else " "
        else:
            if kept.strip():
                yield Statement(start, kept.strip())
            kept = ""
    if kept.strip():
        yield Statement(start, kept.strip())


def without_comment(line: str) -> str:
    """A line without what stands behind % or #."""
    for i, (letter, quoted) in enumerate(quoting(line)):
        if letter in "%#" and not quoted:
            return line[:i]
    return line


def quoting(text: str) -> Iterator[tuple[str, bool]]:
    """Each letter, and whether it stands in quotes; behind a name or a bracket ' is MATLAB's transpose."""
    quote, before = "", ""
    for letter in text:
        if quote:
            yield letter, True
            quote = "" if letter == quote else quote
        elif letter == '"' or (letter == "'" and not (before.isalnum() or before in ")]}.'_")):
            quote = letter
            yield letter, True
        else:
            yield letter, False
        before = letter


def _unquoted(text: str) -> str:
    """A text with a quote in the place of each letter within quotes."""
    return "".join("'" if quoted else letter for letter, quoted in quoting(text))


def calls(text: str, names: re.Pattern[str]) -> Iterator[Call]:
    """The calls of some names in a text, from left to right; those inside another one after it."""
    for match in names.finditer(text):
        end = closing(text, match.end() - 1)
        if end > 0:
            yield Call(match[1], tuple(split(text[match.end() : end])), match.start(), end + 1)


def closing(text: str, start: int) -> int:
    """Index of the bracket that closes the one at `start`; -1 if none does."""
    end = brackets.closing(_unquoted(text[start:]))
    return -1 if end < 0 else start + end


def split(text: str, signs: str = ",") -> list[str]:
    """Pieces between signs that stand outside brackets and quotes; empty ones left out."""
    pieces = (text[at : at + len(piece)].strip() for at, piece in brackets.split(_unquoted(text), signs))
    return [piece for piece in pieces if piece]


def elements(text: str) -> list[str]:
    """The elements of one row of a matrix, between commas or blanks: `0 -0.3 pi/2` are three, `1 - 2` is one."""
    found: list[str] = []
    for piece in split(text):
        joined = False
        for word in split(piece, " \t\n"):
            goes_on = bool(found) and joined and (word[0] in "*/^" or found[-1][-1] in _OPERATORS or word in ("+", "-"))
            if goes_on:
                found[-1] += word
            else:
                found.append(word)
            joined = True
    return found


def unbracketed(text: str) -> str:
    """A list or matrix without its brackets; `array(...)` around them is taken off too."""
    text = re.sub(r"^(?:array|list|tuple)\s*\(", "", text.strip())
    text = text.strip().removesuffix(")") if text.count(")") > text.count("(") else text.strip()
    return text[1:-1].strip() if text[:1] in ("[", "(") and closing(text, 0) == len(text) - 1 else text
