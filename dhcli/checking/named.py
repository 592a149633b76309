"""Numbers behind their names, `z = 3, x = 1, y = 2`: each goes where its name says, in whatever order they stand."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from typing import TypeAlias

from dhcli.checking.lists import untransposed
from dhcli.checking.pasted import UnreadableError
from dhcli.errors import are, listed
from dhcli.notation.brackets import OPENING, closing, depths, split
from dhcli.notation.functions import FUNCTIONS
from dhcli.notation.matrix import bracketed
from dhcli.notation.names import canonical
from dhcli.notation.scope import Scope
from dhcli.notation.screens import equations, plain
from dhcli.regex import regex

Naming: TypeAlias = tuple[str, ...]
"""The names of the numbers of a list, in the order in which these are asked for."""

XYZ: Naming = ("x", "y", "z")

LONGEST = 2000
"""Characters of a list in which names are looked for."""

MOST_TOLD = 3
"""Names that are missing and are told."""

MOST_INDEXED = 10
"""Rows or columns from which on J111 has two meanings."""

_NAME = r"(?:\\(?:d?dot|mathrm|text) ?\{? ?)?\\?[^\W\d](?:[\w'’\u0307}]|_\{){0,14}(?:/dt)?"  # noqa: RUF001
_SIGNED = regex(rf"(?P<name>{_NAME})[ \t]{{0,9}}(?:&?[ \t]{{0,9}}=(?!=)|:(?!=)|≈)[ \t&]{{0,9}}")
_SPOKEN = regex(rf"(?P<name>{_NAME})(?:[ \t]{{1,9}}is)?[ \t]{{1,9}}(?=[-+−.\d√(])")  # noqa: RUF001
_HEAD = regex(
    rf"[\[(<][ \t]{{0,9}}(?P<names>{_NAME}(?:[ \t]{{0,9}}[,;][ \t]{{0,9}}{_NAME}){{1,9}})[ \t]{{0,9}}[\])>]"
    r"(?:\^?\{?T\}?)?[ \t]{0,9}[=:][ \t]{0,9}"
)
"""`(x, y, z) =` before the numbers."""
_DRESS = regex(r"\\d?dot|\\mathrm|\\text|dot|/dt|[\\{}_'’\u0307 ]")  # noqa: RUF001
_TAIL = regex(r"(?P<head>.*?)(?P<tail>[vwxyz]|\d{1,2})")
_SEPARATED = regex(r"[,;]")
_DECIMAL_COMMA = regex(r"\d,\d")
_BEHIND = (" the", " and", "\\\\")
"""What stands between a number and the next name, besides separators."""


def in_order(text: str, namings: Sequence[Naming], scope: Scope) -> str:
    """A list with its numbers in the order asked for, without their names; any other text as it is.

    Args:
        text: What was typed.
        namings: The ways in which the numbers may be called. Whatever stands before the axis or the index of a name,
            `p_x`, `tau2`, is the same for all of them.
        scope: The names that may stand in the numbers themselves.

    Raises:
        UnreadableError: A number stands there twice, or one of them is missing.
    """
    numbers = _numbers(text, namings, scope)
    return ("; " if any(map(_DECIMAL_COMMA.search, numbers)) else ", ").join(numbers) or text


def in_one(text: str, naming: Naming, scope: Scope) -> str:
    """Lists or matrices behind their names as one, `ω = (0, 0, 1), v = (a1, 0, 0)`; any other text as it is.

    Args:
        text: What was typed.
        naming: What they are called, in the order in which they stand above each other.
        scope: The names that may stand in the numbers.

    Raises:
        UnreadableError: One of them stands there twice, or is missing.
    """
    blocks = [untransposed(block).strip() for block in _numbers(text, (naming,), scope)]
    if not blocks or not all(block[:1] in OPENING and closing(block) == len(block) - 1 for block in blocks):
        return text
    insides = [block[1:-1].strip() for block in blocks]
    if all(inside.startswith("[") for inside in insides):
        return f"[{', '.join(insides)}]"
    if not any(set(inside) & set(",;\n") for inside in insides):  # numbers between blanks
        insides = [", ".join(inside.split()) for inside in insides]
    is_list = not any(set(inside) & set(";\n") for inside in insides)
    return ", ".join(insides) if is_list else f"[{'; '.join(insides)}]"


def in_rows(text: str, shape: tuple[int, int], scope: Scope) -> str:
    """A list of all entries of a matrix, `J11 = ..., J12 = ...`, as that matrix; any other text as it is.

    Args:
        text: What was typed.
        shape: Rows and columns, nine at most.
        scope: The names that may stand in the entries.

    Raises:
        UnreadableError: An entry stands there twice, or one of them is missing.
    """
    rows, columns = shape
    naming = tuple(f"{row + 1}{column + 1}" for row in range(rows) for column in range(columns))
    numbers = _numbers(text, (naming,), scope) if max(shape) < MOST_INDEXED else []
    return bracketed([numbers[k : k + columns] for k in range(0, len(numbers), columns)]) if numbers else text


def _numbers(text: str, namings: Sequence[Naming], scope: Scope) -> list[str]:
    """The numbers of a list in the order of a naming; none where they have other names.

    Raises:
        UnreadableError: A number stands there twice, or one of them is missing.
    """
    if len(text) > LONGEST or not any(namings):
        return []
    body = equations(plain(text)).strip()
    if head := _HEAD.match(body):
        return _under_names(re.split(r"[,;]", head["names"]), body[head.end() :], namings)
    inside = body[1:-1] if body[:1] in ("(", "[") and closing(body) == len(body) - 1 else body
    if pairs := _pairs(inside, list(_SIGNED.finditer(inside))):
        return _arranged(pairs, namings)
    known = {name for naming in namings for name in _known(naming)}
    words = [match for match in _SPOKEN.finditer(inside) if _is_label(match["name"], known, scope)]
    try:
        return _arranged(_pairs(inside, words), namings)
    except UnreadableError:  # these may be products, of which something else is to be said
        return []


def _is_label(word: str, known: Collection[str], scope: Scope) -> bool:
    """Whether a word before a number is the name of it, and neither a function nor a factor."""
    if word in FUNCTIONS or scope.readings(word) or scope.split(word):
        return False
    plain = _plain(word)
    return plain in known or _tail(plain) in known


def _under_names(names: Sequence[str], rest: str, namings: Sequence[Naming]) -> list[str]:
    """Numbers behind a list of their names, `(z, y, x) = (3, 2, 1)`."""
    whole = rest[1:-1] if rest[:1] in ("(", "[", "<") and rest[-1:] in (")", "]", ">") else ""
    values = [value for _, value in split(whole)]
    return _arranged(list(zip(names, values, strict=True)), namings) if len(values) == len(names) else []


def _pairs(text: str, labels: Sequence[re.Match[str]]) -> list[tuple[str, str]]:
    """Names with what stands behind each; none where a text does not begin with a name."""
    deep = list(depths(text))
    found = [match for match in labels if not deep[match.start()] and _begins(text[: match.start()])]
    if len(found) < 2 or text[: found[0].start()].strip() not in ("", "the"):  # noqa: PLR2004
        return []
    ends = [*(match.start() for match in found[1:]), len(text)]
    pairs: list[tuple[str, str]] = []
    for match, end in zip(found[::-1], ends[::-1], strict=True):
        value = _without_ends(text[match.end() : end])
        pairs.append((match["name"], value or (pairs[-1][1] if pairs else "")))  # `x = y = 0`
    return pairs[::-1]


def _without_ends(value: str) -> str:
    """A number without what separates it from the next name."""
    for words in ("", *_BEHIND):
        value = value.removesuffix(words).strip(" \t\n,;&")
    return value.replace("\n", " ")


def _begins(before: str) -> bool:
    """Whether a name may stand behind a text: at the beginning, behind a separator, or a blank behind a number."""
    bare = before.rstrip()
    if not bare or bare[-1] in ",;&=" or bare.endswith("\\\\"):
        return True
    return len(bare) < len(before) and bare[-1] not in "+-*/^−·"  # noqa: RUF001


def _arranged(pairs: Sequence[tuple[str, str]], namings: Sequence[Naming]) -> list[str]:
    """The numbers in the order of the first naming that they have all names of; none where they have other names."""
    if not pairs or not all(value for _, value in pairs):
        return []
    labels = [_plain(name) for name, _ in pairs]
    missing = ""
    for naming in namings:
        places = _places(labels, naming)
        if sorted(places) == list(range(len(naming))):
            return [pairs[places.index(k)][1] for k in range(len(naming))]
        is_begun = list(places) == list(range(len(places))) and bool(_SEPARATED.search(pairs[-1][1]))
        if places and not missing and not is_begun:  # `x = 1, y = 2, 3` is in order
            twice = next((pairs[i][0] for i, place in enumerate(places) if place in places[:i]), "")
            absent = [_said(name) for k, name in enumerate(naming) if k not in places]
            missing = (
                f"{twice} stands there twice" if twice else f"{listed(absent, MOST_TOLD)} {are(len(absent))} missing"
            )
    if missing:
        raise UnreadableError(missing)
    return []


def _said(name: str) -> str:
    """A name that is missing, as it is told."""
    return f"entry ({name[0]},{name[1]})" if name.isdecimal() and len(name) > 1 else name


def _places(labels: Sequence[str], naming: Naming) -> tuple[int, ...]:
    """Where the numbers behind labels belong; empty where a label is none of a naming."""
    exact = [_plain(name) for name in naming]
    if all(label in exact for label in labels):
        return tuple(map(exact.index, labels))
    tails = list(map(_tail, exact))
    for own in (_ends(labels), _ends(labels, shortened=True)) if len(set(tails)) == len(tails) else ():
        if own and all(tail and tail in tails for tail in own):
            return tuple(map(tails.index, own))
    return ()


def _known(naming: Naming) -> Iterator[str]:
    """The names of a naming, and the ends of them by which they are told apart."""
    exact = [_plain(name) for name in naming]
    yield from exact
    tails = list(map(_tail, exact))
    if len(set(tails)) == len(tails):
        yield from filter(None, tails)


def _ends(labels: Sequence[str], *, shortened: bool = False) -> list[str]:
    """The axis or index of each label, empty for mixed ones; shortened, the row of entries J11 and J21 of a column."""
    tails = list(map(_tail, labels))
    heads = {label.removesuffix(tail) for label, tail in zip(labels, tails, strict=True)}
    if any(tail.isalpha() for tail in tails):
        return tails if len(heads) == 1 else []
    if shortened and len(heads) == 1 and all(len(tail) == 2 for tail in tails):  # noqa: PLR2004
        rows, columns = [tail[0] for tail in tails], [tail[1] for tail in tails]
        return rows if len(set(columns)) == 1 else columns if len(set(rows)) == 1 else tails
    return tails


def _tail(name: str) -> str:
    """The axis or the index at the end of a name; empty where there is none."""
    match = _TAIL.fullmatch(name)
    return match["tail"] if match else ""


def _plain(name: str) -> str:
    """A name in small letters without dots, primes and signs of an index; ω is w."""
    if not name.isascii():
        from unicodedata import normalize  # few names need it

        name = normalize("NFD", name)
    plain = _DRESS.sub("", canonical(_DRESS.sub("", name))).lower()
    return plain.replace("omega", "w")
