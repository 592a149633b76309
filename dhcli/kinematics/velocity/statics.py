"""Torques with which an arm makes its end press with a wrench: tau = Jᵀ F, in numbers or in symbols."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import field
from typing import Generic, TypeAlias, TypeVar, Unpack

from dhcli.algebra.arithmetic import settled, sum_of_products
from dhcli.algebra.terms import TERMS
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import ORIGIN
from dhcli.kinematics.forward import Given
from dhcli.kinematics.given import coordinates, real
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import JointInput, Values, given_parameters, joint_values, parameter_values
from dhcli.kinematics.velocity.jacobian import Jacobian, numeric_jacobian, textbook_jacobian
from dhcli.kinematics.velocity.view import MotionView, Viewing
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import ZERO, Expr

N = TypeVar("N")

Triple: TypeAlias = tuple[N, N, N]


@frozen
class Wrench(Generic[N]):
    """A force and a moment about the point it acts at.

    Attributes:
        force: Along three axes [N].
        moment: About three axes [N m].
    """

    force: Triple[N]
    moment: Triple[N]

    @property
    def six(self) -> tuple[N, ...]:
        """Force above moment, as v stands above ω."""
        return (*self.force, *self.moment)


@frozen
class Torques(Generic[N]):
    """What the joints bear.

    Attributes:
        values: For each joint a torque [N m] or, of a slide, a force [N].
        joints: Their names.
        kinds: Revolute or prismatic, for the unit.
        wrench: What the end presses with.
        view: At which point, and along which axes it is given.
        writing: The robot's joint angles, for shorthand.
    """

    values: tuple[N, ...]
    joints: tuple[str, ...]
    kinds: tuple[str, ...]
    wrench: Wrench[N]
    view: MotionView
    writing: Joints = field(default=THETAS, compare=False, repr=False)

    @property
    def units(self) -> tuple[str, ...]:
        """The unit of each value."""
        return tuple("N m" if kind == "revolute" else "N" for kind in self.kinds)


def torques(
    robot: Robot,
    q: JointInput = None,
    force: Iterable[float] = ORIGIN,
    moment: Iterable[float] = ORIGIN,
    *,
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> tuple[float, ...]:
    """The joint torques with which the end of an arm presses with a force and a moment, its own weight left aside.

    A load that pulls the end down with 10 N is held by pressing up with 10 N: `force=(0, 0, 10)`.

    Args:
        robot: The robot.
        q: Joint values in any form that `forward` takes.
        force: The force that the end exerts, shape (3,) [N].
        moment: The moment that it exerts, shape (3,) [N m].
        parameters: Lengths and angles to use instead of the robot's own.
        **viewing: Between which frames, along which axes, of which point; see `Viewing`.

    Returns:
        For each joint between the two frames a torque [N m] or, of a slide, a force [N]: tau = Jᵀ F.

    Raises:
        RobotError: A value is missing or no number, or a vector has not three.
        UnknownNameError: The robot has no such frame, joint or length.

    Source: Craig, eq. 5.96; Spong, Hutchinson and Vidyasagar, eq. 4.118.
    """
    check_robot(robot)
    view = MotionView.of(robot, **viewing)
    values = {**parameter_values(robot, parameters), **joint_values(robot, q)}
    wrench = Wrench(three_numbers(force, "a force"), three_numbers(moment, "a moment"))
    return numeric_torques(robot, values, view, wrench).values


def symbolic_torques(
    robot: Robot,
    q: JointInput = None,
    force: Iterable[float | str] = ("f_x", "f_y", "f_z"),
    moment: Iterable[float | str] = ORIGIN,
    *,
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> tuple[Expr, ...]:
    """The same in symbols: `f_y*(a1*c1 + a2*c12) - f_x*(a1*s1 + a2*s12)`; see `torques`.

    Raises:
        RobotError: It would be longer than anybody can read, or a vector has not three numbers.
    """
    check_robot(robot)
    view = MotionView.of(robot, **viewing)
    values = {**given_parameters(robot, parameters), **joint_values(robot, q)}
    wrench = Wrench(three_terms(force, "a force"), three_terms(moment, "a moment"))
    return textbook_torques(robot, values, view, wrench).values


def numeric_torques(robot: Robot, values: Values, view: MotionView, wrench: Wrench[float]) -> Torques[float]:
    """The torques at known values, without numpy; see `torques`."""
    found = numeric_jacobian(robot, values, view)
    return _borne(
        robot,
        found,
        wrench,
        tuple(float(sum_of_products(column, wrench.six)) for column in zip(*found.rows, strict=True)),
    )


def textbook_torques(robot: Robot, values: Values, view: MotionView, wrench: Wrench[Expr]) -> Torques[Expr]:
    """The torques in terms, with some values put in; see `symbolic_torques`."""
    found = textbook_jacobian(robot, values, view)
    return _borne(robot, found, wrench, products(zip(*found.rows, strict=True), wrench.six))


def _borne(robot: Robot, found: Jacobian[N], wrench: Wrench[N], values: tuple[N, ...]) -> Torques[N]:
    kinds = {joint.name: joint.kind for joint in robot.joints}
    return Torques(values, found.joints, tuple(kinds[n] for n in found.joints), wrench, found.view, robot.writing)


def products(rows: Iterable[Sequence[Expr]], column: Sequence[Expr]) -> tuple[Expr, ...]:
    """Each of some rows times a column, in terms; their zeros cost nothing."""

    def plain(entries: Sequence[Expr]) -> tuple[Expr | int, ...]:
        return tuple(0 if entry == ZERO else entry for entry in entries)

    return tuple(settled(sum_of_products(plain(row), plain(column)), TERMS) for row in rows)


def three_numbers(given: Iterable[float], what: str) -> Triple[float]:
    """Three real numbers.

    Raises:
        RobotError: They are something else.
    """
    try:
        found = tuple(map(real, given))
    except (TypeError, ValueError):
        raise RobotError(f"{what} is three numbers, not {given!r:.60}", "in symbols, names too") from None
    three = _three(found, what)
    if not all(map(math.isfinite, three)):
        raise RobotError(f"{what} holds something that is not a real number")
    return three


def three_terms(given: Iterable[float | str], what: str) -> Triple[Expr]:
    """Three expressions, of numbers and text with any names.

    Raises:
        RobotError: They are not three.
        NotationError: A text cannot be read.
    """
    return _three(coordinates(given), what)


def _three(found: Sequence[N], what: str) -> Triple[N]:
    if len(found) != 3:  # noqa: PLR2004
        raise RobotError(f"{what} has three numbers, not {len(found)}", "along x, y and z")
    return found[0], found[1], found[2]
