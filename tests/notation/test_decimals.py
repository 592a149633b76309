"""Numbers as decimal text, and back: the same by Python and by orjson, to the last bit."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.notation.decimals import read_decimals, read_json, spelled
from tests.row_by_row import row_by_row

pytestmark = pytest.mark.usefixtures("json_by")

EDGES = [1e-5, 1e-4, 0.1, 1.0, 1e15, 1e16, 1e17, 2.0**53, 2.0**63, 2.0**64, 1e22, 5e-324, 2.2250738585072014e-308]
"""Where a way to write numbers changes."""
digits = st.text("0123456789", min_size=1, max_size=40)
decimals = st.builds(
    "".join,
    st.tuples(
        st.sampled_from(["", " ", "-", "+"]),
        st.one_of(digits, digits.map(lambda text: f"{text}."), digits.map(lambda text: f".{text}")),
        st.sampled_from(["", "0", "5"]),
        st.sampled_from(["", "e5", "E-7", "e+300", "e-330", " "]),
    ),
)
"""Numbers as people and programs write them."""


@given(st.lists(st.floats()))
def test_numbers_are_written_as_python_writes_them(numbers: list[float]) -> None:
    """As short as it can be; zero without a sign."""
    assert list(map(str, spelled(np.array(numbers)))) == [repr(number + 0.0) for number in numbers]


def test_so_are_those_beside_a_change_of_spelling() -> None:
    """One step below, and one above."""
    near = [step for edge in EDGES for step in (np.nextafter(edge, 0), edge, np.nextafter(edge, math.inf))]
    numbers = np.array([near, [-number for number in near]])
    assert list(map(str, spelled(numbers))) == [repr(number + 0.0) for number in numbers.ravel().tolist()]


@given(st.lists(decimals, min_size=1))
def test_numbers_are_read_as_python_reads_them(texts: list[str]) -> None:
    """Each by itself, with any number of digits; the sign of zero too."""
    found = read_decimals("".join(f"{text}," for text in texts)).tolist()
    assert list(map(repr, found)) == [repr(float(text)) for text in texts]


@given(st.floats(1e-60, 1e60), st.integers(-1, 1), st.booleans())
def test_of_two_floats_the_nearer_is_read(number: float, beside: int, has_point: bool) -> None:
    """At the middle between two of them the even one, and the right one just beside it, hundreds of digits on."""
    middle = (Fraction(number) + Fraction(math.nextafter(number, math.inf))) / 2
    digits = int(middle * 10**260) * 10 + beside  # a middle has no more behind the point
    wanted = Fraction(digits, 10**261)
    text = f"{digits // 10**261}.{digits % 10**261:0>261}" if has_point else f"{digits}e-261"
    [found] = read_decimals(f"{text},").tolist()
    distance = abs(Fraction(found) - wanted)
    assert distance <= min(abs(Fraction(math.nextafter(found, to)) - wanted) for to in (0.0, math.inf))
    assert beside or math.frexp(found)[0] * 2**53 % 2 == 0


@row_by_row("text", ["1,,2,", "1 2,", "1e,", "--1,", "0,-,"])
def test_what_is_no_number_is_refused(text: str) -> None:
    """Also where a number stands before it."""
    with pytest.raises(ValueError):  # noqa: PT011  what it says is not shown
        read_decimals(text)


@pytest.mark.parametrize("text", ["-0,0.5,", "1,-0 ,", "-0,"])
def test_a_zero_keeps_its_sign(text: str) -> None:
    """Also without a point, where JSON would lose it."""
    assert [math.copysign(1, number) for number in read_decimals(text).tolist()].count(-1) == 1


@row_by_row("text", ["[NaN]", "[-Infinity]", "[1.]", "[01]", "[1,]", "[1] [2]", "{1: 2}", "'a'", ""])
def test_what_is_no_json_is_refused(text: str) -> None:
    """By the letter of the standard."""
    with pytest.raises(ValueError):  # noqa: PT011  what it says is not shown
        read_json(text)


@row_by_row("whole", [0, 7, 2**53 + 1, 2**63, 2**64 - 1, 2**64, 10**22 + 1, 10**300])
def test_whole_numbers_are_read_to_the_nearest_float(whole: int) -> None:
    """However long they are."""
    assert float(read_json(f"[{whole}]")[0]) == float(whole)
    assert read_decimals(f"{whole},-{whole},").tolist() == [float(whole), -float(whole)]
