"""Quadratic forms: where they vanish together, and where they do not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhcli.geometry.twists import Array
from dhcli.mobility.second_order import common_zero, possible, proves_rigid, vanish_nowhere

seeds = st.integers(0, 10_000)
law = settings(max_examples=25, deadline=None, derandomize=True)


def symmetric(draw: np.random.Generator, size: int) -> Array:
    """A random form."""
    form = draw.normal(size=(size, size))
    return np.asarray(form + form.T)


def with_zero(seed: int, count: int, size: int) -> tuple[Array, Array]:
    """Random forms that all vanish in one direction, and the direction."""
    draw = np.random.default_rng(seed)
    zero = draw.normal(size=size)
    zero /= np.linalg.norm(zero)
    forms = [
        form - (zero @ form @ zero) * np.outer(zero, zero) for form in (symmetric(draw, size) for _ in range(count))
    ]
    return np.array(forms), zero


def test_forms_without_a_common_zero_and_without_a_definite_combination() -> None:
    """x² - y² and 2xy: real and imaginary part of a square."""
    forms = np.array([[[1.0, 0.0], [0.0, -1.0]], [[0.0, 1.0], [1.0, 0.0]]])
    assert not proves_rigid(forms)
    assert vanish_nowhere(forms)


def test_one_indefinite_form_vanishes_somewhere() -> None:
    """So it proves nothing; a definite one does."""
    assert not vanish_nowhere(np.array([[[1.0, 0.0], [0.0, -1.0]]]))
    assert vanish_nowhere(np.array([[[1.0, 0.0], [0.0, 2.0]]]))
    assert not vanish_nowhere(np.zeros((2, 3, 3)))


@law
@given(seeds, st.integers(1, 3), st.integers(2, 4))
def test_a_common_zero_is_never_overlooked(seed: int, count: int, size: int) -> None:
    """Wherever it lies."""
    forms, _ = with_zero(seed, count, size)
    assert not vanish_nowhere(forms)
    assert not proves_rigid(forms)


@law
@given(seeds)
def test_two_forms_in_two_directions_are_judged_by_their_resultant(seed: int) -> None:
    """The oracle: roots of one form are put into the other."""
    draw = np.random.default_rng(seed)
    forms = np.array([symmetric(draw, 2), symmetric(draw, 2)])
    roots = np.roots([forms[0, 0, 0], 2 * forms[0, 0, 1], forms[0, 1, 1]])
    directions = [np.array([root.real, 1.0]) for root in roots if abs(root.imag) < 1e-12]
    least = min((abs(d @ forms[1] @ d) / (d @ d) for d in directions), default=1.0)
    assert vanish_nowhere(forms) == (least > 1e-3) or least < 1e-2


@law
@given(seeds, st.integers(2, 5))
def test_a_zero_near_by_is_found(seed: int, size: int) -> None:
    """From a start that is a little off."""
    forms, zero = with_zero(seed, 1, size)
    start = zero + 0.01 * np.random.default_rng(seed + 1).normal(size=size)
    found = common_zero(forms, start / np.linalg.norm(start))
    assert np.abs(found @ forms @ found).max() < 1e-10


@pytest.mark.parametrize("seed", range(10))
def test_a_form_that_is_nowhere_negative_leaves_its_null_space(seed: int) -> None:
    """And what a second form stops in there is left out too."""
    draw = np.random.default_rng(seed)
    basis = np.linalg.qr(draw.normal(size=(4, 4)))[0]
    first = basis @ np.diag([2.0, 1.0, 0.0, 0.0]) @ basis.T
    second = symmetric(draw, 4)
    second += (
        basis @ np.diag([0.0, 0.0, 1.0, 0.0]) @ basis.T
        - basis[:, 2:] @ basis[:, 2:].T @ second @ basis[:, 2:] @ basis[:, 2:].T
    )
    left = possible(np.array([first]))
    assert np.abs(left.T @ basis[:, :2]).max() < 1e-9
    assert left.shape == (4, 2)
    both = possible(np.array([first, second]))
    assert both.shape == (4, 1)
    assert abs(both[:, 0] @ basis[:, 3]) == pytest.approx(1)
    assert possible(np.zeros((0, 3, 3))).shape == (3, 3)
