"""A program over a grid says what it says row by row, whichever axes stay and whichever come part by part."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from dhcli.algebra.arithmetic import evaluate_settled
from dhcli.algebra.columns import Columns
from dhcli.algebra.program import Program, assemble
from dhcli.algebra.spread import Spread
from dhcli.algebra.tape import Tape
from dhcli.notation.parser import parse

TEXTS = ("a*b - c", "cos(b + c)*cos(b + c)", "sin(a)", "c", "2", "a*b - c", "sqrt(a)/b", "cos(c)*2 - b*c + cos(c)")


def program() -> Program:
    """What works out some expressions of a, b and c."""
    tape = Tape(["a", "b", "c"], tangents=True)
    return assemble(tape, [evaluate_settled(parse(text), tape) for text in TEXTS])


AXES = np.linspace(0.1, 1, 3), np.linspace(-2, 2, 4), np.array([0.0, 2.0])


@pytest.mark.parametrize("staying", [(), (2,), (1, 2), (0,), (0, 1, 2)])
def test_a_grid_is_its_rows(staying: tuple[int, ...]) -> None:
    """Played twice, so that nothing of the first part is left in the second; NaN where there is no value."""
    made = program()
    rows = np.array(list(product(*AXES)))
    wanted = Columns(made, len(rows)).play(rows.T).copy()
    along = [axis.reshape([-1 if other == k else 1 for other in range(3)]) for k, axis in enumerate(AXES)]
    grid = Spread(made, {k: along[k] for k in staying})
    moving = {k: along[k] for k in range(3) if k not in staying}
    grid.play({k: axis + 1 for k, axis in moving.items()})
    for found, row in zip(grid.play(moving), wanted, strict=True):
        assert np.broadcast_to(found, (3, 4, 2)).ravel() == pytest.approx(row, abs=1e-15, nan_ok=True)


def test_a_step_is_played_over_the_axes_that_it_depends_on() -> None:
    """And over no others: that is what a grid saves."""
    made = program()
    along = [axis.reshape([-1 if other == k else 1 for other in range(3)]) for k, axis in enumerate(AXES)]
    shapes = [np.shape(found) for found in Spread(made, {}).play(dict(enumerate(along)))]
    assert shapes == [(3, 4, 2), (1, 4, 2), (3, 1, 1), (1, 1, 2), (), (3, 4, 2), (3, 4, 1), (1, 4, 2)]
