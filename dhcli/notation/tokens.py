"""Text to tokens. Every spelling of an operator becomes one token, and every token knows its columns."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from dhcli.errors import NotationError, Place, Problem
from dhcli.notation.names import GREEK, describe, foreign_letter

MOST_CHARACTERS = 2000
"""Longest expression that is read; nobody types more into a cell."""

Kind = Literal["number", "word", "sign", "newline", "end"]

_OPERATORS = {
    **dict.fromkeys("−–—‐‑﹣-", "-"),  # noqa: RUF001  the many dashes that are meant as a minus
    **dict.fromkeys("×·⋅∙∗*", "*"),  # noqa: RUF001
    **dict.fromkeys("÷/∕", "/"),
    "√": "√",
    "°": "°",
    "º": "°",
    "˚": "°",
    **{sign: sign for sign in "+^,;()[]{}=@&|'\"!:"},
    "′": "'",
    "’": "'",  # noqa: RUF001
    "″": '"',
}
_SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789", strict=True))
_BOX = re.compile("[│┃║╎┆┊▏▕]")
_NOISE = re.compile("[─━═┄┈╌┌┬┐├┼┤└┴┘┏┳┓┡╇┩┢┣╋┫┗┻┛╔╦╗╠╬╣╚╩╝╭╮╯╰⎡⎢⎣⎤⎥⎦⎛⎜⎝⎞⎟⎠$]")
_NUMBER = re.compile(r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_DECIMAL_COMMA = re.compile(r"\d+,\d+(?![\d,.])")
_GREEK_LETTERS = "".join(GREEK)
_WORD = re.compile(rf"π|[A-Za-z{_GREEK_LETTERS}](?:[A-Za-z0-9{_GREEK_LETTERS}₀-₉]|_\{{[^{{}}]*\}}|_(?=[A-Za-z0-9]))*")
_MODULE = re.compile(r"(?:np|numpy|math|sp|sympy|sym)\.(?=[A-Za-z])")
_SPACES = re.compile(r"[ \t\u00a0\u2009\u202f]+")
_LATEX_SPACES = frozenset(",;:! ") | {"quad", "qquad", "displaystyle", "left", "right", "limits"}
_LATEX_SIGNS = {"cdot": "*", "times": "*", "div": "/", "lbrack": "[", "rbrack": "]", "circ": "°", "degree": "°"}
_LATEX_WRAPPERS = frozenset(("mathrm", "text", "operatorname", "mathbf", "mathit", "rm", "boldsymbol"))


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of text with one meaning.

    Attributes:
        kind: What it is.
        text: Its spelling; signs in their plain form.
        start: Offset of its first character.
        end: Offset behind its last character.
        spaced: Whether a blank stands before it.
    """

    kind: Kind
    text: str
    start: int
    end: int
    spaced: bool


@dataclass(frozen=True, slots=True)
class Source:
    """A text and where it comes from, for errors that point at a column.

    Attributes:
        text: The text itself.
        place: Where its first character stands; a bare option such as `--q` has no line and column.
    """

    text: str
    place: Place

    def error(self, offset: int, message: str, hint: str = "") -> NotationError:
        """An error that points at one character of the text."""
        before = self.text[:offset]
        line, column = before.count("\n"), offset - (before.rfind("\n") + 1)
        if self.place.line is None:
            shown = self.text.split("\n")[line]
            place = Place(self.place.source, line + 1 if "\n" in self.text else None, column + 1, shown)
        else:
            first = self.place.column or 1
            place = Place(
                self.place.source,
                self.place.line + line,
                column + (first if line == 0 else 1),
                self.place.text if line == 0 else self.text.split("\n")[line],
            )
        return NotationError(Problem(message, place, hint))


def tokenize(source: Source, *, decimal_comma: bool = False, most: int = MOST_CHARACTERS) -> list[Token]:
    """Split a text into tokens, the last of which is `end`.

    Args:
        source: The text.
        decimal_comma: Read `0,5` as a number outside brackets; only where a comma cannot separate.
        most: Longest text that is read.

    Raises:
        NotationError: A character that means nothing here, or a text that is too long.
    """
    text = source.text
    if len(text) > most:
        raise source.error(most, f"{len(text)} characters are more than the {most} that are read")
    tokens: list[Token] = []
    position, spaced, depth = 0, False, 0
    while position < len(text):
        start = position
        token = None
        if match := _SPACES.match(text, position):
            position, spaced = match.end(), True
            continue
        letter = text[position]
        if letter in "\r\n":
            token = Token("newline", "\n", start, start + 1, spaced)
        elif decimal_comma and depth == 0 and (match := _DECIMAL_COMMA.match(text, position)):
            token = Token("number", match[0].replace(",", "."), start, match.end(), spaced)
        elif match := _NUMBER.match(text, position):
            token = Token("number", match[0], start, match.end(), spaced)
        elif match := _MODULE.match(text, position):
            position = match.end()
            continue
        elif match := _WORD.match(text, position):
            token = Token("word", match[0], start, match.end(), spaced)
        elif letter == "\\":
            token, position = _latex(source, position, spaced)
            if token is None:
                spaced = True
                continue
        elif letter == "*" and text.startswith("**", position):
            token = Token("sign", "^", start, start + 2, spaced)
        elif letter in _OPERATORS:
            token = Token("sign", _OPERATORS[letter], start, start + 1, spaced)
            depth += (token.text in "([{") - (token.text in ")]}")
        elif letter in _SUPERSCRIPTS:
            tokens.append(Token("sign", "^", start, start, spaced=False))
            token = Token("number", _SUPERSCRIPTS[letter], start, start + 1, spaced=False)
        elif _BOX.match(letter):
            token = Token("sign", "|", start, start + 1, spaced)
        elif _NOISE.match(letter):
            position, spaced = position + 1, True
            continue
        else:
            raise _strange(source, position)
        tokens.append(token)
        position, spaced = max(token.end, position), token.kind == "newline"
    tokens.append(Token("end", "", len(text), len(text), spaced))
    return tokens


def _latex(source: Source, start: int, spaced: bool) -> tuple[Token | None, int]:
    r"""A token from a LaTeX command: `\theta_{1}`, `\cos`, `\cdot`, `\\`; None for mere spacing."""
    text = source.text
    if text.startswith("\\\\", start):
        return Token("sign", ";", start, start + 2, spaced), start + 2
    match = re.compile(r"\\([A-Za-z]+|.)", re.DOTALL).match(text, start)
    if match is None:
        raise source.error(start, "a backslash at the end", "remove it, or write a LaTeX command such as \\theta")
    command = match[1]
    if command in _LATEX_SPACES:
        return None, match.end()
    if command in _LATEX_SIGNS:
        return Token("sign", _LATEX_SIGNS[command], start, match.end(), spaced), match.end()
    if command in _LATEX_WRAPPERS:
        inner = re.compile(r"\s*\{\s*([A-Za-z0-9]*)\s*\}((?:_\{[^{}]*\}|_[A-Za-z0-9])?)").match(text, match.end())
        if inner:
            return Token("word", inner[1] + inner[2], start, inner.end(), spaced), inner.end()
        return None, match.end()
    if not command.isalpha():
        raise source.error(start, f"\\{command} is not understood")
    tail = re.compile(r"\s*(_\{[^{}]*\}|_[A-Za-z0-9])?").match(text, match.end())
    subscript = (tail[1] if tail else None) or ""
    end = tail.end() if tail and subscript else match.end()
    return Token("word", command + subscript, start, end, spaced), end


def _strange(source: Source, position: int) -> NotationError:
    letter = source.text[position]
    latin = foreign_letter(letter)
    if latin:
        return source.error(
            position, f"the letter {describe(letter)} looks like a Latin {latin} but is another", f"write {latin}"
        )
    return source.error(position, f"{describe(letter)} means nothing here")
