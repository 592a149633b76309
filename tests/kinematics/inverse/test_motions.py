"""The actions of motions on directions, points, lines and circles."""

from __future__ import annotations

import numpy as np
import pytest

from dhcli.kinematics.inverse.arm import Arm, Axis
from dhcli.kinematics.inverse.matrices import Actions, acting, forms, value_of
from dhcli.kinematics.inverse.motions import CIRCLE, DIRECTION, LINE, POINT
from dhcli.kinematics.inverse.polishing import motions
from tests.kinematics.inverse.arms import CLASSES, random_arm

KINDS = [DIRECTION, POINT, LINE, CIRCLE]


def motions_at_random(count: int, seed: int) -> np.ndarray:
    """Rigid motions, shape (count, 4, 4)."""
    rng = np.random.default_rng(seed)
    result = np.tile(np.eye(4), (count, 1, 1))
    turns = np.linalg.qr(rng.normal(size=(count, 3, 3)))[0]
    result[:, :3, :3] = turns * np.sign(np.linalg.det(turns))[:, None, None]
    result[:, :3, 3] = rng.normal(size=(count, 3))
    return result


@pytest.mark.parametrize("kind", KINDS)
def test_motions_in_a_row_act_as_their_product_does(kind: int) -> None:
    """The action is a representation: that of a product is the product of those of its factors."""
    one, other = motions_at_random(20, 1), motions_at_random(20, 2)
    assert np.allclose(acting(kind, one @ other), acting(kind, one) @ acting(kind, other), atol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_motions_keep_the_form(kind: int) -> None:
    """What two things have to do with each other does not change when both are moved."""
    moved = acting(kind, motions_at_random(20, 3))
    assert np.allclose(moved.transpose(0, 2, 1) @ forms(kind) @ moved, forms(kind), atol=1e-12)


@pytest.mark.parametrize("name", ["general", "slide third"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_joint_acts_by_three_constant_matrices(kind: int, name: str) -> None:
    """Cosine and sine, or length and half its square, times constant matrices are the action of the motion."""
    arm = random_arm(CLASSES[name], np.random.default_rng(4))
    actions = Actions(arm)
    values = np.array([-2.0, 0.3, 1.4])
    moved = motions(arm, np.tile(values[:, None], len(arm.axes)))
    for j, axis in enumerate(arm.axes):
        there = actions.moved(kind, j, value_of(values, turns=axis.turns))
        assert np.allclose(there, acting(kind, moved[j]), atol=1e-12)
        back = actions.moved(kind, j, value_of(values, turns=axis.turns), back=True)
        assert np.allclose(there @ back, np.eye(len(there[0])), atol=1e-12)


def test_what_a_run_of_joints_leaves_fixed_stays_where_it_is() -> None:
    """Three axes that meet leave their point, parallel axes their direction and the planes across it."""
    arm = random_arm(CLASSES["spherical wrist, two parallel"], np.random.default_rng(5))
    actions = Actions(arm)
    turned = motions(arm, np.full((1, len(arm.axes)), 0.7))
    for run, counts in (((3, 4, 5), (0, 2, 0, 1)), ((1, 2), (1, 2, 1, 1)), ((0,), (1, 3, 2, 4))):
        for kind, count in zip(KINDS, counts, strict=True):
            things = actions.fixed(kind, run)
            assert len(things) == count
            for j in run:
                moved = acting(kind, turned[j])[0]
                assert np.allclose(moved @ things.T, things.T, atol=1e-9)


def test_an_axis_through_the_origin_leaves_zeros_in_what_it_fixes() -> None:
    """Structural zeros stay zeros, so that equations of ordinary robots are short."""
    arm = Arm((Axis("theta1", True, (0.0, 0.0, 1.0)),), 1, np.eye(4), np.eye(4), 1.0)  # noqa: FBT003
    things = Actions(arm).fixed(POINT, (0,))
    assert np.array_equal(np.unique(things), [0.0, 1.0])
