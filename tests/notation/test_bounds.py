"""Any text gives a value or a clear error, in bounded work; nothing that is typed is ever run."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import dhcli
from dhcli.algebra.equality import equal
from dhcli.errors import NotationError
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.operators import DEEPEST
from dhcli.notation.parser import parse
from dhcli.notation.products import parse_factors
from dhcli.notation.scope import MOST_READ, OPEN, Scope
from dhcli.notation.styles import STYLES
from dhcli.notation.tree import ONE, Expr, Unit, add, multiply, number
from dhcli.notation.walk import walk
from dhcli.notation.writer import write
from tests.nightly import examples, some
from tests.row_by_row import row_by_row

ROBOT = Scope(
    joints=("theta1", "theta2", "theta3"),
    angles=("alpha",),
    lengths=("a", "c", "s", "e", "a1", "d3", "m"),
    aliases={"q1": "theta1"},
)
READERS: tuple[Callable[[str, Scope], object], ...] = (parse, parse_matrix, parse_factors)

PIECES = (
    *"()[]{}+-−*/^,;&|'=_.√°²⁻$│─\n \t01π",
    *("c1", "s23", "c_{12}", "cos", "sin", "tan", "sqrt", "atan2(", "asin(", "c(", "s", "theta1", "θ2", "\\theta_{1}"),
    *("a1", "d3", "e", "m", "mm", "deg", "0.5", "1e3", "64", "9" * 30, "**", "0^-1", "1/0", "\\frac{", "\\\\", "\\cos"),
    *("\\left(", "\\right)", "Rot", "Trans", "(z,", "Rot(z, 90°)", "Trans(1,2,3)", "inv(", "\\begin{bmatrix}"),
    *("\\end{bmatrix}", "begin", "end", "array", "\\begin{array}{cc}", "np.", "T =", "% ", "q1", "- ["),
)
"""The alphabet of the grammar, and what is nearly in it."""

any_text = st.one_of(st.text(max_size=80), st.lists(st.sampled_from(PIECES), max_size=30).map("".join))


@examples(4)
@given(any_text, st.sampled_from(READERS), st.sampled_from([OPEN, ROBOT]))
def test_any_text_gives_a_value_or_an_error_with_a_place(
    text: str, read: Callable[[str, Scope], object], scope: Scope
) -> None:
    """Never another exception; and what is read can be written and judged."""
    try:
        value = read(text, scope)
    except NotationError as error:
        (problem,) = error.problems
        assert problem.message
        assert problem.place is not None
        assert 1 <= (problem.place.column or 0) <= len(text) + 1
        return
    if isinstance(value, Expr):
        for style in STYLES:
            assert write(value, style)
        if not any(isinstance(node, Unit) for node in walk(value)):
            thrice = add(multiply(number(3), value), ONE)  # floats cannot tell 1e9 from 1e9 + 1
            assert not equal(value, thrice) or equal(value, number(Fraction(-1, 2)))


ATTACKS = [
    "(" * 2000,
    "(" * 1000 + ")" * 1000,
    "[" * 10_000 + "]" * 10_000,
    "([" * 5000 + "])" * 5000,
    "{" * 2000,
    "-" * 2000,
    "-" * 1999 + "1",
    "√" * 1999 + "2",
    "\\frac{" * 300,
    "\\frac{1}{" * 200 + "1" + "}" * 200,
    "sqrt(" * 300 + "2" + ")" * 300,
    "9^9^9",
    "((((2^64)^64)^64)^64",
    "2^64^64",
    "(1e60^6)*" * 30 + "1",
    "((a+b)^64)^64",
    "1e999999",
    "1e-999999",
    "9" * 2000,
    "0." + "1" * 1990,
    "a" * 2000,
    "c" * 2000,
    "s1" * 1000,
    "c12" * 600,
    "ac" * 1000,
    "a+" * 999 + "a",
    "a/" * 900 + "a",
    "c(" * 900,
    "_{}" * 600,
    "a_{a_{" * 300,
    "np." * 600,
    "\\" * 2000,
    "'" * 2000,
    "^" * 2000,
    "1 " * 10_000,
    "1;" * 10_000,
    "1\n" * 10_000,
    "[1]" * 8_000,
    "|" * 20_000,
    "- [" * 8_000,
    "T=" * 10_000,
    "\\begin{array}{" * 5000,
    "\\begin{bmatrix}" * 8000,
    "%\n" * 10_000,
    "inv(" * 5000 + ")" * 5000,
    "Rot(z," + "(" * 5000,
    "Trans(1,2,3)" * 1600,
    "begin{array}" * 1600,
]
"""Texts that would cost a careless reader its stack, its memory or its evening."""


@row_by_row(("attack", "read"), some([*product(range(len(ATTACKS)), READERS)], 3))
def test_an_attack_ends_at_a_cap(attack: int, read: Callable[[str, Scope], object]) -> None:
    """With a value or a clear error; a reader that did not end would hang this test."""
    for scope in (OPEN, ROBOT):
        try:
            read(ATTACKS[attack], scope)
        except NotationError as error:
            assert error.problems[0].message
            assert len(str(error)) < 2500


@row_by_row(
    ("text", "message"),
    [
        ("a" * 2001, "2001 characters are more than the 2000 that are read"),
        ("+".join(["a"] * 1000), "an expression of more than 500 parts is not read"),
        ("(" * 61 + "a" + ")" * 61, "brackets nested deeper than 60 are not read"),
        ("2^65", "an exponent beyond 64 is not read"),
        ("2^-65", "an exponent beyond 64 is not read"),
        ("9" * 61, "a number with more than 60 digits is not read"),
        ("1e61", "a number with more than 60 digits is not read"),
        ("(2^64)^16", "the number becomes too large"),
        ("1e60^8 * 1e60^9", "the number becomes too large"),
    ],
)
def test_a_text_beyond_a_cap_names_it(text: str, message: str) -> None:
    """2,000 characters, 500 parts, depth 60, exponent 64, 60 digits, 1000 bits."""
    with pytest.raises(NotationError) as caught:
        parse(text)
    assert caught.value.problems[0].message == message


@row_by_row(
    "text",
    [
        "a" * 2000,
        "+".join(["a"] * 250),
        "(" * (DEEPEST - 1) + "a" + ")" * (DEEPEST - 1),
        "2^64",
        "2^-64",
        "(2^64)^15",
        "9" * 60,
        "1e60",
    ],
)
def test_a_text_at_a_cap_is_read(text: str) -> None:
    """So that the caps stand where they are said to stand."""
    assert parse(text) is not None


def test_a_cell_of_a_matrix_has_the_cap_of_an_expression() -> None:
    """The whole may be longer than a cell."""
    cell = "+".join(["a1"] * 250)
    assert len(cell) * 16 > 2000
    assert len(parse_matrix("; ".join([", ".join([cell] * 4)] * 4))) == 4
    with pytest.raises(NotationError, match="a cell of more than 2000 characters is not read"):
        parse_matrix("[1, " + "a" * 2001 + "]")


@row_by_row(
    "text",
    [
        '__import__("os").system("touch /tmp/dhcli-was-here")',
        "().__class__.__bases__",
        "exec('1')",
        "eval('1')",
        "open('/etc/passwd')",
        "lambda: 0",
        "[x for x in (1,2)]",
        "a if b else c",
        "a.b",
        "f'{1}'",
        "1 and 2",
        "a := 3",
        "{'a': 1}",
        "!ls",
        "`ls`",
        "$(ls)",
        "%run x",
    ],
)
def test_code_is_only_text(text: str) -> None:
    """It is refused with a column, or read as names and products, never run."""
    try:
        value = parse(text)
    except NotationError:
        return
    assert {type(node).__module__ for node in walk(value)} == {"dhcli.notation.tree"}


def test_no_door_to_code_exists() -> None:
    """No eval, compile, ast, pickle, sympify or parse_expr, not even in a comment's reach; one exec, of numbers."""
    doors = re.compile(
        r"(?<![\w.])(eval|exec|compile|__import__)\(|\b(sympify|parse_expr|literal_eval|yaml\.load|unsafe_load)\b"
        r"|^\s*(import|from) (ast|pickle|marshal|shelve|code)\b",
        re.MULTILINE,
    )
    package = Path(dhcli.__file__).parent
    files = sorted(package.rglob("*.py"))
    assert len(files) > 50
    found = [
        f"{file.relative_to(package)}: {match[0]}"
        for file in files
        for match in doors.finditer(file.read_text("utf-8"))
    ]
    assert found == [f"{Path('algebra', 'compiled.py')}: exec("]  # the one place where code is made, of numbers
    assert doors.search("x = eval(text)")
    assert doors.search("from ast import literal_eval")


def test_a_scope_remembers_a_counted_number_of_words() -> None:
    """It lives while the answers of a whole class are marked, and every long run of names has thousands of pieces."""
    scope = Scope(lengths=("a", "b"))
    for k in range(2 * MOST_READ):
        assert scope.readings(f"a{k}") == ()
        assert scope.readings("a") != ()
    assert len(scope._read) <= MOST_READ
