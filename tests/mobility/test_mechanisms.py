"""Mechanisms of the literature come out with their true mobility, in both forms, wherever they stand."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from dhcli.mobility.copies import mapped
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.large import large_mobility
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.model import model_of
from dhcli.mobility.result import Mobility
from dhcli.mobility.truth import true_mobility
from tests.mobility.dense import constraint_rank
from tests.mobility.mechanisms import MECHANISMS, linkage
from tests.nightly import paired, some

every = pytest.mark.parametrize("name", MECHANISMS)


@cache
def analysed(name: str) -> Mobility:
    """What is found about a mechanism, for all that is said of it."""
    return mobility_of(linkage(name))


@every
def test_counts_formula_and_truth_are_those_of_the_literature(name: str) -> None:
    """Grübler's number, the instantaneous and the true mobility, idle freedoms, and the output's freedoms."""
    truth, counted = MECHANISMS[name]["truth"], MECHANISMS[name]["counts"]
    found = analysed(name)
    assert (found.counts.n, found.counts.j, found.counts.sum_f) == tuple(
        type(found.counts.n)(counted[key]) for key in ("n", "j", "sum_f")
    )
    assert found.gruebler == truth["gruebler"]
    assert found.counts.by_constraints == found.counts.by_freedoms
    assert (found.instantaneous, found.mobility, len(found.idle)) == (truth["inst"], truth["dof"], truth["idle"])
    assert found.bounds == (truth["dof"], truth["dof"])
    assert int(found.motion[0]) + int(found.motion[2]) == truth["conn"]


@every
def test_a_difference_has_a_reason(name: str) -> None:
    """Where the formula is wrong, or the position is special, something is said; otherwise nothing."""
    truth = MECHANISMS[name]["truth"]
    special = truth["gruebler"] != truth["dof"] or truth["inst"] != truth["dof"]
    assert bool(analysed(name).reasons) == special


@every
def test_the_form_with_constraints_agrees_with_the_loops(name: str) -> None:
    """Both the plain matrix and the one that is eliminated link by link."""
    model = model_of(linkage(name))
    wanted = MECHANISMS[name]["truth"]["inst"]
    assert constraint_rank(model)[1] == wanted
    assert large_mobility(model).instantaneous == wanted


@pytest.mark.parametrize(("name", "seed"), paired(some([*MECHANISMS], 2), [1, 2]))
def test_a_copy_elsewhere_is_the_same_linkage(name: str, seed: int) -> None:
    """Turned in space, moved, and 37 or 0.02 times as large."""
    truth = MECHANISMS[name]["truth"]
    found = true_mobility(moved(linkage(name), seed, {1: 37.0, 2: 0.02}[seed]))
    assert (found.instantaneous, found.mobility, len(found.idle)) == (truth["inst"], truth["dof"], truth["idle"])


def moved(original: Linkage, seed: int, scale: float) -> Linkage:
    """A copy at another place, in another size."""
    draw = np.random.default_rng(seed)
    turn, _ = np.linalg.qr(draw.normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    shift = draw.normal(size=3) * 3 * scale
    return mapped(original, lambda p: scale * turn @ p + shift, lambda d: turn @ d, scale)


REASONS = {
    "fourbar_spatial": "λ is too large",
    "door_2hinges": "λ is too large",
    "cardan": "λ is too large",
    "parallel4": "lengths are special",
    "bennett": "lengths are special",
    "hoberman6": "lengths are special",
    "sarrus": "directions of the axes are special",
    "spatial4r_generic": "over-braced",
    "jessen": "over-braced",
    "parallelogram_flat": "singular",
    "collinear2": "shaky",
}


@pytest.mark.parametrize("name", REASONS)
def test_the_reason_is_the_one_of_the_textbooks(name: str) -> None:
    """In words that a student understands."""
    assert REASONS[name] in " ".join(mobility_of(linkage(name)).reasons)


ROUNDED = ("parallel4", "bennett", "sarrus", "hoberman6", "goldberg5r", "bricard_line")


def rounded(original: Linkage, decimals: int) -> Linkage:
    """A copy with points and unit axes as a drawing has them."""
    return mapped(original, lambda p: np.round(p, decimals), lambda d: np.round(d / np.linalg.norm(d), decimals))


@pytest.mark.parametrize("decimals", [4, 6])
@pytest.mark.parametrize("name", ROUNDED)
def test_a_rounded_drawing_is_understood_with_a_tolerance(name: str, decimals: int) -> None:
    """3·10^-decimals is enough for it."""
    found = mobility_of(rounded(linkage(name), decimals), 3 * 10.0**-decimals)
    assert found.mobility in (MECHANISMS[name]["truth"]["dof"], None)
    assert found.instantaneous == MECHANISMS[name]["truth"]["inst"]


def test_the_order_of_a_shaky_structure_is_told() -> None:
    """Leonardo's structure of order 4 resists later than the usual ones."""
    orders: dict[str, Any] = {
        name: mobility_of(linkage(name)).order for name in ("collinear2", "snu3upu_locked", "leonardo2")
    }
    assert orders == {"collinear2": 2, "snu3upu_locked": 2, "leonardo2": 4}
