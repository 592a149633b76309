"""Conditions under which a Jacobian loses rank, as typed: `s3 = 0`, `theta3 = 0 or 180°`, `s2 = 0 and s6 = 0`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from itertools import product as every
from typing import TypeAlias

from dhcli.algebra.equality import equal
from dhcli.checking.exercise import Exercise
from dhcli.checking.pasted import UnreadableError
from dhcli.errors import NotationError, Place
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.conditions import Put, zeroing
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO, Expr, Number, Power, Product, Symbol, Trig, add, multiply, negate
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import substitute, symbols, walk
from dhcli.notation.writer import write, write_angle
from dhcli.regex import regex

_BETWEEN = regex(r"(,|;|\n|\bor\b|\u2228|\band\b|&+|∧)")
_AND = regex(r"and|&+|∧")
_ON_LINES = regex(r"\s{0,9}(\band\b|&+|∧)\s{0,9}")
"""`and` with the ends of lines around it, which part nothing there."""
_AT_ONCE = regex(r"\(([^(),;\n]{1,200}=[^(),;\n]{1,200})\)(?!\s*=)")
"""`(d2 = 0 and theta3 = 0)`: brackets around what is zero at once; with `or` in them they would say more."""
_WHEN = regex(r"\A\s{0,9}(?:when(?:ever)?|if|where|for|at|singular (?:when|if|for|at))\b\s{0,9}", re.IGNORECASE)
_IS = regex(r"(?<=[\w)])\s{1,9}(?:is|equals)\s{1,9}(?=[-+\d.kn±]|pi|π)")
"""`when theta2 is 0 or 180 degrees`."""
_TURNS = regex(r"(?P<first>.*?)[+±]?\s*\b[knm]\s*[*·]?\s*(?:180(?:\s*°|\s*deg)?|pi|π)")
"""`k*180°`, `90° + n*pi`: half turns as often as one likes."""
_EITHER = regex(
    r"(?P<first>[+−-]?(?:0|[\d.]{1,9}\s?°))\s?/\s?(?P<other>[+−-]?(?:0|90|180|270|360|[^/]{0,20}(?:°|deg|pi|π)))"  # noqa: RUF001
)
"""`0°/180°`: one or the other, for nobody divides an angle by an angle here."""

_ONE_OF = regex(r"\s{0,9}(?:∈|\\in\b|(?<=[\w}\s])in(?=\s*\\?\{))\s*\\?\{(?P<values>[^{}]{1,99}?)\\?\}")
"""`θ2 ∈ {0, π}`: one of these."""

_WHOLE = regex(
    r"[,;]?\s{0,9}(?:(?:with|where|for|\()\s{0,9})?(?<![^\W_])[knm]\s{0,9}(?:∈|\\in\b|in\b)"
    r"\s{0,9}(?:ℤ|Z\b|\\mathbb\s?\{?Z\}?)\s?\)?"  # noqa: RUF001
)
"""What is said of n behind `n*180°`: that it is whole."""
_THAT_IS = regex(r",?\s{0,9}(?:\bi\.\s?e\.,?|⇒|⟹|=>)\s*")
"""The same in other words: `s2 = 0, i.e. theta2 = 0 or 180°`."""
_SEPARATED = regex(r"[,;\n]|\sor\s(?=[^,;\n]*=)")
"""Between two conditions, and not between two angles."""

_LISTED = regex(r"(?:(?<=[,;\n])|\A)\s*([^\W\d]\w{0,20})\s*,\s*([^\W\d]\w{0,20})\s*=(?!=)")
"""Names side by side, the first without a value of its own."""

HALF_TURN, TURN = 180, 360
LONGEST = 2000
MOST = 64
"""Conditions that are read."""


@frozen
class Zero:
    """Something that is zero.

    Attributes:
        expr: What is zero.
        at: The angle [degrees] of the one of its two zeros in a turn that was meant; None for both.
    """

    expr: Expr
    at: Rational | None = None


Condition: TypeAlias = frozenset[Zero]
"""What is zero at once."""


def read_conditions(text: str, exercise: Exercise, place: Place | None, *, joined: bool) -> tuple[Condition, ...]:
    """Read conditions, each of which is enough by itself.

    Args:
        text: What was typed.
        exercise: The exercise, for its names and its joints.
        place: Where it stands, for errors.
        joined: Whether `and` stands between what is zero at once; else it is another word for a comma.

    Raises:
        UnreadableError: They cannot be judged, or are too many.
        NotationError: One cannot be read.
    """
    if len(text) > LONGEST:
        raise UnreadableError(f"an answer of more than {LONGEST} characters is not read")
    if text.strip().lower() in ("never", "nowhere"):
        return ()
    text = _THAT_IS.sub(", ", _WHOLE.sub("", _IS.sub(" = ", _WHEN.sub("", text))))
    text = _ONE_OF.sub(lambda one: f" = {' or '.join(one['values'].split(','))}", text.strip())
    text = _ON_LINES.sub(r" \1 ", _AT_ONCE.sub(_unbracketed, text))
    _check_values(text, exercise)
    found: list[Condition] = []
    for group in _groups(text.strip("{}[]"), joined=joined):
        atoms = [tuple(_zeros(left, rights, exercise, place or Place("answer"))) for left, rights in group]
        found += (frozenset(zeros) for zeros in every(*atoms))
        if len(found) > MOST:
            raise UnreadableError(f"more than {MOST} conditions are not read")
    return _merged(found)


def _unbracketed(found: re.Match[str]) -> str:
    return found[0] if re.search(r"\bor\b|\u2228", found[1]) else found[1]


def _check_values(text: str, exercise: Exercise) -> None:
    """Refuse `theta1, theta2 = 0 or 180°`, which may mean either or both at once.

    Raises:
        UnreadableError: A joint that turns stands without a value before one that has some.
    """
    turning = exercise.robot.angles if exercise.robot else ()
    for match in _LISTED.finditer(text):
        readings = [exercise.scope.readings(name) for name in match.groups()]
        names = [one[0].name for one in readings if len(one) == 1 and isinstance(one[0], Symbol)]
        if len(names) == len(readings) and set(names) <= set(turning):
            values = " or ".join(f"{name} = ..." for name in names)
            raise UnreadableError(f"{names[0]} stands without a value before {names[1]}: write {values}")


def last_said(text: str) -> str:
    """A text without what it says again in other words: of `s2 = 0, i.e. theta2 = 0 or 180°` the angles are left."""
    *others, last = _THAT_IS.split(text)
    ends = (max((found.end() for found in _SEPARATED.finditer(one)), default=0) for one in others)
    return "".join(one[:end] for one, end in zip(others, ends, strict=True)) + last


def _groups(text: str, *, joined: bool) -> list[list[tuple[str, list[str]]]]:
    """Equations that hold at once, each as its left side and its right sides of which one is meant."""
    groups: list[list[tuple[str, list[str]]]] = []
    pieces = ["", *_BETWEEN.split(text)]
    for between, piece in zip(pieces[::2], pieces[1::2], strict=True):
        *lefts, right = (side.strip() for side in piece.split("="))
        if not piece.strip():
            continue
        if not lefts:
            if groups and _is_constant(right):  # theta3 = 0 or 180°
                groups[-1][-1][1].extend(_each(right))
                continue
            lefts, right = [right], "0"
        if len(lefts) > 1 and not joined:
            raise UnreadableError("write each condition by itself, with a comma between")
        equations = [(left, list(_each(right))) for left in lefts]  # s2 = s6 = 0: both
        if joined and groups and _AND.fullmatch(between):
            groups[-1] += equations
        else:
            groups.append(equations)
    return groups


def _each(right: str) -> Iterator[str]:
    """The values that a right side stands for: two for ±90°, for k*180° and for 0°/180°."""
    turns, either = _TURNS.fullmatch(right), _EITHER.fullmatch(right)
    if either:
        yield from (either["first"], either["other"])
    elif turns:
        first = turns["first"].strip() or "0°"
        yield from (first, f"{first} + 180°")
    elif right.startswith("±"):
        yield from (right[1:], f"-({right[1:]})")
    else:
        yield right


def _is_constant(text: str) -> bool:
    try:
        return not any(symbols(parse(one, Scope(is_open=True))) for one in _each(text))
    except NotationError:  # what cannot be read is told where it is read
        return False


def _zeros(left: str, rights: Sequence[str], exercise: Exercise, place: Place) -> Iterator[Zero]:
    """What an equation makes zero, each enough for it."""
    for right in rights:
        one, other = (parse(side, exercise.scope, place) for side in (left, right))
        named, robot = symbols(one), exercise.robot
        joints = frozenset(robot.angles) & frozenset(robot.variables) if robot else frozenset[str]()
        try:
            if named and named <= joints and not any(isinstance(node, Trig) for node in walk(one)):
                yield _at_angle(to_angle(one) - to_angle(other, bare="deg"))
            else:
                yield from map(Zero, apart(add(to_length(one), negate(to_length(other))), exercise))
        except DimensionError as error:
            raise UnreadableError(error.message) from None


def _at_angle(angle: Angle) -> Zero:
    """The cosine or sine that is zero where an angle is."""
    if angle.radians:
        raise UnreadableError("write angles in degrees, or as multiples of pi")
    bare = Angle(angle.terms)
    quarter = angle.degrees % HALF_TURN
    if quarter not in (0, HALF_TURN // 2):
        raise UnreadableError(f"{write_angle(bare)} = {float(-angle.degrees):g}° cannot be judged; write what is zero")
    return Zero(sine(bare) if quarter == 0 else cosine(bare), -angle.degrees % TURN)


def apart(expr: Expr, exercise: Exercise) -> list[Expr]:
    """The factors of a product that hold a joint, each once.

    Raises:
        UnreadableError: None does.
    """
    variables = frozenset(exercise.robot.variables) if exercise.robot else frozenset[str]()
    factors = expr.factors if isinstance(expr, Product) else (expr,)
    bases = [factor.base if isinstance(factor, Power) and factor.exponent > 0 else factor for factor in factors]
    found = [base for base in bases if symbols(base) & variables]
    if not found:
        shown = write(expr, "short", exercise.writing)
        what = "a number" if isinstance(expr, Number) else "a length that does not change"
        raise UnreadableError(f"{shown} is {what}: write what the joints make zero")
    return found


def _merged(conditions: Iterable[Condition]) -> tuple[Condition, ...]:
    """Two conditions that differ in which zero of a sine is meant are one."""
    found = list(dict.fromkeys(conditions))
    for one, other in combinations(found, 2):
        if len(here := one - other) == len(there := other - one) == 1:
            (a,), (b,) = here, there
            if a.expr == b.expr:
                rest = [condition for condition in found if condition not in (one, other)]
                return _merged([*rest, (one & other) | {Zero(a.expr)}])
    return tuple(found)


def covers(wanted: Condition, typed: Condition, robot: Robot) -> bool:
    """Whether all that one condition makes zero is zero under another as well."""
    return all(any(_implied(zero, other, typed, robot) for other in typed) for zero in wanted)


def _implied(zero: Zero, typed: Zero, at_once: Condition, robot: Robot) -> bool:
    """Whether something is zero where something else is, of all that is zero at once."""
    if typed.at is not None and zero.at != typed.at:
        return False
    if alike(zero.expr, typed.expr, robot):
        return True
    others = [one.expr for one in at_once if one != typed and one.at is None]
    return any(
        ways and all(_left(zero.expr, typed.expr, values, robot) for values in ways)
        for ways in (zeroing(other, robot.variables) for other in others)
    )


def _left(zero: Expr, typed: Expr, values: Put, robot: Robot) -> bool:
    """The same where a joint has a value."""
    one, other = (substitute(expr, *values) for expr in (zero, typed))
    return equal(one, ZERO) or (not equal(other, ZERO) and alike(one, other, robot))


def alike(first: Expr, second: Expr, robot: Robot) -> bool:
    """Whether two factors are the same up to a constant: f(q) g(q') = g(q) f(q') for all q and q'."""
    slides = {name: Symbol(f"{name}_b") for name in robot.variables if name not in robot.angles}
    turns = {name: Angle.of(f"{name}_b") for name in robot.variables if name in robot.angles}
    one, other = (substitute(expr, slides, turns) for expr in (first, second))
    return equal(multiply(first, other), multiply(second, one))
