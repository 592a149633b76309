"""Standard to modified and back: the same pairs of moves, grouped otherwise; exact for any letters."""

from __future__ import annotations

from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.moves import Chain, Rot, Trans, along
from dhcli.kinematics.robot import Link, Robot
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr


def repaired(robot: Robot, convention: Convention) -> tuple[Chain, tuple[Row, ...], Chain]:
    """The table of a robot in the other convention.

    A standard table is `base (Z1 X1) ... (Zn Xn) tool`, a modified one `base (X0 Z1) ... (Xn-1 Zn) tool`. What is left
    over goes to the tool, or to the base; and of a base or tool the part that fits is taken into the table.

    Returns:
        Its base, its rows and its tool.
    """
    rows = [link.row for link in robot.links if link.row is not None]
    if convention is Convention.MODIFIED:
        base, (alpha, a) = _x_behind(robot.base)
        pairs = [(alpha, a), *((row.alpha, row.a) for row in rows)]
        left = pairs[-1]
        found = tuple(Row(p[1], p[0], row.d, row.theta) for p, row in zip(pairs, rows, strict=False))
        return base, found, (*_x(*left), *robot.tool)
    (alpha, a), tool = _x_in_front(robot.tool)
    pairs = [*((row.alpha, row.a) for row in rows), (alpha, a)]
    found = tuple(Row(p[1], p[0], row.d, row.theta) for p, row in zip(pairs[1:], rows, strict=True))
    return (*robot.base, *_x(*pairs[0])), found, tool


def with_table(links: tuple[Row, ...], convention: Convention, first: int) -> tuple[Link, ...]:
    """Rows as links."""
    return tuple(Link(first + i, moves_of(row, convention), row) for i, row in enumerate(links))


def _x(alpha: Angle, a: Expr) -> Chain:
    turned: Chain = () if alpha.is_zero else (Rot("x", alpha),)
    return turned if a == ZERO else (*turned, along("x", a))


def _x_behind(chain: Chain) -> tuple[Chain, tuple[Angle, Expr]]:
    """What of a chain's end turns about x or leads along it, and the rest."""
    backwards, found = _taken(chain[::-1])
    return backwards[::-1], found


def _x_in_front(chain: Chain) -> tuple[tuple[Angle, Expr], Chain]:
    rest, found = _taken(chain)
    return found, rest


def _taken(chain: Chain) -> tuple[Chain, tuple[Angle, Expr]]:
    angle, length = Angle(), ZERO + ZERO
    for i, move in enumerate(chain):
        match move:
            case Rot("x", turn):
                angle += turn
            case Trans(x, y, z) if y == ZERO and z == ZERO:
                length += x
            case _:
                return chain[i:], (angle, length)
    return (), (angle, length)
