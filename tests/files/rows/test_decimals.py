"""Floats as text: the law is that of `repr`, for every float there is."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.files.rows.decimals import lines, spelled

RANDOM = np.random.default_rng(7)
COUNT = 20_000


def texts(numbers: Iterable[float]) -> list[str]:
    """Each number as it is spelled."""
    return [row.tobytes().replace(b"\0", b"").decode() for row in spelled(np.array([*numbers], dtype=float))]


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False).map(lambda x: x + 0.0), max_size=9))
def test_any_floats_are_spelled_as_repr_spells_them(numbers: list[float]) -> None:
    """Whatever their size."""
    assert texts(numbers) == [repr(number) for number in numbers]


@pytest.mark.parametrize(
    "numbers",
    [
        RANDOM.uniform(-1, 1, COUNT),
        10 ** RANDOM.uniform(-6, 18, COUNT) * RANDOM.choice([-1, 1], COUNT),
        RANDOM.integers(1, 2**63 - 1, COUNT).view(np.float64),  # any bits at all, some of them no numbers
        RANDOM.uniform(-10, 10, COUNT).round(3),
        RANDOM.integers(-(10**6), 10**6, COUNT) / 8,
        RANDOM.integers(1, 10**6, COUNT) / RANDOM.integers(1, 1000, COUNT),
        RANDOM.integers(2**52, 2**53, COUNT) * 2.0 ** RANDOM.integers(-65, 0, COUNT),
    ],
    ids=["below 1", "all sizes", "all bits", "rounded", "eighths", "ratios", "all 53 bits"],
)
def test_many_floats_are_spelled_as_repr_spells_them(numbers: np.ndarray) -> None:
    """Of the sorts that poses are made of, and of all others."""
    finite = numbers[np.isfinite(numbers)] + 0.0
    assert texts(finite) == [repr(number) for number in finite.tolist()]


def test_borders_are_spelled_as_repr_spells_them() -> None:
    """Powers of two, below which floats are closer; powers of ten, where the point moves; and their neighbours."""
    powers = [2.0**k for k in range(-1074, 1024)] + [float(f"1e{k}") for k in range(-323, 309)]
    numbers = [near for x in powers for near in (x, math.nextafter(x, 0), math.nextafter(x, math.inf), -x)]
    finite = [x + 0.0 for x in numbers if math.isfinite(x)]
    assert texts(finite) == [repr(x) for x in finite]


def test_most_floats_need_no_help(monkeypatch: pytest.MonkeyPatch) -> None:
    """The quick way decides all but a few by itself, or it would not be quick."""
    asked = []
    monkeypatch.setattr("builtins.repr", lambda x: asked.append(x) or float.__repr__(x))
    spelled(RANDOM.uniform(-1, 1, COUNT))
    assert len(asked) < COUNT / 1000


def test_rows_have_their_pieces_between_numbers() -> None:
    """Before the first, and after the last; no rows are nothing."""
    block = np.array([[1.0, -0.25], [1e-9, 3.0]])
    assert lines(block, ["<", "; ", ">\n"]) == "<1.0; -0.25>\n<1e-09; 3.0>\n"
    assert lines(block[:0], ["<", "; ", ">\n"]) == ""
