"""Robots made by a caller: from rows of numbers and texts, and copies with something changed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from dhcli.errors import Place, Problem, RobotError, UnknownNameError, did_you_mean, plural
from dhcli.kinematics.conventions import COLUMNS, TABLES, Convention, Row, moves_of
from dhcli.kinematics.derived import Value
from dhcli.kinematics.description import Description, Link
from dhcli.kinematics.given import chain_of, mapping_of, text_of, texts_of, tuple_of, value_of
from dhcli.kinematics.moves import Chain, read_chain
from dhcli.kinematics.values import parameter_values
from dhcli.notation.angle import Angle
from dhcli.notation.dimensions import read_at
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr

Cell = float | str
_A_ROW = "each is a mapping with a, alpha, d, theta, or these four in this order"
_ROUND = 15
"""Whole multiples of this, beyond a turn, are degrees: nobody means 90 rad."""
Made = TypeVar("Made", bound=Description)


def from_dh(
    made: type[Made],
    /,
    rows: Iterable[Mapping[str, Cell] | Sequence[Cell]],
    *,
    convention: str = "standard",
    variables: Sequence[str],
    parameters: Mapping[str, float | str | Value | None] | None = None,
    name: str = "robot",
) -> Made:
    """A robot from the rows of its table; what is taken is told by `Robot.from_dh`."""
    if text_of(convention, "convention", "standard or modified") not in TABLES:
        raise UnknownNameError(f"there is no convention {convention}", "standard or modified")
    given = {} if parameters is None else mapping_of(parameters, "parameters")
    named, called = texts_of(variables, "variables", 'write ["theta1", "d2"]'), text_of(name, "name")
    scope = Scope(lengths=(*named, *given))
    kind = Convention(convention)
    found = [_row(row, i, scope) for i, row in enumerate(tuple_of(rows, "rows", _A_ROW), 1)]
    links = tuple(Link(i, moves_of(row, kind), row) for i, row in enumerate(found, 1))
    open_: dict[str, Value | None] = dict.fromkeys(given)
    bare = made(called, called, "made in Python", kind, named, links, open_)
    known = {parameter: value for parameter, value in given.items() if value is not None}
    return replace(bare, parameters={**open_, **parameter_values(bare, known)})


def copy(
    robot: Made,
    *,
    tool: object = None,
    base: object = None,
    parameters: Mapping[str, float | str | Value] | None = None,
    name: str | None = None,
) -> Made:
    """The same robot with something changed; what is taken is told by `Robot.copy`."""
    scope = Scope(lengths=tuple(robot.parameters))
    ends = {
        end: _end(given, end, scope, named)
        for end, given, named in (("tool", tool, robot.tools), ("base", base, {}))
        if given is not None
    }
    values = robot.parameters if parameters is None else {**robot.parameters, **parameter_values(robot, parameters)}
    called = robot.name if name is None else text_of(name, "name")
    return replace(robot, name=called, parameters=values, path=None, **ends)  # type: ignore[arg-type]


def _end(given: object, end: str, scope: Scope, named: Mapping[str, Chain]) -> Chain:
    """Moves by name, as text with the robot's lengths in it, or as a matrix."""
    if not isinstance(given, str):
        return chain_of(given, end)
    text = given.strip()
    return named.get(text) or (read_chain(given, scope, Place(end)) if text else ())


def _row(row: object, number: int, scope: Scope) -> Row:
    place = Place(f"row {number}")
    if isinstance(row, Mapping):
        if unknown := [key for key in row if key not in COLUMNS]:
            raise RobotError(Problem(f"{unknown[0]} is no column", place, did_you_mean(unknown[0], COLUMNS)))
        cells = [row.get(column, 0.0) for column in COLUMNS]
    else:
        cells = list(tuple_of(row, str(place), _A_ROW))
    if len(cells) != len(COLUMNS):
        raise RobotError(Problem(f"{plural(len(cells), 'cell')}, not four", place, "a, alpha, d, theta"))
    a, alpha, d, theta = cells
    return Row(
        _length(a, scope, place), _angle(alpha, scope, place), _length(d, scope, place), _angle(theta, scope, place)
    )


def _length(cell: object, scope: Scope, place: Place) -> Expr:
    if not isinstance(cell, str):
        found = value_of(cell, str(place), is_angle=False)
        if isinstance(found, Angle):
            raise RobotError(Problem("an angle, and a length is wanted", place, "write 0.4 or '400 mm'"))
        return found
    return read_at(place, to_length, parse(cell, scope, place))


def _angle(cell: object, scope: Scope, place: Place) -> Angle:
    if not isinstance(cell, str):
        found = value_of(cell, str(place), is_angle=True)
        if not isinstance(found, Angle):
            raise RobotError(Problem(f"{found} is a length, an angle is wanted", place, "write '90°' or radians"))
        if isinstance(cell, int | float) and abs(cell) > math.tau and cell % _ROUND == 0:
            hint = f"write '{cell:g}°', or radians: math.radians({cell:g})"
            raise RobotError(Problem(f"{cell:g} rad is {abs(cell) / math.tau:.3g} turns", place, hint))
        return found
    return read_at(place, to_angle, parse(cell, scope, place), bare="refuse")
