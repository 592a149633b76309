"""Mistakes in a single value: an angle, a length or a number that is computed from an expression."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias

from dhcli.checking.diagnosis.mistakes.changes import CALCULATOR, OFFSETS, scale_of
from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.terms import flipped, pieces, shown
from dhcli.checking.diagnosis.work import Setting
from dhcli.checking.exercise import Exercise
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import has_angle_unit
from dhcli.notation.tree import ZERO, Expr, Trig, Unit, add, multiply, negate, number
from dhcli.notation.trig import swapped
from dhcli.notation.walk import rebuild, substitute, symbols, walk

ValueMaker: TypeAlias = Callable[[Expr, Exercise], Iterator[tuple[str, Expr]]]


IN_VALUES: Catalogue[ValueMaker] = Catalogue()
"""In the order in which they are tried and named."""


@IN_VALUES("value-sign", "the sign of the whole value is turned round", "look at the sign")
def sign(expr: Expr, _exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """The other sign."""
    yield "", negate(expr)


@IN_VALUES("term-sign", "the sign of {where} is turned round", "look at the signs of the terms")
def term_sign(expr: Expr, exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """One term of a sum with the other sign."""
    for term, changed in flipped(expr):
        yield _shown(term, exercise), changed


@IN_VALUES("term-forgotten", "{where} is left out", "count the terms")
def term_forgotten(expr: Expr, exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """One term of a sum left out, wherever the sum stands."""
    for piece in pieces(expr):
        yield _shown(piece.term, exercise), piece.put(ZERO)


@IN_VALUES(
    "sin-cos", "sine and cosine have changed places", "look at sine and cosine: from which axis is the angle measured?"
)
def sine_cosine(expr: Expr, exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """Sine for cosine; of an angle that was asked itself, the complement."""
    if any(isinstance(node, Trig) for node in walk(expr)):
        yield "", rebuild(expr, swapped)
    elif _is_angle(expr, exercise):
        yield "", add(_degrees(90), negate(expr))


@IN_VALUES(
    "angle-unit",
    "an angle is taken in the wrong unit, degrees for radians or the other way round",
    CALCULATOR,
)
def angle_unit(expr: Expr, exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """Every given angle with its number in the other unit, as on a calculator in the wrong mode."""
    if exercise.numeric and any(isinstance(node, Trig) for node in walk(expr)):
        angles = {name: value for name, value in exercise.given.items() if isinstance(value, Angle)}
        in_other = {name: Angle(degrees=value.radians, radians=value.degrees) for name, value in angles.items()}
        yield "", substitute(expr, {}, in_other)


@IN_VALUES("in-mm", "the unit is another, mm for m", "look at the unit of the sheet")
def other_unit(expr: Expr, exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """Millimetres on a sheet in metres, or the other way round."""
    unit = exercise.metres if exercise.unit != "none" else exercise.metres * 0
    factor = scale_of(Setting(numeric=exercise.numeric, unit=unit))
    lengths = [name for name in symbols(expr) if not exercise.scope.is_angle(name)]
    has_length = bool(lengths) or any(isinstance(node, Unit) for node in walk(expr))
    if factor is not None and has_length and not _is_angle(expr, exercise):
        yield "", multiply(factor, expr)


@IN_VALUES("turned", "the angle is off by {where}", "from which axis is the angle measured?")
def turned(expr: Expr, exercise: Exercise) -> Iterator[tuple[str, Expr]]:
    """An angle measured from another axis."""
    if _is_angle(expr, exercise):
        for degrees in OFFSETS:
            yield f"{degrees}°", add(expr, _degrees(degrees))


def _shown(term: Expr, exercise: Exercise) -> str:
    return shown(term, exercise.writing).replace("*deg", "°")


def _is_angle(expr: Expr, exercise: Exercise) -> bool:
    """Whether an expression is an angle by its units or its names."""
    if any(isinstance(node, Trig) for node in walk(expr)):
        return False
    inside = symbols(expr)
    return has_angle_unit(expr) or (bool(inside) and all(exercise.scope.is_angle(name) for name in inside))


def _degrees(value: int) -> Expr:
    return multiply(number(value), Unit("deg"))
