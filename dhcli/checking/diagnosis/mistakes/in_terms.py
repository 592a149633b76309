"""Mistakes in a single entry of a formula: in its terms, their factors, and the cosines and sines of sums.

There are hundreds in a pose, so they are made only in the entries that are wrong, and only where no mistake in the work
itself gives the answer. A number shows no terms.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TypeAlias

from dhcli.checking.diagnosis.bench import terms
from dhcli.checking.diagnosis.record import Catalogue, Mistake
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.terms import Piece, exchanged, flipped, functions, lengths, pieces, products, shown
from dhcli.checking.diagnosis.work import Level, Made, Maker, Matrix, Setting, Work
from dhcli.checking.wanted import Wanted
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.names import natural_key
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import MINUS_ONE, ZERO, Expr, Power, Sum, Symbol, Trig, add, multiply, negate, number
from dhcli.notation.trig import cosine, sine, swapped
from dhcli.notation.walk import put_for, walk
from dhcli.notation.writer import write


@frozen
class Among:
    """What may stand in an entry, and how it is written."""

    angles: tuple[str, ...] = ()
    lengths: tuple[Symbol, ...] = ()
    writing: Joints = THETAS


TermMaker: TypeAlias = Callable[[Expr, Among], Iterator[tuple[str, Expr]]]
"""Every way to make a mistake in an entry: what it is about, such as `d3*s1` or `c2 for c12`, and the wrong entry."""

IN_ENTRY: Catalogue[TermMaker] = Catalogue(Level.MATRIX, Rank.SYMPTOM)
"""In the order in which they are tried and named."""


@IN_ENTRY(
    "term-sign", "the sign of {term} in entry ({entry}) is turned round", "look at the signs of the terms in row {row}"
)
def sign(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """One term of a sum with the other sign, wherever the sum stands in an entry."""
    seen: Counter[str] = Counter()
    for term, changed in flipped(expr):
        text = shown(term, among.writing)
        seen[text] += 1
        yield text + (f" no. {seen[text]}" if seen[text] > 1 else ""), changed


@IN_ENTRY("term-missing", "entry ({entry}) lacks {term}", "count the terms in row {row}")
def missing(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """One term left out."""
    return _with_terms(expr, among, lambda _: ZERO)


@IN_ENTRY("term-double", "{term} is counted twice in entry ({entry})", "count the terms in row {row}")
def double(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """One term too often."""
    return _with_terms(expr, among, lambda term: multiply(number(2), term))


@IN_ENTRY("term-half", "entry ({entry}) has only half of {term}", "look at the numbers before the terms in row {row}")
def half(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """A factor two forgotten."""
    return _with_terms(expr, among, lambda term: multiply(number(Fraction(1, 2)), term))


@IN_ENTRY(
    "function-other",
    "entry ({entry}) has {term}",
    "look at sines and cosines in row {row}",
)
def function_other(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """Sine for cosine, or the other way round, of one angle in an entry."""
    return _with_functions(expr, among, lambda old: (swapped(old),))


@IN_ENTRY("angle-lacking", "entry ({entry}) has {term}", "look at the sums of angles in row {row}")
def angle_lacking(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c2 for c12: one angle of a sum is left out."""

    def made(old: Trig) -> Iterator[Expr]:
        for k in range(len(old.angle.terms)) if len(old.angle.terms) > 1 else ():
            yield _of(old.function, replace(old.angle, terms=(*old.angle.terms[:k], *old.angle.terms[k + 1 :])))

    return _with_functions(expr, among, made)


@IN_ENTRY("angle-other", "entry ({entry}) has {term}", "which joint angle belongs where in row {row}?")
def angle_other(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c3 for c2: the angle of another joint."""

    def made(old: Trig) -> Iterator[Expr]:
        for name, times in old.angle.terms:
            for other in among.angles:
                if other not in old.angle.names:
                    moved = old.angle - Angle.of(name) * times + Angle.of(other) * times
                    yield _of(old.function, moved)

    return _with_functions(expr, among, made)


@IN_ENTRY("angle-added", "entry ({entry}) has {term}", "look at the sums of angles in row {row}")
def angle_added(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c12 for c2: one angle too many."""

    def made(old: Trig) -> Iterator[Expr]:
        for other in among.angles:
            if other not in old.angle.names:
                yield _of(old.function, old.angle + Angle.of(other))

    return _with_functions(expr, among, made)


@IN_ENTRY("sum-as-product", "entry ({entry}) has {term}", "how is the cosine or sine of a sum expanded?")
def sum_as_product(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c1*c2 for c12: half of the expansion, or functions multiplied as if they were angles."""

    def made(old: Trig) -> Iterator[Expr]:
        for a, b in _parted(old.angle):
            (ca, sa), (cb, sb) = ((cosine(x), sine(x)) for x in (a, b))
            if old.function == "cos":
                yield from (multiply(ca, cb), negate(multiply(sa, sb)), multiply(sa, sb))
            else:
                yield from (multiply(sa, sb), multiply(sa, cb), multiply(ca, sb))

    return _with_functions(expr, among, made)


@IN_ENTRY("sum-as-sum", "entry ({entry}) has {term}", "how is the cosine or sine of a sum expanded?")
def sum_as_sum(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c1 + c2 for c12."""

    def made(old: Trig) -> Iterator[Expr]:
        for a, b in _parted(old.angle):
            yield add(_of(old.function, a), _of(old.function, b))

    return _with_functions(expr, among, made)


@IN_ENTRY("expansion-sign", "entry ({entry}) has {term}", "look at the signs where a sum of angles is expanded")
def expansion_sign(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c1*c2 + s1*s2 for c12: the sign between the products is wrong."""

    def made(old: Trig) -> Iterator[Expr]:
        for a, b in _parted(old.angle):
            (ca, sa), (cb, sb) = ((cosine(x), sine(x)) for x in (a, b))
            if old.function == "cos":
                yield add(multiply(ca, cb), multiply(sa, sb))
            else:
                yield add(multiply(sa, cb), negate(multiply(ca, sb)))
                yield add(multiply(ca, sb), negate(multiply(sa, cb)))

    return _with_functions(expr, among, made)


@IN_ENTRY("length-other", "entry ({entry}) has {term}", "which length belongs where in row {row}?")
def length_other(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """a1 for a2."""
    for old in lengths(expr):
        for new in among.lengths:
            if new != old:
                yield _stands_for(new, old, among), exchanged(expr, old, new)


@IN_ENTRY("factor-missing-in-term", "entry ({entry}) has {term}", "count the factors of the terms in row {row}")
def factor_missing(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """c4*c6 for c4*c5*c6: a factor of a term is left out."""
    for product, k, changed in products(expr):
        factor = product.factors[k]
        if not isinstance(factor, Sum) and factor != MINUS_ONE:
            left = multiply(*product.factors[:k], *product.factors[k + 1 :])
            yield _stands_for(left, product, among), changed


@IN_ENTRY("square-missing", "entry ({entry}) has {term}", "look at the powers in row {row}")
def square_missing(expr: Expr, among: Among) -> Iterator[tuple[str, Expr]]:
    """L for l^2."""
    for old in dict.fromkeys(node for node in walk(expr) if isinstance(node, Power) and node.exponent == 2):  # noqa: PLR2004
        yield _stands_for(old.base, old, among), put_for(expr, {old: old.base})


def among_of(rows: Matrix[Expr], setting: Setting) -> Among:
    """What stands in the right entries, and what else of the robot may stand in wrong ones."""
    angles = {name for row in rows for entry in row for node in functions(entry) for name in node.angle.names}
    held = {symbol for row in rows for entry in row for symbol in lengths(entry)}
    if setting.robot is not None:
        turning = setting.robot.angles
        angles |= turning.intersection(setting.robot.variables)
        held |= {Symbol(name) for name in (*setting.robot.variables, *setting.robot.parameters) if name not in turning}
    ordered = sorted(held, key=lambda symbol: natural_key(symbol.name))
    return Among(tuple(sorted(angles, key=natural_key)), tuple(ordered), setting.writing)


def place_in(question: Wanted, row: int, column: int) -> str:
    """Row and column of an entry as they are told, such as `2,4`; if it was asked for itself, those in its matrix."""
    r, c = question.index if question.piece == "entry" else (row, column)
    return f"{r + 1},{c + 1}"


def _in_matrix(made: TermMaker, work: Work, setting: Setting) -> Made:
    """A mistake in any one entry of what is written down."""
    if setting.numeric:
        return
    rows = terms(work, {})
    among = among_of(rows, setting)
    for r, row in enumerate(rows):
        for c, entry in enumerate(row):
            for text, changed in made(entry, among):
                yield f"{place_in(work.question, r, c)} {text}", replace(work, entry=(r, c, changed))


def _with_terms(expr: Expr, among: Among, change: Callable[[Expr], Expr]) -> Iterator[tuple[str, Expr]]:
    """Each term changed; what is a single term is one, too."""
    every = pieces(expr) if isinstance(expr, Sum) else (Piece(expr, expr, lambda new: new), *pieces(expr))
    for piece in every:
        if piece.term != ZERO:
            yield shown(piece.whole, among.writing), piece.put(change(piece.term))


def _with_functions(expr: Expr, among: Among, change: Callable[[Trig], Iterable[Expr]]) -> Iterator[tuple[str, Expr]]:
    """Each cosine or sine changed wherever it stands."""
    for old in functions(expr):
        for new in change(old):
            yield _stands_for(new, old, among), exchanged(expr, old, new)


def _stands_for(new: Expr, old: Expr, among: Among) -> str:
    return f"{write(new, 'short', among.writing)} for {write(old, 'short', among.writing)}"


def _parted(angle: Angle) -> Iterator[tuple[Angle, Angle]]:
    """A sum of angles in two, at each place; what is constant stays with the second."""
    for k in range(1, len(angle.terms)):
        yield Angle(angle.terms[:k]), replace(angle, terms=angle.terms[k:])


def _of(function: str, angle: Angle) -> Expr:
    return cosine(angle) if function == "cos" else sine(angle)


IN_TERMS: tuple[Mistake[Maker], ...] = tuple(
    Mistake(one.id, one.words, one.hint, partial(_in_matrix, one.made), one.level, one.rank, alone=True)
    for one in IN_ENTRY
)
"""The same as mistakes in a matrix."""
