"""Precedence climbing: sums, products with and without a sign, powers, brackets and numbers.

What a word means is left to the parser above. The work is bounded: parts, depth, digits and exponents are capped.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from fractions import Fraction
from typing import ParamSpec

from dhcli.notation.angle import magnitude
from dhcli.notation.brackets import OPENING
from dhcli.notation.cursor import Cursor
from dhcli.notation.quantity import UNITS
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Source, Token
from dhcli.notation.tree import HALF, Expr, Number, Power, Product, Unit, add, multiply, negate, power
from dhcli.notation.walk import symbols

MOST_NODES = 500
DEEPEST = 60
LARGEST_EXPONENT = 64
LONGEST_NUMBER = 60

P = ParamSpec("P")

_SUM, _PRODUCT, _POWER = 10, 20, 30


class Operators(Cursor, ABC):
    """Reads expressions; `_word` says what a word stands for."""

    def __init__(self, source: Source, tokens: list[Token], scope: Scope) -> None:
        """Start before the first token, the last of which must be `end`."""
        super().__init__(source, tokens, scope)
        self._nodes = 0
        self._depth = 0

    @abstractmethod
    def _word(self, token: Token) -> Expr:
        """What a word stands for, with the arguments of a function behind it."""

    def expression(self, binding: int = 0) -> Expr:
        """Read an expression whose operators bind more strongly than `binding`."""
        self.go_deeper()
        left = self._operand()
        while True:
            token = self.token
            self._count()
            if token.kind == "sign":
                if token.text in "+-" and binding < _SUM:
                    left = self._sum(left, token)
                    continue
                if token.text in "*/" and binding < _PRODUCT:
                    left = self._multiplied(left)
                    continue
                if token.text == "^" and binding < _POWER:
                    self.advance()
                    left = self._power(left, token)
                    continue
            if binding >= _PRODUCT or token.kind == "end" or not self._starts_operand():
                self._depth -= 1
                return left
            left = self._build(token, multiply, left, self._implicit(left))

    def _sum(self, first: Expr, token: Token) -> Expr:
        """All terms of a sum at once, for one by one each would be compared with those before it again and again."""
        terms, sign = [first], token
        while sign.kind == "sign" and sign.text in "+-":
            self.position += 1
            right = self.expression(_SUM)
            terms.append(right if sign.text == "+" else negate(right))
            sign = self.token
        return self._build(token, add, *terms)

    def go_deeper(self) -> None:
        """Count one more level of nesting, and stop at the cap."""
        self._depth += 1
        if self._depth > DEEPEST:
            raise self.error(f"brackets nested deeper than {DEEPEST} are not read")

    def _multiplied(self, left: Expr) -> Expr:
        token = self.advance()
        right = self.expression(_PRODUCT)
        if token.text == "*":
            return self._build(token, multiply, left, right)
        follower = self.token
        glued = not isinstance(right, Number) or (not follower.spaced and bool(symbols(left)))  # a1/2c1, not √3/2 a1
        if glued and self._starts_operand() and not self._is_unit():
            below = f"{right}" if isinstance(right, Number) else "b"
            raise self.error(
                "what is divided by a product without a sign can be read in two ways",
                f"write a/({below}*{follower.text}) or a/{below}*{follower.text}",
            )
        return self._build(token, lambda: multiply(left, power(right, -1)))

    def _starts_operand(self) -> bool:
        token = self.token
        return token.kind in ("number", "word") or (token.kind == "sign" and token.text in "([{√°")

    def _is_unit(self) -> bool:
        return self.at("°") or (self.token.kind == "word" and self.token.text in UNITS)

    def _implicit(self, left: Expr) -> Expr:
        """A factor without a sign before it; a unit if the word is one and no name."""
        token, before = self.token, self.tokens[self.position - 1]
        if self._is_unit():
            self._check_unit(left)
            if self.scope.has(token.text) and token.text != "°":
                question = f"write *{token.text} for the name, or give the length in another unit"
                raise self.error(f"{token.text} could be the unit or the name {token.text}", question)
            self.advance()
            unit = Unit("deg" if token.text == "°" else token.text)
            return self._power(unit, self.advance()) if self.at("^") else unit
        if token.kind == "number":
            self._check_number(before)
            if token.text.startswith(".") and before.kind == "word" and not token.spaced:
                hint = f"write {before.text}{token.text[1:]}, or {before.text}*0{token.text}"
                raise self.error(f"{before.text}{token.text} may be a name or a product", hint, before)
        elif token.kind == "word" and before.kind == "number" and before.text == "0" and not token.spaced:
            raise self.error(f"0{token.text} is not a number that is read", "write it in decimal digits", before)
        return self.expression(_PRODUCT)

    def _check_unit(self, left: Expr) -> None:
        """Refuse a unit behind what has one: `1 m m`, and `400mm/2mm`, which could be a ratio or an area."""
        factors = left.factors if isinstance(left, Product) else (left,)
        if any(isinstance(f.base if isinstance(f, Power) else f, Unit) for f in factors):
            hint = "write a sign and a bracket, 400 mm/(2 mm) for a ratio" if self.token.text != "°" else ""
            raise self.error(f"a second unit, {self.token.text}, stands in one product", hint)

    def _check_number(self, before: Token) -> None:
        """Refuse a number behind a number, and behind a unit: `2 3`, `2 m 3`, `30° 15`."""
        if before.kind == "number":
            raise self.error("two numbers side by side", "write * between them, or a comma if they are two values")
        if before.text == "°" or before.text in UNITS:
            hint = "write 30°15' or 30.25°" if before.text == "°" else "write * between them, or + for a sum"
            raise self.error(f"a number stands behind the unit {before.text}", hint)

    def _operand(self) -> Expr:
        token = self.advance()
        self._count()
        if token.kind == "number":
            return self._number(token)
        if token.kind == "word":
            return self._word(token)
        if token.kind == "sign":
            if token.text in "+-":
                operand = self.expression(_SUM + 1)
                return operand if token.text == "+" else negate(operand)
            if token.text in OPENING:
                inside = self.expression()
                self.expect(OPENING[token.text], f"to close {token.text}")
                return inside
            if token.text == "√":
                return self._build(token, power, self.expression(_POWER), HALF)
        self.position -= token.kind != "end"
        raise self.error(f"{self.shown()} where a number, a name or a bracket was expected")

    def _number(self, token: Token) -> Expr:
        mantissa, _, exponent = token.text.lower().partition("e")
        if len(mantissa) > LONGEST_NUMBER or len(exponent) > 3 or abs(int(exponent or 0)) > LONGEST_NUMBER:  # noqa: PLR2004
            raise self.error(f"a number with more than {LONGEST_NUMBER} digits is not read", "", token)
        name = next((name for name in ("e", f"e{exponent}") if exponent and self.scope.has(name)), "")
        if name:
            raise self.error(
                f"{token.text} could be a power of ten or a multiple of the length {name}",
                f"write {mantissa}*{name} or {float(token.text):g}",
                token,
            )
        places = len(mantissa.partition(".")[2]) - int(exponent or 0)
        value = int(token.text) if token.text.isdecimal() else Fraction(token.text)
        return Number(value, places if places > 0 else None)

    def _power(self, base: Expr, token: Token) -> Expr:
        if self.at("°"):  # LaTeX writes 90^\circ
            self.advance()
            return multiply(base, Unit("deg"))
        if self.at("{") and self.tokens[self.position + 1].text == "°":
            self.advance()
            self.advance()
            self.expect("}", "after the degree sign")
            return multiply(base, Unit("deg"))
        sign = self.take("-")
        exponent = self._operand()
        if self.at("^"):
            self.go_deeper()
            exponent = self._power(exponent, self.advance())
            self._depth -= 1
        return self._raised(base, negate(exponent) if sign else exponent, token)

    def _raised(self, base: Expr, exponent: Expr, token: Token) -> Expr:
        if not isinstance(exponent, Number):
            raise self.error("an exponent must be a number", "", token)
        if magnitude(exponent.value) > LARGEST_EXPONENT or exponent.value.denominator > LARGEST_EXPONENT:
            raise self.error(f"an exponent beyond {LARGEST_EXPONENT} is not read", "", token)
        return self._build(token, power, base, exponent.value)

    def _build(self, token: Token, make: Callable[P, Expr], *args: P.args, **kwargs: P.kwargs) -> Expr:
        """Put nodes together, turning arithmetic accidents into errors with a place."""
        try:
            return make(*args, **kwargs)
        except ZeroDivisionError:
            raise self.error("a division by zero", "", token) from None
        except OverflowError:
            raise self.error("the number becomes too large", "", token) from None

    def _has_room(self, parts: int, levels: int) -> bool:
        """Whether so many parts more, nested so deep at most, are below the caps; else the cap is met where it is."""
        return self._nodes + parts <= MOST_NODES * 2 and self._depth + levels <= DEEPEST

    def _count(self) -> None:
        self._nodes += 1
        if self._nodes > MOST_NODES * 2:
            raise self.error(f"an expression of more than {MOST_NODES} parts is not read")
