"""A tape: the fold is run once over numbers that note what is done with them, and can then be played over columns.

Joint values are not known while the tape is recorded, all else is. So what does not depend on a joint is a float before
the first pose, and a step that was noted before is not noted again: the cosine of theta2 + theta3 is taken once, and so
is every product that two entries share. No step changes a sign: a cell carries its sign along, and a sum of two signs
is a difference.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TypeAlias

from dhcli.algebra.arithmetic import evaluate, plus, times
from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.tree import Expr

UFUNCS = {"acos": "arccos", "asin": "arcsin", "atan": "arctan", "atan2": "arctan2"}
"""What numpy calls the functions that it calls by other names than notation."""


@frozen
class Column:
    """A column of numbers by its place: first those of the variables, then one for each step."""

    place: int


@frozen
class Operation:
    """One operation on whole columns.

    Attributes:
        ufunc: Its name in numpy.
        operands: One or two, columns or constants.
    """

    ufunc: str
    operands: tuple[Column | float, ...]

    @property
    def columns(self) -> list[Column]:
        """The operands that are columns."""
        return [operand for operand in self.operands if isinstance(operand, Column)]


@frozen
class Cell:
    """A number that depends on the joint values: a column of the tape, perhaps with its sign turned."""

    tape: Tape
    column: Column
    negative: bool = False

    def __neg__(self) -> Cell:
        """The other sign, without a step."""
        return Cell(self.tape, self.column, not self.negative)

    def __mul__(self, other: Cell | float) -> Cell:
        """A product."""
        operand, negative = _magnitude(other)
        return self.tape.step("multiply", *_in_order(self.column, operand), negative=self.negative != negative)

    __rmul__ = __mul__

    def __add__(self, other: Cell | float) -> Cell:
        """A sum; a difference where the signs differ."""
        operand, negative = _magnitude(other)
        if self.negative == negative:
            return self.tape.step("add", *_in_order(self.column, operand), negative=negative)
        first, second = (operand, self.column) if self.negative else (self.column, operand)
        return self.tape.step("subtract", first, second)

    __radd__ = __add__


Number: TypeAlias = Cell | float


def _magnitude(number: Number) -> tuple[Column | float, bool]:
    """A number without its sign, and whether it has one."""
    if isinstance(number, Cell):
        return number.column, number.negative
    return float(abs(number)), number < 0  # a structural integer is a constant too


def _in_order(a: Column, b: Column | float) -> tuple[Column | float, ...]:
    """Two operands in an order that does not depend on which came first, constants last."""
    return (a, b) if not isinstance(b, Column) or a.place < b.place else (b, a)


class Tape:
    """An arithmetic that computes with what is known, and notes what is to be done once the joints are."""

    def __init__(
        self, variables: Sequence[str], values: Mapping[str, Angle | float] | None = None, *, tangents: bool = False
    ) -> None:
        """Begin a tape.

        Args:
            variables: Names whose columns come later; they are the columns 0, 1, ...
            values: Values of the other names: exact angles, radians, metres.
            tangents: Whether a cosine and a sine are noted as what follows from the tangent of half their angle.
        """
        self._tangents = tangents
        self.variables = {name: Cell(self, Column(k)) for k, name in enumerate(variables)}
        self.steps: dict[Operation, Column] = {}
        self._known = Floats(values)
        self._angles = {name: value for name, value in (values or {}).items() if isinstance(value, Angle)}

    def step(self, ufunc: str, *operands: Column | float, negative: bool = False) -> Cell:
        """The column that an operation gives, noted unless it was before."""
        following = Column(len(self.variables) + len(self.steps))
        return Cell(self, self.steps.setdefault(Operation(ufunc, operands), following), negative)

    def cos_sin(self, angle: Angle) -> tuple[Number | int, Number | int]:
        """Cosine and sine; right angles in it are carried out as swaps and signs, before any number is rounded."""
        angle = angle.substitute(self._angles)
        quarters = round(Fraction(angle.degrees, 90))
        rest = angle - Angle.in_degrees(90 * quarters)
        turning = self._half(rest) if self._tangents else self._whole(rest)
        if turning is None:
            return self._known.cos_sin(angle)
        cos, sin = turning
        for _ in range(quarters % 4):
            cos, sin = -sin, cos
        return cos, sin

    def _whole(self, angle: Angle) -> tuple[Number, Number] | None:
        """Cosine and sine, one step each; None where no joint turns it."""
        whole = self._scaled(angle, 1)
        if not isinstance(whole, Cell):
            return None
        return self.step("cos", whole.column), self.step("sin", whole.column, negative=whole.negative)

    def _half(self, angle: Angle) -> tuple[Number, Number] | None:
        """Cosine and sine, by t = tan(angle/2): (1 - t²)/(1 + t²) and 2t/(1 + t²).

        One tangent and five cheap steps in the place of a cosine and a sine: where numpy's tangent is vectorised, which
        its sine and cosine in double precision are not, that is five times as fast, elsewhere about as fast. A relative
        error e of t turns the angle by e·sin(angle) only, so that a tangent beyond all measure near 180° does no harm.
        """
        half = self._scaled(angle, Fraction(1, 2))
        if not isinstance(half, Cell):
            return None
        tangent = self.step("tan", half.column, negative=half.negative)
        ratio = self.step("divide", 2.0, (tangent * tangent + 1.0).column)
        return ratio + -1.0, tangent * ratio

    def _scaled(self, angle: Angle, scale: Rational) -> Number | int:
        """A multiple of an angle [rad]."""
        total: Number | int = angle.constant() * float(scale) or 0
        for name, factor in angle.terms:
            share = factor * scale
            total = plus(total, times(int(share) if share in (1, -1) else float(share), self.symbol(name)))
        return total

    def length(self, expr: Expr) -> Number | int:
        """Value of an expression of lengths [m]."""
        return evaluate(expr, self)

    def constant(self, value: int) -> Number:
        """0.0, 1.0 or -1.0."""
        return float(value)

    def number(self, value: Rational) -> Number:
        """The nearest float."""
        return float(value)

    def symbol(self, name: str) -> Number:
        """A joint's column, or the value of a name that is known."""
        return self.variables.get(name) or self._known.symbol(name)

    def pi(self) -> Number:
        """3.14159..."""
        return self._known.pi()

    def power(self, base: Number, exponent: Rational) -> Number:
        """A power; NaN where it is not real."""
        if not isinstance(base, Cell):
            return self._known.power(base, exponent)
        return self.step("power", self.plain(base), float(exponent))

    def call(self, function: str, arguments: list[Number]) -> Number:
        """A function; NaN where it is not defined."""
        known = [argument for argument in arguments if not isinstance(argument, Cell)]
        if len(known) == len(arguments):
            return self._known.call(function, known)
        return self.step(UFUNCS.get(function, function), *map(self.plain, arguments))

    def plain(self, number: Number) -> Column | float:
        """What a step takes that cannot carry a sign: a constant, or a column that holds the number itself."""
        return self.column(number) if isinstance(number, Cell) else number

    def column(self, cell: Cell) -> Column:
        """A column that holds a number with its sign."""
        return self.step("negative", cell.column).column if cell.negative else cell.column
