"""Formulas for a joint as they are typed: with ±, with several values, with names for what is long."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, product

from dhcli.algebra.floats import Floats
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.solving.putting import put_for
from dhcli.errors import DhcliError, Place
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.brackets import OPENING
from dhcli.notation.dimensions import ANGLE_UNITS, LENGTH_UNITS
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import PI, Expr, Number, Sum, Symbol, Trig, Unit, add, multiply, number
from dhcli.notation.walk import rebuild, symbols, walk
from dhcli.regex import regex

MOST_SIGNS = 4
"""Signs ± in one answer; each doubles its values."""

MOST_STATEMENTS = 12
_PLUS_MINUS = regex(r"\\pm|\+\s*/\s*-|\+-")
_MINUS_PLUS = regex(r"\\mp|-\s*/\s*\+|-\+")
_HALF_TURN_MORE = regex(r",?\s*or\s+180\s*°?\s*more\s*$")
_OR = regex(r"\s+(?:or|and)\s+")
_STATEMENT = regex(r"\s*(?P<name>[^\W\d][\w{}\\()+ ]*?)\s*=(?!=)\s*(?P<rest>.*)", re.DOTALL)
_BESIDE = regex(r"(?:,?\s+(?:where|with|and)\b|,)\s*(?=(?P<name>[^\W\d][\w{}\\]*)\s*=(?!=))")
"""What stands between the formula and a name that is given beside it."""

_RIGHT_ANGLES = frozenset((90, 180, 270, 360))


@frozen
class Formula:
    """A formula as typed.

    Attributes:
        values: What it may come to, one for each combination of its signs.
        text: As it was typed, without a label.
        signs: How many ± stand in it.
        together: What it may come to where all its signs go together, upper with upper; empty for fewer than two.
    """

    values: tuple[Expr, ...]
    text: str
    signs: int
    together: tuple[Expr, ...] = ()

    @property
    def names(self) -> frozenset[str]:
        """The names in it."""
        return frozenset[str]().union(*map(symbols, self.values))

    def at(self, point: Mapping[str, Angle | float]) -> list[float]:
        """Its real values at a point, angles in radians."""
        over = Floats(point)
        return [value for value in map(over.value, self.values) if math.isfinite(value)]


def read_formula(text: str, asked: Sequence[str], scope: Scope, place: Place) -> Formula:
    """Read a formula: `theta2 = ±acos(D)`, with `D = ...` on a line before it, or `, D = ...` behind it.

    Args:
        text: What was typed.
        asked: The names that what is asked for goes by, in canonical form.
        scope: The names that may stand in it.
        place: Where it stands, for errors.

    Raises:
        UnreadableError: There are too many signs or statements, or none is the answer.
        NotationError: It cannot be read.
    """
    text = _MINUS_PLUS.sub("∓", _PLUS_MINUS.sub("±", text))
    signs = sum(text.count(sign) for sign in "±∓")
    if signs > MOST_SIGNS:
        raise UnreadableError(f"{signs} signs ± make {2**signs} values; write at most {MOST_SIGNS}")

    def values(choices: Iterable[Sequence[str]]) -> tuple[Expr, ...]:
        found = chain.from_iterable(_values(_signed(text, chosen), asked, scope, place) for chosen in choices)
        return tuple(dict.fromkeys(found))

    together = values(("+" * signs, "-" * signs)) if signs > 1 else ()
    every = values(product("+-", repeat=signs))
    return Formula(every, _statements(text, asked)[-1][1].strip(), signs, together)


def _signed(text: str, chosen: Sequence[str]) -> str:
    """A text with a sign for each ±, so that columns stay; a plus in front of everything is a blank."""
    signs = iter(chosen)
    letters = list(text)
    for at, letter in enumerate(letters):
        if letter in "±∓":
            sign = next(signs)
            letters[at] = sign if letter == "±" else {"+": "-", "-": "+"}[sign]
            before = text[:at].rstrip()
            if letters[at] == "+" and (not before or before[-1] in "=(,[;{\n"):
                letters[at] = " "
    return "".join(letters)


def _statements(text: str, asked: Sequence[str]) -> list[tuple[str, str]]:
    """The names in front of `=` with what stands behind: those of parts of the formula, then the answer without one.

    A part is named on a line of its own, or beside the formula: `acos(D), D = ...`, `acos(D) where D = ...`.
    """
    parts, answers = list[tuple[str, str]](), list[tuple[str, str]]()

    def take(statement: str) -> None:
        found = _part_named(statement, asked)
        if found:
            parts.append((found["name"], found["rest"]))
        elif statement.strip():
            match = _STATEMENT.fullmatch(statement)
            answers.append(("", match["rest"] if match else statement))

    for piece in re.split(r"[\n;]", text):
        start = 0
        for match in _BESIDE.finditer(piece):
            is_new = canonical(match["name"]) not in asked or _part_named(piece[start : match.start()], asked)
            if is_new and not _depth(piece[: match.start()]):
                take(piece[start : match.start()])
                start = match.end()
        take(piece[start:])
    return [*parts, *answers]


def _part_named(statement: str, asked: Sequence[str]) -> re.Match[str] | None:
    """A statement that gives a name to a part of the formula, and not to what is asked for."""
    match = _STATEMENT.fullmatch(statement)
    return match if match and canonical(match["name"].replace(" ", "")) not in asked else None


def _depth(text: str) -> int:
    """How many brackets are open at the end of a text."""
    return sum((letter in OPENING) - (letter in OPENING.values()) for letter in text)


def _values(text: str, asked: Sequence[str], scope: Scope, place: Place) -> list[Expr]:
    statements = _statements(text, asked)
    if len(statements) > MOST_STATEMENTS:
        raise UnreadableError(f"{len(statements)} lines; the formula and names for what is long in it will do")
    known: dict[Expr, Expr] = {}
    found = list[Expr]()
    for name, rest in statements:
        names = Scope(scope.joints, scope.angles, (*scope.lengths, *_symbols(known)), scope.aliases)
        if name:
            known[_defined(name, names, place)] = put_for(_plain(_parsed(rest, names, place)), known)
            continue
        half = _HALF_TURN_MORE.search(rest)
        for piece in _pieces(rest[: half.start()] if half else rest):
            value = put_for(_plain(_parsed(piece, names, place)), known)
            found += [value, add(value, PI)] if half else [value]
    if not found:
        raise UnreadableError(f"no line says what {asked[0]} is: write {asked[0]} = ...")
    return found


def _parsed(text: str, scope: Scope, place: Place) -> Expr:
    return parse(text, scope, place)


def _symbols(known: Mapping[Expr, Expr]) -> tuple[str, ...]:
    return tuple(node.name for node in known if isinstance(node, Symbol))


def _defined(name: str, scope: Scope, place: Place) -> Expr:
    """What a name in front of `=` stands for: a new name, or the cosine or sine that `c2` is."""
    try:
        found = parse(name, scope, place)
    except DhcliError:
        found = Symbol(name)
    if isinstance(found, Symbol | Trig):
        return found
    raise UnreadableError(f"{name} is no name for a part of the formula")


def _pieces(text: str) -> Iterator[str]:
    """Several values: between commas outside brackets, or with `or` between them."""
    for piece in _OR.split(text.strip().strip("{}")):
        depth, start = 0, 0
        for at, letter in enumerate(piece):
            depth += (letter in OPENING) - (letter in OPENING.values())
            if letter == "," and depth == 0:
                yield piece[start:at]
                start = at + 1
        if piece[start:].strip():
            yield piece[start:]


def _plain(expr: Expr) -> Expr:
    """An expression with its units as numbers: radians and metres."""
    for node in walk(expr):
        for term in node.terms if isinstance(node, Sum) else ():
            if isinstance(term, Number) and abs(term.value) in _RIGHT_ANGLES:
                raise UnreadableError(f"what is {abs(term.value)}? write {abs(term.value)}° for degrees, or pi")

    def leaf(node: Expr) -> Expr:
        if not isinstance(node, Unit):
            return node
        if node.name in LENGTH_UNITS:
            return Number(LENGTH_UNITS[node.name])
        radians = node.name in ("rad", "radian", "radians")
        return number(1) if radians or node.name not in ANGLE_UNITS else multiply(PI, Number(number(1).value / 180))

    return rebuild(expr, leaf)
