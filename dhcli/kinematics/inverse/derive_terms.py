"""What of an expression is unknown, and its coefficients in one unknown: the algebra of a derivation."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

from dhcli.notation.angle import Angle, Rational
from dhcli.notation.tree import ONE, ZERO, Expr, Power, Product, Sum, Symbol, Trig, add, multiply, negate
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import children, walk

Terms: TypeAlias = tuple[tuple[str, Rational], ...]
"""Names and multiples of a sum of angles."""

Atom: TypeAlias = Terms | str
"""An unknown: a sum of joint angles that is found as a whole, or a joint that slides."""

Coefficients: TypeAlias = tuple[Expr, Expr, Expr]
"""Of 1, cosine and sine of an angle; of 1, length and its square."""


@dataclass
class Knowledge:
    """What has been found on the way.

    Attributes:
        unknown: Joints that are not known yet.
        sums: Sums of them that are.
    """

    unknown: set[str]
    sums: list[Terms] = field(default_factory=list)

    def unknown_terms(self, angle: Angle) -> Terms:
        """The part of an angle that is unknown."""
        left = {name: factor for name, factor in angle.terms if name in self.unknown}
        for known in sorted(self.sums, key=len, reverse=True):  # a part of another one leaves what that has more
            if _sign(known, left):
                for name, _ in known:
                    del left[name]
        return tuple(sorted(left.items()))

    def atom(self, among: Iterable[Symbol | Trig]) -> Atom | None:
        """The one unknown among names, cosines and sines; None if there is none, or more than one."""
        whole, parts, slides = set[Terms](), set[Terms](), set[str]()
        for node in among:
            if type(node) is Symbol and node.name in self.unknown:
                slides.add(node.name)
            elif type(node) is Trig and (part := self.unknown_terms(node.angle)):
                whole.add(positive(node.angle.terms))
                parts.add(positive(part))
        if slides:
            return slides.pop() if len(slides) == 1 and not parts else None
        if len(whole) == 1:
            return whole.pop()
        return parts.pop() if len(parts) == 1 else None

    def is_known(self, expr: Expr) -> bool:
        """Whether nothing in an expression is unknown."""
        return not any(
            (type(node) is Symbol and node.name in self.unknown)
            or (type(node) is Trig and bool(self.unknown_terms(node.angle)))
            for node in walk(expr)
        )

    def learn(self, atom: Atom) -> None:
        """Take an unknown as known."""
        if isinstance(atom, str):
            self.unknown.discard(atom)
        elif len(atom) == 1:
            self.unknown.discard(atom[0][0])
        else:
            self.sums.append(atom)
        left = (tuple(term for term in known if term[0] in self.unknown) for known in self.sums)
        self.sums = [known for known in left if known]


def name_of(atom: Atom) -> str:
    """What an unknown is called: theta2, d3, and theta23 for theta2 + theta3."""
    if isinstance(atom, str):
        return atom
    if len(atom) == 1:
        return atom[0][0]
    stems = {name.rstrip("0123456789") for name, _ in atom}
    if len(stems) == 1 and all(abs(factor) == 1 for _, factor in atom):
        plus, minus = ("".join(n[len(n.rstrip("0123456789")) :] for n, f in atom if f == sign) for sign in (1, -1))
        return stems.pop() + plus + (f"m{minus}" if minus else "")
    return "_".join(("sum", *(name for name, _ in atom)))


def length(expr: Expr) -> int:
    """How long an expression is: its nodes."""
    return 1 + sum(map(length, children(expr)))


def positive(terms: Terms) -> Terms:
    """The same sum with a positive first multiple."""
    return terms if not terms or terms[0][1] > 0 else tuple((name, -factor) for name, factor in terms)


def in_atom(expr: Expr, atom: Atom, known: Knowledge) -> Coefficients | None:
    """The coefficients of an expression in one unknown; None if it is not linear in cosine and sine, or quadratic.

    Args:
        expr: The expression.
        atom: The unknown.
        known: What is known; other unknowns are taken as numbers too.
    """
    if not _holds(expr, atom, known):
        return expr, ZERO, ZERO
    if type(expr) is Symbol:
        return ZERO, ONE, ZERO
    if type(expr) is Trig:
        return _of_trig(expr, atom)
    if type(expr) is Sum:
        parts = [in_atom(term, atom, known) for term in expr.terms]
        if any(part is None for part in parts):
            return None
        k0, k1, k2 = zip(*(part for part in parts if part is not None), strict=True)
        return add(*k0), add(*k1), add(*k2)
    if type(expr) is Product:
        inside = [factor for factor in expr.factors if _holds(factor, atom, known)]
        if len(inside) != 1 or (part := in_atom(inside[0], atom, known)) is None:
            return None
        others = [factor for factor in expr.factors if factor is not inside[0]]
        return (multiply(*others, part[0]), multiply(*others, part[1]), multiply(*others, part[2]))
    if isinstance(expr, Power) and isinstance(atom, str) and expr == Power(Symbol(atom), 2):
        return ZERO, ZERO, ONE
    return None


def _holds(expr: Expr, atom: Atom, known: Knowledge) -> bool:
    """Whether an unknown stands in an expression."""
    if isinstance(atom, str):
        return any(type(node) is Symbol and node.name == atom for node in walk(expr))
    return any(
        type(node) is Trig and bool(_multiple(node.angle, atom)) and bool(known.unknown_terms(node.angle))
        for node in walk(expr)
    )


def _multiple(angle: Angle, atom: Terms) -> int:
    """1 or -1 if the angle is the unknown or its opposite, with known angles beside it; else 0."""
    return _sign(atom, dict(angle.terms))


def _sign(terms: Terms, held: Mapping[str, Rational]) -> int:
    """1 or -1 if terms stand among others, all as they are or all with the opposite sign; else 0."""
    if any(name not in held for name, _ in terms):
        return 0
    if all(held[name] == factor for name, factor in terms):
        return 1
    return -1 if all(held[name] == -factor for name, factor in terms) else 0


def _of_trig(expr: Trig, atom: Atom) -> Coefficients | None:
    assert not isinstance(atom, str)  # noqa: S101  a slide stands in no angle
    sign = _multiple(expr.angle, atom)
    if not sign:
        return None
    names = {name for name, _ in atom}
    beside = Angle(tuple(t for t in expr.angle.terms if t[0] not in names), expr.angle.degrees, expr.angle.radians)
    c, s = cosine(beside), sine(beside)
    if expr.function == "cos":
        return ZERO, c, negate(s) if sign > 0 else s
    return ZERO, s, c if sign > 0 else negate(c)
