"""No answer hangs on how a library for linear algebra rounds, or on which basis of a null space it picks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from dhcli.geometry.rank import spaces
from dhcli.geometry.twists import Array
from dhcli.mobility import landing
from dhcli.mobility.landing import close
from dhcli.mobility.model import model_of
from dhcli.mobility.truth import true_mobility
from tests.mobility.mechanisms import MECHANISMS, linkage
from tests.nightly import cases_for_nights, in_turn

EPSILON = float(np.finfo(float).eps)
NOTHING = 1e-12
"""Relative to the largest, singular values below this may be zero: any basis of their vectors is as good."""

Svd = Callable[..., Any]


def another(svd: Svd, seed: int) -> Svd:
    """A singular value decomposition as right as the given one: other rounding, other bases of the null spaces."""
    draw = np.random.default_rng(seed)

    def decomposed(matrix: Array, *, full_matrices: bool = True, compute_uv: bool = True) -> object:
        if not compute_uv or not matrix.size:
            return svd(matrix, full_matrices=full_matrices, compute_uv=compute_uv)
        left, values, right = svd(matrix, full_matrices=full_matrices)
        largest = values[0]
        kept = int(np.count_nonzero(values > NOTHING * largest))
        values = np.abs(values + 4 * EPSILON * largest * draw.normal(size=values.shape))
        left = np.hstack([left[:, :kept], left[:, kept:] @ rotation(left.shape[1] - kept)])
        right = np.vstack([right[:kept], rotation(right.shape[0] - kept) @ right[kept:]])
        return left, np.sort(values)[::-1], right

    def rotation(size: int) -> Array:
        return np.asarray(np.linalg.qr(draw.normal(size=(size, size)))[0]) if size else np.zeros((0, 0))

    return decomposed


@pytest.mark.parametrize("seed", cases_for_nights([1, 2, 3], 1))
@pytest.mark.parametrize("name", in_turn([*MECHANISMS], 0, 2))
def test_another_library_gives_the_same_mobility(name: str, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Though it rounds otherwise, and its null spaces have other bases."""
    expected = MECHANISMS[name]["truth"]
    monkeypatch.setattr(np.linalg, "svd", another(np.linalg.svd, seed))
    found = true_mobility(linkage(name))
    assert (found.instantaneous, found.mobility, len(found.idle)) == tuple(expected[k] for k in ("inst", "dof", "idle"))


@pytest.mark.parametrize("name", ["fourbar_shaky_brace", "leonardo2", "snu3upu_locked"])
def test_an_imposed_amplitude_is_kept(name: str) -> None:
    """Also where the loops cannot close, and sixty steps look for a way out."""
    model = model_of(linkage(name))
    _, motions, _ = spaces(model.jacobian())
    for direction in motions.T:
        for amplitude in landing.AMPLITUDES:
            q, _ = close(model, amplitude * direction, direction[None, :], np.array([amplitude]))
            assert direction @ q == pytest.approx(amplitude, rel=1e-12)
