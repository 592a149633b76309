"""The Jacobian of a robot: columns of linear and angular velocity, in numbers or as a textbook prints it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field
from fractions import Fraction
from typing import TypeVar

from dhcli.algebra.arithmetic import Arithmetic, Evaluator, plus, settled, times
from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.entries import DIGITS
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.frames import ORIGIN, between
from dhcli.kinematics.matrix import Matrix, Rows
from dhcli.kinematics.moves import Rot, Trans
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values, numbers, require
from dhcli.kinematics.velocity.form import GEOMETRIC, TINY, Form, Triple
from dhcli.kinematics.velocity.steps import Vector, fold_columns
from dhcli.kinematics.velocity.view import MotionView, Part, Way, check_size, joints_between, parts
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Expr, power
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import symbols_in

N = TypeVar("N")


@frozen
class Jacobian(Matrix[N]):
    """A Jacobian with the names of its rows and columns.

    Attributes:
        rows: Entries, shape (rows, joints), floats or expressions: metres and radians, a second cancelled.
        labels: What each row is, such as v_x.
        joints: The joint of each column.
        view: Of which frame and point it is, in which axes.
        form: Which rows it has.
        writing: The robot's joint angles, for shorthand.
    """

    rows: Rows[N]
    labels: tuple[str, ...]
    joints: tuple[str, ...]
    view: MotionView
    form: Form = GEOMETRIC
    writing: Joints = field(default=THETAS, compare=False, repr=False)

    def in_numbers(self) -> Rows[float]:
        """The entries in floats.

        Raises:
            RobotError: An entry holds a symbol.
        """
        return self._floats("the Jacobian", "jacobian(robot, q) gives numbers")

    def _numbers(self) -> Rows[float]:
        return self.in_numbers()

    def cells(self, style: str = "short", digits: int = DIGITS) -> tuple[tuple[str, ...], ...]:
        """The entries as text: expressions in a notation, numbers rounded for people."""
        return self._written(self.writing, style, digits)

    def __repr__(self) -> str:
        """A heading and the matrix, as a notebook or the prompt shows it."""
        return f"Jacobian, rows {', '.join(self.labels)}, columns {', '.join(self.joints)}:\n{self}"


def columns_over(made: Sequence[Part], count: int, over: Arithmetic[N]) -> tuple[list[Vector[N]], list[Vector[N]]]:
    """Linear and angular velocity for each joint, three numbers each, structural integers kept."""
    linear: list[Vector[N]] = [[0, 0, 0] for _ in range(count)]
    angular: list[Vector[N]] = [[0, 0, 0] for _ in range(count)]
    for part in made:
        folded = fold_columns(part.steps, len(part.joints), over)
        for k, joint in enumerate(part.joints):
            linear[joint], angular[joint] = folded.linear[k], folded.angular[k]
    return linear, angular


def six_rows(made: Sequence[Part], count: int, over: Arithmetic[N]) -> tuple[Rows[N], Rows[N]]:
    """The rows of v and those of ω, shape (3, count) each."""
    linear, angular = (
        tuple(tuple(settled(vector[k], over) for vector in vectors) for k in range(3))
        for vectors in columns_over(made, count, over)
    )
    return linear, angular


def numeric_jacobian(robot: Robot, values: Values, view: MotionView, form: Form = GEOMETRIC) -> Jacobian[float]:
    """The Jacobian at known values, without numpy; see `jacobian`.

    Raises:
        RobotError: A value is missing, an entry is not a real number, or there are no rates of the angles here.
    """
    joints = moving_joints(robot, view)
    check_values(robot, view, form, values)
    over = Floats(numbers(values))
    try:
        linear, angular = six_rows(tuple(parts(robot, view, joints, merged=False)), len(joints), over)
    except OverflowError:
        raise RobotError("a value is too large to compute with") from None
    if not all(math.isfinite(entry) for row in (*linear, *angular) for entry in row):
        raise RobotError("the Jacobian has an entry that is not a real number")
    if form.analytic:
        angular, square = rates_by(form, fold_rows(between(robot, view.start, view.end), over), angular, over)
        if square < TINY**2:
            triple = Triple.called(form.analytic)
            hint = "leave --analytic out, or take angles that are singular elsewhere"
            raise RobotError(f"{triple.singular}, where there are no rates of {triple.name}", hint)
    return Jacobian(form.chosen(linear, angular), form.labels, joints, view, form, robot.writing)


def textbook_jacobian(robot: Robot, values: Values, view: MotionView, form: Form = GEOMETRIC) -> Jacobian[Expr]:
    """The Jacobian in terms, with some values put in; see `symbolic_jacobian`.

    Raises:
        RobotError: It would be longer than anybody can read.
    """
    joints = moving_joints(robot, view)
    _check_axes(view, form)
    made = tuple(parts(robot, view, joints, merged=True, values=values))
    check_size(made)
    linear, angular = six_rows(made, len(joints), TERMS)
    if form.analytic:
        angular = _rates_in_terms(robot, values, view, form)
    return Jacobian(form.chosen(linear, angular), form.labels, joints, view, form, robot.writing)


def _rates_in_terms(robot: Robot, values: Values, view: MotionView, form: Form) -> Rows[Expr]:
    """Rows of rates of angles, from ω along the axes that the first angle has reached.

    So that angle and the joints about parallel axes are merged before anything is multiplied: sin(theta4 - yaw).
    """
    triple = Triple.called(form.analytic)
    alpha, beta = (Angle.of(free_name(robot, name)) for name in triple.angles[:2])
    vanishing, other = (sine(beta), cosine(beta)) if triple.is_proper else (cosine(beta), sine(beta))
    joints = moving_joints(robot, view)
    way = Way((Rot(AXES[triple.axes[0]], -alpha),), between(robot, view.start, view.end))
    made = tuple(way.parts(joints, robot.angles, merged=True, values=values))
    check_size(made)
    turned = six_rows(made, len(joints), TERMS)[1]
    return rates_of(form, turned, (1, 0), (power(vanishing, -1), other), TERMS)


def rates_by(
    form: Form, rotation: Sequence[Sequence[N | int]], angular: Rows[N], over: Evaluator[N]
) -> tuple[Rows[N], N]:
    """Rows of rates of the angles that an orientation has, and the square of what vanishes where there are none."""
    x, y, other = Triple.called(form.analytic).seen(rotation)
    square = settled(plus(times(x, x), times(y, y)), over)
    root = over.power(square, Fraction(-1, 2))
    return rates_of(form, angular, (times(x, root), times(y, root)), (root, other), over), square


def rates_of(
    form: Form,
    angular: Rows[N],
    alpha: tuple[N | int, N | int],
    beta: tuple[N | int, N | int],
    over: Arithmetic[N],
) -> Rows[N]:
    """Rows of rates of angles from rows of ω, shape (3, joints); see `Triple.rates`."""
    triple = Triple.called(form.analytic)
    columns = [triple.rates(column, alpha, beta) for column in zip(*angular, strict=True)]
    return tuple(tuple(settled(entry, over) for entry in row) for row in zip(*columns, strict=True))


def free_name(robot: Robot, name: str) -> str:
    """A name that the robot has no other use for."""
    while name in robot.variables or name in robot.parameters:
        name += "_e"
    return name


def moving_joints(robot: Robot, view: MotionView) -> tuple[str, ...]:
    """The joints that have a column.

    Raises:
        RobotError: There are none.
    """
    joints = joints_between(robot, view.start, view.end)
    if not joints:
        if not robot.variables:
            raise RobotError(f"{robot.name} has no joint, so nothing of it moves")
        message = f"no joint of {robot.name} moves frame {view.end} against frame {view.start}"
        raise RobotError(message, f"frames: {', '.join(robot.frames)}")
    return joints


def check_values(robot: Robot, view: MotionView, form: Form, values: Mapping[str, object]) -> None:
    """Make sure that every name has a value, those of the point too.

    Raises:
        RobotError: One has none, or rates of angles are asked for along other axes.
    """
    _check_axes(view, form)
    free = symbols_in(view.point) - values.keys() if view.point is not ORIGIN else frozenset()
    if unknown := sorted(free - robot.parameters.keys() - {*robot.variables}):
        raise RobotError(f"{', '.join(unknown)} of the point has no value", "write numbers, or ask with --symbolic")
    way = (
        between(robot, view.axes, view.start),
        between(robot, view.start, view.end),
        between(robot, view.end, view.place),
    )
    require(robot, (*way[0], *way[1], *way[2], Trans(*view.point)), values)


def _check_axes(view: MotionView, form: Form) -> None:
    if form.analytic and view.axes != view.start:
        name = Triple.called(form.analytic).name
        message = f"rates of {name} are those of frame {view.end} seen from frame {view.start}, in no other axes"
        raise RobotError(message, "leave --in out")
