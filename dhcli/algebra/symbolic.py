"""The bridge to sympy, the only file that imports it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from dhcli.algebra.arithmetic import evaluate, evaluate_settled
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.styles import identifier
from dhcli.notation.tree import Expr, Number

if TYPE_CHECKING:
    import sympy


class Sympy:
    """Sympy expressions; names become real symbols whose spelling programs accept."""

    def cos_sin(self, angle: Angle) -> tuple[sympy.Expr, sympy.Expr]:
        """Cosine and sine, as sympy writes them."""
        import sympy

        radians = sympy.Rational(angle.degrees.numerator, angle.degrees.denominator) * sympy.pi / 180
        radians += self.number(angle.radians)
        for name, factor in angle.terms:
            radians += self.number(factor) * self.symbol(name)
        return sympy.cos(radians), sympy.sin(radians)

    def length(self, expr: Expr) -> sympy.Expr | int:
        """An expression of lengths."""
        return 0 if isinstance(expr, Number) and not expr.value else evaluate(expr, self)

    def constant(self, value: int) -> sympy.Expr:
        """A sympy integer."""
        import sympy

        return sympy.Integer(value)

    def number(self, value: Rational) -> sympy.Expr:
        """A sympy rational."""
        import sympy

        return sympy.Rational(value.numerator, value.denominator)

    def symbol(self, name: str) -> sympy.Expr:
        """A real symbol."""
        import sympy

        return sympy.Symbol(identifier(name), real=True)

    def pi(self) -> sympy.Expr:
        """Sympy's π."""
        import sympy

        return sympy.pi

    def power(self, base: sympy.Expr, exponent: Rational) -> sympy.Expr:
        """A rational power."""
        return base ** self.number(exponent)

    def call(self, function: str, arguments: list[sympy.Expr]) -> sympy.Expr:
        """A function by its name in sympy."""
        import sympy

        known = {
            "tan": sympy.tan,
            "acos": sympy.acos,
            "asin": sympy.asin,
            "atan": sympy.atan,
            "atan2": sympy.atan2,
            "cos": sympy.cos,
            "sin": sympy.sin,
        }
        return known[function](*arguments)


def to_sympy(expr: Expr) -> sympy.Expr:
    """One of our trees as a sympy expression."""
    return evaluate_settled(expr, Sympy())


def to_sympy_matrix(rows: Iterable[Iterable[object]]) -> sympy.Matrix:
    """Rows of our trees, or of floats, as a sympy matrix."""
    import sympy

    return sympy.Matrix([[to_sympy(e) if isinstance(e, Expr) else sympy.Float(e) for e in row] for row in rows])
