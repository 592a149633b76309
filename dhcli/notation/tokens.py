"""Text to tokens. Every spelling of an operator becomes one token, and every token knows its columns."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal

from dhcli.errors import NotationError, Place, Problem
from dhcli.frozen import frozen
from dhcli.notation.names import GREEK, GREEK_NAMES, SUBSCRIPTS, describe, foreign_letter
from dhcli.notation.styles import SPOKEN_FOR
from dhcli.regex import regex

MOST_CHARACTERS = 2000
"""Longest expression that is read; nobody types more into a cell."""

Kind = Literal["number", "word", "sign", "newline", "end"]

_OPERATORS = {
    **dict.fromkeys("−–—‐‑﹣-", "-"),  # noqa: RUF001  the many dashes that are meant as a minus
    **dict.fromkeys("×·⋅∙∗*", "*"),  # noqa: RUF001
    **dict.fromkeys("÷/∕⁄", "/"),  # noqa: RUF001
    "√": "√",
    "°": "°",
    "º": "°",
    "˚": "°",
    **dict.fromkeys("│┃║╎┆┊▏▕", "|"),
    **{sign: sign for sign in "+^,;()[]{}=@&|'\"!:"},
    "′": "'",
    "’": "'",  # noqa: RUF001
    "″": '"',
}
_SIGNS = {**_OPERATORS, "**": "^", ".": "*"}
_SPOKEN = {"minus": "-"}
_CAPITALS = {word: word.lower() for word in ("Deg", "DEG", "Degree", "Degrees", "Rad", "RAD", "Radians")}
"""Units behind a number as phones and forms write them."""
_SUPERSCRIPT = regex("(⁻?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
_NOISE = "─━═┄┈╌┌┬┐├┼┤└┴┘┏┳┓┡╇┩┢┣╋┫┗┻┛╔╦╗╠╬╣╚╩╝╭╮╯╰⎡⎢⎣⎤⎥⎦⎛⎜⎝⎞⎟⎠$"
"""What frames a table or a formula on a screen and means nothing."""
_GREEK_LETTERS = "".join(GREEK)
_LONGEST_WORD = 12
_DECIMAL_COMMA = regex(r"\d+,\d+(?![\d,.])", re.ASCII)
_WORD = rf"π|[A-Za-z{_GREEK_LETTERS}](?:[A-Za-z0-9{_GREEK_LETTERS}₀-₉]|_\{{[^{{}}]*\}}|_(?=[A-Za-z0-9]))*"
_NAME = regex(_WORD)
_LATEX_COMMA = r"0\{,\}[0-9]+|[0-9]+\{,\}(?![0-9]{3}(?![0-9]))[0-9]+"
"""A decimal comma as LaTeX has it, `0{,}866`; `1{,}234` may be a thousand and more, and stays a question."""
_PIECE = regex(
    rf"(?P<blank>[ \t\u00a0\u2009\u202f{_NOISE}]+|\.(?=[*/^]))"
    r"|(?P<module>(?:np|numpy|math|sp|sympy|sym)\.(?=[A-Za-z]))"
    rf"|(?P<word>{_WORD})"
    rf"|(?P<number>(?:{_LATEX_COMMA}|[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    rf"|(?P<sign>\*\*|(?<=[\w)\]}}])\.(?=[^\W\d_]|[(\\])|[{re.escape(''.join(_OPERATORS))}])"
)
"""Everything but LaTeX, superscripts and decimal commas; a full stop between names is the dot of a product."""
_MINUTES = regex(
    r"(?P<degrees>[0-9]{1,3})[ ]?(?:[°º˚]|deg(?:rees?)?\b\.?)[ ]?"
    r"(?P<minutes>[0-5]?[0-9](?:\.[0-9]{1,9})?)[ ]?(?:['′’]|(?:arc[ -]?)?min(?:utes?)?\b\.?)"  # noqa: RUF001
    r"(?:[ ]?(?P<seconds>[0-5]?[0-9](?:\.[0-9]{1,9})?)[ ]?"
    r"(?:[\"″”]|''|′′|’’|(?:arc[ -]?)?(?:sec(?:onds?)?|s)\b\.?))?",  # noqa: RUF001
    re.ASCII,
)
"""An angle in degrees, minutes and seconds, `2°28′38″` and `2 deg 28 min 38 sec`."""
_DEGREES = ("°", "deg", "º", "˚")
_COMMAND = regex(r"\\([A-Za-z]+|.)", re.DOTALL)
_SUBSCRIPT = regex(r"\s*(_\{[^{}]*\}|_[A-Za-z0-9])")
_WRAPPED = regex(r"\s*\{\s*([A-Za-z0-9]+)\s*\}((?:_\{[^{}]*\}|_[A-Za-z0-9])?)")
_LATEX_SPACES = frozenset(",;:! ") | {"quad", "qquad", "displaystyle", "left", "right", "limits"}
_LATEX_SIGNS = {
    "\\": ";",
    "cdot": "*",
    "times": "*",
    "div": "/",
    "lbrack": "[",
    "rbrack": "]",
    "circ": "°",
    "degree": "°",
}
_LATEX_WRAPPERS = frozenset(("mathrm", "text", "operatorname", "mathbf", "mathit", "rm", "boldsymbol"))


_ESCAPED = regex(rf"(?<![A-Za-z0-9_])(?:{'|'.join(sorted(SPOKEN_FOR))})$")
"""A keyword before the underscore that makes it a name in a program."""
_ROW_ROOM = regex(r"\s{0,9}\[\s{0,9}-?[0-9.]{1,9}\s{0,9}(?:pt|ex|em|mm|cm|in)\s{0,9}\]")
r"""The room below a row of LaTeX, `\\[2pt]`."""
_INDEX = regex(r" ?([0-9]{1,2})(?![0-9.,])")
r"""The index of `\theta 1`, which TeX sets on the line."""


@frozen
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


@frozen
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
        first = (self.place.column or 1) if line == 0 else 1
        if self.place.line is None:
            shown = (line == 0 and self.place.text) or self.text.split("\n")[line]
            place = Place(self.place.source, line + 1 if "\n" in self.text else None, column + first, shown)
        else:
            place = Place(
                self.place.source,
                self.place.line + line,
                column + first,
                self.place.text if line == 0 else self.text.split("\n")[line],
            )
        return NotationError(Problem(message, place, hint))


def spelling(tokens: Iterable[Token]) -> str:
    """Some tokens as one text, the same for those that are read alike."""
    return "\0".join(
        [f"{token.kind} {token.text}" if token.spaced else f"{token.kind}{token.text}" for token in tokens]
    )


def is_name(text: str) -> bool:
    """Whether a text is one name: letters and digits, with an index behind it if need be."""
    return _NAME.fullmatch(text.removeprefix("\\")) is not None


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
    position, spaced, depth, length = 0, False, 0, len(text)
    in_minutes = any(sign in text for sign in _DEGREES) and _MINUTES.search(text) is not None
    while position < length:
        if in_minutes and (angle := _MINUTES.match(text, position)):
            tokens += _in_degrees(angle, spaced=spaced)
            position, spaced = angle.end(), False
            continue
        match = _PIECE.match(text, position)
        kind = match.lastgroup if match else None
        if match and kind == "sign":
            end, sign = match.end(), _SIGNS[match[0]]
            if decimal_comma:
                depth += (sign in "([{") - (sign in ")]}")
            tokens.append(Token("sign", sign, position, end, spaced))
            position, spaced = end, False
        elif match and kind == "word":
            end, word = match.end(), match[0]
            if word in _SPOKEN:
                tokens.append(Token("sign", _SPOKEN[word], position, end, spaced))
            else:
                plain = word if word.isascii() else word.translate(SUBSCRIPTS)
                plain = _CAPITALS.get(plain, plain) if tokens and tokens[-1].kind == "number" else plain
                tokens.append(Token("word", plain, position, end, spaced))
            position, spaced = end, False
        elif match and kind == "number" and (depth or not decimal_comma):
            end = match.end()
            tokens.append(Token("number", match[0].replace("{,}", "."), position, end, spaced))
            position, spaced = end, False
        elif match and kind in ("blank", "module"):
            position, spaced = match.end(), spaced or kind == "blank"
        else:
            found, position = _rare(source, position, spaced=spaced)
            tokens += found
            spaced = not found or found[-1].kind == "newline"
    tokens.append(Token("end", "", len(text), len(text), spaced))
    return tokens


def _in_degrees(angle: re.Match[str], *, spaced: bool) -> Iterator[Token]:
    """Degrees, minutes and seconds as the sum in degrees that they are, exactly."""
    start, end = angle.span()
    yield Token("sign", "(", start, start, spaced)
    yield Token("number", angle["degrees"], start, angle.end("degrees"), spaced=False)
    for name, parts in (("minutes", "60"), ("seconds", "3600")):
        if angle[name]:
            first, last = angle.span(name)
            yield Token("sign", "+", first, first, spaced=False)
            yield Token("number", angle[name], first, last, spaced=False)
            yield Token("sign", "/", last, last, spaced=False)
            yield Token("number", parts, last, last, spaced=False)
    yield Token("sign", ")", end, end, spaced=False)
    yield Token("sign", "°", end, end, spaced=False)


def _rare(source: Source, start: int, *, spaced: bool) -> tuple[tuple[Token, ...], int]:
    """What begins here, and where it ends: a line end, LaTeX, a number that may have a decimal comma, a superscript."""
    text = source.text
    if text[start] in "\r\n":
        return (Token("newline", text[start], start, start + 1, spaced),), start + 1
    if text[start] == "\\":
        return _latex(source, start, spaced=spaced)
    if match := _DECIMAL_COMMA.match(text, start) or _PIECE.match(text, start):
        return (Token("number", match[0].replace(",", "."), start, match.end(), spaced),), match.end()
    if match := _SUPERSCRIPT.match(text, start):
        power = Token("sign", "^", start, start, spaced=False)
        minus = (Token("sign", "-", start, start + 1, spaced=False),) if match[1] else ()
        number = Token("number", match[2].translate(_RAISED), match.start(2), match.end(), spaced=False)
        return (power, *minus, number), match.end()
    if text[start] == "_" and _ESCAPED.search(text, max(start - _LONGEST_WORD, 0), start):
        return (), start + 1  # `lambda_` and `E_` in code that dhcli has written
    raise _strange(source, start)


def _latex(source: Source, start: int, *, spaced: bool) -> tuple[tuple[Token, ...], int]:
    r"""What a LaTeX command stands for, `\theta_{1}`, `\cos`, `\cdot`, `\\`, and where it ends; nothing for a space."""
    text = source.text
    match = _COMMAND.match(text, start)
    if match is None:
        raise source.error(start, "a backslash at the end", "remove it, or write a LaTeX command such as \\theta")
    command, end = match[1], match.end()
    if command in _LATEX_SPACES:
        return (), end
    if command in _LATEX_SIGNS:
        if command == "\\" and (room := _ROW_ROOM.match(text, end)):
            end = room.end()
        return (Token("sign", _LATEX_SIGNS[command], start, end, spaced),), end
    if command in _LATEX_WRAPPERS:
        inner = _WRAPPED.match(text, end)
        if inner is None:
            return (), end
        return (Token("word", inner[1] + inner[2], start, inner.end(), spaced),), inner.end()
    if not command.isalpha():
        raise source.error(start, f"\\{command} is not understood")
    if (tail := _SUBSCRIPT.match(text, end)) or (command in GREEK_NAMES and (tail := _INDEX.match(text, end))):
        command, end = command + tail[1], tail.end()
    return (Token("word", command, start, end, spaced),), end


def _strange(source: Source, position: int) -> NotationError:
    letter = source.text[position]
    latin = foreign_letter(letter)
    if latin:
        return source.error(
            position, f"the letter {describe(letter)} looks like a Latin {latin} but is another", f"write {latin}"
        )
    if letter in "∑Σ":
        return source.error(position, f"{describe(letter)} means nothing here", "write the sum out, a1 + a2")
    if not "\udc80" <= letter <= "\udcff":  # a byte that Python could not read as a letter
        return source.error(position, f"{describe(letter)} means nothing here")
    message = "this letter did not arrive: the locale of the terminal is not UTF-8"
    return source.error(position, message, "write deg, pi, sqrt, theta1; or begin the line with LC_ALL=C.UTF-8")
