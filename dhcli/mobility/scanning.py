"""Lists of joints read from left to right, each character once: `3R 1P`, `4 pins, 1 slot`, `(3*n - 2)R + n P`.

What stands before a joint is its count. A joint is a letter, or one of the words of `pairs`, in one word or in several
(`ball in a tube`), in the singular or the plural. Nothing is tried a second time, so that a text of any length is read
or refused at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from dhcli.errors import Place, Problem, did_you_mean
from dhcli.frozen import frozen
from dhcli.mobility.pairs import LETTERS, WORDS, LinkageError, Pair
from dhcli.notation.brackets import STEPS
from dhcli.notation.names import GREEK_NAMES

LONGEST = 2_000
"""Characters of a count or of a list of joints; a longer one is a slip of the clipboard."""

FILLERS = frozenset({"and", "joint", "joints", "pair", "pairs"})
"""Words that people write and that count nothing."""

_MOST_WORDS = max(len(words.split()) for words in WORDS)


@frozen
class Token:
    """A word, a number, or a sign.

    Attributes:
        text: As it is spelled.
        kind: `word`, `number`, or the sign itself.
        start: Index of its first character.
        end: Index after its last character.
    """

    text: str
    kind: str
    start: int
    end: int


def joint_pieces(text: str, place: Place | None) -> Iterator[tuple[str, Pair]]:
    """The pieces of a list of joints: the text of a count, which may be empty, and the kind that it counts.

    Raises:
        LinkageError: A piece does not end in a joint, a bracket is not closed, or the text is too long.
    """
    check_length(text, place)
    tokens = list(_split_letters(_tokens(text)))
    start, depth, i = 0, 0, 0  # where the count of the piece begins
    while i < len(tokens):
        token = tokens[i]
        found = _joint_at(tokens, i) if depth == 0 and token.kind == "word" else None
        if found is not None:
            pair, used = found
            yield _count(text, tokens, start, i), pair
            i = start = _next_piece(tokens, i + used)
            continue
        depth += STEPS.get(token.kind, 0)
        if depth < 0 or (depth == 0 and token.kind in ",;"):
            break
        i += 1
    if start < len(tokens):
        raise _no_joint(text[tokens[start].start :].strip(), place)


def check_length(text: str, place: Place | None = None) -> None:
    """Refuse a text that nobody has typed.

    Raises:
        LinkageError: It is longer than `LONGEST`.
    """
    if len(text) > LONGEST:
        raise LinkageError(Problem(f"more than {LONGEST:,} characters are not read as a count", place))


def check_count(text: str, place: Place | None = None) -> None:
    """Refuse what notation would read as a product of names: a name in a count is one letter, with an index or not.

    Raises:
        LinkageError: It is too long, holds a word such as `inf`, or a number such as `0x10`.
    """
    check_length(text, place)
    before: Token | None = None
    for token in _tokens(text):
        if token.kind == "word":
            name = token.text.rstrip("0123456789_").lower()
            if len(name) > 1 and name not in GREEK_NAMES:
                raise LinkageError(
                    Problem(f"'{token.text}' is no count", place, "a name in a count is one letter: 2*n")
                )
            if before and before.end == token.start and before.text.startswith("0"):
                message = f"'{before.text}{token.text}' is no count"
                raise LinkageError(Problem(message, place, "write a whole number, or a formula such as 2*n"))
        before = token


def _tokens(text: str) -> Iterator[Token]:
    """Words, numbers and signs; blanks part them."""
    i = 0
    while i < len(text):
        start = i
        if text[i].isspace():
            i += 1
            continue
        if text[i].isalpha():
            while i < len(text) and (text[i].isalpha() or text[i].isdecimal() or text[i] == "_"):
                i += 1
            # `ball-in-tube` is one word; a minus has a blank or a number behind it
            while i + 1 < len(text) and text[i] == "-" and text[i + 1].isalpha() and i - start > 1:
                i += 1
                while i < len(text) and text[i].isalpha():
                    i += 1
            yield Token(text[start:i], "word", start, i)
        elif text[i].isdigit() or text[i] == ".":
            while i < len(text) and (text[i].isdigit() or text[i] == "."):
                i += 1
            yield Token(text[start:i], "number", start, i)
        else:
            i += 1
            yield Token(text[start:i], text[start:i], start, i)


def _split_letters(tokens: Iterator[Token]) -> Iterator[Token]:
    """`nR` as a count and a joint, `RRP` as three joints, `R3P` as R, 3, P; words stay whole."""
    for token in tokens:
        known = any(word in WORDS for word in _singulars(token.text.lower()))
        letters = [i for i, letter in enumerate(token.text) if letter in LETTERS]
        borders = [-1, *letters, len(token.text)]
        between = [token.text[a + 1 : b] for a, b in pairwise(borders)]
        if token.kind != "word" or known or not letters or not all(map(_is_count, between)):
            yield token
            continue
        for i, plain in zip(borders[1:], between, strict=True):
            if plain:
                kind = "number" if plain.isdigit() else "word"
                yield Token(plain, kind, token.start + i - len(plain), token.start + i)
            if i < len(token.text):
                yield Token(token.text[i], "word", token.start + i, token.start + i + 1)


def _is_count(text: str) -> bool:
    """Whether it may stand between two letters of joints: nothing, a number, or a name of one letter."""
    return text.isdigit() or not text[1:] or not text[1:].strip("0123456789_")


def _joint_at(tokens: list[Token], i: int) -> tuple[Pair, int] | None:
    """The joint that begins at a token, and its number of words; the longest one counts."""
    for used in range(min(_MOST_WORDS, len(tokens) - i), 0, -1):
        if all(token.kind == "word" for token in tokens[i : i + used]):
            phrase = " ".join(token.text.lower() for token in tokens[i : i + used])
            if word := next((found for found in _singulars(phrase) if found in WORDS), ""):
                return WORDS[word], used
    letter = LETTERS.get(tokens[i].text)
    return None if letter is None else (letter, 1)


def _next_piece(tokens: list[Token], i: int) -> int:
    """Over what may stand between two pieces: words that count nothing, and one sign."""
    while i < len(tokens) and tokens[i].text.lower() in FILLERS:
        i += 1
    if i < len(tokens) and tokens[i].kind in ",;+":
        i += 1
    return i


def _count(text: str, tokens: list[Token], start: int, end: int) -> str:
    """The text of a count, without a sign of multiplication at its end."""
    while end > start and tokens[end - 1].kind in "*·×":
        end -= 1
    return text[tokens[start].start : tokens[end - 1].end] if end > start else ""


def _singulars(words: str) -> tuple[str, ...]:
    """`pins` as `pin`, `balls in a tube` as `ball in a tube`, `line contacts` as `line contact`; the text first."""
    first, blank, rest = words.partition(" ")
    return words, first.removesuffix("s") + blank + rest, words.removesuffix("s")


def _no_joint(piece: str, place: Place | None) -> LinkageError:
    words = [word for word in piece.replace("(", " ").replace(")", " ").split() if word.isalpha() and len(word) > 1]
    near = next((hint for word in words if (hint := did_you_mean(word, WORDS)).startswith("did")), "")
    shown = piece if len(piece) < 40 else f"{piece[:40]}..."  # noqa: PLR2004  as much as a person reads
    return LinkageError(Problem(f"'{shown}' is not a number of joints", place, near or "write 4R, or 3 pins 1 slider"))
