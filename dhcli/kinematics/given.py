"""What a caller may give for the parts of a robot, for points and matrices: taken as what it plainly means, or refused.

A file has its own reader, which knows where everything stands; here a program gives text for moves, a float for a
length, a list for a tuple.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction
from numbers import Complex, Real
from typing import Any

from dhcli.errors import Place, RobotError
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans, read_chain
from dhcli.notation.angle import Angle
from dhcli.notation.dimensions import read_at
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.tree import ONE, ZERO, Expr, Number, number

_A_CHAIN = 'write "Trans(0, 0, l3) Rot(x, 90°)", or give a matrix of shape (4, 4), or Rot, Trans and Fixed moves'
_A_VALUE = 'write 0.4, "400 mm", "90°", or None for one that stays open'


def chain_of(given: object, part: str) -> Chain:
    """Moves, or a text that spells them, or a pose or its matrix, which is one move.

    Args:
        given: What the caller gave.
        part: What to call it in a message: `tool`, `base`.

    Raises:
        RobotError: It is none of them; whether the first three columns of a matrix are a rotation is not asked here.
        NotationError: The text cannot be read, with the column.
    """
    if isinstance(given, str):
        return read_chain(given, place=Place(part, text=given)) if given.strip() else ()
    if isinstance(given, Rot | Trans | Fixed):
        return (given,)
    moves: list[Move] = []
    parts = tuple_of(getattr(given, "rows", given), part, _A_CHAIN)
    if parts and all(isinstance(each, Iterable) and not isinstance(each, str) for each in parts):
        return (_fixed(parts, part),)
    for move in parts:
        if not isinstance(move, Rot | Trans | Fixed):
            raise RobotError(f"{part}: {_shown(move)} is no move", _A_CHAIN)
        moves.append(move)
    return tuple(moves)


def _fixed(rows: tuple[object, ...], part: str) -> Fixed:
    """The move that a matrix is.

    Raises:
        RobotError: It is no matrix of a pose.
    """
    entries = [tuple_of(row, part, _A_CHAIN) for row in rows]
    if [*map(len, entries)] != [4] * 4:
        raise RobotError(f"{part}: a pose is a matrix of shape (4, 4)", _A_CHAIN)
    found = [[value_of(entry, part, is_angle=False) for entry in row] for row in entries]
    if found[3] != [ZERO, ZERO, ZERO, ONE]:
        raise RobotError(f"{part}: the last row of a pose is 0 0 0 1", "see that rows and columns are not exchanged")
    return Fixed(tuple((row[0], row[1], row[2], row[3]) for row in found[:3]))  # type: ignore[misc]


def text_of(given: object, part: str, hint: str = "") -> str:
    """A text.

    Raises:
        RobotError: It is none.
    """
    if not isinstance(given, str):
        raise RobotError(f"{part}: {_shown(given)} is no text", hint)
    return given


def texts_of(given: object, part: str, hint: str) -> tuple[str, ...]:
    """A list of texts.

    Raises:
        RobotError: It is no list, or one of them is no text.
    """
    return tuple(text_of(each, part, hint) for each in tuple_of(given, part, hint))


def tuple_of(given: object, part: str, hint: str) -> tuple[object, ...]:
    """A list of something.

    Raises:
        RobotError: It is none; a text is one thing, and not its letters.
    """
    if isinstance(given, str | bytes | Mapping) or not isinstance(given, Iterable):
        raise RobotError(f"{part}: {_shown(given)} is no list", hint)
    return tuple(given)


def mapping_of(given: object, part: str) -> Mapping[str, Any]:
    """Something by name.

    Raises:
        RobotError: It is no mapping, or a key is no text.
    """
    if not isinstance(given, Mapping):
        raise RobotError(f"{part}: {_shown(given)} is no mapping of names", 'write {"a1": 0.4}')
    for key in given:
        if not isinstance(key, str):
            raise RobotError(f"{part}: {_shown(key)} is no name", 'write {"a1": 0.4}')
    return given


def real(given: Any) -> float:  # noqa: ANN401  whatever a program gives
    """A real number as Python's.

    Raises:
        TypeError, ValueError: It is none; of a complex one of numpy's `float` takes the real part, and warns.
        OverflowError: It is beyond what a float holds.
    """
    if isinstance(given, Complex) and not isinstance(given, Real):
        raise TypeError
    return float(given)


def value_of(given: object, name: str, *, is_angle: bool) -> Angle | Expr:
    """An angle or a length, a text with its unit, or a number: radians or metres.

    Raises:
        RobotError: It is none of them, or not finite.
        NotationError: The text cannot be read, with the column.
    """
    if isinstance(given, Angle | Expr):
        return given
    if isinstance(given, str):
        try:
            expr = parse(given, Scope(), Place(name, text=given))
            return to_angle(expr, bare="refuse") if is_angle else to_length(expr)
        except DimensionError as error:
            raise RobotError(f"{name}: {error.message}", error.hint) from None
    try:
        number = real(given)
    except (TypeError, ValueError, OverflowError):
        raise RobotError(f"{name}: {_shown(given)} is no value", _A_VALUE) from None
    if not math.isfinite(number):
        raise RobotError(f"{name}: {number} is no value", _A_VALUE)
    exact = Fraction(repr(number))  # 0.1 is a tenth, as it was typed, and not the binary fraction nearest to it
    if is_angle:
        return Angle(radians=exact)
    return Number(exact, None if exact.denominator == 1 else exact.denominator.bit_length() - 1)


def _shown(given: object) -> str:
    return f"{given!r:.60}"


def coordinates(point: Iterable[Any]) -> list[Expr]:
    """Coordinates as expressions: of numbers as they are typed [m], and of text with any names, `"a6"` or `"30mm"`.

    Raises:
        RobotError: One is neither, or the point is no list of them.
        NotationError: A text cannot be read, or is no length.
    """
    found: list[Expr] = []
    if not isinstance(point, Iterable):
        raise RobotError(f"a point has three coordinates, and {point!r:.60} has none", "write (0, 0, 0.1)")
    for coordinate in point:
        if isinstance(coordinate, Expr):
            found.append(coordinate)
        elif isinstance(coordinate, str):
            found.append(read_at(None, to_length, parse(coordinate, OPEN)))
        else:
            try:
                found.append(number(Fraction(repr(real(coordinate)))))
            except (TypeError, ValueError):
                raise RobotError(f"{coordinate!r} is no coordinate", 'write 0.1 or "a6"') from None
    return found


def three_coordinates(point: Iterable[Any]) -> tuple[Expr, Expr, Expr]:
    """The coordinates of a point.

    Raises:
        RobotError: They are not three, or one is no number.
        NotationError: A text cannot be read, or is no length.
    """
    found = coordinates(point)
    if len(found) != 3:  # noqa: PLR2004
        raise RobotError(f"a point has three coordinates, not {len(found)}")
    return found[0], found[1], found[2]


def float_coordinates(point: Iterable[Any]) -> list[float]:
    """Coordinates for a pose in numbers [m]."""
    try:
        return [*map(real, point)]
    except (TypeError, ValueError):
        raise RobotError(f"a point of a pose in numbers has three numbers [m], not {tuple(point)}") from None


def are_floats(given: object) -> bool:
    """Whether something is four tuples of four floats, as most poses are: the checks of `rows_of` in one glance."""
    if type(given) is not tuple or list(map(type, given)) != [tuple] * 4 or list(map(len, given)) != [4] * 4:
        return False
    first, second, third, fourth = given
    return {*map(type, first + second + third + fourth)} == {float}


def rows_of(given: object) -> tuple[tuple[Any, ...], ...]:
    """The entries of a matrix as tuples.

    Raises:
        RobotError: It is none.
    """
    hint = "four rows of four numbers or expressions, the last row 0 0 0 1"
    try:
        rows = tuple(map(tuple, given))  # type: ignore[call-overload]
    except TypeError:
        raise RobotError(f"a pose is a 4x4 matrix, and {given!r:.60} is none", hint) from None
    if [len(row) for row in rows] != [4] * 4:
        raise RobotError(f"a pose is a 4x4 matrix, and {given!r:.60} is none", hint)
    for entry in (entry for row in rows for entry in row):
        if not isinstance(entry, int | float | Expr) and not hasattr(entry, "__float__"):
            raise RobotError(f"a pose has numbers or expressions in it, and {entry!r:.60} is neither", hint)
    return rows
