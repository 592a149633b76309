"""The determinant of a few rows in the shortest form that is known: in factors, where those have been found."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.algebra.equality import equal
from dhcli.errors import RobotError
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.finding import find
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.cramer import determinant
from dhcli.kinematics.velocity.form import Which
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.tree import Expr, negate


def neat_determinant(
    robot: Robot, view: MotionView, part: Which, values: Values, rows: Sequence[Sequence[Expr]]
) -> Expr:
    """The determinant of some rows of a Jacobian along any axes; the factors are proved to be just that.

    Args:
        robot: The robot.
        view: What the Jacobian is of.
        part: Which rows it has, before those are left out that no joint moves.
        values: Values that have been put in.
        rows: The rows that are left, as many as columns.
    """
    plain = determinant(rows)
    try:
        factored = find(robot, view, part, values).determinant
    except RobotError:
        return plain
    if factored is not None and equal(factored, plain):
        return factored
    if factored is not None and equal(negate(factored), plain):
        return negate(factored)
    return plain
