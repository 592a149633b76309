"""Answers as screens, programs and papers hold them, and the error for those that cannot be judged."""

from __future__ import annotations

import re

from dhcli.checking.reckoned import ReckonedError, reckoned
from dhcli.errors import joined
from dhcli.notation.brackets import closing
from dhcli.notation.commas import Shape
from dhcli.notation.pasted import EntriesError, rows_of
from dhcli.notation.pasted import without_label as _without_label
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_ABOUT = regex(r"≈")
_ABOUT_NAMED = regex(r"(?<=[\w}\u0307])[ \t]{0,9}≈(?=[ \t]{0,9}[+−-]?[\d.]{1,30}[^\n,;=]{0,20}(?:[\n,;]|$))")  # noqa: RUF001
"""Behind each name of a list of numbers, `v_x ≈ 0.1, v_y ≈ 0.2`."""
_ABOUT_NUMBER = regex(r"(?:(?<=[\[(,;&])[ \t]{0,9}|(?<=\d[ \t]))≈(?=[+−-]?[\d.])")  # noqa: RUF001
_ABOUT_WORD = regex(
    r"^\s{0,9}(?:ca\.|ca(?=\s{0,9}[+−-]?[\d.,]{1,30}\s{0,9}[A-Za-z°]{0,4}\s{0,9}$)|circa|about|approx(?:\.|imately)?"  # noqa: RUF001
    r"|~|≃|≅)\s{0,9}(?=[\d.+−-])",  # noqa: RUF001
    re.IGNORECASE,
)
"""Before a number; `ca` alone before more of them is the cosine of alpha."""
_WORD = (
    r"(?:the|my|so|then|it|this|here|is|are|final|answer|ans|result|solution|matrix|vector|position|rotation|point|pose"
    r"|table|dh|jacobian|se3|product|column|[^\W\d_](?:\{?_?\{?\d{1,2}\}?'?){0,2})"
)
_WORDS = regex(rf"\s*(?P<words>{_WORD}(?:[ \t]{{1,9}}{_WORD}){{0,5}})[ \t]{{0,9}}(?P<colon>:?)\s*", re.IGNORECASE)
"""What people write before the bracket of a matrix, or with a colon before its rows: words, a letter with indices."""
_NAMED = regex(
    r"(?:\A\s{0,9}|[\])}]['ᵀ]?[^\S\n]{0,9}[;,\n]\s{0,9}(?:and\s{1,9})?)(?P<name>[^\W\d][\w{}'^ ]{0,14}?)\s{0,9}="
    r"\s{0,9}(?=[\[(]|\\begin|\\left|np\.|array|[mM]atrix)"
)
"""A name before a matrix or a list, at the beginning or behind another one."""
_CELLS = regex(r"[,;&\n]|\][^\]\[]{0,9}\[")
_BEHIND = regex(r"\s{0,9}(?:\.?'|\^\{?\\?[A-Za-z]{1,3}\}?|ᵀ|\.T)?\s{0,9}(?:[A-Za-z°/]{1,6})?\s{0,9}[.;]?\s{0,9}")
"""Several cells, and what may stand behind their bracket."""
_UNFILLED = regex(r"(?<![\w}])_(?![\w{])")

_NUMBER_WORDS = (
    *("zero", "one", "two", "three", "four", "five", "six"),
    *("seven", "eight", "nine", "ten", "eleven", "twelve"),
)


_COUNTED = regex(
    r"\s{0,9}(?:(?P<before>d\.?o\.?f\.?)\s{0,9}[:=]\s{0,9}"
    r"|(?:(?:the|it|there|is|are|has|have|exactly|only|just|rank|answer|number|count)\s{1,9}){0,4})"
    r"(?P<number>[a-z]{1,9}|\d{1,9})(?:\.0{1,9})?"
    r"(?:\s{1,9}(?P<behind>d\.?o\.?f\.?s?|degrees? of freedom"
    r"|(?:link|joint|freedom|constraint|solution|way|posture|branch)(?:e?s)?))?"
    r"\s{0,9}(?:\((?![^()]{0,60}(?:\d|\bor\b))[^()]{2,60}\)\s{0,9})?\.?\s{0,9}",
    re.IGNORECASE,
)
"""A whole number, what it counts, and a remark in brackets, `2 (elbow up and down)`."""


LARGEST = 256_000
"""Characters of an answer that are read at the most."""


class UnreadableError(Exception):
    """An answer that cannot be judged, because of its format and not of its content.

    Attributes:
        remarks: What is wrong with it and what would be read.
    """

    def __init__(self, *remarks: str) -> None:
        """Say what would be read."""
        super().__init__("; ".join(remarks))
        self.remarks = remarks


def refuse_long(text: str, most: int = LARGEST) -> None:
    """Refuse an answer that is too long to be read.

    Raises:
        UnreadableError: It is.
    """
    if len(text) > most:
        raise UnreadableError(f"the answer has {len(text)} characters, more than the {most} that are read")


def without_label(text: str, shape: Shape | None = None) -> str:
    """A text without `T_03 =` in front, without what a screen shows around a matrix, and without decimal commas.

    Args:
        text: What was typed.
        shape: Rows and columns of what is asked for, where several cells are.

    Raises:
        UnreadableError: Several matrices or lists stand there, each with a name; or numbers that are not equal have a
            sign of equality between them, `7 = 6`.
    """
    several = [match["name"].strip() for match in _NAMED.finditer(text)]
    if len(several) > 1:
        raise UnreadableError(f"{joined(several)} stand here: write the one that is asked for")
    text = _ABOUT_NUMBER.sub("", _ABOUT_WORD.sub("", text))
    text = _ABOUT_NAMED.sub("=", text)
    text = _ABOUT.sub("=" if text[: text.find("≈")].strip() else "", text, count=1)
    try:
        text = reckoned(text)
    except ReckonedError as error:
        raise UnreadableError(str(error)) from None
    return _without_label(text, shape)


def without_words(text: str, scope: Scope) -> str:
    """A text without words before a matrix or a list, `the answer is [1 0; 0 1]`, `J: ...`; any other as it is.

    Args:
        text: What was typed.
        scope: The names it may use; one of them before a bracket may be a factor.

    Raises:
        UnreadableError: It is such a name.
    """
    match = _WORDS.match(text)
    if match is None:
        return text
    rest = text[match.end() :].strip()
    if match["colon"]:
        return rest if rest and ":" not in rest else text
    if not is_bracketed(rest):
        return text
    word = match["words"]
    if (
        scope.readings(word)
        or scope.split(word)
        or (scope.is_open and word.islower() and len(word.rstrip("0123456789_{}'")) == 1)
    ):
        raise UnreadableError(
            f"{word} stands before the bracket: write {word} = for its name, {word}*[...] for a factor"
        )
    return rest


def is_bracketed(text: str) -> bool:
    """Whether a text is one bracket around several cells, behind which a unit or a sign of transposition may stand."""
    end = closing(text) if text[:1] in ("[", "(") else -1
    return end > 0 and bool(_CELLS.search(text[1:end])) and bool(_BEHIND.fullmatch(text[end + 1 :]))


def without_number_word(text: str, counted: tuple[str, ...]) -> str:
    """A text, or the figure of a whole number with what it counts, and of a small one that is a word: `six links`.

    Args:
        text: What was typed.
        counted: How the words begin for what is counted; a number of something else stays as it is.
    """
    match = _COUNTED.fullmatch(text)
    nouns = [noun.casefold() for noun in match.group("before", "behind") if noun] if match else []
    number = match["number"].casefold() if match and all(noun.startswith(counted) for noun in nouns) else ""
    if number in _NUMBER_WORDS:
        return str(_NUMBER_WORDS.index(number))
    return number if number.isdecimal() else text


def refuse_blanks(text: str) -> None:
    """Make sure that nothing is still to be filled in.

    Raises:
        UnreadableError: A `_` of the sheet stands alone somewhere.
    """
    if _UNFILLED.search(text):
        raise UnreadableError("some entries are still blank: fill in every _")


def as_matrix(text: str, shape: Shape) -> str:
    """A matrix in brackets, where an answer is dhcli's JSON or a list of entries such as `r11 = c1`, `px = a1*c1`.

    Raises:
        UnreadableError: Entries are missing in the list, or stand in it twice.
    """
    try:
        return rows_of(text, shape)
    except EntriesError as error:
        raise UnreadableError(str(error)) from None
