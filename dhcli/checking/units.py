"""The unit of a sheet: it belongs to bare lengths; directions, orientations, angles and plain numbers have none.

In symbols a letter is a length as it stands, and only the numbers beside it are in the unit of the sheet: on a sheet
in millimetres `10*c1 + a1*s1` is 0.01*c1 + a1*s1 in metres. A text that writes its unit is believed.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from dhcli.errors import NotationError, Place, Problem
from dhcli.kinematics.conventions import Row
from dhcli.kinematics.moves import Chain, Fixed, Move, Trans, from_factor
from dhcli.kinematics.ranges import units_in
from dhcli.kinematics.robot import Robot
from dhcli.notation.products import parse_factors
from dhcli.notation.quantity import LENGTH_UNITS, DimensionError
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Number, Power, Product, Sum, Symbol, Unit, add, multiply, places_of, power
from dhcli.notation.walk import walk

ONE = Fraction(1)
MOST_PLACES = 12
MOST_POWER = 64
"""Of a length, below roots: no formula of an arm has more."""


def degree(expr: Expr, scope: Scope) -> Fraction:
    """The power of a length that an expression is: 1 for a length, 0 for an angle or a plain number."""
    if isinstance(expr, Symbol):
        return Fraction(_is_length(expr.name, scope))
    if isinstance(expr, Unit):
        return Fraction(expr.name in LENGTH_UNITS)
    if isinstance(expr, Sum):
        return max(degree(term, scope) for term in expr.terms)
    if isinstance(expr, Product):
        return sum((degree(factor, scope) for factor in expr.factors), Fraction(0))
    if isinstance(expr, Power):
        return degree(expr.base, scope) * expr.exponent
    return Fraction(0)


def is_measure(expr: Expr, scope: Scope) -> bool:
    """Whether an expression is a length."""
    return degree(expr, scope) == 1


def is_homogeneous(expr: Expr, scope: Scope) -> bool:
    """Whether only likes are added in an expression: lengths to lengths, numbers to numbers."""
    if isinstance(expr, Sum):
        alike = len({degree(term, scope) for term in expr.terms}) == 1
        return alike and all(is_homogeneous(term, scope) for term in expr.terms)
    if isinstance(expr, Product):
        return all(is_homogeneous(factor, scope) for factor in expr.factors)
    return not isinstance(expr, Power) or is_homogeneous(expr.base, scope)


def has_length_unit(expr: Expr) -> bool:
    """Whether a unit of length stands somewhere in an expression."""
    return any(isinstance(node, Unit) and node.name in LENGTH_UNITS for node in walk(expr))


def length_in_metres(expr: Expr, unit: Fraction, scope: Scope) -> Expr:
    """A length of a sheet with its bare numbers in metres; letters, and what has its own unit, stay.

    Args:
        expr: The length, units as they were written.
        unit: Metres in a bare length of the sheet.
        scope: Says which names are angles.

    Raises:
        DimensionError: A number in it becomes too large or too small to compute with.
    """
    if unit == 1:
        return expr
    try:
        return _scaled(expr, unit, scope, ONE)
    except (OverflowError, ZeroDivisionError):
        raise DimensionError("the number becomes too large or too small", "write it in another unit") from None


def on_sheet(expr: Expr, unit: Fraction, scope: Scope) -> Expr:
    """A length in metres as it is written on a sheet, where its bare numbers are in another unit."""
    try:
        return length_in_metres(expr, 1 / unit, scope)
    except DimensionError:  # nobody types that
        return expr


def chain_in_metres(text: str, unit: Fraction, scope: Scope, place: Place | None = None) -> Chain:
    """Moves whose bare lengths are in a unit; a move that writes a unit anywhere is taken as it stands.

    Raises:
        NotationError: They cannot be read.
    """
    chain = []
    for factor in parse_factors(text, scope, place):
        move = from_factor(factor)
        own = any(name in LENGTH_UNITS for name in units_in(factor.text))
        try:
            chain.append(move if own else move_in_metres(move, unit, scope))
        except DimensionError as error:
            raise NotationError(Problem(f"{factor.text:.60}: {error.message}", place, error.hint)) from None
    return tuple(chain)


def move_in_metres(move: Move, unit: Fraction, scope: Scope) -> Move:
    """A move with its bare lengths in metres; the fourth column of a matrix is lengths."""
    if isinstance(move, Trans):
        return Trans(*(length_in_metres(length, unit, scope) for length in move.offset))
    if isinstance(move, Fixed):
        rows = ((row[0], row[1], row[2], length_in_metres(row[3], unit, scope)) for row in move.rows)
        return Fixed(tuple(rows))
    return move


def in_unit(robot: Robot, unit: Fraction) -> Robot:
    """A robot in metres as it is where all lengths are numbers of another unit; letters stay letters."""
    if unit == 1:
        return robot

    def moved(chain: Chain) -> Chain:
        return tuple(move_in_metres(move, 1 / unit, robot.scope) for move in chain)

    def row(old: Row) -> Row:
        a, d = (length_in_metres(length, 1 / unit, robot.scope) for length in (old.a, old.d))
        return replace(old, a=a, d=d)

    links = tuple(replace(one, moves=moved(one.moves), row=one.row and row(one.row)) for one in robot.links)
    return replace(robot, links=links, base=moved(robot.base), tool=moved(robot.tool))


def _scaled(expr: Expr, unit: Fraction, scope: Scope, power_of: Fraction) -> Expr:
    """What has a letter or a unit stays; of a product its brackets are scaled, of a root what stands below it."""
    if isinstance(expr, Sum):
        return add(*(_scaled(term, unit, scope, power_of) for term in expr.terms))
    if isinstance(expr, Power) and _is_measured(expr.base, scope):
        return power(_scaled(expr.base, unit, scope, power_of / expr.exponent), expr.exponent)
    if isinstance(expr, Product):
        powers = [degree(factor, scope) for factor in expr.factors]
        if any(powers):
            pairs = zip(expr.factors, powers, strict=True)
            scaled = (_scaled(factor, unit, scope, of) if of else factor for factor, of in pairs)
            return _times(multiply(*scaled), unit, max(power_of - sum(powers), Fraction(0)))
    return expr if _is_measured(expr, scope) else _times(expr, unit, power_of)


def _times(expr: Expr, unit: Fraction, power_of: Fraction) -> Expr:
    """An expression times a power of a unit, if that is a power anybody has use for."""
    if not power_of or power_of.denominator != 1 or abs(power_of) > MOST_POWER:
        return expr
    factor = unit ** int(power_of)
    return multiply(Number(factor, _places(factor)), expr)


def _places(factor: Fraction) -> int:
    """Decimal places of a factor, so that those of a number that is multiplied by it are still known."""
    places = places_of(factor, MOST_PLACES)
    return MOST_PLACES if places is None else places


def _is_measured(expr: Expr, scope: Scope) -> bool:
    """Whether a letter that is a length, or a unit, stands in an expression; inside an angle there is none."""
    return any(
        (isinstance(node, Symbol) and _is_length(node.name, scope))
        or (isinstance(node, Unit) and node.name in LENGTH_UNITS)
        for node in walk(expr)
    )


def _is_length(name: str, scope: Scope) -> bool:
    """Whether a letter is a length; an angle is none, nor is the rate dtheta1 of the angle theta1."""
    return not scope.is_angle(name) and not (name.startswith("d") and scope.is_angle(name[1:]))
