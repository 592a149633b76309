"""Elementary moves: the atoms that every robot, base, tool and block assembly is made of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TypeAlias

from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.geometry.motion import inverse as undone
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES, Axis, Factor
from dhcli.notation.products import in_order_of_motion, parse_factors
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import PI, ZERO, Expr, Number, Symbol, add, multiply, negate, number
from dhcli.notation.walk import angles_in, substitute, symbols, symbols_in
from dhcli.notation.writer import write, write_angle


@frozen
class Rot:
    """Rotation about an axis of the current frame, positive by the right-hand rule."""

    axis: Axis
    angle: Angle


@frozen
class Trans:
    """Translation along the axes of the current frame [m]."""

    x: Expr
    y: Expr
    z: Expr

    @property
    def offset(self) -> tuple[Expr, Expr, Expr]:
        """The three lengths."""
        return self.x, self.y, self.z


@frozen
class Fixed:
    """A pose given as a matrix: three rows of three direction cosines and a length [m]."""

    rows: tuple[tuple[Expr, Expr, Expr, Expr], ...]


Move: TypeAlias = Rot | Trans | Fixed
Chain: TypeAlias = tuple[Move, ...]
"""Moves from left to right, each in the frame that those before it have reached."""

PLANES: Mapping[Axis, tuple[int, int]] = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}
"""The two coordinates that a rotation mixes, in the order of its positive sense."""


def along(axis: Axis, length: Expr) -> Trans:
    """Translation along one axis."""
    x, y, z = (length if name == axis else ZERO for name in AXES)
    return Trans(x, y, z)


def read_chain(
    text: str, scope: Scope = OPEN, place: Place | None = None, remarks: list[str] | None = None, unit: str = ""
) -> Chain:
    """Read a product of moves such as `Trans(0, 0, l1) * Rot(z, theta1)`.

    Args:
        text: What a person wrote.
        scope: The names it may use.
        place: Where the text stands, for errors.
        remarks: Where to say that 1.5708 rad was taken as 90°; without it such angles are taken as they stand.
        unit: The unit of bare lengths; empty for metres.

    Raises:
        NotationError: With the column and what would be read.
    """
    return tuple(from_factor(factor) for factor in in_order_of_motion(parse_factors(text, scope, place, remarks, unit)))


def from_factor(factor: Factor) -> Move:
    """The move that a factor of a product spells."""
    if factor.kind == "rot":
        move: Move = Rot(factor.axis, factor.angle)
    elif factor.kind == "trans":
        move = Trans(*factor.offset)
    else:
        move = Fixed(tuple((row[0], row[1], row[2], row[3]) for row in factor.rows[:3]))
    return inverse_of(move) if factor.inverse else move


def inverse_of(move: Move) -> Move:
    """The move that undoes another."""
    match move:
        case Rot(axis, angle):
            return Rot(axis, -angle)
        case Trans(x, y, z):
            return Trans(negate(x), negate(y), negate(z))
        case Fixed(rows):
            back = ([ZERO + entry for entry in row] for row in undone(rows))
            return Fixed(tuple((a, b, c, p) for a, b, c, p in back))


def inverse(chain: Chain) -> Chain:
    """The chain that leads back."""
    return tuple(inverse_of(move) for move in reversed(chain))


def substituted(chain: Chain, lengths: Mapping[str, Expr], angles: Mapping[str, Angle]) -> Chain:
    """The same chain with exact values in the place of names; an angle in a length, as a screw has it, in radians."""
    inside = symbols_in(expr for expr in expressions(chain) if type(expr) is not Number)
    lengths = {**{name: in_radians(angles[name]) for name in inside & angles.keys()}, **lengths}

    def put(expr: Expr) -> Expr:
        return substitute(expr, lengths, angles)

    def changed(move: Move) -> Move:
        match move:
            case Rot(axis, angle):
                return Rot(axis, angle.substitute(angles))
            case Trans(x, y, z):
                return Trans(put(x), put(y), put(z))
            case Fixed(rows):
                return Fixed(tuple((put(r[0]), put(r[1]), put(r[2]), put(r[3])) for r in rows))

    return tuple(changed(move) for move in chain)


def in_radians(angle: Angle) -> Expr:
    """An angle as a number of radians, names and π in it."""
    constant = add(multiply(number(Fraction(angle.degrees, 180)), PI), number(angle.radians))
    return add(*(multiply(number(factor), Symbol(name)) for name, factor in angle.terms), constant)


def expressions(chain: Iterable[Move]) -> Iterable[Expr]:
    """Every expression of lengths or direction cosines in a chain."""
    for move in chain:
        if isinstance(move, Trans):
            yield from move.offset
        elif isinstance(move, Fixed):
            for row in move.rows:
                yield from row


def angle_names(chain: Iterable[Move]) -> frozenset[str]:
    """Names that stand inside rotations."""
    return frozenset([name for move in chain if type(move) is Rot for name, _ in move.angle.terms])


def every_angle(chain: Chain) -> frozenset[str]:
    """Names that stand for angles: inside rotations, and inside the cosines and sines of lengths."""
    return angle_names(chain).union(*map(angles_in, expressions(chain)))


def names(chain: Chain) -> frozenset[str]:
    """Every name that a chain needs a value for."""
    return angle_names(chain).union(*[symbols(expr) for expr in expressions(chain) if type(expr) is not Number])


def spelled(move: Move, joints: Joints = THETAS) -> str:
    """A move as it is typed: `Rot(z, theta1)`, `Trans(0, 0, d1)`."""
    if isinstance(move, Rot):
        return f"Rot({move.axis}, {write_angle(move.angle, 'short', joints)})"
    if isinstance(move, Fixed):
        rows = "; ".join(" ".join(write(entry, "short", joints).replace(" ", "") for entry in row) for row in move.rows)
        return f"[{rows}; 0 0 0 1]"
    return "Trans(" + ", ".join(write(length, "short", joints) for length in move.offset) + ")"


def product_text(chain: Chain) -> str:
    """A product of moves as a file spells it; nothing where there is none."""
    return " * ".join(spelled(move) for move in chain)


def sharpened(chain: Chain, remarks: list[str] | None) -> Chain:
    """A chain with the nearest rotations in the place of those that are printed with a few decimals.

    Args:
        chain: The moves; a matrix that is no rotation stays as it is.
        remarks: Where to say so; None leaves the chain as it is.
    """
    if remarks is None:
        return chain
    return tuple(_sharp(move, remarks) if isinstance(move, Fixed) else move for move in chain)


def _sharp(move: Fixed, remarks: list[str]) -> Move:
    from dhcli.geometry.orthonormal import not_a_rotation  # most robots have no literal matrix
    from dhcli.geometry.printed import sharp_rows

    if not_a_rotation(move.rows):
        return move
    rows, remark = sharp_rows(move.rows)
    if not remark:
        return move
    remarks.append(remark)
    return Fixed(tuple((row[0], row[1], row[2], row[3]) for row in rows))
