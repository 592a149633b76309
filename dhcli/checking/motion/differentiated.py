"""The columns of somebody who differentiates the position, by rules of their own for cosines and sines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TypeAlias

from dhcli.checking.entries import Entries
from dhcli.checking.motion.columns import Columns, Vector, position
from dhcli.checking.wanted import Wanted
from dhcli.kinematics.frames import ORIGIN, View, between
from dhcli.kinematics.moves import Trans
from dhcli.kinematics.recorded import kept
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.derivative import derivative
from dhcli.notation.tree import Expr, Symbol, Trig, add, multiply
from dhcli.notation.walk import rebuild, walk

Rule: TypeAlias = Callable[[Trig, str, tuple[str, ...]], Expr]
"""The derivative of a cosine or sine by a joint, of these joints."""

HELD = "held still"
"""A name that no answer has, for a cosine that is not differentiated."""


def differentiated(columns: Columns, rule: Rule) -> Iterator[tuple[str, Columns]]:
    """The position differentiated by each joint, with another rule for cosines and sines.

    What went wrong in the columns before says nothing of the position, so it is differentiated once for a robot.
    """
    view, robot = columns.view, columns.robot
    if view.axes != view.start or view.place != view.end:
        return
    joints = tuple(one.joint for one in columns.each)
    velocities = kept(robot, ("differentiated", rule, view, joints), lambda: _velocities(robot, view, joints, rule))
    pairs = zip(columns.each, velocities, strict=True)
    yield "", replace(columns, each=tuple(replace(one, linear=velocity) for one, velocity in pairs))


def slopes(columns: Columns, question: object, entries: Entries) -> dict[tuple[int, int], Expr] | None:
    """The rows of v of somebody who differentiates a position of their own, in letters, by row and column.

    Args:
        columns: The right columns.
        question: The question that the position answers.
        entries: The pose or the position that was typed.

    Returns:
        None where it is no position of the end that moves.
    """
    view = columns.view
    if not isinstance(question, Wanted) or question.inverse or question.piece not in ("pose", "position"):
        return None
    if question.source != View(view.start, view.end) or view.axes != view.start or view.place != view.end:
        return None
    place = [row[-1].expr for row in entries[:3]] if view.point == ORIGIN else []
    pairs = [(row, k, expr, one.joint) for row, expr in enumerate(place) for k, one in enumerate(columns.each)]
    return {(row, k): derivative(expr, joint) for row, k, expr, joint in pairs} or None


def _velocities(robot: Robot, view: MotionView, joints: tuple[str, ...], rule: Rule) -> tuple[Vector, ...]:
    """The velocity that each joint gives to the point, by a rule."""
    chain = between(robot, view.start, view.end)
    x, y, z = position(chain if view.point == ORIGIN else (*chain, Trans(*view.point)))

    def by(joint: str) -> Vector:
        def slope(trig: Trig) -> Expr:
            return rule(trig, joint, joints)

        return _by(x, joint, slope), _by(y, joint, slope), _by(z, joint, slope)

    return tuple(map(by, joints))


def _by(expr: Expr, name: str, slope: Callable[[Trig], Expr]) -> Expr:
    """A derivative by the chain rule: by each cosine and sine, and by the name itself."""
    shares = []
    trigs = list(dict.fromkeys(node for node in walk(expr) if isinstance(node, Trig)))
    for trig in trigs:
        outer = derivative(rebuild(expr, lambda node, t=trig: Symbol(HELD) if node == t else node), HELD)  # type: ignore[misc]
        back = rebuild(outer, lambda node, t=trig: t if node == Symbol(HELD) else node)  # type: ignore[misc]
        shares.append(multiply(back, slope(trig)))
    if not any(name in trig.angle.names for trig in trigs):
        shares.append(derivative(expr, name))
    return add(*shares)
