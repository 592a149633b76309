"""The columns of a Jacobian with what they are made of: the axis of each joint, a point on it, and the point moved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TypeAlias

from dhcli.algebra.arithmetic import settled, sum_of_products
from dhcli.algebra.terms import TERMS
from dhcli.checking.exercise import Case
from dhcli.checking.motion.asked import Motion
from dhcli.checking.motion.grid import Grid, Rows, exact
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.forward import textbook_form
from dhcli.kinematics.frames import ORIGIN, between
from dhcli.kinematics.moves import Chain, Trans, names
from dhcli.kinematics.recorded import kept
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values, numbers
from dhcli.kinematics.velocity.form import Form, Triple
from dhcli.kinematics.velocity.jacobian import free_name, rates_of, textbook_jacobian
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Number, add, multiply, negate, number, power
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import substitute, symbols_in

Vector: TypeAlias = tuple[Expr, Expr, Expr]

NOTHING: Vector = (ZERO, ZERO, ZERO)

MOST_VECTORS = 2_000
"""Vectors that are kept: those of two slips in six joints, of which most have the same axes and arms."""


@frozen
class Column:
    """The column of a joint: its axis, a point on that, and the velocity and the angular velocity for a rate of 1."""

    joint: str
    turns: bool
    axis: Vector
    origin: Vector
    linear: Vector
    angular: Vector


@frozen
class Columns:
    """All columns between two frames of a robot."""

    robot: Robot
    view: MotionView
    point: Vector
    each: tuple[Column, ...]

    def along(self, axes: str) -> Columns:
        """The same along the axes of another frame."""
        return columns_of(self.robot, replace(self.view, axes=axes))

    def cut(self, kept: Sequence[int]) -> Rows:
        """Some rows of the six."""
        six = [[*one.linear, *one.angular] for one in self.each]
        return tuple(tuple(column[k] for column in six) for k in kept)

    @property
    def names(self) -> frozenset[str]:
        """Every name in them."""
        return symbols_in(entry for row in self.cut(range(6)) for entry in row)

    @property
    def moved(self) -> tuple[int, ...]:
        """The rows of the six that a joint can move."""
        return tuple(k for k, row in enumerate(self.cut(range(6))) if any(entry != ZERO for entry in row))


def columns_of(robot: Robot, view: MotionView) -> Columns:
    """The columns of a robot, in symbols, worked out once for it.

    Raises:
        RobotError: They would be longer than anybody can read.
    """
    return kept(robot, ("columns", view), lambda: _columns_of(robot, view))


def _columns_of(robot: Robot, view: MotionView) -> Columns:
    found = textbook_jacobian(robot, {}, view)
    joints = {joint.name: joint for joint in robot.joints}
    each = []
    for k, name in enumerate(found.joints):
        linear, angular = ((row[0], row[1], row[2]) for row in _halves([line[k] for line in found.rows]))
        turns = joints[name].kind == "revolute"
        before = _before(robot, name, str(joints[name].link))
        origin = position((*between(robot, view.axes, before[0]), *before[1]))
        each.append(Column(name, turns, angular if turns else linear, origin, linear, angular))
    point = position((*between(robot, view.axes, view.place), *(() if view.point == ORIGIN else (Trans(*view.point),))))
    return Columns(robot, view, point, tuple(each))


def _halves(column: Sequence[Expr]) -> tuple[Sequence[Expr], Sequence[Expr]]:
    return column[:3], column[3:]


def _before(robot: Robot, joint: str, link: str) -> tuple[str, Chain]:
    """The frame before a link, and the moves of the link before the one that holds its joint."""
    index = robot.frames.index(link)
    moves = next(one.moves for one in robot.links if str(one.number) == link)
    place = next(k for k, move in enumerate(moves) if joint in names((move,)))
    return robot.frames[index - 1], moves[:place]


def position(chain: Chain) -> Vector:
    """Where the end of a chain is."""
    x, y, z, _ = (row[3] for row in textbook_form(chain))
    return x, y, z


def origin_of(robot: Robot, axes: str, name: str) -> Vector:
    """The origin of a frame seen from another, worked out once for a robot."""
    return kept(robot, ("origin", axes, name), lambda: position(between(robot, axes, name)))


def axis_z(robot: Robot, axes: str, name: str) -> Vector:
    """The z axis of a frame along the axes of another."""
    x, y, z, _ = (row[2] for row in textbook_form(between(robot, axes, name)))
    return x, y, z


@lru_cache(MOST_VECTORS)
def minus(first: Vector, second: Vector) -> Vector:
    """A difference of vectors."""
    x, y, z = (add(a, negate(b)) for a, b in zip(first, second, strict=True))
    return x, y, z


@lru_cache(MOST_VECTORS)
def cross(first: Vector, second: Vector) -> Vector:
    """A cross product of vectors."""
    (a, b, c), (x, y, z) = first, second
    return (
        add(multiply(b, z), negate(multiply(c, y))),
        add(multiply(c, x), negate(multiply(a, z))),
        add(multiply(a, y), negate(multiply(b, x))),
    )


def combined(row: Sequence[Expr], column: Sequence[Expr]) -> Expr:
    """A sum of products, in the order of the row."""
    plain = [0 if entry == ZERO else entry for entry in row]
    total = sum_of_products(plain, [0 if entry == ZERO else entry for entry in column])
    return number(total) if isinstance(total, int) else total


def columns_for(case: Case, motion: Motion) -> Columns:
    """The columns that a question is about."""
    return columns_of(*motion.check(case.exercise.robot))


def jacobian_grid(case: Case, columns: Columns, form: Form) -> Grid:
    """The Jacobian of columns in the rows of a form; the angles of an analytic one have their values in numbers."""
    six = columns.cut(range(6))
    linear, angular = six[:3], six[3:]
    if form.analytic:
        angular = _analytic(columns, form, angular, case.exercise.values if case.exercise.numeric else None)
    rows = form.chosen(linear, angular)
    one = tuple(int(column.turns) for column in columns.each)
    zero = (0,) * len(one)
    powers = form.chosen((one,) * 3, (zero,) * 3)
    return Grid(rows, powers, cosines=True)


def _analytic(columns: Columns, form: Form, angular: Rows, values: Values | None) -> Rows:
    """Rates of the three angles, whose own values stand there as names, or in numbers."""
    robot, triple = columns.robot, Triple.called(form.analytic)
    alpha, beta = (free_name(robot, name) for name in triple.angles[:2])
    a, b = Angle.of(alpha), Angle.of(beta)
    vanishing, other = (sine(b), cosine(b)) if triple.is_proper else (cosine(b), sine(b))
    rows = rates_of(form, angular, (cosine(a), sine(a)), (power(vanishing, -1), other), TERMS)
    if values is None:
        return rows
    angles = dict(zip((alpha, beta), _angles(columns, triple, values), strict=True))
    return tuple(tuple(substitute(entry, {}, angles) for entry in row) for row in rows)


def _angles(columns: Columns, triple: Triple, values: Values) -> tuple[Angle, Angle]:
    import math

    from dhcli.algebra.floats import Floats

    arithmetic = Floats(numbers(values))
    rotation = fold_rows(between(columns.robot, columns.view.start, columns.view.end), arithmetic)
    x, y, other = (settled(part, arithmetic) for part in triple.seen(rotation))
    size = math.hypot(x, y)
    beta = math.atan2(size, other) if triple.is_proper else math.atan2(other, size)
    return Angle(radians=exact(math.atan2(y, x)).value), Angle(radians=exact(beta).value)


def plain(found: Sequence[float]) -> tuple[Number, ...]:
    """Floats as numbers of trees."""
    return tuple(map(exact, found))
