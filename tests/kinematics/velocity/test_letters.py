"""Joint rates in letters: with numbers put in they are the rates in numbers."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.floats import Floats
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.values import numbers
from dhcli.kinematics.velocity.asked import answer_symbolic_rates
from dhcli.kinematics.velocity.rates import joint_rates
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.tree import ZERO, Symbol
from tests.nightly import examples

WANTED = (0.3, -0.2, 0.5)


@pytest.mark.parametrize("robot", ["planar-2r", "articulated", "cylindrical", "scara"])
@examples(0.5)
@given(q=st.tuples(*[st.floats(0.2, 1.2)] * 3), axes=st.integers(0, 2))
def test_rates_in_letters_are_those_in_numbers(robot: str, q: tuple[float, float, float], axes: int) -> None:
    """Cramer's rule over proved factors, and a least-squares solution by singular values."""
    arm = load_robot(robot)
    joints = q[: len(arm.variables)]
    flat = robot == "planar-2r"
    wanted = (*WANTED[:2], 0.0) if flat else WANTED
    letters = (Symbol("u"), Symbol("v"), ZERO if flat else Symbol("w"))
    found = answer_symbolic_rates(arm, {}, MotionView.of(arm, axes=axes), letters, None)
    values = {**numbers(arm.parameters), **dict(zip(arm.variables, joints, strict=True)), "u": 0.3, "v": -0.2, "w": 0.5}
    over = Floats(values)
    true = joint_rates(arm, list(joints), wanted, axes=axes)
    assert true.is_reached
    assert [over.value(rate) for rate in found.rates] == pytest.approx(list(true.values), rel=1e-6, abs=1e-9)
