"""Jacobians in numbers: against differences of the pose, and the same in every arithmetic, frame and convention."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import (
    forward,
    in_motors,
    jacobian,
    joint_rates,
    load_robot,
    manipulability,
    singularities,
    symbolic_jacobian,
)
from dhcli.algebra.floats import Floats
from dhcli.algebra.residues import Residues
from dhcli.errors import RobotError, UnknownNameError
from dhcli.kinematics.moves import Rot
from dhcli.kinematics.playing import BLOCK
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers, parameter_values
from dhcli.kinematics.velocity.form import TRIPLES, Triple
from dhcli.kinematics.velocity.jacobian import six_rows
from dhcli.kinematics.velocity.view import MotionView, Viewing, joints_between, parts
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from tests.kinematics.arms import PAN_TILT, hinges, joint_point, moving_robots, robot_once, with_values
from tests.nightly import examples, in_turn, paired, some
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from numpy.typing import NDArray

ROBOTS = moving_robots()
VIEWS: list[Viewing] = [
    {},
    {"axes": "tool"},
    {"place": "base"},
    {"point": (0.1, -0.2, 0.3)},
    {"start": "base", "axes": "tool", "place": "base", "point": (0.1, 0, 0)},
    {"start": "tool", "end": "base"},
]


def differences(robot: Robot, q: list[float], parameters: dict[str, str | float]) -> NDArray[np.float64]:
    """The Jacobian by central differences of `forward`."""
    here = forward(robot, q, parameters=parameters).matrix
    step, columns = 1e-5, []
    for k in range(len(q)):
        up, down = (
            forward(robot, [v + s * step * (j == k) for j, v in enumerate(q)], parameters=parameters).matrix
            for s in (1, -1)
        )
        rate = (up - down) / (2 * step)
        turning = rate[:3, :3] @ here[:3, :3].T
        columns.append([*rate[:3, 3], turning[2, 1], turning[0, 2], turning[1, 0]])
    return np.array(columns).T


@pytest.mark.parametrize("name", ROBOTS)
def test_a_jacobian_is_the_slope_of_the_pose(name: str) -> None:
    """To a relative 1e-8, for every robot of the library."""
    robot, parameters = robot_once(name), with_values(robot_once(name))
    for seed in in_turn((1, 2), ROBOTS.index(name), 2):
        q = joint_point(robot, seed)
        found = jacobian(robot, q, parameters=parameters)
        assert np.abs(found - differences(robot, q, parameters)).max() <= 1e-8 * max(1.0, np.abs(found).max())


@pytest.mark.parametrize("name", in_turn(ROBOTS, 0, 2))
def test_symbols_with_numbers_put_in_are_floats_and_columns(name: str) -> None:
    """In every view: three arithmetics, one fold."""
    robot, parameters = robot_once(name), with_values(robot_once(name))
    q = joint_point(robot, 3)
    at = Floats({**numbers(parameter_values(robot, parameters)), **dict(zip(robot.variables, q, strict=True))})
    inside: Viewing = {"start": "base", "end": "tool", "axes": robot.frames[2]}
    further: Viewing = {"start": robot.frames[1], "axes": "base", "place": robot.frames[2], "point": (0.1, 0.2, 0)}
    for viewing in (*in_turn(VIEWS, ROBOTS.index(name) // 2, 6), inside, further):
        one = jacobian(robot, q, parameters=parameters, **viewing)
        many = jacobian(robot, np.array([q, q]), parameters=parameters, **viewing)
        terms = [[at.value(entry) for entry in row] for row in symbolic_jacobian(robot, **viewing).rows]
        assert np.allclose(many, one, atol=1e-13)
        assert np.allclose(terms, one, atol=1e-13)


@pytest.mark.parametrize("name", in_turn(ROBOTS, 1, 2))
def test_what_is_asked_again_is_the_same(name: str) -> None:
    """By the fold at first, then by its recording: in lists and arrays, in every view and form."""
    robot = load_robot(name)
    if any(value is None for value in robot.parameters.values()):
        return
    q = joint_point(robot, 3)
    for viewing in in_turn(VIEWS, ROBOTS.index(name) // 2, 6):
        for more in ({}, {"part": "angular"}, {"part": "linear", "angular_first": True}):
            first = jacobian(robot, q, **more, **viewing)
            for asked in (q, tuple(q), np.array(q)):
                assert np.allclose(jacobian(robot, asked, **more, **viewing), first, atol=1e-13)
    rates = [jacobian(robot, q, analytic="zyz") for _ in range(3)] if len(q) > 5 else []
    assert all(np.allclose(one, rates[0], atol=1e-12) for one in rates)


def test_what_cannot_be_is_said_again() -> None:
    """As often as it is asked."""
    robot = robot_once("articulated")
    for _ in range(3):
        with pytest.raises(RobotError, match="3 joints"):
            jacobian(robot, [0.1, 0.2])
        with pytest.raises(RobotError, match="there are no rates of rpy"):
            jacobian(robot, [0, np.pi / 2, 0], analytic="rpy")
        with pytest.raises(UnknownNameError, match="no frame 9"):
            jacobian(robot, [0.1, 0.2, 0.3], axes=9)
        with pytest.raises(RobotError, match="no part"):
            jacobian(robot, [0.1, 0.2, 0.3], part="top")  # type: ignore[arg-type]
        with pytest.raises(RobotError):
            jacobian(robot, [0.1, np.nan, 0.3])
        assert np.allclose(jacobian(robot, [0.1, 0.2, 0.3], point=[0, 0, 0.1]).shape, (6, 3))


@pytest.mark.parametrize("name", ["stanford", "puma560", "scara", "ur5e"])
@pytest.mark.parametrize("viewing", VIEWS[:5])
def test_values_put_in_exactly_are_those_values(name: str, viewing: Viewing) -> None:
    """Every other joint and one length; the others are put in afterwards."""
    robot = robot_once(name)
    q = dict(zip(robot.variables, joint_point(robot, 2), strict=True))
    half = {joint: q[joint] for joint in robot.variables[::2]}
    length = next(name for name in robot.parameters if name not in robot.angles)
    at = Floats({**numbers(parameter_values(robot, {})), **q})
    put = symbolic_jacobian(robot, half, parameters={length: 0.31}, **viewing)
    expected = jacobian(robot, list(q.values()), parameters={length: 0.31}, **viewing)
    assert np.allclose([[at.value(entry) for entry in row] for row in put.rows], expected, atol=1e-12)


@pytest.mark.parametrize(("name", "viewing"), paired(ROBOTS, VIEWS[:5]))
def test_symbols_are_residues(name: str, viewing: Viewing) -> None:
    """At a random point of the field, exactly, from the plain chain."""
    robot = robot_once(name)
    view = MotionView.of(robot, **viewing)
    joints = joints_between(robot, view.start, view.end)
    at = Residues(angles=[move.angle for move in robot.chain if isinstance(move, Rot)])
    linear, angular = six_rows(tuple(parts(robot, view, joints, merged=False)), len(joints), at)
    found = symbolic_jacobian(robot, **viewing).rows
    assert [[at.value(e) for e in row] for row in found] == [[at.value(e) for e in row] for row in (*linear, *angular)]


@pytest.mark.parametrize("name", in_turn(ROBOTS, 0, 2))
def test_a_jacobian_in_another_frame_is_turned(name: str) -> None:
    """Rᵀ v and Rᵀ ω for every frame of the robot."""
    robot, parameters = robot_once(name), with_values(robot_once(name))
    q = joint_point(robot, 4)
    base = jacobian(robot, q, parameters=parameters)
    for frame in some(robot.frames, 3):
        turn = forward(robot, q, end=frame, parameters=parameters).matrix[:3, :3].T
        turned = np.vstack([turn @ base[:3], turn @ base[3:]])
        assert np.allclose(jacobian(robot, q, axes=frame, parameters=parameters), turned, atol=1e-13)


@pytest.mark.parametrize("name", in_turn(ROBOTS, 1, 2))
def test_space_and_body_jacobian_are_related_by_the_adjoint(name: str) -> None:
    """J_s = Ad_T J_b, ω above v, as Lynch and Park write it (eq. 5.22)."""
    robot, parameters = robot_once(name), with_values(robot_once(name))
    q, end = joint_point(robot, 5), robot_once(name).frames[-2]
    space = jacobian(robot, q, place=robot.frames[1], angular_first=True, parameters=parameters)
    body = jacobian(robot, q, axes=end, angular_first=True, parameters=parameters)
    pose = forward(robot, q, parameters=parameters).matrix
    turn, (x, y, z) = pose[:3, :3], pose[:3, 3]
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    adjoint = np.block([[turn, np.zeros((3, 3))], [skew @ turn, turn]])
    assert np.allclose(space, adjoint @ body, atol=1e-13)


@pytest.mark.parametrize("angles", TRIPLES)
def test_rates_of_angles_give_the_angular_velocity(angles: str) -> None:
    """B times them is ω, for every order of axes, in one and in many; B by differences of the rotation."""
    robot = robot_once("puma560")
    q = joint_point(robot, 2)
    rates, omega = (jacobian(robot, q, part="angular", analytic=name) for name in (angles, ""))
    assert np.allclose(jacobian(robot, [q, q], part="angular", analytic=angles)[1], rates, atol=1e-12)
    order = (2, 1, 0) if angles == "rpy" else (0, 1, 2)
    axes = TRIPLES[angles]
    found = _angles(forward(robot, q).matrix[:3, :3], axes)
    step, columns = 1e-6, []
    for k in range(3):
        up, down = (_rotation([a + s * step * (j == k) for j, a in enumerate(found)], axes) for s in (1, -1))
        turning = (up - down) / (2 * step) @ _rotation(found, axes).T
        columns.append([turning[2, 1], turning[0, 2], turning[1, 0]])
    b = np.array(columns).T
    assert np.allclose(_rotation(found, axes), forward(robot, q).matrix[:3, :3], atol=1e-9)
    assert np.allclose(b @ rates[list(order)], omega, atol=1e-8)
    triple = Triple.called(angles)
    over = Floats(dict(zip(triple.angles, found, strict=True)) | dict(zip(robot.variables, q, strict=True)))
    letters = symbolic_jacobian(robot, part="angular", analytic=angles)
    assert np.allclose([[over.value(entry) for entry in row] for row in letters.rows], rates, atol=1e-9)
    whole = over.value(parse(triple.vanishing, Scope(is_open=True, angles=triple.angles)))
    assert np.linalg.det(b[:, list(order)]) == pytest.approx(whole, abs=1e-8)


def _rotation(angles: list[float], axes: tuple[int, ...]) -> NDArray[np.float64]:
    """Three turns one after the other."""
    whole = np.eye(3)
    for angle, axis in zip(angles, axes, strict=True):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        turn = np.eye(3)
        turn[u, u] = turn[v, v] = np.cos(angle)
        turn[v, u], turn[u, v] = np.sin(angle), -np.sin(angle)
        whole = whole @ turn
    return whole


def _angles(rotation: NDArray[np.float64], axes: tuple[int, ...]) -> list[float]:
    """Three angles that make a rotation, by Newton from many starts; the middle one in its usual range."""
    rng = np.random.default_rng(7)
    proper = axes[0] == axes[2]
    for _ in range(200):
        guess = rng.uniform(-3, 3, 3)
        for _ in range(60):
            off = _rotation(list(guess), axes) - rotation
            slope = np.array(
                [
                    ((_rotation(list(guess + e), axes) - _rotation(list(guess - e), axes)) / 2e-6).ravel()
                    for e in np.eye(3) * 1e-6
                ]
            ).T
            step = np.linalg.lstsq(slope, off.ravel(), rcond=None)[0]
            guess = guess - step
            if np.abs(step).max() < 1e-13:
                break
        inside = 0 < guess[1] < np.pi if proper else abs(guess[1]) < np.pi / 2
        if inside and np.abs(_rotation(list(guess), axes) - rotation).max() < 1e-10:
            return list(guess)
    raise AssertionError(axes)


def test_rates_of_rpy_are_the_slopes_of_rpy() -> None:
    """As `forward(...).rpy` says them, roll first."""
    robot = robot_once("ur5e")
    q = joint_point(robot, 1)
    found = jacobian(robot, q, part="angular", analytic="rpy")
    for k in range(6):
        up, down = (forward(robot, [v + s * 1e-6 * (j == k) for j, v in enumerate(q)]).rpy for s in (1, -1))
        slopes = [(up.roll - down.roll), (up.pitch - down.pitch), (up.yaw - down.yaw)]
        assert np.allclose(np.array(slopes) / 2e-6, found[:, k], atol=1e-7)


def test_there_are_no_rates_of_rpy_at_pitch_90() -> None:
    """Said for one, NaN among many; the other rows stay."""
    robot = robot_once("articulated")
    with pytest.raises(RobotError, match="pitch is ±90°"):
        jacobian(robot, [0, "90°", 0], analytic="rpy")
    two = jacobian(robot, [[0, np.pi / 2, 0], [0, 0.3, 0]], analytic="rpy")
    assert np.isnan(two[0]).all()
    assert np.isfinite(two[1]).all()


def test_rates_of_angles_have_no_other_axes() -> None:
    """They are those of one frame seen from the other."""
    with pytest.raises(RobotError, match="in no other axes"):
        jacobian(robot_once("puma560"), "ready", axes=3, analytic="rpy")


@examples(0.5)
@given(st.lists(st.floats(-9, 9), min_size=6, max_size=6), st.sampled_from(["puma560", "stanford", "ur5e"]))
def test_many_are_one_row_by_row(q: list[float], name: str) -> None:
    """Wherever the joints stand."""
    robot = robot_once(name)
    assert np.allclose(jacobian(robot, [q])[0], jacobian(robot, q), atol=1e-12)


def test_a_batch_of_more_than_one_block_is_whole() -> None:
    """Blocks of different length, in order."""
    robot = robot_once("planar-2r")
    q = np.random.default_rng(1).uniform(-3, 3, (BLOCK + 5, 2))
    found = jacobian(robot, q)
    assert found.shape == (BLOCK + 5, 6, 2)
    for k in (0, BLOCK - 1, BLOCK, BLOCK + 4):
        assert np.allclose(found[k], jacobian(robot, q[k]), atol=1e-13)


def test_a_row_that_is_no_number_gives_none() -> None:
    """The others are as ever."""
    found = jacobian(robot_once("planar-2r"), [[0.1, np.nan], [0.1, 0.2]])
    assert np.isnan(found[0]).all()
    assert np.isfinite(found[1]).all()


def test_no_rows_give_no_jacobians() -> None:
    """Of the right shape."""
    assert jacobian(robot_once("puma560"), np.empty((0, 6)), part="linear").shape == (0, 3, 6)


def test_many_rows_may_lie_in_memory_as_they_like() -> None:
    """Columns first, every second row, read-only, shared by threads, a single row; the same Jacobians."""
    robot = robot_once("scara")
    q = np.random.default_rng(1).uniform(-3, 3, (20, 3))
    plain = jacobian(robot, q)
    fixed = q.copy()
    fixed.flags.writeable = False
    for rows in (np.asfortranarray(q), np.repeat(q, 2, axis=0)[::2], fixed, q.astype(object)):
        assert np.abs(jacobian(robot, rows, threads=2) - plain).max() <= 1e-15
    assert np.abs(jacobian(robot, q[:1]) - plain[:1]).max() <= 1e-15


@pytest.mark.parametrize(
    ("rows", "options", "said"),
    [
        (np.zeros((2, 3)), {"threads": 0}, "threads is a number from 1, not 0"),
        (np.zeros((2, 3)), {"threads": "2"}, "threads is a number from 1, not '2'"),
        (np.zeros((2, 3)), {"dtype": int}, "float64 or float32"),
        (np.zeros((2, 3), complex), {}, "complex numbers are given"),
        (np.array([[None, object(), 0]]), {}, "Q is no array of numbers"),
        (np.zeros((2, 4)), {}, r"scara has 3 joints; Q has the shape \(2, 4\)"),
    ],
)
def test_many_that_cannot_be_are_refused_in_words(rows: object, options: dict[str, object], said: str) -> None:
    """As by `forward_batch`."""
    with pytest.raises(RobotError, match=said):
        jacobian(robot_once("scara"), rows, **options)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (
            lambda arm, q: joint_rates(arm, q, [1, 0, 0], damping="much"),
            "damping is 0 or a positive number, not 'much'",
        ),
        (lambda arm, q: joint_rates(arm, q, [1, 0, 0], damping=-1), "damping is 0 or a positive number, not -1"),
        (lambda arm, q: manipulability(arm, q, part="v"), "a Jacobian has no part v"),
        (lambda arm, q: singularities(arm, part=3), "a Jacobian has no part 3"),
        (lambda arm, q: manipulability("scara", q), "scara"),
        (lambda arm, q: in_motors(5), "5"),
    ],
)
def test_what_is_no_part_no_damping_and_no_robot_is_refused(ask: Callable[..., object], said: str) -> None:
    """In words."""
    with pytest.raises(RobotError, match=said):
        ask(robot_once("scara"), [0.1, 0.2, 0.3])


def test_a_part_has_its_rows() -> None:
    """And the order can be turned over."""
    robot = robot_once("puma560")
    whole = jacobian(robot, "nominal")
    assert np.array_equal(jacobian(robot, "nominal", part="linear"), whole[:3])
    assert np.array_equal(jacobian(robot, "nominal", part="angular"), whole[3:])
    assert np.array_equal(jacobian(robot, "nominal", angular_first=True), np.roll(whole, 3, axis=0))


def test_a_jacobian_in_symbols_says_so_when_numbers_are_wanted() -> None:
    """And is a matrix once there are none left."""
    robot = robot_once("planar-2r")
    letters = symbolic_jacobian(robot)
    with pytest.raises(RobotError, match="in symbols: a1, a2, theta1, theta2"):
        _ = letters.matrix
    put = symbolic_jacobian(robot, [0.3, 0.5], parameters={"a1": 0.4, "a2": 0.3})
    assert np.allclose(put.matrix, jacobian(robot, [0.3, 0.5]))
    assert np.allclose(np.asarray(put, dtype=float), put.matrix)
    assert letters.to_sympy().shape == (6, 2)
    assert "Jacobian, rows v_x" in repr(letters)
    assert letters.latex().startswith("\\begin{bmatrix}")


@row_by_row(
    ("call", "error", "match"),
    [
        (lambda: jacobian(robot_once("scara"), [0.1, 0.2]), RobotError, "3 joints"),
        (lambda: jacobian(robot_once("scara"), [[0.1, 0.2]]), RobotError, r"not \(N, 3\)"),
        (lambda: jacobian(robot_once("scara")), RobotError, "no value for theta1"),
        (lambda: jacobian(PAN_TILT, [0.1, 0.2]), RobotError, "a1, a2 of pan-tilt have no value"),
        (lambda: jacobian(robot_once("assembly-blocks")), RobotError, "has no joint"),
        (lambda: jacobian(robot_once("scara"), "pick", start=2, end=2), RobotError, "no joint of scara moves frame 2"),
        (lambda: jacobian(robot_once("scara"), "pick", axes=9), UnknownNameError, "no frame 9"),
        (lambda: jacobian(robot_once("scara"), "pick", point=("x", 0, 0)), RobotError, "x of the point has no value"),
        (lambda: jacobian(robot_once("scara"), "pick", point=(0, 0)), RobotError, "three coordinates"),
        (lambda: jacobian(robot_once("scara"), "pick", part="upper"), RobotError, "no part upper"),  # type: ignore[arg-type]
        (lambda: jacobian(robot_once("scara"), "pick", analytic="zzy"), UnknownNameError, "no angles called zzy"),
        (lambda: jacobian("scara", "pick"), RobotError, "load_robot"),  # type: ignore[arg-type]
        (lambda: symbolic_jacobian(hinges("long", *[("a", 60, "d")] * 12)), RobotError, "symbols long"),
        (lambda: symbolic_jacobian(hinges("longer", *[("a", 60, "d")] * 50)), RobotError, "more than the 20000"),
    ],
)
def test_what_cannot_be_is_said(call: object, error: type[Exception], match: str) -> None:
    """With what would be right."""
    with pytest.raises(error, match=match):
        call()  # type: ignore[operator]
