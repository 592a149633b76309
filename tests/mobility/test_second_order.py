"""Quadratic forms: where they vanish together, and where they do not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.geometry.rank import spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.model import model_of
from dhcli.mobility.motion import residual
from dhcli.mobility.second_order import common_zero, cover, possible, proves_rigid, quadratic_forms
from tests.mobility.building import joint, planar
from tests.mobility.mechanisms import linkage
from tests.nightly import cases_for_nights, examples
from tests.row_by_row import row_by_row

seeds = st.integers(0, 10_000)
law = examples(0.8)


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


def vanish_nowhere(forms: Array) -> bool:
    """Whether the forms have no common zero."""
    return not len(cover(forms))


@law
@given(seeds, st.integers(1, 3), st.integers(2, 4))
def test_a_common_zero_is_never_overlooked(seed: int, count: int, size: int) -> None:
    """Wherever it lies."""
    forms, zero = with_zero(seed, count, size)
    assert not vanish_nowhere(forms)
    assert np.abs(cover(forms) @ zero).max() > 0.9
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
    assert found is not None
    assert np.abs(found @ forms @ found).max() < 1e-10


@row_by_row("seed", range(10))
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


@pytest.mark.parametrize("name", ["collinear2", "jessen", "snu3upu_locked", "fourbar_shaky_brace", "delta_rrpar"])
def test_the_forms_are_the_second_order_of_the_gap(name: str) -> None:
    """The oracle: the loops themselves, a little away along each instantaneous motion."""
    model = model_of(linkage(name))
    _, motions, stresses = spaces(model.jacobian())
    forms = quadratic_forms(model, motions, stresses)
    draw = np.random.default_rng(3)
    for _ in range(3):
        x = draw.normal(size=motions.shape[1])
        step = 1e-4
        gaps = [residual(model, sign * step * (motions @ x))[0] for sign in (1, -1)]
        measured = stresses.T @ (gaps[0] + gaps[1]) / (2 * step**2)
        assert np.abs(measured - x @ forms @ x).max() < 1e-5 * max(1.0, float(np.abs(forms).max()))


@pytest.mark.parametrize("sizes", cases_for_nights([(20, 2), (60, 3)], (20, 2)))
def test_many_freedoms_with_a_shaky_part_are_told_apart(sizes: tuple[int, int]) -> None:
    """A ring of bars moves as it likes; two bars in a line on one of them only seem to."""
    bars, shaky = sizes
    names = ["g", *map(str, range(1, bars)), "g"]
    angles = [2 * np.pi * i / bars for i in range(bars)]
    radii = [1 + 0.1 * np.sin(7 * i) for i in range(bars)]
    joints = [
        joint("R", names[i], names[i + 1], (radii[i] * np.cos(angles[i]), radii[i] * np.sin(angles[i])))
        for i in range(bars)
    ]
    for i in range(shaky):
        joints += [joint("R", str(i + 1), f"u{i}", (0, i)), joint("R", f"u{i}", f"v{i}", (0.5, i))]
        joints.append(joint("R", f"v{i}", str(i + 1), (1.2, i)))
    found = planar(joints, "1")
    assert (found.instantaneous, found.mobility, found.gruebler) == (bars - 3 + shaky, bars - 3, bars - 3)
