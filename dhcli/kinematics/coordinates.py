"""Points and matrices as a caller gives them: coordinates as floats or expressions, rows as tuples."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from dhcli.errors import NotationError, RobotError
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_length
from dhcli.notation.scope import OPEN
from dhcli.notation.tree import Expr, number


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
            try:
                found.append(to_length(parse(coordinate, OPEN)))
            except DimensionError as error:
                raise NotationError(error.message, error.hint) from None
        else:
            try:
                found.append(number(Fraction(repr(float(coordinate)))))
            except (TypeError, ValueError):
                raise RobotError(f"{coordinate!r} is no coordinate", 'write 0.1 or "a6"') from None
    return found


def float_coordinates(point: Iterable[Any]) -> list[float]:
    """Coordinates for a pose in numbers [m]."""
    try:
        return [float(coordinate) for coordinate in point]
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
