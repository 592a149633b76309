"""Torques and rates: power is conserved, both ways agree, and nothing is infinite at a singular pose."""

from __future__ import annotations

import math

import numpy as np
import pytest

from dhcli import (
    Robot,
    jacobian,
    joint_rates,
    load_robot,
    manipulability,
    singularities,
    symbolic_torques,
    torques,
    velocity_of,
)
from dhcli.algebra.floats import Floats
from dhcli.errors import DhcliError, RobotError
from dhcli.kinematics.singular.standing import standing_at
from dhcli.kinematics.values import joint_values, numbers, parameter_values
from dhcli.kinematics.velocity.measures import measures_of
from dhcli.kinematics.velocity.view import MotionView, Viewing
from tests.kinematics.arms import IIWA, joint_point, moving_robots, with_values
from tests.nightly import in_turn
from tests.row_by_row import row_by_row

FORCE, MOMENT = (3.0, -5.0, 7.0), (0.4, 0.2, -0.6)


@pytest.mark.parametrize("name", moving_robots())
def test_power_is_conserved(name: str) -> None:
    """tau·q' = F·v + M·ω for every robot, in any frame, at any point."""
    robot, parameters = load_robot(name), with_values(load_robot(name))
    q = joint_point(robot, 1)
    rates = [0.3 - 0.17 * k for k in range(len(q))]
    views: tuple[Viewing, ...] = ({}, {"axes": robot.frames[-2]}, {"point": (0.1, 0.2, 0.3)}, {"place": "base"})
    for viewing in views:
        borne = torques(robot, q, FORCE, MOMENT, parameters=parameters, **viewing)
        moved = velocity_of(robot, q, rates, parameters=parameters, **viewing)
        power = sum(t * r for t, r in zip(borne, rates, strict=True))
        assert power == pytest.approx(sum(f * v for f, v in zip((*FORCE, *MOMENT), moved, strict=True)), abs=1e-12)


def test_torques_in_symbols_are_those_of_the_book() -> None:
    """The planar arm: Jᵀ F, no bracket expanded."""
    robot = load_robot("planar-2r")
    first, second = symbolic_torques(robot, None, ("f_x", "f_y", 0))
    assert str(first) == "-f_x*(a1*s1 + a2*s12) + f_y*(a1*c1 + a2*c12)"
    assert str(second) == "-a2*f_x*s12 + a2*f_y*c12"
    at = Floats({"theta1": 0.3, "theta2": 0.5, "a1": 0.4, "a2": 0.3, "f_x": 2.0, "f_y": -3.0})
    assert [at.value(first), at.value(second)] == pytest.approx(torques(robot, [0.3, 0.5], (2, -3, 0)))


def test_a_load_at_a_stretched_arm_turns_by_its_lever() -> None:
    """10 N at 0.7 m, by hand."""
    assert torques(load_robot("planar-2r"), [0, 0], (0, 10, 0)) == pytest.approx((7.0, 3.0))


def test_a_slide_bears_a_force() -> None:
    """The third joint of a SCARA, along the axis."""
    assert torques(load_robot("scara"), "pick", (0, 0, 5))[2] == pytest.approx(-5.0)


@pytest.mark.parametrize("name", ["puma560", "ur5e", "stanford", "cylindrical-wrist"])
def test_rates_and_velocities_are_inverse(name: str) -> None:
    """Where the arm is not singular: the rates give the velocity that was asked for."""
    robot = load_robot(name)
    q = joint_point(robot, 2)
    found = joint_rates(robot, q, (0.1, -0.2, 0.3), (0.4, 0.5, -0.6))
    assert found.is_reached
    assert found.warnings == ()
    assert velocity_of(robot, q, found.values) == pytest.approx((0.1, -0.2, 0.3, 0.4, 0.5, -0.6))


def test_nothing_is_infinite_at_a_singular_pose() -> None:
    """The rates are finite, and the warning says that the velocity has none."""
    found = joint_rates(load_robot("planar-2r"), [0, 0], (0.1, 0, 0))
    assert all(map(math.isfinite, found.values))
    assert not found.is_reached
    assert "the arm is singular here (rank 1 of 2)" in found.warnings[0]


def test_damping_keeps_rates_small_near_a_singular_pose() -> None:
    """(JᵀJ + λ²)⁻¹ Jᵀ v, by its definition; and it is said."""
    robot, q = load_robot("planar-2r"), [0.3, 0.001]
    plain, damped = (joint_rates(robot, q, (0.1, 0.1, 0), damping=d) for d in (0.0, 0.05))
    matrix = jacobian(robot, q, part="linear")
    expected = np.linalg.solve(matrix.T @ matrix + 0.05**2 * np.eye(2), matrix.T @ np.array([0.1, 0.1, 0]))
    assert damped.values == pytest.approx(tuple(expected))
    assert max(map(abs, damped.values)) < max(map(abs, plain.values)) / 10
    assert "damped by 0.05" in damped.warnings[0]


def test_too_few_joints_come_as_near_as_they_can() -> None:
    """A planar arm has no way up."""
    found = joint_rates(load_robot("planar-2r"), [0.3, 0.5], (0, 0, 0.1))
    assert found.values == pytest.approx((0, 0))
    assert "2 joints cannot make every velocity" in found.warnings[0]


def test_the_self_motion_of_a_redundant_arm_is_named() -> None:
    """One direction in joint space that leaves the end at rest."""
    robot = load_robot("panda")
    found = joint_rates(robot, "ready", (0.1, 0, 0), (0, 0, 0))
    (idle,) = found.idle
    assert np.linalg.norm(idle) == pytest.approx(1)
    assert velocity_of(robot, "ready", idle) == pytest.approx((0,) * 6, abs=1e-12)
    assert np.dot(idle, found.values) == pytest.approx(0, abs=1e-12)


def test_several_self_motions_are_told_apart_by_joints_that_only_one_of_them_moves() -> None:
    """A base that turns below a shoulder about the same axis, and a slide beside three parallel axes."""
    links = ["Rot(z, q1)", "Rot(z, q2)", "Trans(0.3, 0, 0)", "Trans(d3, 0, 0)", "Trans(d4, 0, 0)"]
    head = "format: 1\ntitle: x\nsource: x\nconvention: product\nvariables: [q1, q2, d3, d4]\n"
    robot = Robot.from_text(f"{head}links: [{', '.join(repr(link) for link in links)}]\n")
    found = joint_rates(robot, [0.2, 0.3, 0.1, 0.2], (0.1, 0.2, 0), (0, 0, 0))
    half = math.sqrt(0.5)
    assert np.abs(found.idle) == pytest.approx(np.array([[half, half, 0, 0], [0, 0, half, half]]))
    for idle in found.idle:
        assert velocity_of(robot, [0.2, 0.3, 0.1, 0.2], idle) == pytest.approx((0,) * 6, abs=1e-12)


def test_the_angular_velocity_alone_may_be_asked_for() -> None:
    """Any velocity of the point will do then."""
    found = joint_rates(load_robot("spherical-wrist"), [0.3, 0.5, 0.7], None, (0.1, 0.2, 0.3))
    assert found.labels == ("ω_x", "ω_y", "ω_z")
    assert found.is_reached


@pytest.mark.parametrize("name", in_turn([n for n in moving_robots() if not n.startswith("dh-link")], 0, 2))
def test_manipulability_is_the_size_of_the_determinant(name: str) -> None:
    """Where there is one; else the volume by its singular values; for one and for many."""
    robot = load_robot(name)
    found = singularities(robot)
    q = joint_point(robot, 1)
    w = manipulability(robot, q)
    assert manipulability(robot, [q, q]) == pytest.approx([w, w])
    if found.determinant is None:
        assert w >= 0
        return
    at = Floats({**numbers(parameter_values(robot, {})), **dict(zip(robot.variables, q, strict=True))})
    assert w == pytest.approx(abs(at.value(found.determinant)), abs=1e-12)


def test_the_measures_of_a_planar_arm_are_those_of_its_plane() -> None:
    """The row that leads out of it is left aside; at right angles the ellipse has known axes."""
    robot = load_robot("planar-2r")
    found = measures_of(jacobian(robot, "elbow", part="linear"), (0, 1))
    assert (found.rank, len(found.values)) == (2, 2)
    assert found.manipulability == pytest.approx(0.4 * 0.3)
    assert found.condition == pytest.approx(found.values[0] / found.least)
    assert all(direction[2] == 0 for direction in found.directions)
    stretched = measures_of(jacobian(robot, [0, 0], part="linear"), (0, 1))
    assert (stretched.rank, stretched.condition, stretched.directions[0]) == (1, None, (0, 1, 0))
    assert measures_of(np.zeros((3, 2))).rank == 0


def test_a_stretched_arm_has_no_manipulability() -> None:
    """Where a row happens to be zero it still counts."""
    assert manipulability(load_robot("planar-2r"), [0, 0]) == 0
    assert manipulability(load_robot("planar-2r"), [[0, 0], [0, 1]]) == pytest.approx([0, 0.12 * math.sin(1)])


def test_an_arm_knows_how_far_it_stands_from_each_factor() -> None:
    """The wrist at 10° is 10° away; the nearest stands first."""
    robot = load_robot("puma560")
    found = singularities(robot)
    values = {**parameter_values(robot, {}), **joint_values(robot, "10°, -45°, 20°, 30°, 10°, 5°")}
    standing = standing_at(robot, values, MotionView.of(robot), found)
    first = standing.distances[0]
    assert str(found.factors[first.factor].zeros[0]) == "s5"
    assert first.distance == pytest.approx(math.radians(10))
    assert standing.determinant == pytest.approx(
        np.linalg.det(jacobian(robot, "10°, -45°, 20°, 30°, 10°, 5°")), rel=1e-9
    )
    at_wrist = {**values, **joint_values(robot, "theta5=0")}
    assert standing_at(robot, at_wrist, MotionView.of(robot), found).measures.rank == 5


def test_the_distance_of_a_condition_is_that_to_all_its_zeros() -> None:
    """Two sines at 3° and 4° are 5° from both."""
    found = singularities(IIWA)
    lengths = dict.fromkeys(IIWA.parameters, 0.4)
    q = joint_values(IIWA, "10°, 3°, 40°, 50°, 60°, 4°, 0")
    standing = standing_at(IIWA, {**parameter_values(IIWA, lengths), **q}, MotionView.of(IIWA), found)
    first = standing.distances[0]
    assert [str(zero) for zero in found.factors[first.factor].zeros] == ["s2", "s6"]
    assert math.degrees(first.distance) == pytest.approx(5)


@row_by_row(
    ("call", "match"),
    [
        (lambda: torques(load_robot("scara"), "pick", (1, 2)), "a force has three numbers, not 2"),
        (lambda: torques(load_robot("scara"), "pick", (1, 2, math.nan)), "not a real number"),
        (lambda: torques(load_robot("scara"), "pick", ("a", 0, 0)), "a force is three numbers"),  # type: ignore[arg-type]
        (lambda: symbolic_torques(load_robot("scara"), None, ("a", 0)), "a force has three numbers"),
        (lambda: joint_rates(load_robot("scara"), "pick"), "need a velocity"),
        (lambda: joint_rates(load_robot("scara"), "pick", (0, 0, 1), damping=-1), "damping is 0 or a positive"),
        (lambda: joint_rates(load_robot("scara"), "pick", (0, 0, math.inf)), "a velocity holds"),
        (lambda: velocity_of(load_robot("scara"), "pick", [1, 2]), "2 rates for 3 joints"),
        (lambda: velocity_of(load_robot("scara"), "pick", [1, 2, math.nan]), "a rate is not a real number"),
        (lambda: velocity_of(load_robot("scara"), "pick", ["a", 2, 3]), "rates are numbers"),  # type: ignore[list-item]
        (lambda: manipulability(load_robot("assembly-blocks")), "has no joint"),
    ],
)
def test_what_cannot_be_is_said(call: object, match: str) -> None:
    """With what would be right."""
    with pytest.raises(DhcliError, match=match):
        call()  # type: ignore[operator]


def test_a_row_that_is_no_number_has_no_manipulability() -> None:
    """The others have."""
    found = manipulability(load_robot("planar-2r"), [[0.1, math.nan], [0.1, 0.2]])
    assert not isinstance(found, float)
    assert np.isnan(found[0])
    assert found[1] == pytest.approx(0.12 * math.sin(0.2))
    with pytest.raises(RobotError):
        manipulability(load_robot("planar-2r"), [0.1, math.nan])


def test_vectors_and_points_may_be_arrays() -> None:
    """Of either precision, for whoever checks types too."""
    robot, q = load_robot("ur5e"), np.linspace(0.1, 0.6, 6)
    v, w, rates = np.array([1.0, 2, 3]), np.array([0.5, 0.25, -1], np.float32), np.arange(6.0)
    assert torques(robot, q, v, w, point=v) == torques(robot, q, (1, 2, 3), (0.5, 0.25, -1), point=(1, 2, 3))
    assert joint_rates(robot, q, v, w) == joint_rates(robot, q, (1, 2, 3), (0.5, 0.25, -1))
    assert velocity_of(robot, q, rates, point=w) == velocity_of(robot, q, range(6), point=(0.5, 0.25, -1))
    assert np.array_equal(jacobian(robot, q, point=v), jacobian(robot, q, point=(1, 2, 3)))
    arm = load_robot("planar-2r")
    assert singularities(arm, point=np.array([0.1, 0, 0])) == singularities(arm, point=(0.1, 0, 0))


def test_rates_show_themselves_in_a_line() -> None:
    """With a word where they do not give the velocity."""
    arm = load_robot("planar-2r")
    assert repr(joint_rates(arm, [0.3, 0.5], (0.1, 0, 0))) == "<Rates theta1' = 0.3633, theta2' = -1.0275>"
    assert repr(joint_rates(arm, [0, 0], (0.1, 0, 0))).endswith("theta2' = 0; the velocity is not reached>")
