"""Formulas for a joint as they are typed: with ±, with several values, with names for what is long."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, product

from dhcli.algebra.floats import Floats
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.solving.statements import SQUARE, STATEMENT, statements_in, with_own_capitals
from dhcli.checking.units import ONE as METRE
from dhcli.errors import DhcliError, Place
from dhcli.frozen import frozen
from dhcli.notation.brackets import split
from dhcli.notation.dimensions import ANGLE_UNITS, LENGTH_UNITS, DimensionError, dimension, has_units, is_inverse
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import PI, Call, Expr, Number, Power, Product, Sum, Symbol, Trig, Unit, add, multiply, number
from dhcli.notation.walk import put_for, rebuild, symbols_in, walk
from dhcli.regex import regex

MOST_SIGNS = 4
"""Signs ± in one answer; each doubles its values."""

MOSTSTATEMENTS = 12
_FACTORS = frozenset((0, 1, 2, 4, Fraction(1, 2), Fraction(1, 4), 180))
"""Numbers of formulas that are all in letters."""

_PLUS_MINUS = regex(r"\\pm|\+\s*/\s*-|\+-|\bplus[ -](?:or[ -])?minus\b", re.IGNORECASE)
_MINUS_PLUS = regex(r"\\mp|-\s*/\s*\+|-\+")
_HALF_TURN_MORE = regex(r",?\s*or\s+180\s*°?\s*more\s*$")
_OR = regex(r"\s+(?:or|and)\s+")
_NEXT = regex(r"(?:,|,?\s+(?:with|where|and|or)\s)(?=\s*\\?[^\W\d][\w{}\\]{0,20}(?:\^2|\*\*2|²)?[ \t]{0,9}=(?!=))")
"""Between statements in one line: `D = ..., theta2 = ...`, `theta2 = ... with D = ...`."""

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
        return symbols_in(self.values)

    @property
    def has_measures(self) -> bool:
        """Whether a number stands in it that may be a length, and is no factor of a formula in letters."""
        return any(isinstance(n, Number) and abs(n.value) not in _FACTORS for value in self.values for n in walk(value))

    def at(self, over: Floats) -> list[float]:
        """Its real values at a point, angles in radians."""
        return [value for value in map(over.value, self.values) if math.isfinite(value)]


def read_formula(text: str, asked: Sequence[str], scope: Scope, place: Place, unit: Fraction = METRE) -> Formula:
    """Read a formula: `theta2 = ±acos(D)`, with `D = ...` before it or behind it.

    Args:
        text: What was typed.
        asked: The names that what is asked for goes by, in canonical form.
        scope: The names that may stand in it.
        place: Where it stands, for errors.
        unit: Metres in a bare length; the formula is in that unit.

    Raises:
        UnreadableError: There are too many signs or statements, or none is the answer.
        NotationError: It cannot be read.
    """
    text = _NEXT.sub("\n", _MINUS_PLUS.sub("∓", _PLUS_MINUS.sub("±", text.strip().rstrip("."))))
    signs = sum(text.count(sign) for sign in "±∓")
    if signs > MOST_SIGNS:
        raise UnreadableError(f"{signs} signs ± make {2**signs} values; write at most {MOST_SIGNS}")

    def values(choices: Iterable[Sequence[str]]) -> tuple[Expr, ...]:
        found = chain.from_iterable(_values(_signed(text, chosen), asked, scope, place, unit) for chosen in choices)
        return tuple(dict.fromkeys(found))

    together = values(("+" * signs, "-" * signs)) if signs > 1 else ()
    shown = statements_in(text, asked)[-1].strip()
    match = STATEMENT.fullmatch(shown)
    return Formula(values(product("+-", repeat=signs)), match["rest"] if match else shown, signs, together)


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


def _values(text: str, asked: Sequence[str], scope: Scope, place: Place, unit: Fraction) -> list[Expr]:
    statements = statements_in(text, asked)
    if len(statements) > MOSTSTATEMENTS:
        raise UnreadableError(f"{len(statements)} lines; the formula and names for what is long in it will do")
    scope = with_own_capitals(scope, statements)
    known: dict[Expr, Expr] = {}
    found = list[Expr]()
    for statement in statements:
        match = STATEMENT.fullmatch(statement)
        name = match["name"] if match else ""
        rest = match["rest"] if match else statement
        names = Scope(
            scope.joints,
            scope.angles,
            (*scope.lengths, *(name for name in symbols_in(known) if not scope.has(name))),
            scope.aliases,
        )
        if match and canonical(name.replace(" ", "")) not in asked:
            known[_defined(name, names, place)] = put_for(_plain(_parsed(rest, names, place), unit), known)
            continue
        half = _HALF_TURN_MORE.search(rest)
        rest = rest[: half.start()] if half else rest
        for piece in _pieces(rest):
            _check_kind(_parsed(piece, names, place), asked[0], scope)
            value = put_for(_plain(_parsed(piece, names, place), unit), known)
            found += [value, add(value, PI)] if half else [value]
    own = {node.name for node in known if isinstance(node, Symbol) and not scope.has(node.name)}
    squared = {node.base.name for node in known if isinstance(node, Power) and isinstance(node.base, Symbol)}
    if alone := sorted(squared & symbols_in(found)):
        raise UnreadableError(f"{alone[0]} stands without its square: define {alone[0]} itself, with a square root")
    if inside := sorted(own & symbols_in(found)):
        raise UnreadableError(f"{inside[0]} stands inside a cosine or sine: write there what it is made of")
    if not found:
        raise UnreadableError(f"no line says what {asked[0]} is: write {asked[0]} = ...")
    return found


def _parsed(text: str, scope: Scope, place: Place) -> Expr:
    return parse(text, scope, place)


def _defined(name: str, scope: Scope, place: Place) -> Expr:
    """What a name in front of `=` stands for: a new name, or the cosine or sine that `c2` is."""
    square = SQUARE.fullmatch(name)
    if square and not scope.has(square["base"]):
        return Power(Symbol(canonical(square["base"])), Fraction(2))
    try:
        found = parse(name, scope, place)
    except DhcliError:
        found = Symbol(name)
    if isinstance(found, Symbol | Trig):
        return found
    raise UnreadableError(f"{name} is no name for a part of the formula")


def _pieces(text: str) -> Iterator[str]:
    """Several values: between commas outside brackets, or with `or` between them."""
    text = text.strip()
    for piece in _OR.split(text[1:-1] if text.startswith("{") and text.endswith("}") else text):
        *before, last = (part for _, part in split(piece))
        yield from before
        if last.strip():
            yield last


def _check_kind(expr: Expr, asked: str, scope: Scope) -> None:
    """Refuse a length for an angle, an angle for a length, and a sum of both; letters may be anything.

    Raises:
        UnreadableError: It is one.
    """
    turns = any(map(scope.is_angle, asked.split("+")))
    if not turns and is_inverse(expr):
        raise UnreadableError(f"this is an angle, and {asked} is a length")
    outside = _without_functions(expr)  # bare numbers in these may be lengths beside others with a unit
    try:
        power = dimension(outside) if has_units(outside) else None
    except DimensionError as error:
        raise UnreadableError(error.message) from None
    wanted, what = (0, "an angle") if turns else (1, "a length")
    if power not in (None, wanted):
        raise UnreadableError(f"by its units this is no {what.split()[1]}, and {asked} is {what}")


def _without_functions(expr: Expr) -> Expr:
    """An expression with a plain angle in the place of each function that stands in it."""
    if isinstance(expr, Call):
        return PI
    if isinstance(expr, Sum):
        return add(*map(_without_functions, expr.terms))
    return multiply(*map(_without_functions, expr.factors)) if isinstance(expr, Product) else expr


def _plain(expr: Expr, unit: Fraction) -> Expr:
    """An expression with its units as numbers: radians, and lengths in a unit of so many metres."""
    for node in walk(expr):
        for term in node.terms if isinstance(node, Sum) else ():
            if isinstance(term, Number) and abs(term.value) in _RIGHT_ANGLES:
                raise UnreadableError(f"what is {abs(term.value)}? write {abs(term.value)}° for degrees, or pi")

    def leaf(node: Expr) -> Expr:
        if not isinstance(node, Unit):
            return node
        if node.name in LENGTH_UNITS:
            return Number(LENGTH_UNITS[node.name] / unit)
        radians = node.name in ("rad", "radian", "radians")
        return number(1) if radians or node.name not in ANGLE_UNITS else multiply(PI, Number(Fraction(1, 180)))

    return rebuild(expr, leaf)
