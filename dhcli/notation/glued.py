"""Functions in one run of letters with what is before or behind them, `cos30°`, `a2cos(...)`; indices on the line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dhcli.notation.brackets import OPENING
from dhcli.notation.names import GREEK_NAMES, canonical
from dhcli.notation.quantity import ANGLE_UNITS
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Token
from dhcli.regex import regex

_GLUED = regex(r"(?P<head>.*?)(?P<function>cos|sin|tan|sqrt)(?P<digits>\d*)")
_NAMES = regex(r"[^\W\d_]|(?:[^\W\d_](?:[0-9]+|_\{[^{}]*\}|_[0-9]+))+")
"""What nobody doubts where any name stands for itself: a letter, or letters each with an index."""


def unglued(tokens: Sequence[Token], at: int, scope: Scope, *, angle_follows: bool) -> tuple[tuple[Token, ...], int]:
    """The tokens that a word of several is meant as, and how many it replaces; none if it is no such word.

    Args:
        tokens: The tokens of the text.
        at: Index of the word.
        scope: The names it may use; a factor before the function must be one, or a product of some.
        angle_follows: Whether an angle stands behind the word, so that its last letter may be a cosine or a sine.
    """
    word = tokens[at]
    match = _GLUED.fullmatch(word.text)
    short = len(word.text) > 1 and word.text[-1] in "csCS"
    if match is None and angle_follows and short and is_factor(word.text[:-1], scope):
        middle = word.end - 1  # as in `a_{i}c\theta_{i}`
        factor = Token("word", word.text[:-1], word.start, middle, word.spaced)
        return (factor, Token("word", word.text[-1], middle, word.end, spaced=False)), 1
    if match is None:
        return (), 0
    head, function, digits = match["head"], match["function"], match["digits"]
    has_argument = angle_follows or _called(tokens[at + 1])
    if (head and not is_factor(head, scope)) or not (digits or (head and has_argument)):
        return (), 0
    middle, behind = word.end - len(digits), tokens[at + 1]
    begin = middle - len(function)
    pieces = [Token("word", head, word.start, begin, word.spaced)] if head else []
    pieces.append(Token("word", function, begin, middle, spaced=not head and word.spaced))
    if not digits:
        return tuple(pieces), 1
    fraction = behind.kind == "number" and behind.text.startswith(".") and not behind.spaced  # cos22.5° is cos22 and .5
    end = behind.end if fraction else word.end
    pieces.append(Token("number", digits + (behind.text if fraction else ""), middle, end, spaced=False))
    return tuple(pieces), 1 + fraction


def indexed(tokens: Sequence[Token], at: int, scope: Scope) -> tuple[tuple[Token, ...], int]:
    """The name `a_{i-1}` for `ai-1`, `a_i-1` or `a(i-1)`, and how many tokens it replaces; none where it is no name.

    Args:
        tokens: The tokens of the text.
        at: Index of the word, which is no name itself.
        scope: The names it may use.
    """
    word = tokens[at]
    behind = [each.text for each in tokens[at + 1 : at + 6] if not each.spaced]
    if behind[:2] == ["-", "1"] and word.text.endswith("i"):
        stem, more = word.text.removesuffix("i").removesuffix("_"), 2
    elif behind[1:4] == ["i", "-", "1"] and behind[4:] and OPENING.get(behind[0]) == behind[4]:
        stem, more = word.text, 5
    else:
        return (), 0
    name = f"{stem}_{{i-1}}"
    if not stem or scope.is_open or not (scope.readings(name) or len(scope.split(name)) == 1):
        return (), 0
    return (replace(word, text=name, end=tokens[at + more].end),), more + 1


def in_degrees(tokens: Sequence[Token], at: int) -> bool:
    r"""Whether a unit of angle stands here, or LaTeX's `^\circ`."""
    if tokens[at].text == "^":
        return any(token.text == "°" for token in tokens[at + 1 : at + 3])
    return tokens[at].text == "°" or tokens[at].text in ANGLE_UNITS


def is_factor(head: str, scope: Scope) -> bool:
    """Whether what stands before a function is a name, or a product of names, in one way only."""
    if len(scope.readings(head)) == 1 or len(scope.split(head)) == 1:
        return True
    return scope.is_open and (bool(_NAMES.fullmatch(head)) or canonical(head).rstrip("0123456789") in GREEK_NAMES)


def _called(token: Token) -> bool:
    """Whether a function has its argument in what comes next, a bracket or a number, or a power before it."""
    return token.kind == "number" or (token.kind == "sign" and token.text in ("(", "^"))
