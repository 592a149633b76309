"""Rotations as people write them, about any axis and by several angles, as turns about coordinate axes and matrices."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Literal, TypeAlias

from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import DimensionError
from dhcli.notation.roots import square_root
from dhcli.notation.tree import HALF, ONE, ZERO, Constant, Expr, Number, Power, Product, Sum, decimal, multiply, power
from dhcli.regex import regex

Axis = Literal["x", "y", "z"]
Rows: TypeAlias = tuple[tuple[Expr, ...], ...]

EULER = regex(r"(?P<fixed>fixed)?[-_ ]?(?P<axes>[xyz]{3})")
EXAMPLES = {
    "rpy": "rpy(10°, 20°, 30°): roll, pitch, yaw",
    "euler": "euler(zyz, 10°, 20°, 30°)",
    "quaternion": "quaternion(w, x, y, z), as quaternion(0.5, 0.5, 0.5, 0.5)",
    "quat": "quat(w, x, y, z), as quat(0.5, 0.5, 0.5, 0.5)",
    "rotvec": "rotvec(0, 0.1 rad, 0.2 rad)",
    "rotation_vector": "rotation_vector(0, 0.1 rad, 0.2 rad)",
}
"""How each rotation by several numbers is written."""

NOT_UNIT = 1e-2
"""How far the length of a quaternion may be from 1: as far as two decimals leave it."""

_SMALL = 6
"""Roots up to that of this number are written as such."""


@frozen
class Turn:
    """A rotation about a coordinate axis."""

    axis: Axis
    angle: Angle


@frozen
class Block:
    """A constant rotation as the four rows of its matrix."""

    rows: Rows


Part: TypeAlias = Turn | Block


def about(axis: Sequence[Expr], angle: Angle) -> tuple[Part, ...]:
    """A rotation about any axis: a matrix that lays z on it, the turn about z, and back.

    Args:
        axis: Three plain numbers, of any length but zero.
        angle: How far; it may hold names.

    Raises:
        DimensionError: The axis is zero, or holds a name.
    """
    x, y, z = (_rational(part, "an axis") for part in axis)
    if not (x or y or z):
        raise DimensionError("an axis of length zero has no direction", "write Rot([1, 2, 2], 40°)")
    if not (y or z):
        return (Turn("x", angle if x > 0 else -angle),)
    if not (x or z):
        return (Turn("y", angle if y > 0 else -angle),)
    if not (x or y):
        return (Turn("z", angle if z > 0 else -angle),)
    across = (-y, x, Fraction(0))
    third = _cross((x, y, z), across)
    typed = any(isinstance(part, Number) and part.places for part in axis)
    columns = [unit(column, typed=typed) for column in (across, third, (x, y, z))]
    rows = [[columns[k][i] for k in range(3)] for i in range(3)]
    return Block(_pose(rows)), Turn("z", angle), Block(_pose(columns))


def by_quaternion(parts: Sequence[Expr]) -> tuple[Part, ...]:
    """A rotation by a unit quaternion w, x, y, z; one rounded to two decimals is made one of length 1.

    Raises:
        DimensionError: Its length is not 1, or it holds a name.
    """
    w, x, y, z = (_rational(part, "a quaternion") for part in parts)
    n = w * w + x * x + y * y + z * z
    if abs(math.sqrt(n) - 1) > NOT_UNIT:
        shown = ", ".join(f"{float(part) / math.sqrt(n):.4g}" for part in (w, x, y, z)) if n else "1, 0, 0, 0"
        raise DimensionError(f"a quaternion has length 1, this one {math.sqrt(n):.4g}", f"write {shown}")
    s = 2 / n
    rows = (
        (1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)),
    )
    return (Block(_pose([[Number(entry) for entry in row] for row in rows])),)


def by_vector(parts: Sequence[Angle]) -> tuple[Part, ...]:
    """A rotation by its vector: the axis times the angle.

    Raises:
        DimensionError: It holds a name, or degrees and radians.
    """
    if any(part.terms for part in parts):
        raise DimensionError("a rotation vector is three constant angles", "write Rot([0, 0, 1], theta1)")
    if any(part.degrees for part in parts) and any(part.radians for part in parts):
        raise DimensionError("a rotation vector is in degrees or in radians", "write all three in one unit")
    in_degrees = any(part.degrees for part in parts)
    sizes = [part.degrees if in_degrees else part.radians for part in parts]
    square = sum((size * size for size in sizes), Fraction(0))
    if not square:
        return (Turn("z", Angle()),)
    exact = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
    size = exact if exact * exact == square else Fraction(repr(math.sqrt(square)))
    angle = Angle(degrees=size) if in_degrees else Angle(radians=size)
    return about([Number(part) for part in sizes], angle)


def in_order(word: str, angles: Sequence[Angle]) -> tuple[Part, ...]:
    """Three turns about current axes, such as `zyz`, or about fixed ones, `fixed xyz`.

    Raises:
        DimensionError: There is no such order.
    """
    found = EULER.fullmatch(word.strip().lower())
    axes = found["axes"] if found else ""
    if not found or axes[0] == axes[1] or axes[1] == axes[2]:
        raise DimensionError(f"{word} is no order of three axes", "write zyz, xyz or fixed xyz")
    named: dict[str, Axis] = {"x": "x", "y": "y", "z": "z"}
    turns = tuple(Turn(named[axis], angle) for axis, angle in zip(axes, angles, strict=True))
    return turns[::-1] if found["fixed"] else turns


def _rational(expr: Expr, what: str) -> Fraction:
    """A plain number; a root as the nearest float."""
    if isinstance(expr, Number):
        return Fraction(expr.value)
    try:
        return Fraction(repr(_float(expr)))
    except (TypeError, ValueError, OverflowError):
        raise DimensionError(
            f"{what} is made of plain numbers, not {expr}", "put values in the place of names"
        ) from None


def _float(expr: Expr) -> float:
    """The value of roots and fractions.

    Raises:
        TypeError: A name stands in it.
    """
    read: Callable[[Expr], float] = _float
    match expr:
        case Number(value):
            return float(value)
        case Constant():
            return math.pi
        case Sum(terms):
            return sum(map(read, terms))
        case Product(factors):
            return math.prod(map(read, factors))
        case Power(base, exponent):
            return math.pow(read(base), exponent)
    raise TypeError(expr)


def unit(vector: Sequence[Fraction], *, typed: bool = False) -> list[Expr]:
    """A vector divided by its length.

    Args:
        vector: Three numbers, not all zero.
        typed: Whether it was typed in decimals: then its parts are decimals too, exact ones or roots of small numbers,
            and else the nearest float.
    """
    square = sum((part * part for part in vector), Fraction(0))
    return [_share(part, square, typed=typed) for part in vector]


def _share(part: Fraction, square: Fraction, *, typed: bool) -> Expr:
    """A number divided by the root of another."""
    outside, inside = square_root(part * part / square)
    outside = -outside if part < 0 else outside
    if typed and inside > _SMALL:
        return decimal(Fraction(repr(float(part) / math.sqrt(square))))
    rational = decimal(outside) if typed and inside == 1 else Number(outside)
    return multiply(rational, power(Number(Fraction(inside)), HALF))


def _cross(a: Sequence[Fraction], b: Sequence[Fraction]) -> tuple[Fraction, Fraction, Fraction]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _pose(rows: Sequence[Sequence[Expr]]) -> Rows:
    return (*((*row, ZERO) for row in rows), (ZERO, ZERO, ZERO, ONE))
