"""Robots made by a caller from screws and the home pose, `T = exp(S1 q1) ... exp(Sn qn) M`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar, get_args

from dhcli.errors import RobotError, UnknownNameError, did_you_mean, plural
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.geometry.vectors import ORIGIN, Vector, length
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.describe.drawn import Drawing, Frame, drawing_of
from dhcli.kinematics.describe.linear import Point, point_of
from dhcli.kinematics.describe.products import chains_of
from dhcli.kinematics.describe.screws import ScrewAxis, Side, lines_of
from dhcli.kinematics.description import Description, Link
from dhcli.kinematics.given import chain_of, text_of, texts_of, tuple_of, value_of
from dhcli.kinematics.moves import Fixed
from dhcli.notation.tree import ONE

Made = TypeVar("Made", bound=Description)
_SIX = 6
_A_SCREW = "write six numbers, ω then v: (0, 0, 1, 0, 0, 0)"
_SOME_NAMES = 'write ["theta1", "d2"]'
_A_HOME = "write moves, 'Trans(0.7, 0, 0)', or give a matrix of shape (4, 4)"


def from_screws(
    made: type[Made],
    screws: Iterable[Sequence[float]],
    home: object,
    *,
    frame: str = "space",
    variables: Sequence[str] = (),
    name: str = "robot",
) -> Made:
    """A robot from its screws and its home pose; what is taken is told by `Robot.from_screws`."""
    sides: tuple[Side, ...] = get_args(Side)
    text_of(frame, "frame", "space or body")
    side = next((known for known in sides if known == frame), None)
    if side is None:
        raise UnknownNameError(f"frame: {frame!r:.60} is not known", did_you_mean(str(frame), sides))
    rows = [_six(row, i) for i, row in enumerate(tuple_of(screws, "screws", _A_SCREW), 1)]
    letters = ["theta" if any(omega) else "d" for omega, _ in rows]
    named = texts_of(variables, "variables", _SOME_NAMES) or tuple(
        f"{letter}{i}" for i, letter in enumerate(letters, 1)
    )
    if len(named) != len(rows) or not rows:
        raise RobotError(
            f"{plural(len(named), 'variable')} and {plural(len(rows), 'screw')}", "one variable for each screw"
        )
    end = _end(home)
    axes = tuple(ScrewAxis(label, omega, v) for label, (omega, v) in zip(named, rows, strict=True))
    drawing = Drawing(lines_of(axes, end, side), end)
    links = tuple(Link(i, chain) for i, chain in enumerate(chains_of(drawing), 1))
    called = text_of(name, "name")
    return made(called, called, "made in Python", Convention.PRODUCT, named, links)


def _six(row: object, number: int) -> tuple[Vector, Point]:
    """ω and v of one screw."""
    given = tuple_of(row, f"screw {number}", _A_SCREW)
    if len(given) != _SIX:
        raise RobotError(f"screw {number}: {plural(len(given), 'number')}, not six", _A_SCREW)
    exprs = [value_of(part, f"screw {number}", is_angle=False) for part in given]
    omega, v = (point_of(part) for part in (exprs[:3], exprs[3:]))  # type: ignore[arg-type]
    if set(omega) - {ONE}:
        raise RobotError(f"screw {number}: a direction cannot depend on letters", _A_SCREW)
    return omega.get(ONE, ORIGIN), v


def _end(home: object) -> Frame:
    """The end frame, from moves or from a matrix."""
    chain = chain_of(home, "home")
    for move in chain:
        if isinstance(move, Fixed) and (fault := not_a_rotation(move.rows)):
            raise RobotError(f"home: {fault}", "its first three columns must be perpendicular unit vectors")
    found = drawing_of(chain, (), {}).end
    if not length(found.x) or set(found.origin) - {ONE}:
        raise RobotError("home: a length has no value", _A_HOME)
    return found
