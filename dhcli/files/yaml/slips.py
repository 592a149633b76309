"""What an author has written in the place of a list or a mapping, where it is plain which one is meant.

It is told all the same, with what would be right, and then read as it was meant, so that nothing follows from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TypeAlias

from dhcli.files.yaml.cut import is_piece
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence
from dhcli.kinematics.conventions import COLUMNS
from dhcli.notation.brackets import OPENING, closing, split
from dhcli.regex import regex
from dhcli.safe import yaml_scalar

_WORD = regex(r"[^\s]+")
_PAIR = regex(
    r"±\s*(?P<both>[^-+±,]+)|(?P<low>[^,]{1,99}?)\s{0,9}(?:\.\.{1,9}|…|~| to | [-–] )\s{0,9}(?P<high>[^,]{1,99})"  # noqa: RUF001
)
"""Two ends of a range, `±170°` or `-90°..90°`."""
_LOW, _HIGH = ("lower", "low", "min", "from"), ("upper", "high", "max", "to")
_WHOLE = regex(r"[-+]?[0-9]+")
Entry: TypeAlias = tuple[PlacedScalar, PlacedNode]

LONGEST_SHOWN = 100
"""Characters of a list or a mapping that a hint shows."""


def node_kind(node: PlacedNode) -> str:
    """What a node is, for a message: `a list`, `a mapping`, `a text`, `empty`."""
    if isinstance(node, PlacedScalar):
        return "a text" if node.text or node.quoted else "empty"
    return "a list" if isinstance(node, PlacedSequence) else "a mapping"


def hint_for_brackets(node: PlacedNode) -> str:
    """What makes a text of a list or a mapping: quotes, where it stands in brackets on one line."""
    text = node.place.text[(node.place.column or 1) - 1 :]
    if text[:1] not in OPENING:
        return "write one line, or several behind |"
    end = closing(text) + 1
    shown = f": {yaml_scalar(text[:end])}" if end else ""
    return f"text that begins with a bracket needs quotes{shown}"


def with_equals(key: PlacedScalar, value: PlacedNode) -> Entry | None:
    """A key and its value where `=` stands between them, as in `{a1 = 0.3 m}`; None where it does not."""
    is_empty = isinstance(value, PlacedScalar) and not value.text and not value.quoted
    return _split(key) if is_empty and not key.quoted and is_piece(key.text, key.place) else None


def entries_of(node: PlacedNode) -> tuple[tuple[Entry, ...], str]:
    """The entries of a list that is meant as a mapping, `[a1 = 0.3 m, a2: 0.2 m]`, and that mapping as it is written.

    Returns:
        Nothing where that is not what it is.
    """
    found: list[Entry] = []
    if not isinstance(node, PlacedSequence) or not node.items:
        return (), ""
    for item in node.items:
        if isinstance(item, PlacedMapping):
            found += item.entries
        elif isinstance(item, PlacedScalar) and (entry := _split(item)):
            found.append(entry)
        else:
            return (), ""
    texts = (f"{key.text}: {value.text}" if isinstance(value, PlacedScalar) else "" for key, value in found)
    return tuple(found), _shown(texts, "{}")


def items_of(node: PlacedNode, count: int = 0, *, are_names: bool = False) -> tuple[tuple[PlacedScalar, ...], str]:
    """The items of a text that is meant as a list, `theta1, theta2` or `(0, 1)`, and that list as it is written.

    Args:
        node: The text.
        count: How many there should be: so many words, `0 90°`, are they.
        are_names: Whether they are names, which have no blanks: `crank rod`.

    Returns:
        Nothing where it is no text of one line. A sentence with commas is one item.
    """
    if isinstance(node, PlacedMapping) and count == 2:  # noqa: PLR2004  lowest and highest
        ends_by = {key.text: value for key, value in node.entries if isinstance(value, PlacedScalar)}
        pair_of = tuple(ends_by[key] for keys in (_LOW, _HIGH) for key in keys if key in ends_by)
        return (pair_of, _shown((end.text for end in pair_of), "[]")) if len(pair_of) == count else ((), "")
    if not isinstance(node, PlacedScalar) or not node.text.strip() or "\n" in node.text:
        return (), ""
    if count == 2 and (pair := _PAIR.fullmatch(node.text.strip())):  # noqa: PLR2004  lowest and highest
        text = pair["both"] or ""
        ends = (f"-{text}", text) if text else (pair["low"], pair["high"])
        return tuple(PlacedScalar(end, node.place) for end in ends), _shown(ends, "[]")
    text, start = node.text, 0
    if text.startswith("(") and text.endswith(")"):
        text, start = text[1:-1], 1
    pieces = [(start + at + len(piece) - len(piece.lstrip()), piece.strip()) for at, piece in split(text)]
    words = [(start + word.start(), word[0]) for word in _WORD.finditer(text)] if len(pieces) == 1 else []
    if len(words) > 1 and (are_names or len(words) == count == sum(map(_has_digit, words))):
        pieces = words
    if any(not piece or " " in piece for _, piece in pieces) and not start and len(pieces) != count:
        return (node,), _shown([yaml_scalar(node.text) if "," in node.text else node.text], "[]")
    items = tuple(PlacedScalar(piece, node.place_of(at)) for at, piece in pieces)
    return items, _shown((item.text for item in items), "[]")


def row_of(node: PlacedNode, variables: Sequence[str]) -> tuple[PlacedMapping, str]:
    """The row of a table that is a list of its cells, `[a1, 0, 0, theta1]`, and that row as it is written with keys.

    Its columns are those of the standard order, or of the one that begins with theta, by where the variable stands.

    Returns:
        Nothing where it has not four cells, or nobody knows what the variables are.
    """
    cells = (
        items_of(node)[0] if isinstance(node, PlacedScalar) else node.items if isinstance(node, PlacedSequence) else ()
    )
    scalars = [cell for cell in cells if isinstance(cell, PlacedScalar)]
    if not variables or not len(cells) == len(scalars) == len(COLUMNS):
        return PlacedMapping((), node.place), ""
    moves = next((k for k, cell in enumerate(scalars) if any(name in cell.text for name in variables)), len(COLUMNS))
    columns = COLUMNS if moves > 1 else ("theta", "d", "a", "alpha")
    entries = tuple((PlacedScalar(key, cell.place), cell) for key, cell in zip(columns, scalars, strict=True))
    return PlacedMapping(entries, node.place), _shown((f"{key.text}: {cell.text}" for key, cell in entries), "{}")


def blanks_between(node: PlacedSequence, count: int) -> tuple[tuple[PlacedScalar, ...], str]:
    """The items of a list in which blanks or semicolons stand between them, `[0 0 1]`, and that list as it is written.

    Returns:
        Nothing where there are not so many as there should be.
    """
    if len(node.items) != 1 or count <= 1:
        return (), ""
    items, shown = items_of(node.items[0], count)
    return (items, shown) if len(items) == count else ((), "")


def with_decimal_points(node: PlacedSequence, count: int) -> tuple[PlacedScalar, ...]:
    """The items of a list in which decimal commas have cut numbers in two, `[-0,5, 1]`: so many as there should be.

    Returns:
        Nothing where that is not what it is, or where nobody can say which commas they are, as in `[1,2,3]` for two.
    """
    items = [item for item in node.items if isinstance(item, PlacedScalar) and not item.quoted]
    if not 0 < count < len(items) or len(items) < len(node.items):
        return ()
    is_cut = [_is_cut(*pair) for pair in pairwise(items)] + [False]
    found: list[PlacedScalar] = []
    while items:
        item, *items = items
        if is_cut.pop(0):
            if is_cut.pop(0) and not is_cut[0]:  # a comma on either side
                return ()
            item = replace(item, text=f"{item.text}.{items.pop(0).text}")
        found.append(item)
    return tuple(found) if len(found) == count else ()


def _has_digit(word: tuple[int, str]) -> bool:
    return any(map(str.isdecimal, word[1]))


def _is_cut(item: PlacedScalar, following: PlacedScalar) -> bool:
    """Whether two items are a number with a decimal comma."""
    are_beside = replace(item.place, column=(item.place.column or 0) + len(item.text) + 1) == following.place
    return are_beside and _WHOLE.fullmatch(item.text) is not None and following.text[:1].isdecimal()


def _split(scalar: PlacedScalar) -> Entry | None:
    """What stands before and behind a `=`."""
    name, sign, text = scalar.text.partition("=")
    if not sign or not name.strip() or not text.strip():
        return None
    start = len(name) + 1 + len(text) - len(text.lstrip())
    return replace(scalar, text=name.strip()), PlacedScalar(text.strip(), scalar.place_of(start))


def _shown(texts: Iterable[str], brackets: str) -> str:
    """Items in brackets, as a file has them; nothing if one is missing or they are too many."""
    texts = tuple(texts)
    shown = brackets[0] + ", ".join(texts) + brackets[1]
    return shown if all(texts) and len(shown) <= LONGEST_SHOWN else ""
