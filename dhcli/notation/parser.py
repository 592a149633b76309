"""Tokens to tree: one grammar for files, options and answers.

A precedence-climbing parser of our own. It reads what people write, `c1 s12`, `-90°`, `√3/2`, `2a1`, `cos θ1`,
and refuses with a column where a text could be read in two ways. Nothing is ever evaluated as code, and the work is
bounded: characters, nodes, depth and exponents are capped.
"""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.errors import NotationError, Place
from dhcli.notation.brackets import OPENING, STEPS, closing
from dhcli.notation.calls import Calls
from dhcli.notation.dimensions import unit_meant
from dhcli.notation.functions import FUNCTIONS, is_usual, nearest_meaning, refusal
from dhcli.notation.glued import in_degrees, indexed, is_factor, unglued
from dhcli.notation.names import canonical, is_greek, suggestion
from dhcli.notation.quantity import ANGLE_UNITS, UNITS, DimensionError, is_inverse, to_angle, to_length
from dhcli.notation.scope import OPEN, Scope, trig_name
from dhcli.notation.tokens import Source, Token, spelling, tokenize
from dhcli.notation.tree import PI, Expr, Symbol, Trig, Unit, add, multiply
from dhcli.notation.walk import symbols, walk
from dhcli.regex import regex

RESERVED = frozenset(FUNCTIONS) | {"pi", "frac", "inv", "Rot", "Trans", "nan", "inf", "infinity", "minus"}
"""Words that cannot name a joint or a length."""

_FUNCTION = regex("(cos|sin)")
_PIECES = regex(r"[^\W\d_]+(?:[0-9₀-₉]+|_\{[^{}]*\}|_[A-Za-z]+[0-9]*|_[0-9]+)?")
"""One name inside a run of letters and digits: `a1c1` is two."""


def parse(text: str, scope: Scope = OPEN, place: Place | None = None) -> Expr:
    """Read one expression.

    Args:
        text: What a person wrote.
        scope: The names it may use.
        place: Where the text stands, for errors.

    Raises:
        NotationError: With the column, what is wrong there, and what would be read.
    """
    source = Source(text, place or Place("expression"))
    tokens = [token for token in tokenize(source, decimal_comma=True) if token.kind != "newline"]
    parser = Parser(source, tokens, scope)
    expr = parser.expression()
    parser.finish()
    return expr


def parse_quantity(text: str, scope: Scope, place: Place | None = None) -> Expr:
    """Read one expression that must be an angle, a length or a number; its units are still in it.

    Raises:
        NotationError: It cannot be read, or is none of them, such as `a1*90°` or `400 mm/(2 mm) + 1 mm`.
    """
    expr = parse(text, scope, place)
    by_inverse = is_inverse(expr)
    if by_inverse and symbols(expr):
        return expr  # what it is worth is known when its names are
    try:
        if by_inverse or any(isinstance(n, Unit) and n.name in ANGLE_UNITS for n in walk(expr)):
            to_angle(expr)
        else:
            to_length(expr)
    except DimensionError as error:
        source = Source(text, place or Place("expression"))
        raise source.error(len(text) - len(text.lstrip()), error.message, error.hint) from None
    return expr


def read_all(source: Source, tokens: Sequence[Token], scope: Scope) -> Expr:
    """Read an expression that some tokens of a text are, a cell of a matrix for one; many are the same in a class.

    Raises:
        NotationError: With the column, what is wrong there, and what would be read.
    """
    key = spelling(tokens)
    found = scope.read.get(key)
    if found is None:
        end = tokens[-1].end if tokens else 0
        parser = Parser(source, [*tokens, Token("end", "", end, end, spaced=False)], scope)
        found = parser.expression(), 0
        parser.finish()
        scope.keep(key, *found)
    return found[0]


class Parser(Calls):
    """Reads expressions from tokens; the readers of matrices and of moves share it."""

    def finish(self) -> None:
        """Make sure that nothing is left over, and that no length has two names, A1 and a1 or l1 and a1."""
        super().finish()
        words = [token for token in self.tokens if token.kind == "word"]
        for token in words:
            name = self.scope.length_meant(token.text)
            if not name:
                continue
            own = canonical(token.text)
            for other in (canonical(each.text) for each in words):
                if other != own and name in (other, self.scope.length_meant(other)):
                    raise self.error(
                        f"{token.text} stands beside {other}: are they the same?", "write one of them", token
                    )

    def _word(self, token: Token) -> Expr:
        word = token.text
        if word in ("pi", "π") or (word in ("PI", "Pi") and not self.scope.has(word)):
            if self.at("(") and self.tokens[self.position + 1].text == ")":  # a spreadsheet's PI()
                self.position += 2
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
        if self._takes_index():
            return self._operand()
        if word in ("c", "C", "s", "S") and (self._angle_follows() or self.at("^")):
            return self._function("cos" if word in "cC" else "sin", token)
        return self._joined(token)

    def _takes_index(self) -> bool:
        """Put `a_{i-1}` in the place of `ai-1` or `a(i-1)`, whose word was just taken."""
        start = self.position - 1
        pieces, replaced = indexed(self.tokens, start, self.scope)
        if pieces:
            self.tokens[start : start + replaced] = pieces
            self.position = start
        return bool(pieces)

    def _maybe_called(self, reading: Expr, token: Token) -> Expr:
        """A length called c or s, unless an angle in brackets or an angle's name follows."""
        if token.text in ("c", "s") and self._angle_follows():
            return self._function("cos" if token.text == "c" else "sin", token)
        return reading

    def _angle_follows(self) -> bool:
        """Whether what follows `c` or `s` is an angle: its name, or a bracket in which one is named."""
        if self.token.kind == "word":
            return self._names_angle(self.token.text)
        if not (self.token.kind == "sign" and self.token.text in OPENING):
            return False
        return self._bracket_names_angle()

    def _bracket_names_angle(self) -> bool:
        """Whether an angle is named in the bracket that comes next, outside the functions in it."""
        depth, at = 0, self.position
        while self.tokens[at].kind != "end":
            token = self.tokens[at]
            if token.kind == "sign":
                depth += STEPS.get(token.text, 0)
                if token.text == "°":
                    return True
                if depth == 0:
                    return False
            elif token.kind == "word" and self._names_angle(token.text):
                return True
            elif token.kind == "word" and (token.text in FUNCTIONS or token.text in "csCS"):
                at = self._behind_argument(at)
            at += 1
        return False

    def _behind_argument(self, at: int) -> int:
        """The last token of the argument of a function that stands at a token: a bracket, or `2θ1` without one."""
        tokens, last = self.tokens, at
        if tokens[last + 1].text == "^" and tokens[last + 2].kind == "number":
            last += 2
        if tokens[last + 1].text in OPENING and tokens[last + 1].kind == "sign":
            end = closing(token.text for token in tokens[last + 1 : -1])
            return len(tokens) - 2 if end < 0 else last + 1 + end
        if tokens[last + 1].kind == "number":
            last += 1
            return last + (tokens[last + 1].text == "°" or self._is_angle_word(tokens[last + 1]))
        return last + self._is_angle_word(tokens[last + 1])

    def _is_angle_word(self, token: Token) -> bool:
        return token.kind == "word" and self._names_angle(token.text)

    def _names_angle(self, word: str) -> bool:
        if word in ("deg", "rad", "pi", "π"):
            return True
        readings = self.scope.readings(word)
        if any(isinstance(reading, Symbol) and self.scope.is_angle(reading.name) for reading in readings):
            return True
        if self.scope.sums(word):
            return True
        return self.scope.is_open and is_greek(word)

    def _joined(self, token: Token) -> Expr:
        """A word that is no single name: `cosθ1`, `cos30` before its degrees, `a1c1`, or unknown."""
        if token.text in UNITS and not self.scope.has(token.text) and (unit := self._unit(token)):
            return unit
        self._check_meaning(token.text, token)
        if self._unglue():
            return self._operand()
        with_functions = self._with_functions(token)
        if with_functions:
            return self._build(token, multiply, *with_functions)
        ways = self.scope.split(token.text)
        if len(ways) == 1:
            return self._build(token, multiply, *ways[0])
        if ways:
            raise self._question(token, [" * ".join(map(trig_name, way)) for way in ways])
        return self._resolve(token.text, token)

    def _unit(self, token: Token) -> Expr | None:
        """A unit behind a sign, as in `30*deg`; none where `m` may be a name, and an error where no number stands."""
        may_be_name = len(token.text) == 1 and self.scope.is_open
        before = [each.text for each in self.tokens[max(self.position - 3, 0) : self.position - 1]]
        behind_sign = len(before) == 2 and before[1] == "*" and (before[0] == ")" or before[0][:1].isdecimal())  # noqa: PLR2004
        if may_be_name:
            return None
        if not behind_sign:
            raise self.error(f"{token.text} is a unit, and no number stands before it", f"write 1 {token.text}", token)
        return Unit(token.text)

    def _check_meaning(self, word: str, token: Token, *, is_last: bool = False) -> None:
        """Refuse a word that is a function or a unit that is not read, or no number."""
        before = self.tokens[self.position - 2] if self.position > 1 else token
        called = is_last and self.token.kind == "sign" and self.token.text in OPENING
        message, hint = refusal(word, self.scope.names, called=called, measured=before.kind == "number")
        if message:
            raise self.error(message, hint, token)

    def _unglue(self) -> bool:
        """Put the tokens of `cos30°`, `sqrt3` or `a2cos(...)` in the place of the word that was just taken."""
        start = self.position - 1
        pieces, replaced = unglued(self.tokens, start, self.scope, angle_follows=self._angle_follows())
        if not pieces:
            return False
        name, number = pieces[-2].text, pieces[-1].text
        if pieces[-1].kind == "number" and name != "sqrt" and not in_degrees(self.tokens, start + replaced):
            hint = f"write {name}({number}°) for degrees, {name}({number}) for radians"
            if self.scope.readings(name[0] + number):
                hint += f", {name[0]}{number} for a joint angle"
            raise self.error(f"{name}{number} does not say what {number} is", hint, pieces[-2])
        self.tokens[start : start + replaced] = pieces
        self.position = start
        return True

    def _with_functions(self, token: Token) -> tuple[Expr, ...]:
        """The factors of `a1cosθ1sinθ12`; none if a piece of it means nothing, or two things."""
        head, *rest = _FUNCTION.split(token.text)
        ways: list[tuple[Expr, ...]] = self.scope.split(head) if head else [()]
        if rest and not ways and self.scope.is_open and is_factor(head, self.scope):
            ways = [(self._resolve(head, token),)]
        if not rest or len(ways) != 1:
            return ()
        factors = list(ways[0])
        for name, angle in zip(rest[::2], rest[1::2], strict=True):
            if not angle[:1].isalpha():
                return ()
            trig = self.scope.readings(name[0] + angle)
            if self._names_angle(angle):
                factors.append(self._apply(name, [self._resolve(angle, token)], token))
            elif len(trig) == 1 and isinstance(trig[0], Trig):
                factors.append(trig[0])
            else:
                return ()
        return tuple(factors)

    def _resolve(self, word: str, token: Token) -> Expr:
        readings = self.scope.readings(word)
        if readings:
            return readings[0]
        sums = self.scope.sums(word)
        if len(sums) == 1:
            return add(*(Symbol(name) for name, _ in sums[0].terms))
        if self.scope.is_open:
            pieces = _PIECES.findall(word)
            if len(pieces) > 1 and "".join(pieces) == word:
                return self._build(token, multiply, *(self._resolve(piece, token) for piece in pieces))
            self._check_meaning(word, token, is_last=token.text.endswith(word))
            if self.scope.is_usual and not is_usual(word):
                raise self._unusual(word, token)
            return Symbol(canonical(word))
        if not self.scope.split(word):
            self._check_meaning(word, token, is_last=token.text.endswith(word))
        unit = unit_meant(word)
        hint = f"the unit is written {unit}" if unit else self._square(word) or suggestion(word, self.scope.names)
        raise self.error(f"{word} is not a name that is known here", hint, token)

    def _square(self, word: str) -> str:
        """A hint at the square that a 2 on the line may be, `px2` for px²; `a2` is rather an index."""
        base = word[:-1]
        is_length = len(base) > 1 and self.scope.has(base) and not self.scope.is_angle(canonical(base))
        return f"the square is written {base}^2" if word.endswith("2") and is_length else ""

    def _unusual(self, word: str, token: Token) -> NotationError:
        hint = nearest_meaning(word, self.scope.names)
        hint = f"{hint} " if hint.startswith("did") else ""
        hint += f"a name is a letter with an index, such as l1; declare others: --symbols {canonical(word)}"
        return self.error(f"{word} is not a name, a function or a unit that is known here", hint, token)

    def _question(self, token: Token, readings: list[str]) -> NotationError:
        return self.error(f"{token.text} could be " + " or ".join(readings), "write it out", token)
