"""Random angles, lengths, moves and chains: what the laws are tried on.

Small on purpose: few names and round constants meet each other often, and parallel axes are the rule, as in robots.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import permutations, product

from hypothesis import strategies as st

from dhcli.kinematics.conventions import Row
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.tree import HALF, ONE, ZERO, Expr, Symbol, add, multiply, negate, number, power
from dhcli.notation.trig import cosine, sine

THETAS = ("theta1", "theta2", "theta3", "theta4")
LENGTHS = ("a1", "a2", "d3", "d4")

quarters = st.integers(-4, 4).map(lambda k: Angle.in_degrees(90 * k))
"""Whole numbers of right angles, -360° to 360°."""

round_degrees = st.sampled_from([-150, -120, -60, -45, -30, 15, 30, 36, 45, 60, 72, 120, 135, 150, 210, 330]).map(
    Angle.in_degrees
)
"""Constants whose cosines are roots, and some whose are not."""

names = st.sampled_from(THETAS)
factors = st.sampled_from([Fraction(1), Fraction(1), Fraction(1), Fraction(-1), Fraction(2), HALF, Fraction(-3, 2)])

exact_constants = st.one_of(quarters, quarters, round_degrees)
named_angles = st.builds(lambda name, factor: Angle.of(name) * factor, names, factors)
offset_angles = st.builds(lambda one, other: one + other, named_angles, exact_constants)
sums_of_angles = st.builds(lambda one, other: one + other, offset_angles, named_angles)

exact_angles = st.one_of(exact_constants, named_angles, offset_angles, sums_of_angles)
"""Angles that every arithmetic holds."""

numeric_angles = st.one_of(
    exact_constants, st.fractions(-7, 7, max_denominator=1000).map(lambda value: Angle(radians=value))
)
"""Angles without names, radians among them."""

small_fractions = st.fractions(-3, 3, max_denominator=8)
length_names = st.sampled_from(LENGTHS).map(Symbol)
lengths = st.one_of(
    st.just(ZERO),
    st.just(ZERO),
    length_names,
    length_names.map(negate),
    small_fractions.map(number),
    st.builds(lambda name, value: name + number(value), length_names, small_fractions),
    st.builds(lambda one, other: one * 2 - other, length_names, length_names),
)


@cache
def quarter_turns() -> tuple[tuple[tuple[int, ...], ...], ...]:
    """The 24 rotations that map axes to axes, as matrices of 0, 1 and -1."""
    found = []
    for order, signs in product(permutations(range(3)), product((1, -1), repeat=3)):
        parity = 1 if order in {(0, 1, 2), (1, 2, 0), (2, 0, 1)} else -1
        if parity * signs[0] * signs[1] * signs[2] == 1:
            found.append(tuple(tuple(signs[i] * (order[i] == j) for j in range(3)) for i in range(3)))
    return tuple(found)


def fixed(turn: tuple[tuple[int, ...], ...], offset: tuple[Expr, Expr, Expr]) -> Fixed:
    """A literal matrix from integers and an offset."""
    return Fixed(tuple((number(r[0]), number(r[1]), number(r[2]), p) for r, p in zip(turn, offset, strict=True)))


def tilted(axis: int, angle: Angle, offset: tuple[Expr, Expr, Expr]) -> Fixed:
    """A literal matrix that turns about one axis by a constant angle."""
    cos, sin = cosine(angle), sine(angle)
    first, second = [(1, 2), (2, 0), (0, 1)][axis]
    entries = [[ONE if i == j else ZERO for j in range(3)] for i in range(3)]
    entries[first][first] = entries[second][second] = cos
    entries[first][second], entries[second][first] = negate(sin), sin
    return Fixed(tuple((r[0], r[1], r[2], p) for r, p in zip(entries, offset, strict=True)))


axes = st.sampled_from(AXES)
offsets = st.tuples(lengths, lengths, lengths)
rotations = st.builds(Rot, axes, exact_angles)
translations = offsets.map(lambda offset: Trans(*offset))
literals = st.one_of(
    st.builds(fixed, st.sampled_from(quarter_turns()), offsets),
    st.builds(tilted, st.integers(0, 2), round_degrees, offsets),
)
moves: st.SearchStrategy[Move] = st.one_of(rotations, rotations, translations, literals)
"""Any move, the exact ones."""

parallel_moves: st.SearchStrategy[Move] = st.one_of(
    st.builds(Rot, st.just("z"), st.one_of(named_angles, offset_angles)),
    st.builds(Rot, axes, quarters),
    st.builds(Rot, st.just("z"), exact_angles),
    translations,
    st.builds(fixed, st.sampled_from(quarter_turns()), offsets),
)
"""Moves that keep axes on axes, as DH rows do, so that there is much to merge."""

rows = st.builds(
    Row,
    a=lengths,
    alpha=st.one_of(quarters, quarters, round_degrees, st.just(Angle.of("theta4"))),
    d=lengths,
    theta=exact_angles,
)
"""A row of a DH table; the twist may be anything too."""


def chains(most: int = 7, of: st.SearchStrategy[Move] = moves) -> st.SearchStrategy[Chain]:
    """Chains of up to so many moves."""
    return st.lists(of, max_size=most).map(tuple)


any_chains = st.one_of(chains(), chains(10, parallel_moves))

numeric_moves: st.SearchStrategy[Move] = st.one_of(
    st.builds(Rot, axes, numeric_angles),
    st.tuples(small_fractions, small_fractions, small_fractions).map(lambda p: Trans(*map(number, p))),
    st.builds(fixed, st.sampled_from(quarter_turns()), st.tuples(*[small_fractions.map(number)] * 3)),
)
"""Moves without a name."""


def _trees(below: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    some = st.lists(below, min_size=2, max_size=4)
    return st.one_of(
        some.map(lambda terms: add(*terms)),
        some.map(lambda terms: multiply(*terms)),
        below.map(negate),
        st.builds(power, below, st.sampled_from([2, 3])),
        st.builds(lambda base: base if base == ZERO else power(base, -1), below),
    )


leaves = st.one_of(
    length_names,
    small_fractions.map(number),
    exact_angles.map(cosine),
    exact_angles.map(sine),
)
polynomials: st.SearchStrategy[Expr] = st.recursive(leaves, _trees, max_leaves=12)
"""Trees that the constructors have built, of what residues hold: sums, products, powers, cosines."""
