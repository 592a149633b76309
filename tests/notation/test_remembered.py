"""What a scope remembers of texts that were read changes nothing but the time: neither trees nor errors nor caps."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import NotationError
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.operators import DEEPEST, MOST_NODES
from dhcli.notation.parser import parse
from dhcli.notation.scope import MOST_KEPT, OPEN, Scope
from dhcli.notation.tree import ONE, Expr, Symbol, add, multiply, negate, power
from dhcli.notation.trig import cosine, sine

ROBOT = Scope(joints=("theta1", "theta2"), angles=("alpha1",), lengths=("a1", "a2", "c"))
USED = replace(ROBOT)
"""A scope that every example is read with, one after the other."""

PIECES = ("cos", "sin", "c", "c1", "s12", "(theta1)", "( theta1 )", "(theta1 + theta2)", "(", ")", "^2", "sqrt(3)")
MORE = (
    "a1",
    "a2",
    "2",
    "0",
    "0.50",
    "+",
    "-",
    "*",
    "/",
    " ",
    "90°",
    "cos(90)",
    "sin(0.5)",
    "atan2(1, 2)",
    "x",
    ",",
    ";",
)

texts = st.lists(st.sampled_from((*PIECES, *MORE)), max_size=14).map("".join)


def outcome(read: object, text: str, scope: Scope) -> object:
    """What comes of a text: what was read, or the error with its place."""
    assert callable(read)
    try:
        return read(text, scope)
    except NotationError as error:
        return [str(problem) for problem in error.problems]


@given(texts)
def test_a_text_is_read_alike_whatever_was_read_before(text: str) -> None:
    """An expression and a matrix, errors with their columns included."""
    for read in (parse, parse_matrix):
        once, again = outcome(read, text, replace(ROBOT)), outcome(read, text, USED)
        assert again == once
        assert repr(again) == repr(once)  # 0.5 is 1/2, and is not written so


@pytest.mark.parametrize("unit", ["cos(theta1)", "cos(theta1 + theta2)", "sqrt(2*a1)"])
def test_parts_are_counted_also_where_they_are_remembered(unit: str) -> None:
    """Formulas about as long as the cap, with a scope that has read the function before and with one that has not."""
    parse(unit, USED)
    verdicts = set()
    for count in range(MOST_NODES // 8, MOST_NODES // 2, 7):
        found = outcome(parse, "+".join([unit] * count), USED)
        assert found == outcome(parse, "+".join([unit] * count), replace(ROBOT))
        verdicts.add(isinstance(found, Expr))
    assert verdicts == {True, False}


def test_levels_are_counted_also_where_they_are_remembered() -> None:
    """A function that was read before, in brackets nested about as deep as the cap."""
    parse("cos((theta1))", USED)
    for depth in range(DEEPEST - 4, DEEPEST + 2):
        text = "(" * depth + "cos((theta1))" + ")" * depth
        assert outcome(parse, text, USED) == outcome(parse, text, replace(ROBOT))


def test_a_scope_remembers_no_more_than_it_may() -> None:
    """However many functions are read with it."""
    scope = replace(ROBOT)
    for k in range(MOST_KEPT + 10):
        parse(f"cos({k}.5°)", scope)
    assert 0 < len(scope.read) <= MOST_KEPT


leaves = st.sampled_from(
    (
        *(Symbol(name) for name in ("a1", "a2", "A1", "d3")),
        *(turn(Angle.of(name)) for name in ("theta1", "theta2") for turn in (cosine, sine)),
        cosine(Angle.of("theta1") + Angle.of("theta2")),
        add(Symbol("a1"), Symbol("a2")),
        add(negate(Symbol("a1")), Symbol("d3")),
        power(Symbol("a2"), -1),
    )
)


@given(st.lists(leaves, min_size=1, max_size=5))
def test_a_product_without_numbers_is_that_with_a_one(factors: list[Expr]) -> None:
    """Where nothing is to be gathered, nothing is looked for."""
    assert multiply(*factors) == multiply(ONE, *factors)
    assert hash(multiply(*factors)) == hash(multiply(ONE, *factors))


def test_parts_of_an_angle_do_not_share_a_hash() -> None:
    """A formula in a hundred of them would compare each with all others, wherever they are remembered."""
    parts = [Fraction(1, k) for k in range(1, 101)] + [Fraction(k) for k in range(2, 101)]
    for beside in ((), (("theta1", Fraction(1)),)):
        assert len({hash(Angle((*beside, ("theta2", part)))) for part in parts}) == len(parts)


def test_what_is_equal_has_the_same_hash_once_kept() -> None:
    """Of two trees that were read apart, one hashed before."""
    one, other = parse("a1*c1 + a2*c12", OPEN), parse("a1*c1 + a2*c12", OPEN)
    assert hash(one) == hash(one) == hash(other)
    assert one == other
