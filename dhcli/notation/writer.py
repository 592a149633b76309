"""The one writer: every expression dhcli prints, in any notation, passes through `write`.

Order of terms and factors and the signs of brackets are settled in the tree already; here they only get their
spelling. `short` is the textbook's `c1*(a2*c2 + a3*c23)`, `full` spells out `cos(theta1)`, `latex` is for papers,
`matlab`, `numpy` and `sympy` are for pasting into programs.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from dhcli.errors import NotationError
from dhcli.notation.angle import FULL_TURN_IN_RADIANS, Angle, Rational, magnitude
from dhcli.notation.styles import STYLES, THETAS, Joints, Style
from dhcli.notation.tree import (
    HALF,
    ONE,
    Call,
    Constant,
    Expr,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    Trig,
    Unit,
    places_of,
    split,
)

SUM, PRODUCT, ATOM = 1, 2, 3
SQUARE = 2
LARGEST_IN_FRACTION = 1000
"""Above it a fraction is a decimal in programs."""

LARGEST_BELOW = 10
"""Above it what an angle is multiplied by is a decimal: 0.35*theta1, but theta1/20 and 3*theta1/4."""

MOST_BITS_WRITTEN = 14_000
"""Some 4,200 digits; Python refuses to write more than 4,300."""

RADIAN_PLACES = 40
"""Decimals of radians at most: a thousandth of a degree in all digits of a float has 21."""


def write(expr: Expr, style: str | Style = "short", joints: Joints = THETAS) -> str:
    """Write an expression.

    Args:
        expr: The tree.
        style: One of `STYLES`, short, full, latex, matlab, numpy, sympy; or one of a language that nobody types.
        joints: The robot's joint angles, for shorthand and for the order of factors.
    """
    return _Writer(STYLES[style] if isinstance(style, str) else style, joints).expression(expr)


def write_angle(angle: Angle, style: str = "short", joints: Joints = THETAS) -> str:
    """Write an angle with its units, `theta1 + 90°` or `theta1 + 0.3 rad`; zero is `0`."""
    return _Writer(STYLES[style], joints).angle(angle, spaced=True)


def write_value(value: Angle | Expr, style: str = "short", joints: Joints = THETAS) -> str:
    """Write an angle or an expression."""
    return write_angle(value, style, joints) if isinstance(value, Angle) else write(value, style, joints)


def write_number(value: Rational, places: int | None = None) -> str:
    """Write an exact number: with decimals if it has that many places, else as a fraction.

    Raises:
        NotationError: It has more digits than Python writes.
    """
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > MOST_BITS_WRITTEN:
        raise NotationError("a number of thousands of digits is not written", "put in values with fewer digits")
    if value.denominator == 1:
        return str(value.numerator)
    if places is not None:
        scaled = magnitude(value) * 10**places
        if scaled.denominator == 1:
            digits = str(scaled.numerator).rjust(places + 1, "0")
            return ("-" if value < 0 else "") + f"{digits[:-places]}.{digits[-places:]}".rstrip("0").rstrip(".")
    return f"{value.numerator}/{value.denominator}"


class _Writer:
    def __init__(self, style: Style, joints: Joints) -> None:
        self.style = style
        self.joints = joints

    def expression(self, expr: Expr) -> str:
        return self.node(expr)[0]

    def bracketed(self, expr: Expr, level: int) -> str:
        text, own = self.node(expr)
        if own >= level and not text.startswith("-"):
            return text
        return f"\\left({text}\\right)" if self.style.latex else f"({text})"

    def node(self, expr: Expr) -> tuple[str, int]:
        """The text of a node and how strongly it binds."""
        match expr:
            case Number(value, places):
                return self.number(value, places)
            case Symbol(name):
                return self.style.symbol(name), ATOM
            case Constant():
                return self.style.pi, ATOM
            case Unit(name):
                return name, ATOM
            case Trig(function, angle):
                return self.trig(function, angle), ATOM
            case Sum(terms):
                return self.sum(terms), SUM
            case Product():
                return self.product(expr)
            case Power(base, exponent):
                return self.power(base, exponent)
            case Call(function, arguments):
                name = self.style.functions.get(function, function)
                name = rf"\operatorname{{{name}}}" if self.style.latex else self.style.prefix + name
                return f"{name}({', '.join(self.expression(argument) for argument in arguments)})", ATOM
        raise TypeError(expr)

    def plain(self, value: Rational, places: int | None = None) -> str:
        """A number; for programs a decimal, unless it is a fraction of small numbers."""
        if self.style.decimal and max(abs(value.numerator), value.denominator) > LARGEST_IN_FRACTION:
            return repr(float(value))
        return write_number(value, places)

    def number(self, value: Rational, places: int | None) -> tuple[str, int]:
        text = self.plain(value, places)
        if self.style.decimal and "/" in text:
            text = repr(float(value))  # 1/2 is 0 in C
        if "/" not in text:
            return text, ATOM
        if self.style.latex:
            sign = "-" if value < 0 else ""
            above, below = text.removeprefix("-").split("/")
            return rf"{sign}\frac{{{above}}}{{{below}}}", PRODUCT
        return text, PRODUCT

    def sum(self, terms: tuple[Expr, ...]) -> str:
        pieces = [self.expression(term) for term in terms]
        rest = [f" - {piece[1:]}" if piece.startswith("-") else f" + {piece}" for piece in pieces[1:]]
        return pieces[0] + "".join(rest)

    def product(self, expr: Product) -> tuple[str, int]:
        number, rest = split(expr)
        sign = "-" if number.value < 0 else ""
        above, below = self.fraction(magnitude(number.value), number.places, self.in_order(rest))
        top = self.style.times.join(above) or "1"
        if not below:
            return sign + top, PRODUCT
        if self.style.latex:
            factors = rest.factors if type(rest) is Product else (rest,)
            lower = [factor.base for factor in factors if type(factor) is Power]
            return rf"{sign}\frac{{{self.stacked(above, factors)}}}{{{self.stacked(below, lower)}}}", PRODUCT
        bottom = below[0] if len(below) == 1 else f"({self.style.times.join(below)})"
        return f"{sign}{top}/{bottom}", PRODUCT

    def stacked(self, texts: Sequence[str], factors: Sequence[Expr]) -> str:
        """What stands above or below a line: a sum alone needs no brackets there."""
        sums = [factor for factor in factors if type(factor) is Sum]
        alone = len(texts) == 1 and list(texts) == [self.bracketed(one, PRODUCT) for one in sums]
        return self.expression(sums[0]) if alone else self.style.times.join(texts) or "1"

    def fraction(self, value: Rational, places: int | None, factors: list[Expr]) -> tuple[list[str], list[str]]:
        """What stands above and below the fraction bar."""
        above: list[str] = []
        below: list[str] = []
        text = self.plain(value, places)
        if "/" in text:
            upper, lower = text.split("/")
            below.append(lower)
            text = upper
        if text != "1":
            above.append(text)
        for factor in factors:
            if type(factor) is Power and factor.exponent < 0 and factor.exponent.denominator == 1:
                inverse = factor.base if factor.exponent == -1 else Power(factor.base, -factor.exponent)
                below.append(self.bracketed(inverse, ATOM))
            else:
                above.append(self.bracketed(factor, PRODUCT))
        return above, below

    def in_order(self, rest: Expr) -> list[Expr]:
        """Factors with the cosines and sines in joint order; everything else stays where it is."""
        factors = list(rest.factors) if type(rest) is Product else [rest]
        if not self.joints.order:
            return factors
        places = [i for i, factor in enumerate(factors) if _angle_of(factor).terms]
        ordered = sorted((factors[i] for i in places), key=self.trig_key)
        for place, factor in zip(places, ordered, strict=True):
            factors[place] = factor
        return factors

    def trig_key(self, factor: Expr) -> list[tuple[int, object]]:
        return sorted(self.joints.place(name) for name in _angle_of(factor).names)

    def power(self, base: Expr, exponent: Rational) -> tuple[str, int]:
        if exponent == HALF:
            return self.style.prefix + self.style.root.format(self.expression(base)), ATOM
        if exponent < 0 and exponent.denominator == 1:
            return self.product(Product((ONE, Power(base, exponent))))
        if self.style.power:
            return self.in_power(base, exponent)
        text = write_number(exponent)
        text = f"{{{text}}}" if self.style.latex else f"({text})" if "/" in text or exponent < 0 else text
        return f"{self.bracketed(base, ATOM)}{self.style.caret}{text}", ATOM

    def in_power(self, base: Expr, exponent: Rational) -> tuple[str, int]:
        """A power in a language that has no sign for it: squares as products."""
        if exponent == SQUARE and type(base) is Symbol:
            return self.style.times.join([self.style.symbol(base.name)] * SQUARE), PRODUCT
        return self.style.power.format(self.expression(base), self.number(exponent, None)[0]), ATOM

    def trig(self, function: str, angle: Angle) -> str:
        if self.style.name in ("short", "latex") and angle.terms:
            indices = self.indices(angle)
            if indices:
                return f"{function[0]}_{{{indices}}}" if self.style.latex else function[0] + indices
            if self.style.name == "short" and all(name in self.joints.index for name in angle.names):
                return f"{function[0]}({self.angle(angle)})"
        return self.style.trig.format(self.style.prefix + function, self.angle(angle))

    def indices(self, angle: Angle) -> str:
        """`12` for theta1 + theta2, or nothing if the sum has no short form."""
        if angle.degrees or angle.radians or any(factor != 1 for _, factor in angle.terms):
            return ""
        names = sorted(angle.names, key=self.joints.place)
        digits = [self.joints.index.get(name, "") for name in names]
        return "".join(digits) if all(digits) else ""

    def angle(self, angle: Angle, *, spaced: bool = False) -> str:
        ordered = sorted(angle.terms, key=lambda term: (term[1] < 0, self.joints.place(term[0])))
        pieces = [self.scaled(factor, self.style.symbol(name), decimals=True) for name, factor in ordered]
        if angle.degrees:
            pieces.append(self.degrees(angle.degrees))
        if angle.radians:
            must = spaced or magnitude(angle.radians) > FULL_TURN_IN_RADIANS  # 90 would be a question
            unit = " rad" if must and self.style.degrees is not None and not self.style.latex else ""
            radians = repr(float(angle.radians)) if self.style.decimal else write_number(angle.radians, RADIAN_PLACES)
            pieces.append(radians + unit)
        if not pieces:
            return "0"
        minus, plus = (" - ", " + ") if spaced else ("-", "+")
        rest = [minus + piece[1:] if piece.startswith("-") else plus + piece for piece in pieces[1:]]
        return pieces[0] + "".join(rest)

    def scaled(self, factor: Rational, text: str, *, decimals: bool = False) -> str:
        sign = "-" if factor < 0 else ""
        decimals = decimals and factor.denominator > LARGEST_BELOW and abs(factor.numerator) != 1
        places = places_of(factor) if decimals else None
        above, _, below = write_number(magnitude(factor), places).partition("/")
        upper = "" if above == "1" else f"{above}{self.style.times}"
        lower = f"/{below}" if below else ""
        return f"{sign}{upper}{text}{lower}"

    def degrees(self, degrees: Rational) -> str:
        if self.style.degrees is None:
            return self.scaled(Fraction(degrees, 180), self.style.pi)
        text = write_number(degrees, 6)
        return self.style.degrees.format(f"({text})" if "/" in text else text)


def _angle_of(factor: Expr) -> Angle:
    base = factor.base if type(factor) is Power else factor
    return base.angle if type(base) is Trig else Angle()
