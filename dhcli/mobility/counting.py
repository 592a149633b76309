"""The counting formula, in both of its forms, with the numbers filled in.

F = λ(n - j - 1) + Σf and F = λ(n - 1) - ΣC, where n counts the ground and C = λ - f; they are equal because
ΣC = λj - Σf. Counts may hold names: a machine with n arms has its F as a formula in n.

Source: Grübler 1883, Kutzbach 1929; Lynch and Park, Modern Robotics, section 2.2.1; Yim, week 5.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from dhcli.frozen import frozen
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.pairs import LinkageError, Pair, Space
from dhcli.notation.tree import ONE, ZERO, Expr, Number, Product, Sum, add, is_negative, multiply, number
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

MOST_TERMS = 200
"""Terms that a product of sums may have; counts are short."""


@frozen
class Group:
    """Joints of one kind, their count, and the freedoms f and constraints c = λ - f of each."""

    pair: Pair
    count: Expr
    f: int
    c: int


@frozen
class Counts:
    """What goes into the formula.

    Attributes:
        space: Where the linkage moves; gives λ.
        n: Links, the ground among them.
        groups: The joints by kind.
        title: What was counted.
        reading: How a short pattern was read.
    """

    space: Space
    n: Expr
    groups: tuple[Group, ...]
    title: str = ""
    reading: str = ""

    @classmethod
    def of(cls, linkage: Linkage) -> Counts:
        """The counts of a joint graph."""
        found: dict[Pair, int] = {}
        for joint in linkage.joints:
            found[joint.pair] = found.get(joint.pair, 0) + 1
        numbers = [(pair, number(count)) for pair, count in found.items()]
        return counts(
            linkage.space, number(len(linkage.links)), numbers, linkage.title or linkage.name, linkage.reading
        )

    @cached_property
    def pattern(self) -> str:
        """The joints in short: `4R`, `3*n R`."""
        return " ".join(
            f"{group.count}{'' if isinstance(group.count, Number) and group.pair.letter else ' '}"
            f"{group.pair.letter or group.pair.name}"
            for group in self.groups
        )

    @cached_property
    def j(self) -> Expr:
        """Joints."""
        return expanded(add(ZERO, *(group.count for group in self.groups)))

    @cached_property
    def sum_f(self) -> Expr:
        """Freedoms of all joints, Σf."""
        return expanded(add(ZERO, *(group.count * group.f for group in self.groups)))

    @cached_property
    def sum_c(self) -> Expr:
        """Constraints of all joints, ΣC."""
        return expanded(add(ZERO, *(group.count * group.c for group in self.groups)))

    @cached_property
    def by_freedoms(self) -> Expr:
        """F = λ(n - j - 1) + Σf."""
        return expanded(number(self.space.lambda_) * (self.n - self.j - 1) + self.sum_f)

    @cached_property
    def by_constraints(self) -> Expr:
        """F = λ(n - 1) - ΣC."""
        return expanded(number(self.space.lambda_) * (self.n - 1) - self.sum_c)

    @property
    def is_number(self) -> bool:
        """Whether F is a number, and not a formula."""
        return isinstance(self.by_freedoms, Number)

    @property
    def gruebler(self) -> int | None:
        """F as a whole number; None where it is a formula."""
        return int(self.by_freedoms.value) if isinstance(self.by_freedoms, Number) else None

    @cached_property
    def formulas(self) -> tuple[str, str]:
        """Both forms with the numbers filled in."""
        lambda_, n, j = self.space.lambda_, _shown(self.n), _shown(self.j, inside=True)
        f, c = _sum_text([(g.count, g.f) for g in self.groups]), _sum_text([(g.count, g.c) for g in self.groups])
        total = write(self.by_freedoms)
        return (
            f"F = λ(n - j - 1) + Σf = {lambda_}({n} - {j} - 1) + {f} = {total}",
            f"F = λ(n - 1) - ΣC = {lambda_}({n} - 1) - {c} = {write(self.by_constraints)}",
        )


def counts(space: Space, n: Expr, joints: Iterable[tuple[Pair, Expr]], title: str = "", reading: str = "") -> Counts:
    """Counts from numbers or formulas.

    Raises:
        LinkageError: A count is negative, not whole, or too few joints tie the links together.
    """
    groups = tuple(
        Group(pair, _checked(count, f"joints {pair.name}"), space.freedoms(pair), space.constraints(pair))
        for pair, count in joints
    )
    found = Counts(space, _checked(n, "links"), groups, title, reading)
    if isinstance(found.n, Number) and found.n.value < 1:
        raise LinkageError("there are no links", "the ground counts as one")
    if isinstance(found.n, Number) and isinstance(found.j, Number) and found.j.value < found.n.value - 1:
        raise LinkageError(
            f"{found.j} joints cannot connect {found.n} links",
            f"{found.n} links need at least {found.n.value - 1} joints; does n count the ground once?",
        )
    return found


def expanded(expr: Expr) -> Expr:
    """A formula with its brackets multiplied out, so that equal ones look equal.

    Raises:
        LinkageError: It would have too many terms.
    """
    return add(ZERO, *(multiply(term, ONE) for term in _terms(expr)))


def _terms(expr: Expr) -> tuple[Expr, ...]:
    if isinstance(expr, Sum):
        return tuple(part for term in expr.terms for part in _terms(term))
    if not isinstance(expr, Product):
        return (expr,)
    parts: tuple[Expr, ...] = (ONE,)
    for factor in expr.factors:
        parts = tuple(part * term for part in parts for term in _terms(factor))
        if len(parts) > MOST_TERMS:
            raise LinkageError(f"the formula has more than {MOST_TERMS} terms")
    return parts


def _checked(count: Expr, what: str) -> Expr:
    count = expanded(count)
    if isinstance(count, Number):
        if count.value.denominator != 1:
            raise LinkageError(f"{what}: {count} is not a whole number")
        if count.value < 0:
            raise LinkageError(f"{what}: {count} is negative", "a count is 0 or more")
    elif not symbols(count):
        raise LinkageError(f"{what}: {count} is not a count")
    return count


def _shown(expr: Expr, *, inside: bool = False) -> str:
    text = write(expr)
    return f"({text})" if isinstance(expr, Sum) and (inside or is_negative(expr.terms[0])) else text


def _sum_text(parts: list[tuple[Expr, int]]) -> str:
    """`4·1`, or `(6·2 + 6·1 + 6·3)`."""
    counts = [(_shown(count, inside=True), each) for count, each in parts]
    texts = [f"({count})·{each}" if "/" in count else f"{count}·{each}" for count, each in counts]
    if not texts:
        return "0"
    return texts[0] if len(texts) == 1 else f"({' + '.join(texts)})"
