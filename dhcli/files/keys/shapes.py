"""What may stand under a key, and the keys that several kinds of files have.

A loader asks `names` and `required`; `dhcli schema` and the tables of the manual come from the same lines.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeAlias

from dhcli.frozen import frozen


@frozen
class Scalar:
    """One value: a text, which may look like a number.

    Attributes:
        words: The only words that it may be; any text if empty.
        pattern: A regular expression that the whole text keeps; empty for none.
        may_be_empty: Whether it may be left out behind its key.
        is_angle: Whether a number has a unit, unless it is 0.
    """

    words: tuple[str, ...] = ()
    pattern: str = ""
    may_be_empty: bool = False
    is_angle: bool = False


@frozen
class Many:
    """A list.

    Attributes:
        of: What each of its items is.
        least: How many there are at least.
        most: How many there are at most, if that is fixed.
    """

    of: Shape
    least: int = 0
    most: int | None = None


@frozen
class Named:
    """Values by names that the author chooses."""

    of: Shape


@frozen
class Keyed:
    """Values under keys that are known."""

    keys: tuple[Key, ...]


@frozen
class Either:
    """One of several shapes."""

    of: tuple[Shape, ...]


Shape: TypeAlias = Scalar | Many | Named | Keyed | Either


@frozen
class Key:
    """A key.

    Attributes:
        name: As it is written.
        means: What its value means, in a sentence.
        holds: What its value is.
        is_required: Whether it must stand there.
        example: What the manual shows, if that is more than the name.
    """

    name: str
    means: str
    holds: Shape
    is_required: bool = False
    example: str = ""


def names(keys: Iterable[Key]) -> tuple[str, ...]:
    """The names of keys, as they may stand in a file."""
    return tuple(key.name for key in keys)


def required(keys: Iterable[Key]) -> dict[str, str]:
    """The names of those that must stand there, each with an example, the words it may be, or what it means."""
    return {key.name: key.example or f"{key.name}: {_said(key)}" for key in keys if key.is_required}


def _said(key: Key) -> str:
    return " | ".join(key.holds.words) if isinstance(key.holds, Scalar) and key.holds.words else key.means


TEXT = Scalar()
FLAG = Scalar(("true", "false"))
FLAGS = {"true": True, "yes": True, "false": False, "no": False}
"""How they are written, `yes` and `no` by some."""
NUMBER = Scalar()
WHOLE = Scalar(pattern="[0-9]{1,3}")
ANGLE = Scalar(is_angle=True)
TEXTS = Many(TEXT)
PAIR = Many(TEXT, 2, 2)
COORDINATES = Many(TEXT, 2, 3)
MOVES = Either((TEXT, Many(TEXTS, 3, 4)))
"""A product of moves; a matrix alone may be a list of its rows."""

HEAD = (
    Key("title", "what it is called", TEXT, is_required=True),
    Key("source", "where its numbers come from", TEXT, is_required=True),
)
NOTES = Key("notes", "what else a reader should know", TEXT)

ROW = (
    Key("a", "length a_i of the link, in a modified table a_{i-1}", TEXT, is_required=True),
    Key("alpha", "its twist, with its unit", ANGLE, is_required=True),
    Key("d", "offset d_i", TEXT, is_required=True),
    Key("theta", "angle theta_i, with its unit", ANGLE, is_required=True),
)
"""The columns of a table."""
