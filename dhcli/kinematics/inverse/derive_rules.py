"""The rules of a derivation: how one unknown is read off one equation, or off two."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypeAlias

from dhcli.algebra.equality import equal
from dhcli.frozen import frozen
from dhcli.kinematics.inverse.derive_levels import Equation
from dhcli.kinematics.inverse.derive_terms import Atom, Coefficients, Knowledge, in_atom
from dhcli.notation.angle import magnitude
from dhcli.notation.tree import (
    HALF,
    ONE,
    PI,
    ZERO,
    Call,
    Expr,
    Number,
    Power,
    Product,
    Trig,
    add,
    decimal,
    is_negative,
    multiply,
    negate,
    power,
)
from dhcli.notation.walk import operations

Rule = Literal["SUM", "SLIDE", "BOTH", "RATIO", "ZERO", "ONE", "SQUARES"]

Two: TypeAlias = Literal["", "plus-minus", "opposite"]
"""Whether there is one value, two that differ by the sign before a term, or two that are half a turn apart."""


FAINT = 1e-3
"""A sine and a cosine this much smaller than those of another step to the same angle leave it the say."""


@frozen
class Step:
    """One step of a derivation.

    Attributes:
        rule: The rule.
        atom: What is found.
        equations: From what.
        value: The value, or what stands before the sign.
        spread: What stands behind ±; None where nothing does.
        two: Whether there are two values.
        condition: What must not be 0, or must not be beyond ±1; None where nothing can go wrong.
        instead: Another step to the same unknown, with as many values, that says something where this one does not.
    """

    rule: Rule
    atom: Atom
    equations: tuple[Equation, ...]
    value: Expr
    spread: Expr | None = None
    two: Two = ""
    condition: Expr | None = None
    instead: Step | None = None

    @property
    def arc(self) -> tuple[Expr, ...]:
        """Sine and cosine of which it is the angle; nothing where it is none."""
        return self.value.arguments if isinstance(self.value, Call) and self.value.function == "atan2" else ()

    @property
    def is_met_often(self) -> bool:
        """Whether it says nothing where one joint stands at 0 or at a right angle, as in many ordinary poses."""
        one = self.condition
        return type(one) is Trig or (type(one) is Product and Trig in map(type, one.factors))


def difference(one: Equation, atom: Atom, known: Knowledge) -> Coefficients | None:
    """Coefficients of an equation in an unknown, `k0 + k1 c + k2 s = 0`."""
    right, left = in_atom(one.right, atom, known), in_atom(one.left, atom, known)
    if right is None or left is None:
        return None
    k0, k1, k2 = (add(r, negate(x)) for r, x in zip(right, left, strict=True))
    return k0, k1, k2


def slide(one: Equation, atom: Atom, k: Coefficients) -> Step | None:
    """SLIDE: a length from an equation linear in it."""
    if k[2] != ZERO or k[1] == ZERO:
        return None
    value = divided(negate(k[0]), k[1])
    return Step("SLIDE", atom, (one,), value, condition=None if type(k[1]) is Number else k[1])


Found: TypeAlias = tuple[Equation, Coefficients]
"""An equation and its coefficients in an unknown."""


def both(one_found: Found, other_found: Found, atom: Atom, sign: int) -> Step | None:
    """BOTH: cosine and sine from two equations.

    Args:
        one_found: An equation linear in both.
        other_found: Another.
        atom: The angle.
        sign: Sign of their determinant where it is always the same; 0 where it changes.
    """
    (first, one), (second, other) = one_found, other_found
    if not sign:
        return None
    (e1, a1, b1), (e2, a2, b2) = (negate(one[0]), *one[1:]), (negate(other[0]), *other[1:])
    if ZERO not in {a1, b1} and a1 == b2 and b1 == negate(a2):
        # a c + b s = e1 and a s - b c = e2: the angle is that of (e1, e2), turned by that of (a, b)
        turn = Call("atan2", (b1, a1)) if not _starts_negative(b1) else negate(Call("atan2", (negate(b1), a1)))
        return Step("BOTH", atom, (first, second), add(Call("atan2", (e2, e1)), turn), condition=_hypot(a1, b1))
    if ZERO not in {a1, b1} and a1 == negate(b2) and b1 == a2:
        turn = Call("atan2", (b1, a1)) if not _starts_negative(b1) else negate(Call("atan2", (negate(b1), a1)))
        return Step("BOTH", atom, (first, second), add(Call("atan2", (negate(e2), e1)), turn), condition=_hypot(a1, b1))
    s = add(multiply(a1, e2), negate(multiply(a2, e1)))
    c = add(multiply(e1, b2), negate(multiply(e2, b1)))
    if sign < 0:
        s, c = negate(s), negate(c)
    det = add(multiply(a1, b2), negate(multiply(a2, b1)))
    return Step("BOTH", atom, (first, second), Call("atan2", (s, c)), condition=None if type(det) is Number else det)


def _starts_negative(expr: Expr) -> bool:
    terms = getattr(expr, "terms", (expr,))
    return is_negative(terms[0]) if isinstance(terms, tuple) and isinstance(terms[0], Expr) else is_negative(expr)


Single: TypeAlias = tuple[tuple[Atom, Expr, str], Expr]
"""Cosine or sine of an unknown, what it is multiplied by, which of the two it is, and what that comes to."""


def ratio(one_found: tuple[Equation, list[Single]], other_found: tuple[Equation, list[Single]]) -> Step | None:
    """RATIO: cosine and sine of an angle, each times the same unknown."""
    (first, one), (second, other) = one_found, other_found
    for (angle, f1, kind1), e1 in one:
        for (same, f2, kind2), e2 in other:
            if (kind1, kind2) == ("cos", "sin") and same == angle and f2 in {f1, negate(f1)}:
                s = e2 if f1 == f2 else negate(e2)
                return Step("RATIO", angle, (first, second), Call("atan2", (s, e1)), two="opposite", condition=f1)
    return None


def single(one: Equation, known: Knowledge) -> list[Single]:
    """An equation as cosine or sine of an unknown times something, equal to something known."""
    found = list[Single]()
    for side, other in ((one.right, one.left), (one.left, one.right)):
        if type(side) is not Product or not known.is_known(other):
            continue
        trigs = [f for f in side.factors if type(f) is Trig and known.unknown_terms(f.angle)]
        for trig in trigs:
            rest = multiply(*(f for f in side.factors if f is not trig))
            if known.is_known(rest) or trig.angle.degrees or trig.angle.radians:
                continue
            found.append(((trig.angle.terms, rest, trig.function), other))
    return found


def of_coefficients(k: Coefficients, atom: Atom, equations: tuple[Equation, ...], rule: Rule = "ONE") -> Step | None:
    """ZERO and ONE: two angles from `k0 + k1 c + k2 s = 0`."""
    k0, a, b = k
    if a == ZERO and b == ZERO:
        return None
    e = negate(k0)
    if _starts_negative(a if a != ZERO else b):
        a, b, e = negate(a), negate(b), negate(e)
    if e == ZERO:
        if ZERO in {a, b}:
            return None
        return Step("ZERO", atom, equations, Call("atan2", (negate(a), b)), two="opposite", condition=_hypot(a, b))
    factor = common_factor(a, b)
    a, b, e = divided(a, factor), divided(b, factor), divided(e, factor)
    size = _hypot(a, b)
    over = divided(e, size) if ZERO in {a, b} else over_root(e, size)
    base = ZERO if b == ZERO else multiply(Number(HALF), PI) if a == ZERO else _arc(b, a)
    return Step(rule, atom, equations, base, Call("acos", (over,)), "plus-minus", over)


def common_factor(a: Expr, b: Expr) -> Expr:
    """What two products have in common: lengths, and a number that stands in both; 1 where one of them is 0 as well."""
    if ZERO in {a, b}:
        return ONE
    first, second = (list(x.factors) if type(x) is Product else [x] for x in (a, b))
    shared = [factor for factor in first if factor in second and type(factor) is not Number]
    numbers = [magnitude(f[0].value) if type(f[0]) is Number else 1 for f in (first, second)]
    number = numbers[0] if numbers[0] == numbers[1] else 1
    return multiply(Number(number), *shared)


def over_root(one: Expr, root: Expr) -> Expr:
    """A quotient by a root, with the root below the line."""
    if type(root) is not Power or root.exponent != HALF:
        return divided(one, root)
    below = Power(root, -1)  # not folded into a power of minus one half, which nobody writes
    factors = one.factors if type(one) is Product else (one,)
    return below if one == ONE else Product((*factors, below))


def squared(level: Equation, left: Sequence[Expr], right: Sequence[Expr], atom: Atom, known: Knowledge) -> Step | None:
    """SQUARES: the squares of position entries, added, hold one unknown; it follows by ONE, or as a root."""
    parts = [in_atom(part, atom, known) for part in right]
    if any(part is None for part in parts):
        return None
    rows = [part for part in parts if part is not None]
    total = add(*(power(part, 2) for part in left))
    constant = add(*(power(r[0], 2) for r in rows))
    first = add(*(multiply(r[0], r[1]) for r in rows))
    if isinstance(atom, str):
        if any(r[2] != ZERO for r in rows):
            return None
        lead = add(*(power(r[1], 2) for r in rows))
        if not equal(first, ZERO) or lead == ZERO:
            return None
        inside = divided(add(total, negate(constant)), lead)
        return Step("SQUARES", atom, (level,), ZERO, power(inside, HALF), "plus-minus", inside)
    cc, ss, cs = (add(*(multiply(x, y) for x, y in pairs)) for pairs in (
        [(r[1], r[1]) for r in rows], [(r[2], r[2]) for r in rows], [(r[1], r[2]) for r in rows]))  # fmt: skip
    if not equal(cc, ss) or not equal(cs, ZERO):
        return None
    second = add(*(multiply(r[0], r[2]) for r in rows))
    shorter = min(cc, ss, key=operations)
    k0 = negate(add(total, negate(constant), negate(shorter)))
    two = Number(2)
    first = ZERO if equal(first, ZERO) else first
    second = ZERO if equal(second, ZERO) else second
    made = of_coefficients((k0, multiply(two, first), multiply(two, second)), atom, (level,), "SQUARES")
    return made if made is None or made.rule == "SQUARES" else Step("SQUARES", *_tail(made))


def _tail(step: Step) -> tuple[Atom, tuple[Equation, ...], Expr, Expr | None, Two, Expr | None]:
    return step.atom, step.equations, step.value, step.spread, step.two, step.condition


def divided(one: Expr, other: Expr) -> Expr:
    """A quotient, plain where the divisor is a number."""
    return one if other == ONE else multiply(one, power(other, -1))


def _hypot(a: Expr, b: Expr) -> Expr:
    if b == ZERO:
        return a
    if a == ZERO:
        return b
    if _is_one_angle(a, b):
        return ONE
    first, second = sorted((power(a, 2), power(b, 2)), key=str)
    return power(add(first, second), HALF)


def _is_one_angle(a: Expr, b: Expr) -> bool:
    """Whether two are the cosine and the sine of one angle, in either order."""
    return type(a) is Trig and type(b) is Trig and a.angle == b.angle and a.function != b.function


def _arc(s: Expr, c: Expr) -> Expr:
    """The angle of a sine and a cosine; one in radians that was given is itself."""
    if type(s) is Trig and s.function == "sin" and _is_one_angle(s, c) and not s.angle.terms and not s.angle.degrees:
        return decimal(s.angle.radians)
    return Call("atan2", (s, c))
