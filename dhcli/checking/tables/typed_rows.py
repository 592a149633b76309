"""A DH table as people type it: any spelling of a matrix, with or without heads and link numbers, stars and values."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import islice

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.checking.pasted import LARGEST, UnreadableError, refuse_long, without_label, without_words
from dhcli.checking.tables.spelling import ANGLES, Heads, in_order, keyed_rows, plain_text, without_heads, without_stars
from dhcli.errors import NotationError, Place, plural
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, Row
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import Cell, read_matrix
from dhcli.notation.quantity import (
    LENGTH_UNITS,
    Bare,
    DimensionError,
    is_affine,
    to_angle,
    to_plain_length,
)
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Source, tokenize
from dhcli.notation.tree import Constant, Expr, Number, Sum, Symbol, Trig, Unit, add, multiply
from dhcli.notation.walk import symbols, walk

SEED, TRIES = 29, 4


@frozen
class TypedRow:
    """A row as it was read, with what was typed.

    Attributes:
        row: The row: lengths in metres, exact angles.
        cells: The cell of each column, with its text and its offset in the answer.
        swapped: The row if bare angles were meant in radians; where the heads say radians, in degrees.
        says_unit: Whether the heads say the unit of lengths.
    """

    row: Row
    cells: Mapping[str, Cell]
    swapped: Row
    says_unit: bool = False

    def in_unit(self, unit: str) -> Row:
        """The row with its bare lengths in another unit; letters, and what is written with its unit, stay."""
        if self.says_unit:
            return self.row
        a, d = (to_plain_length(_in_unit(self.cells[column].expr, unit)) for column in ("a", "d"))
        return replace(self.row, a=a, d=d)


def read_table(
    text: str,
    robot: Robot,
    scope: Scope | None = None,
    columns: Sequence[str] | None = None,
    unit: str = "m",
    place: Place | None = None,
) -> tuple[TypedRow, ...]:
    """Read a DH table.

    Args:
        text: What a person typed or pasted.
        robot: The robot whose joints the table moves.
        scope: The names it may use; those of the robot by default.
        columns: Order of the columns where no heads say it; that of the robot's own table by default.
        unit: Unit of bare lengths.
        place: Where the text stands, for errors.

    Raises:
        UnreadableError: Naming row and column, and what would be read.
    """
    refuse_long(text)
    scope = scope or robot.scope
    columns = tuple(columns or robot.columns)
    source = Source(plain_text(without_label(without_words(keyed_rows(text), scope))), place or Place("answer"))
    try:
        tokens = without_stars(tokenize(source, most=LARGEST), scope, robot.variables)
        tokens, heads = without_heads(in_order(tokens, columns), Heads(columns, unit=unit))
        cells = read_matrix(source, tokens, scope)
    except NotationError as error:
        raise UnreadableError(*(str(problem) for problem in error.problems)) from None
    width = len(cells[0])
    if width == len(COLUMNS) + 1:
        cells = tuple(row[1:] for row in cells)
    elif width != len(COLUMNS):
        raise UnreadableError(
            f"the rows have {plural(width, 'cell')}; a DH table has the four columns {', '.join(heads.columns)}"
        )
    rows = tuple(_row(row, index, heads, robot, scope) for index, row in enumerate(cells, robot.first))
    _check_variables(rows, robot)
    return rows


def names_in(row: Row) -> dict[str, frozenset[str]]:
    """The names in each cell of a row."""
    return {"a": symbols(row.a), "alpha": row.alpha.names, "d": symbols(row.d), "theta": row.theta.names}


def variable_of(row: Row, variables: Sequence[str]) -> str | None:
    """The joint variable that a row moves, wherever it stands."""
    inside = frozenset().union(*names_in(row).values())
    return next((name for name in variables if name in inside), None)


def misplaced(rows: Sequence[TypedRow], robot: Robot) -> str:
    """A joint variable under a or alpha, in words; nothing if all stand under d and theta."""
    for number, typed in enumerate(rows, robot.first):
        names = names_in(typed.row)
        for column in ("a", "alpha"):
            for name in sorted(names[column] & set(robot.variables)):
                order = ", ".join(robot.columns)
                return f"row {number}: {name} stands under {column}, not under d or theta; the columns are {order}"
    return ""


def _row(cells: Sequence[Cell], number: int, heads: Heads, robot: Robot, scope: Scope) -> TypedRow:
    named = dict(zip(heads.columns, cells, strict=True))
    other: Bare = "rad" if heads.bare == "deg" else "deg"
    _check_columns(named, number, heads, scope)
    a, d = (_length(named[column], f"row {number}, {column}", heads.unit, robot) for column in ("a", "d"))
    alpha, theta = (_angle(named[column], f"row {number}, {column}", heads.bare) for column in ANGLES)
    row = Row(a, alpha, d, theta)
    alpha, theta = (_angle(named[column], f"row {number}, {column}", other) for column in ANGLES)
    return TypedRow(row, named, replace(row, alpha=alpha, theta=theta), heads.says_unit)


def _check_columns(named: Mapping[str, Cell], number: int, heads: Heads, scope: Scope) -> None:
    """Refuse a length among the angles, and an angle among the lengths: the columns stand in another order.

    Raises:
        UnreadableError: There is one.
    """
    for column, cell in named.items():
        for name in sorted(node.name for node in walk(cell.expr) if isinstance(node, Symbol)):
            if scope.is_angle(name) is not (column in ANGLES):
                what, others = ("a length", "angles") if column in ANGLES else ("an angle", "lengths")
                where = f"row {number}, {column}: {name} is {what}, and this column holds {others}"
                raise UnreadableError(f"{where}; the columns are {', '.join(heads.columns)}")


def _angle(cell: Cell, where: str, bare: Bare) -> Angle:
    radians = any(isinstance(node, Constant) for node in walk(cell.expr))
    try:
        return to_angle(cell.expr, bare="rad" if radians else bare)
    except DimensionError as error:
        raise UnreadableError(f"{where}: {cell.text}: {error.message} ({error.hint})") from None


def _length(cell: Cell, where: str, unit: str, robot: Robot) -> Expr:
    for node in walk(cell.expr):
        if isinstance(node, Trig) and node.angle.names & set(robot.variables):
            raise UnreadableError(f"{where}: {cell.text} moves with a joint; a length of a link is constant")
    try:
        expr = to_plain_length(_in_unit(cell.expr, unit))
    except DimensionError as error:
        raise UnreadableError(f"{where}: {cell.text}: {error.message} ({error.hint})") from None
    for name in symbols(expr) & set(robot.variables):
        if not is_affine(expr, name):
            raise UnreadableError(f"{where}: {cell.text} is not {name} plus a constant")
    if not _is_real(expr, robot):
        raise UnreadableError(f"{where}: {cell.text} is not a finite number; a length is one")
    return expr


def _is_real(expr: Expr, robot: Robot) -> bool:
    """Whether a length has a finite value, be it at the robot's own lengths or at any others."""
    if isinstance(expr, Symbol):
        return True
    own = numbers(robot.known)
    points = ({**drawn, **known} for drawn in islice(general(symbols(expr), SEED), TRIES) for known in (own, {}))
    try:
        return any(math.isfinite(Floats(point).value(expr)) for point in points)
    except OverflowError:  # a number beyond all floats
        return False


def _in_unit(expr: Expr, unit: str) -> Expr:
    """Bare lengths in the unit of the sheet; what has a name or a unit stays."""
    if isinstance(expr, Sum):
        return add(*(_in_unit(term, unit) for term in expr.terms))
    if unit in ("m", "none") or symbols(expr) or any(isinstance(node, Unit) for node in walk(expr)):
        return expr
    return multiply(expr, Number(LENGTH_UNITS[unit]))


def _check_variables(rows: tuple[TypedRow, ...], robot: Robot) -> None:
    """Every joint variable in one cell, every row with one at most."""
    where: dict[str, str] = {}
    for number, typed in enumerate(rows, robot.first):
        inside: list[str] = []
        for column, names in names_in(typed.row).items():
            for name in sorted(names & set(robot.variables)):
                here = f"row {number}, {column}"
                if name in where:
                    raise UnreadableError(f"{here}: {name} stands in {where[name]} too; a joint has one cell")
                where[name] = here
                inside.append(name)
        if len(inside) > 1:
            raise UnreadableError(f"row {number} moves with {' and '.join(inside)}; a row has one joint at the most")
    missing = [joint for joint in robot.joints if joint.name not in where]
    if missing:
        joint = missing[0]
        column = "theta" if joint.kind == "revolute" else "d"
        listed = ", ".join(joint.name for joint in missing)
        raise UnreadableError(
            f"no row has {listed}: a table holds the variables of its joints and not their values; write {joint.name} "
            f"in the {column} cell of its row"
        )
