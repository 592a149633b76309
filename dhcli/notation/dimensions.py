"""Which power of a length an expression is, so that an area or a bare ratio is not read as a length.

A name may stand for a length or for a plain number, and so has no dimension of its own; units, cosines and numbers
have. A number without a unit is a plain number beside one with a unit, whatever it is where no unit stands.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import ParamSpec, TypeVar

from dhcli.errors import NotationError, Place, Problem
from dhcli.notation.angle import Rational
from dhcli.notation.tree import Call, Constant, Expr, Number, Power, Product, Sum, Symbol, Trig, Unit
from dhcli.notation.walk import rebuild, walk

P = ParamSpec("P")
R = TypeVar("R")

LENGTH_UNITS = {
    "mm": Fraction(1, 1000),
    "cm": Fraction(1, 100),
    "m": Fraction(1),
    "in": Fraction(254, 10000),
    "inch": Fraction(254, 10000),
}
"""Metres in each unit of length."""

RADIANS = frozenset(("rad", "radian", "radians"))
ANGLE_UNITS = RADIANS | {"deg", "degree", "degrees", "°"}
UNITS = ANGLE_UNITS | LENGTH_UNITS.keys()

_OTHER_WORDS = {
    "mm": ("millimeter", "millimeters", "millimetre", "millimetres", "millimètre", "millimètres"),
    "cm": ("centimeter", "centimeters", "centimetre", "centimetres", "zentimeter"),
    "m": ("meter", "meters", "metre", "metres", "mètre", "mètres", "metro", "metri"),
    "in": ("inches", "zoll"),
    "°": ("grad", "degré", "degrés", "grados", "gradi", "o"),
}


def unit_meant(word: str) -> str:
    """The unit that a word means which is none that is read, such as millimetres; empty if it means none."""
    return next((unit for unit, words in _OTHER_WORDS.items() if word.lower() in words), "")


INVERSE = frozenset(("acos", "asin", "atan", "atan2"))
"""Functions whose value is an angle."""

_NUMBER: Rational = 0
_LENGTH: Rational = 1


class DimensionError(ValueError):
    """An expression that is not the kind of quantity wanted; carries a message and a hint."""

    def __init__(self, message: str, hint: str = "") -> None:
        """Say what is wrong, and what would be right."""
        super().__init__(message)
        self.message = message
        self.hint = hint


def read_at(place: Place | None, read: Callable[P, R], *given: P.args, **named: P.kwargs) -> R:
    """What a function such as `to_length` reads, at a place in a text.

    Raises:
        NotationError: It is of another kind than is wanted.
    """
    try:
        return read(*given, **named)
    except DimensionError as error:
        raise NotationError(Problem(error.message, place, error.hint)) from None


def dimension(expr: Expr) -> Rational | None:
    """The power of a length that an expression is: 1 for a length, 0 for a number, None where names leave it open.

    Raises:
        DimensionError: A sum of what cannot be added, such as a length and a number; or a function of a length.
    """
    if isinstance(expr, Symbol) or (isinstance(expr, Number) and not expr.value):
        return None  # a name is anything, and 0 is 0 in any unit
    if isinstance(expr, Number | Constant | Trig):
        return _NUMBER
    if isinstance(expr, Unit):
        return _LENGTH if expr.name in LENGTH_UNITS else _NUMBER
    if isinstance(expr, Power):
        base = dimension(expr.base)
        return None if base is None else base * expr.exponent
    if isinstance(expr, Product):
        parts = [dimension(factor) for factor in expr.factors]
        known = [part for part in parts if part is not None]
        return sum(known, _NUMBER) if len(known) == len(parts) else None
    if isinstance(expr, Sum):
        return _common([(term, dimension(term)) for term in expr.terms])
    assert isinstance(expr, Call)  # noqa: S101  there is no other kind of node
    return _of_call(expr)


def check_is(expr: Expr, wanted: Rational) -> None:
    """Make sure that an expression in which units stand is what is wanted.

    Raises:
        DimensionError: It is an area, the units cancel, or what is added cannot be.
    """
    found = dimension(expr)
    if found is None or found == wanted:
        return
    if wanted == _NUMBER:
        raise DimensionError(f"this is {_called(found)}, a number is wanted", "leave the unit out")
    hints: dict[Rational, str] = {1: "write 0.4 m or 400 mm", 2: "write 0.4 m^2"}
    hint = hints.get(wanted, "write 0.4 m^3")
    if found == _NUMBER:
        raise DimensionError(f"the units cancel, and {_called(wanted)} is wanted", hint)
    raise DimensionError(f"this is {_called(found)}, {_called(wanted)} is wanted", hint)


def has_units(expr: Expr) -> bool:
    """Whether a unit stands anywhere in an expression."""
    return any(isinstance(node, Unit) for node in walk(expr))


def is_inverse(expr: Expr) -> bool:
    """Whether an expression is an angle by an inverse function, or a multiple of one, or a sum that holds one."""
    if isinstance(expr, Sum):
        return any(map(is_inverse, expr.terms))
    if isinstance(expr, Product):
        rest = [factor for factor in expr.factors if not isinstance(factor, Number)]
        return len(rest) == 1 and is_inverse(rest[0])
    return isinstance(expr, Call) and expr.function in INVERSE


def in_metres(expr: Expr) -> Expr:
    """An expression with metres in the place of units of length.

    Raises:
        DimensionError: A number in it becomes too large or too small to compute with.
    """
    if not has_units(expr):
        return expr
    try:
        return rebuild(expr, _metres)
    except (OverflowError, ZeroDivisionError):
        raise DimensionError("the number becomes too large or too small", "write it in another unit") from None


def _metres(node: Expr) -> Expr:
    if not isinstance(node, Unit) or node.name not in LENGTH_UNITS:
        return node
    factor = LENGTH_UNITS[node.name]
    places = {"mm": 3, "cm": 2, "m": 0}.get(node.name, 4)
    return Number(factor, places)


def _common(terms: list[tuple[Expr, Rational | None]]) -> Rational | None:
    """The dimension that all terms of a sum have."""
    known = [(term, part) for term, part in terms if part is not None]
    if not known:
        return None
    for term, part in known[1:]:
        if part != known[0][1]:
            first, second = known[0], (term, part)
            if _LENGTH in (first[1], second[1]) and (bare := next((t for t, _ in known if type(t) is Number), None)):
                raise DimensionError(f"{bare} has no unit beside a length that has one", f"write {bare} m or {bare} mm")
            message = f"{_called(first[1])} and {_called(second[1])} cannot be added"
            raise DimensionError(message, "each term of a length is a length")
    return known[0][1]


def _of_call(expr: Call) -> Rational | None:
    parts = [dimension(argument) for argument in expr.arguments]
    if expr.function == "atan2":
        _common(list(zip(expr.arguments, parts, strict=True)))
    elif parts[0] not in (None, _NUMBER):
        raise DimensionError(f"{expr.function} takes a number, and not {_called(parts[0])}", "divide by another length")
    return _NUMBER


def _called(power: Rational | None) -> str:
    names: dict[Rational, str] = {0: "a number", 1: "a length", 2: "an area", 3: "a volume"}
    return names.get(power or 0, f"a length to the power {power}")
