"""The two conventions of Denavit and Hartenberg, and how a row of their tables becomes four moves."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from dhcli.errors import did_you_mean
from dhcli.frozen import frozen
from dhcli.kinematics.moves import Chain, Rot, Trans, along
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.names import canonical, parts
from dhcli.notation.tree import ZERO, Expr
from dhcli.regex import regex


class Convention(StrEnum):
    """How the links of a robot are described."""

    STANDARD = "standard"
    MODIFIED = "modified"
    PRODUCT = "product"


TABLES = (Convention.STANDARD, Convention.MODIFIED)
"""The conventions whose links are rows of a table."""

OTHER = dict(zip(TABLES, TABLES[::-1], strict=True))
"""The convention for which that of a table is taken by mistake; a product has none."""


@frozen
class Row:
    """One row of a DH table.

    Attributes:
        a: Link length a_i, in the modified convention a_{i-1} [m].
        alpha: Link twist alpha_i, in the modified convention alpha_{i-1}.
        d: Link offset d_i [m].
        theta: Joint angle theta_i.
    """

    a: Expr
    alpha: Angle
    d: Expr
    theta: Angle


COLUMNS = ("a", "alpha", "d", "theta")
LETTERS = {"a": "a", "alpha": "α", "d": "d", "theta": "θ"}
"""The columns as a book writes them."""
STILL = (*(Rot(axis, Angle()) for axis in AXES), Trans(ZERO, ZERO, ZERO))
"""Moves that do nothing."""

_HEADS = {"a": "a", "r": "a", "alpha": "alpha", "d": "d", "s": "d", "theta": "theta"}
_INDICES = {False: frozenset(("", "i", "j", "n")), True: frozenset(("i-1", "j-1", "n-1"))}


def column_of(head: str) -> tuple[str, bool]:
    """The column that a head such as `α_{i-1}` names, empty if none, and whether its index is the one before."""
    stem, subscript = parts(canonical(head))
    column = _HEADS.get(stem, "")
    before = subscript in _INDICES[True]
    return (column, before) if before or subscript in _INDICES[False] else ("", False)


_WORD = regex(r"[a-z]+")
_CALLED = {
    Convention.STANDARD: ("standard", "classic", "classical", "distal", "paul", "original", "sdh"),
    Convention.MODIFIED: ("modified", "craig", "mdh", "proximal", "khalil"),
    Convention.PRODUCT: ("products", "moves", "home", "matrices"),
}


_ALONE = ("dh", "denavit-hartenberg")
"""Words that mean the standard convention where nothing else is said."""


def conventions_in(text: str) -> frozenset[Convention]:
    """The conventions of tables that a text speaks of, in the words of books."""
    words = frozenset(_WORD.findall(text.lower()))
    return frozenset(convention for convention in TABLES if words.intersection(_CALLED[convention]))


def convention_hint(word: str, known: Iterable[str]) -> str:
    """What to say of a word that is none of the conventions known: what books call so, or the nearest."""
    meant = next((convention for convention, words in _CALLED.items() if word.lower() in words), None)
    meant = Convention.STANDARD if word.lower() in _ALONE else meant
    return did_you_mean(word, known) if meant is None else f"write {meant}"


ORDER = {
    Convention.STANDARD: "A_i = Rot(z, theta_i) Trans(z, d_i) Trans(x, a_i) Rot(x, alpha_i)",
    Convention.MODIFIED: "A_i = Rot(x, alpha_{i-1}) Trans(x, a_{i-1}) Trans(z, d_i) Rot(z, theta_i)",
    Convention.PRODUCT: "A_i = the product written in row i, from left to right",
}
"""The order of operations that stands under every table."""

NAMES = {
    Convention.STANDARD: "standard DH",
    Convention.MODIFIED: "modified DH",
    Convention.PRODUCT: "product of moves",
}


def moves_of(row: Row, convention: Convention) -> Chain:
    """The four elementary moves of a row, in the order of its convention.

    Source: standard as Denavit and Hartenberg 1955 in Paul's form; modified as Craig, eq. 3.6.
    """
    turn, slide = Rot("z", row.theta), along("z", row.d)
    reach, twist = along("x", row.a), Rot("x", row.alpha)
    if convention is Convention.MODIFIED:
        return (twist, reach, slide, turn)
    return (turn, slide, reach, twist)


def calibrated_moves(row: Row, beta: Angle, convention: Convention) -> Chain:
    """The moves of a row of a calibrated table, which turns about y besides; those that do nothing are left out.

    Source: behind the row as Hayati, in front of one of the modified convention as Khalil.
    """
    moves, tilt = moves_of(row, convention), (Rot("y", beta),)
    whole = (*tilt, *moves) if convention is Convention.MODIFIED else (*moves, *tilt)
    return tuple(move for move in whole if move not in STILL)
