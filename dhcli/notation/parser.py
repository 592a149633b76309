"""Tokens to tree: one grammar for files, options and answers.

A precedence-climbing parser of our own. It reads what people write, `c1 s12`, `-90°`, `√3/2`, `2a1`, `cos θ1`,
and refuses with a column where a text could be read in two ways. Nothing is ever evaluated as code, and the work is
bounded: characters, nodes, depth and exponents are capped.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from typing import ParamSpec

from dhcli.errors import NotationError, Place, did_you_mean
from dhcli.notation.names import GREEK_NAMES, canonical, parts
from dhcli.notation.quantity import UNITS, DimensionError, to_angle
from dhcli.notation.scope import OPEN, Scope, trig_name
from dhcli.notation.tokens import Source, Token, tokenize
from dhcli.notation.tree import HALF, PI, Call, Expr, Number, Symbol, Unit, add, cosine, multiply, negate, power, sine

MOST_NODES = 500
DEEPEST = 60
LARGEST_EXPONENT = 64
LONGEST_NUMBER = 60

FUNCTIONS = {name: name for name in ("cos", "sin", "tan", "sqrt", "acos", "asin", "atan", "atan2", "cosd", "sind")} | {
    "arccos": "acos",
    "arcsin": "asin",
    "arctan": "atan",
    "arctan2": "atan2",
    "Cos": "cos",
    "Sin": "sin",
}
"""Functions by the names people write."""

RESERVED = frozenset(FUNCTIONS) | {"pi", "frac", "inv", "Rot", "Trans"}
"""Words that cannot name a joint or a length."""

P = ParamSpec("P")

_PIECES = re.compile(r"[^\W\d_]+(?:[0-9₀-₉]+|_\{[^{}]*\}|_[A-Za-z]+[0-9]*|_[0-9]+)?")
"""One name inside a run of letters and digits: `a1c1` is two."""

_SUM, _PRODUCT, _POWER = 10, 20, 30
_OPENING = {"(": ")", "[": "]", "{": "}"}


def parse(text: str, scope: Scope = OPEN, place: Place | None = None, *, decimal_comma: bool = True) -> Expr:
    """Read one expression.

    Args:
        text: What a person wrote.
        scope: The names it may use.
        place: Where the text stands, for errors.
        decimal_comma: Whether `0,5` may be a number; not where commas separate.

    Raises:
        NotationError: With the column, what is wrong there, and what would be read.
    """
    source = Source(text, place or Place("expression"))
    tokens = [token for token in tokenize(source, decimal_comma=decimal_comma) if token.kind != "newline"]
    parser = Parser(source, tokens, scope)
    expr = parser.expression()
    parser.finish()
    return expr


class Parser:
    """Reads expressions from tokens; the readers of matrices and of moves share it."""

    def __init__(self, source: Source, tokens: list[Token], scope: Scope) -> None:
        """Start before the first token, the last of which must be `end`."""
        self.source = source
        self.tokens = tokens
        self.scope = scope
        self.position = 0
        self._nodes = 0
        self._depth = 0

    @property
    def token(self) -> Token:
        """The token that comes next."""
        return self.tokens[self.position]

    def advance(self) -> Token:
        """Take the next token."""
        token = self.token
        self.position += token.kind != "end"
        return token

    def at(self, sign: str) -> bool:
        """Whether the next token is a certain sign."""
        return self.token.kind == "sign" and self.token.text == sign

    def take(self, sign: str) -> bool:
        """Take a sign if it comes next."""
        found = self.at(sign)
        self.position += found
        return found

    def expect(self, sign: str, after: str) -> None:
        """Take a sign that must come next."""
        if not self.take(sign):
            raise self.error(f"{self.shown()} where {sign} was expected {after}")

    def error(self, message: str, hint: str = "", token: Token | None = None) -> NotationError:
        """An error that points at a token, the next one unless told otherwise."""
        return self.source.error((token or self.token).start, message, hint)

    def shown(self) -> str:
        """The next token as a message names it."""
        return "the end" if self.token.kind == "end" else repr(self.token.text)

    def finish(self) -> None:
        """Make sure that nothing is left over."""
        if self.token.kind != "end":
            raise self.error(f"{self.shown()} is left over here", "is a bracket or an operator missing?")

    def expression(self, binding: int = 0) -> Expr:
        """Read an expression whose operators bind more strongly than `binding`."""
        self._depth += 1
        if self._depth > DEEPEST:
            raise self.error(f"brackets nested deeper than {DEEPEST} are not read")
        left = self._operand()
        while True:
            token = self.token
            self._count()
            if token.kind == "sign" and token.text in "+-" and binding < _SUM:
                self.advance()
                right = self.expression(_SUM)
                left = self._build(token, add, left, right if token.text == "+" else negate(right))
            elif token.kind == "sign" and token.text in "*/" and binding < _PRODUCT:
                left = self._multiplied(left)
            elif token.kind == "sign" and token.text == "^" and binding < _POWER:
                self.advance()
                left = self._power(left, token)
            elif self._starts_operand() and binding < _PRODUCT:
                left = self._build(token, multiply, left, self._implicit())
            else:
                self._depth -= 1
                return left

    def _multiplied(self, left: Expr) -> Expr:
        token = self.advance()
        right = self.expression(_PRODUCT)
        if token.text == "*":
            return self._build(token, multiply, left, right)
        follower = self.token
        if not isinstance(right, Number) and self._starts_operand() and not self._is_unit():
            raise self.error(
                "what is divided by a product without a sign can be read in two ways",
                f"write a/(b*{follower.text}) or a/b*{follower.text}",
            )
        return self._build(token, lambda: multiply(left, power(right, -1)))

    def _starts_operand(self) -> bool:
        token = self.token
        return token.kind in ("number", "word") or (token.kind == "sign" and token.text in "([{√°")

    def _is_unit(self) -> bool:
        return self.at("°") or (self.token.kind == "word" and self.token.text in UNITS)

    def _implicit(self) -> Expr:
        """A factor without a sign before it; a unit if the word is one and no name."""
        token = self.token
        if self._is_unit():
            if self.scope.has(token.text) and token.text != "°":
                question = f"write *{token.text} for the name, or give the length in another unit"
                raise self.error(f"{token.text} could be the unit or the name {token.text}", question)
            self.advance()
            return Unit("deg" if token.text == "°" else token.text)
        if token.kind == "number" and self.tokens[self.position - 1].kind == "number":
            raise self.error("two numbers side by side", "write * between them, or a comma if they are two values")
        return self.expression(_PRODUCT)

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
            if token.text in _OPENING:
                inside = self.expression()
                self.expect(_OPENING[token.text], f"to close {token.text}")
                return inside
            if token.text == "√":
                return self._build(token, power, self.expression(_POWER), HALF)
        self.position -= token.kind != "end"
        raise self.error(f"{self.shown()} where a number, a name or a bracket was expected")

    def _number(self, token: Token) -> Expr:
        mantissa, _, exponent = token.text.lower().partition("e")
        if len(mantissa) > LONGEST_NUMBER or len(exponent) > 3 or abs(int(exponent or 0)) > LONGEST_NUMBER:  # noqa: PLR2004
            raise self.error(f"a number with more than {LONGEST_NUMBER} digits is not read", "", token)
        if exponent and self.scope.has("e"):
            raise self.error(
                f"{token.text} could be a power of ten or a multiple of the length e",
                f"write {mantissa}*e or {float(token.text):g}",
                token,
            )
        places = len(mantissa.partition(".")[2]) - int(exponent or 0)
        return Number(Fraction(token.text), places if places > 0 else None)

    def _word(self, token: Token) -> Expr:
        word = token.text
        if word in ("pi", "π"):
            return PI
        if word == "frac":
            return self._fraction(token)
        readings = self.scope.readings(word)
        if len(readings) == 1:
            return self._maybe_called(readings[0], token)
        if len(readings) > 1:
            raise self._question(token, [trig_name(reading) for reading in readings])
        if word in FUNCTIONS:
            return self._function(FUNCTIONS[word], token)
        if word in ("c", "C", "s", "S") and (self._angle_follows() or self.at("^")):
            return self._function("cos" if word in "cC" else "sin", token)
        return self._joined(token)

    def _maybe_called(self, reading: Expr, token: Token) -> Expr:
        """A length called c or s, unless an angle in brackets or an angle's name follows."""
        if token.text in ("c", "s") and self._angle_follows():
            return self._function("cos" if token.text == "c" else "sin", token)
        return reading

    def _angle_follows(self) -> bool:
        """Whether what follows `c` or `s` is an angle: its name, or a bracket in which one is named."""
        if self.token.kind == "word":
            return self._names_angle(self.token.text)
        if not (self.token.kind == "sign" and self.token.text in _OPENING):
            return False
        depth = 0
        for token in self.tokens[self.position :]:
            depth += token.kind == "sign" and token.text in _OPENING
            depth -= token.kind == "sign" and token.text in _OPENING.values()
            if token.text == "°" or (token.kind == "word" and self._names_angle(token.text)):
                return True
            if depth == 0:
                return False
        return False

    def _names_angle(self, word: str) -> bool:
        if word in ("deg", "rad", "pi", "π"):
            return True
        readings = self.scope.readings(word)
        if any(isinstance(reading, Symbol) and self.scope.is_angle(reading.name) for reading in readings):
            return True
        return self.scope.is_open and parts(word)[0] in GREEK_NAMES

    def _joined(self, token: Token) -> Expr:
        """A word that is no single name: `cosθ1`, `a1c1`, or unknown."""
        for name in ("cos", "sin"):
            rest = token.text.removeprefix(name)
            if rest != token.text and self._names_angle(rest):
                return self._apply(name, [self._resolve(rest, token)], token)
        ways = self.scope.split(token.text)
        if len(ways) == 1:
            return self._build(token, multiply, *ways[0])
        if ways:
            raise self._question(token, [" * ".join(map(trig_name, way)) for way in ways])
        return self._resolve(token.text, token)

    def _resolve(self, word: str, token: Token) -> Expr:
        readings = self.scope.readings(word)
        if readings:
            return readings[0]
        if self.scope.is_open:
            pieces = _PIECES.findall(word)
            if len(pieces) > 1 and "".join(pieces) == word:
                return self._build(token, multiply, *(self._resolve(piece, token) for piece in pieces))
            return Symbol(canonical(word))
        hint = did_you_mean(word, self.scope.names)
        raise self.error(f"{word} is not a name that is known here", hint, token)

    def _question(self, token: Token, readings: list[str]) -> NotationError:
        return self.error(f"{token.text} could be " + " or ".join(readings), "write it out", token)

    def _fraction(self, token: Token) -> Expr:
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
            exponent = self._operand()
        if self.token.kind == "sign" and self.token.text in _OPENING:
            closing = _OPENING[self.advance().text]
            arguments = [self.expression()]
            while self.take(","):
                arguments.append(self.expression())
            self.expect(closing, f"after the argument of {name}")
        elif self.token.kind in ("number", "word"):
            arguments = [self._bare_argument()]
        else:
            raise self.error(f"{self.shown()} where the argument of {name} was expected", f"write {name}(theta1)")
        value = self._apply(name, arguments, token)
        return value if exponent is None else self._raised(value, exponent, token)

    def _bare_argument(self) -> Expr:
        """What `cos` without brackets applies to: a number with its unit and name, or one name."""
        operand = self._operand()
        if isinstance(operand, Number):
            if self._is_unit():
                return multiply(operand, self._implicit())
            if self.token.kind == "word" and self._names_angle(self.token.text):
                return multiply(operand, self._operand())
        return operand

    def _apply(self, name: str, arguments: list[Expr], token: Token) -> Expr:
        wanted = 2 if name == "atan2" else 1
        if len(arguments) != wanted:
            raise self.error(f"{name} takes {wanted} argument{'s'[: wanted - 1]}, not {len(arguments)}", "", token)
        argument = arguments[0]
        if name == "sqrt":
            return self._build(token, power, argument, HALF)
        if name in ("cosd", "sind"):
            name, argument = name[:3], multiply(argument, Unit("deg"))
        if name in ("cos", "sin"):
            try:
                return (cosine if name == "cos" else sine)(to_angle(argument))
            except DimensionError as error:
                if any(unit in str(error) for unit in ("unit of length",)):
                    raise self.error(error.message, error.hint, token) from None
        return Call(name, tuple(arguments))

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
            exponent = self._power(exponent, self.advance())
        return self._raised(base, negate(exponent) if sign else exponent, token)

    def _raised(self, base: Expr, exponent: Expr, token: Token) -> Expr:
        if not isinstance(exponent, Number):
            raise self.error("an exponent must be a number", "", token)
        if abs(exponent.value) > LARGEST_EXPONENT or exponent.value.denominator > LARGEST_EXPONENT:
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

    def _count(self) -> None:
        self._nodes += 1
        if self._nodes > MOST_NODES * 2:
            raise self.error(f"an expression of more than {MOST_NODES} parts is not read")
