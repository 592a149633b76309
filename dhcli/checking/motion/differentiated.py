"""The columns of somebody who differentiates the position, by rules of their own for cosines and sines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from dhcli.checking.motion.columns import Column, Columns, position
from dhcli.kinematics.frames import ORIGIN, between
from dhcli.kinematics.moves import Trans
from dhcli.notation.derivative import derivative
from dhcli.notation.tree import Expr, Symbol, Trig, add, multiply
from dhcli.notation.walk import rebuild, walk

HELD = "held still"
"""A name that no answer has, for a cosine that is not differentiated."""


def differentiated(columns: Columns, slope: Callable[[Trig, str], Expr]) -> Iterator[tuple[str, Columns]]:
    """The position differentiated by each joint, with another rule for cosines and sines."""
    view, robot = columns.view, columns.robot
    if view.axes != view.start or view.place != view.end:
        return
    chain = between(robot, view.start, view.end)
    place = position(chain if view.point == ORIGIN else (*chain, Trans(*view.point)))

    def changed(one: Column) -> Column:
        x, y, z = (_by(entry, one.joint, slope) for entry in place)
        return replace(one, linear=(x, y, z))

    yield "", replace(columns, each=tuple(map(changed, columns.each)))


def _by(expr: Expr, name: str, slope: Callable[[Trig, str], Expr]) -> Expr:
    """A derivative by the chain rule: by each cosine and sine, and by the name itself."""
    shares = []
    trigs = list(dict.fromkeys(node for node in walk(expr) if isinstance(node, Trig)))
    for trig in trigs:
        outer = derivative(rebuild(expr, lambda node, t=trig: Symbol(HELD) if node == t else node), HELD)  # type: ignore[misc]
        back = rebuild(outer, lambda node, t=trig: t if node == Symbol(HELD) else node)  # type: ignore[misc]
        shares.append(multiply(back, slope(trig, name)))
    if not any(name in trig.angle.names for trig in trigs):
        shares.append(derivative(expr, name))
    return add(*shares)
