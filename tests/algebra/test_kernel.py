"""The loop over many rows, as plain Python and compiled: its sine and cosine, and its steps."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np
import pytest

from dhcli.algebra import kernel as kernels
from dhcli.algebra.arithmetic import evaluate_settled
from dhcli.algebra.columns import Columns
from dhcli.algebra.kernel import Kernel
from dhcli.algebra.loop import LONG, MIDDLE, MOST_QUARTERS, SHORT
from dhcli.algebra.program import Program, assemble
from dhcli.algebra.tape import Tape
from dhcli.notation.parser import parse
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from numpy.typing import NDArray

needs_numba = pytest.mark.skipif(find_spec("numba") is None, reason="the extra [fast] is not installed")


@pytest.fixture(params=["plain", pytest.param("compiled", marks=needs_numba)], autouse=True)
def loop(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Every test is of the plain loop, and of the compiled one where there is a compiler."""
    loader = kernels._Loader()
    if request.param == "compiled":
        loader.loop = _compiled()
    monkeypatch.setattr(kernels, "_LOADED", loader)
    with np.errstate(all="ignore"):  # numpy's numbers warn one by one, the compiled loop does not
        yield


def _compiled(made: list[Any] = []) -> Any:  # noqa: ANN401, B006  once for all tests
    made += [] if made else [kernels._compiled_loop()]
    return made[0]


def program(*texts: str) -> Program:
    """What works out some expressions of a and b."""
    tape = Tape(["a", "b"])
    return assemble(tape, [evaluate_settled(parse(text), tape) for text in texts])


def played(made: Program, rows: NDArray[np.float64], dtype: type = np.float64, width: int = 19) -> NDArray[Any]:
    """What the loop says; it must have gone well."""
    found = np.empty((len(rows), made.inputs.start), dtype)
    assert Kernel(made).play(rows, found, width=width)
    return found


ANGLES = {
    "small": np.linspace(-8, 8, 401),
    "near right angles": np.nextafter(np.pi / 2 * np.arange(-40, 40), np.inf),
    "odd pi": np.pi * (2 * np.random.default_rng(3).integers(-100_000, 100_000, 100) + 1.0),
    "large": np.random.default_rng(5).uniform(-1.6e6, 1.6e6, 400),
    "tiny": 10.0 ** np.random.default_rng(7).uniform(-320, -3, 100),
    "zero": np.array([0.0]),
}


@row_by_row("kind", ANGLES)
def test_sine_and_cosine_are_right_to_the_last_digit_but_one(kind: str) -> None:
    """3e-16 from those of many digits, at any angle that the loop takes."""
    rows = np.stack([ANGLES[kind]] * 2, axis=1)
    found = played(program("cos(a)", "sin(a)"), rows)
    with mpmath.workdps(40):
        wanted = np.array([[float(mpmath.cos(x)), float(mpmath.sin(x))] for x in ANGLES[kind].tolist()])
    assert np.abs(found - wanted).max() <= 3e-16


def test_the_three_parts_of_a_right_angle_add_up() -> None:
    """To 2**-120, and the products of the first two with any number of quarters are exact."""
    with mpmath.workdps(60):
        rest = mpmath.pi / 2 - sum(mpmath.mpf(part) for part in (LONG, MIDDLE, SHORT))
        assert abs(rest) < 2.0**-120
    for part in (LONG, MIDDLE):
        quarters = int(MOST_QUARTERS) - 1
        assert Fraction(part) * quarters == Fraction(part * quarters)


def test_an_angle_that_is_too_large_is_not_passed_over() -> None:
    """One in many rows, and an infinite one; what is no number is none afterwards, and its neighbours are right."""
    made, found = program("cos(a)", "sin(a)"), np.empty((5, 2))
    for large in (1e7, -1e300, math.inf):
        assert not Kernel(made).play(np.array([[0.1, 0.0], [0.2, 0.0], [large, 0], [0.3, 0], [0.4, 0]]), found)
    assert Kernel(made).play(np.array([[0.1, 0.0], [math.nan, 0.0], [0.3, 0.0], [0.4, 0.0], [0.5, 0.0]]), found)
    assert np.isnan(found[1]).all()
    assert found[[0, 2]] == pytest.approx(np.array([[math.cos(x), math.sin(x)] for x in (0.1, 0.3)]))


TEXTS = (
    "a*b - 2", "2 - a", "-a - b", "-3*a*b", "cos(2*a + 200°)", "sin(-b)", "cos(a - b)*sin(a - b)", "sqrt(b)", "b",
    "0.5", "a + 1", "a*b - 2", "-b", "sin(b)", "cos(a)",
)  # fmt: skip


def test_the_loop_says_what_columns_say() -> None:
    """Every step it knows: pairs of cosine and sine, and each of them alone; constants, a variable, a result twice."""
    rows = np.random.default_rng(1).uniform(0.1, 4, (8, 2))
    for texts in (TEXTS, *((text,) for text in TEXTS)):
        made = program(*texts)
        assert played(made, rows) == pytest.approx(Columns(made, 8).play(rows.T).T, abs=1e-15)


@row_by_row("count", [1, 7, 8, 9, 40, 41])
def test_rows_are_played_alike_however_many_at_a_time(count: int) -> None:
    """Fewer than are turned into columns at once, as many, and some left over."""
    rows = np.random.default_rng(count).uniform(0.1, 4, (count, 2))
    made = program(*TEXTS)
    one = played(made, rows, width=1)
    for width in (3, 8, 19, 300):
        assert np.allclose(played(made, rows, width=width), one, rtol=1e-14, atol=1e-15)


def test_values_are_taken_up_to_a_size() -> None:
    """Of either sign, in any row and column; what is no number is not of a size, but taken where any is."""
    made, found = program("a + b"), np.empty((21, 1))
    for place in ((0, 0), (13, 1), (20, 0)):
        for value, is_taken in ((3.0, True), (-3.0, True), (3.1, False), (-math.inf, False), (math.nan, False)):
            rows = np.ones((21, 2))
            rows[place] = value
            assert Kernel(made).play(rows, found, most=3.0, width=10) is is_taken
            assert Kernel(made).play(rows, found, width=10)
            assert np.array_equal(found, rows.sum(axis=1, keepdims=True), equal_nan=True)


def test_a_step_that_the_loop_does_not_know_is_said() -> None:
    """So that numpy can take its place."""
    for text in ("acos(a)", "atan2(a, b)", "atan(b) + a"):
        with pytest.raises(KeyError):
            Kernel(program(text))


def test_single_precision_is_double_rounded_once() -> None:
    """The results are those of double precision, each rounded to the nearest of float32."""
    rows = np.random.default_rng(1).uniform(-4, 4, (8, 2))
    made = program("cos(a)*b - a", "sin(a + b)")
    assert np.array_equal(played(made, rows, np.float32), played(made, rows).astype(np.float32))


def test_rows_that_nobody_may_write_to_are_only_read() -> None:
    """And no rows are no work."""
    rows = np.random.default_rng(1).uniform(-4, 4, (8, 2))
    before = rows.copy()
    rows.flags.writeable = False
    assert played(program("a*b"), rows)[:, 0] == pytest.approx(before[:, 0] * before[:, 1])
    assert np.array_equal(rows, before)
    assert played(program("a*b"), np.empty((0, 2))).shape == (0, 1)
