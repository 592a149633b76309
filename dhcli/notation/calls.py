r"""Functions and their arguments: `cos(theta1)`, `sin^2 θ1`, `\frac{1}{2}`, `sqrt 3`, `atan2(y, x)`."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from fractions import Fraction

from dhcli.errors import plural
from dhcli.notation.angle import FULL_TURN_IN_RADIANS, Angle, magnitude
from dhcli.notation.brackets import OPENING, closing
from dhcli.notation.functions import FUNCTIONS
from dhcli.notation.glued import in_degrees
from dhcli.notation.operators import Operators
from dhcli.notation.quantity import ANGLE_UNITS, DimensionError, to_angle
from dhcli.notation.tokens import Token, spelling
from dhcli.notation.tree import HALF, Call, Expr, Number, Sum, Unit, multiply, power
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import walk

INVERSE = ("-1", "{-1}", "(-1)")
"""The exponent of an inverse function, a token for each letter."""

LONGEST_KEPT = 16
"""Tokens of the longest argument of a function that is remembered with its brackets."""


class Calls(Operators):
    """Reads what stands behind the name of a function; which words name angles is known above."""

    @abstractmethod
    def _names_angle(self, word: str) -> bool:
        """Whether a word is an angle, or begins one."""

    @abstractmethod
    def _bracket_names_angle(self) -> bool:
        """Whether an angle is named in the bracket that comes next, outside the functions in it."""

    def _fraction(self, token: Token) -> Expr:
        if self.token.kind == "number" and len(self.token.text) == 2 and self.token.text.isdecimal():  # noqa: PLR2004
            over, under = map(Fraction, self.advance().text)  # \frac12 as TeX reads it
            return self._build(token, lambda: Number(over / under))
        self.expect("{", "after \\frac")
        above = self.expression()
        self.expect("}", "after the numerator")
        self.expect("{", "after the numerator")
        below = self.expression()
        self.expect("}", "after the denominator")
        return self._build(token, lambda: multiply(above, power(below, -1)))

    def _function(self, name: str, token: Token) -> Expr:
        """A function with its argument: `cos(theta1)`, `cos θ1`, `sin^2 θ1`, `sqrt 3`."""
        exponent = None
        if self.take("^"):
            inverse = self._tokens_of_inverse()
            if inverse and self._is_inverse(name, inverse):
                self.position += inverse
                return self._called(f"a{name}", token)
            if inverse or self.at("-"):
                hint = f"write a{name}(0.5) for the angle, or 1/{name}(theta1)"
                raise self.error(f"{name} to a negative power can be read in two ways", hint, token)
            exponent = self._operand()
        if self.token.kind == "sign" and self.token.text in OPENING:
            value = self._called(name, token)
            return value if exponent is None else self._raised(value, exponent, token)
        if self.token.kind in ("number", "word"):
            arguments = [self._bare_argument()]
        else:
            raise self.error(f"{self.shown()} where the argument of {name} was expected", f"write {name}(theta1)")
        value = self._apply(name, arguments, token)
        return value if exponent is None else self._raised(value, exponent, token)

    def _tokens_of_inverse(self) -> int:
        """How many tokens -1 is as an exponent, in brackets or none, that comes next; 0 for another one."""
        texts = [token.text for token in self.tokens[self.position : self.position + 4]]
        return next((len(one) for one in INVERSE if texts[: len(one)] == list(one)), 0)

    def _is_inverse(self, name: str, length: int) -> bool:
        """Whether `cos⁻¹(D)` is the angle that has this cosine: what stands in the bracket has names, and no angle."""
        start = self.position
        if f"a{name}" not in FUNCTIONS:
            return False
        self.position += length
        is_called = self.token.kind == "sign" and self.token.text in OPENING
        has_names = is_called and any(token.kind == "word" for token in self._bracket())
        has_angle = is_called and self._bracket_names_angle()
        self.position = start
        return has_names and not has_angle

    def _bracket(self, longest: int | None = None) -> Sequence[Token]:
        """The tokens of the bracket that comes next; none where it does not close, or not soon enough."""
        tokens = self.tokens[self.position :][:longest]
        return tokens[: closing(token.text for token in tokens) + 1]

    def _called(self, name: str, token: Token) -> Expr:
        """A function with arguments in brackets; short ones are read once, for a formula repeats few of them."""
        short = self._bracket(LONGEST_KEPT)
        key = f"{name}\0{spelling(short)}" if short else ""
        known = self.scope.read.get(key)
        if known is not None and self._has_room(known[1], len(short)):
            self.position += len(short)
            self._nodes += known[1]
            return known[0]
        nodes = self._nodes
        close = OPENING[self.advance().text]
        arguments = [self.expression()]
        while self.take(","):
            arguments.append(self.expression())
        self.expect(close, f"after the argument of {name}")
        value = self._apply(name, arguments, token)
        if short:
            self.scope.keep(key, value, self._nodes - nodes)
        return value

    def _bare_argument(self) -> Expr:
        """What `cos` without brackets applies to: a number with its unit and name, or one name."""
        self.go_deeper()
        operand = self._operand()
        self._depth -= 1
        if isinstance(operand, Number):
            if self.at("^") and in_degrees(self.tokens, self.position):  # LaTeX writes \cos 30^\circ
                return self._power(operand, self.advance())
            if self._is_unit():
                return multiply(operand, self._implicit(operand))
            if self.token.kind == "word" and self._names_angle(self.token.text):
                return multiply(operand, self._operand())
        return operand

    def _apply(self, name: str, arguments: list[Expr], token: Token) -> Expr:
        wanted = 2 if name == "atan2" else 1
        if len(arguments) != wanted:
            raise self.error(f"{name} takes {plural(wanted, 'argument')}, not {len(arguments)}", "", token)
        argument = arguments[0]
        if name == "sqrt":
            return self._build(token, power, argument, HALF)
        if name in ("cos", "sin", "tan", "cosd", "sind"):
            return self._trigonometry(name, argument, token)
        if any(isinstance(node, Unit) and node.name in ANGLE_UNITS for each in arguments for node in walk(each)):
            raise self.error(f"{name} takes numbers, and a unit of angle stands in it", "", token)
        return Call(name, tuple(arguments))

    def _check_bare(self, name: str, argument: Expr, angle: Angle, token: Token) -> None:
        """Ask what the 90 of `sin(90 + θ1)` and of `sin(90)` is, for nobody writes 90 radians."""
        if name.endswith("d") or magnitude(angle.radians) <= FULL_TURN_IN_RADIANS:
            return
        for term in argument.terms if isinstance(argument, Sum) else (argument,):
            if isinstance(term, Number) and magnitude(term.value) > FULL_TURN_IN_RADIANS:
                shown = f"{abs(float(term.value)):g}"
                of = f"a sum with {shown}" if term is not argument else shown
                hint = f"write {shown}° for degrees, {shown} rad for radians"
                raise self.error(f"{name} of {of} does not say what {shown} is", hint, token)

    def _trigonometry(self, name: str, argument: Expr, token: Token) -> Expr:
        """Cosine, sine or tangent, of an exact angle if the argument is one."""
        try:
            angle = to_angle(argument, bare="deg" if name.endswith("d") else "rad")
        except DimensionError as error:
            if any(isinstance(node, Unit) for node in walk(argument)):
                raise self.error(error.message, error.hint, token) from None
            return Call(name.removesuffix("d"), (argument,))
        self._check_bare(name, argument, angle, token)
        if angle.radians and any(type(node) is Call for node in walk(argument)):
            return Call(name.removesuffix("d"), (argument,))  # the cosine of atan2(3, 4) is no decimal
        if name == "tan":
            return self._build(token, lambda: multiply(sine(angle), power(cosine(angle), -1)))
        return cosine(angle) if name.startswith("cos") else sine(angle)
