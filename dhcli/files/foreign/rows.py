"""Rows of a DH table in the words of a file that is none of dhcli's, and the robot they make."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from dhcli.errors import FileError, NotationError, Place, Problem, plural
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention, Row, calibrated_moves, moves_of
from dhcli.kinematics.derived import Formula, circle, with_derived
from dhcli.kinematics.description import Link
from dhcli.kinematics.moves import Chain, angle_names, names
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.names import canonical
from dhcli.notation.parser import RESERVED, parse
from dhcli.notation.quantity import UNITS, DimensionError, to_angle, to_length
from dhcli.notation.quarters import with_right_angles
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO, Constant, Expr, Sum, Symbol, Unit, add, multiply
from dhcli.notation.walk import symbols, walk
from dhcli.regex import regex

_WORD = regex(r"(?<!\w)\\?[^\W\d](?:_\{[^{}]{1,20}\}|\w)*")
_STAR = regex(r"(?<=[\w})])[ ]?\^?\*(?=[ ]*(?:$|[-+−]))")  # noqa: RUF001  a minus sign
_ALONE = frozenset(("*", "var", "var.", "variable"))
"""Cells that say only that they are the variable of their row."""
_NO_NAMES = RESERVED | UNITS | {"π"}


@frozen
class Cell:
    """A cell as it was typed, with its place, and the unit of its bare numbers."""

    text: str
    place: Place
    unit: str = ""


@frozen
class Units:
    """Units of bare numbers where nothing else is said: none of an angle, and metres, where they are empty."""

    length: str = ""
    angle: str = ""


@dataclass(slots=True)
class RowText:
    """A row as it was typed.

    Attributes:
        place: Where it stands.
        cells: The cells that are there, by column; `offset` is added to the variable, `lower` and `upper` are limits.
        kind: R, P or F where the file says what its joint is; else empty. Where no variable stands in theta, or in d of
            a slide, what stands there is added to one.
    """

    place: Place
    cells: dict[str, Cell]
    kind: str = ""


@frozen
class Whole:
    """What a robot has besides its rows; limits by number of the row, from 1."""

    name: str
    title: str
    source: str
    convention: Convention
    base: Chain = ()
    tool: Chain = ()
    limits: Mapping[int, tuple[Value, Value]] = field(default_factory=dict)
    values: Mapping[str, Cell] = field(default_factory=dict)


def robot_of_rows(reader: Reader, rows: Sequence[RowText], whole: Whole, joints: str = "") -> Robot:
    """The robot that rows make.

    Args:
        reader: What reads them, with all that is wrong already.
        rows: The rows.
        whole: What it has besides.
        joints: A letter for each row: R, P, or F for one that stands still; then rows may lack their variables.

    Raises:
        FileError: With all that is wrong, each with its line.
    """
    if joints and (len(joints) != len(rows) or set(joints) - set("RPF")):
        hint = "a letter for each: R turns, P slides, F stands still"
        raise FileError(
            Problem(f"{plural(len(rows), 'row')}, and --joints {joints}", rows[0].place if rows else None, hint)
        )
    made = [reader.row(row, i, joints[i - 1] if joints else row.kind) for i, row in enumerate(rows, 1)]
    if not reader.variables and not reader.problems:
        hint = "write theta1 in the column theta, or say what the rows are: --joints " + "R" * len(rows)
        reader.problems.append(Problem("no row holds a joint variable", rows[0].place if rows else None, hint))
    if reader.problems:
        raise FileError(reader.problems)
    links = tuple(Link(i, moves_of(row, whole.convention), row) for i, row in enumerate(made, 1))
    is_calibrated = any("beta" in row.cells for row in rows)
    if is_calibrated:
        tilts = [reader.angle(row.cells.get("beta"), "beta") for row in rows]
        chains = (calibrated_moves(*pair, whole.convention) for pair in zip(made, tilts, strict=True))
        links = tuple(Link(i, chain) for i, chain in enumerate(chains, 1))
    variables = tuple(reader.variables.values())
    chain = (*whole.base, *(move for link in links for move in link.moves), *whole.tool)
    turning = angle_names(chain)
    used = names(chain) - set(variables)
    parameters, derived = reader.parameters(used, whole.values, turning)
    limits = {reader.variables[i]: pair for i, pair in whole.limits.items() if i in reader.variables}
    for i, name in reader.variables.items():
        if (pair := reader.limits(rows[i - 1], is_angle=name in turning)) is not None:
            limits[name] = pair
    if reader.problems:
        raise FileError(reader.problems)
    return Robot(
        name=whole.name,
        title=whole.title,
        source=whole.source,
        convention=Convention.PRODUCT if is_calibrated else whole.convention,
        variables=variables,
        links=links,
        parameters=parameters,
        derived=derived,
        base=whole.base,
        tool=whole.tool,
        limits=limits,
        remarks=tuple(dict.fromkeys(reader.remarks)),
    )


def scope_of(texts: Iterable[str]) -> Scope:
    """The names in texts, units, functions and numbers left aside."""
    words = (canonical(word) for text in texts for word in _WORD.findall(text))
    return Scope(lengths=tuple(dict.fromkeys(word for word in words if word not in _NO_NAMES)))


def in_unit(expr: Expr, unit: str) -> Expr:
    """An expression with a unit behind its bare numbers; what has a name, a unit or π stays."""
    if not unit:
        return expr
    if isinstance(expr, Sum):
        return add(*(in_unit(term, unit) for term in expr.terms))
    if symbols(expr) or any(isinstance(node, Unit | Constant) for node in walk(expr)):
        return expr
    return multiply(expr, Unit(unit))


class Reader:
    """Reads cells and rows one after another; what is wrong is collected."""

    def __init__(self, scope: Scope, *, units: Units | None = None, as_typed: bool = False) -> None:
        """Take the names that may stand in them, units of bare numbers, and whether 1.5708 rad stays what it is."""
        self.scope = scope
        self.units = units or Units()
        self.as_typed = as_typed
        self.problems: list[Problem] = []
        self.remarks: list[str] = []
        self.variables: dict[int, str] = {}

    def row(self, row: RowText, number: int, kind: str) -> Row:
        """One row; its variable is noted."""
        for column, letter in (("theta", "R"), ("d", "P")):
            if (cell := row.cells.get(column)) is not None and cell.text.strip().lower() in _ALONE:
                row.cells[column], kind = replace(cell, text="0"), kind or letter
        starred = {column for column, cell in row.cells.items() if _STAR.search(cell.text)}
        a, d, offset = (row.cells.get(column) for column in ("a", "d", "offset"))
        found = Row(self.length(a, "a"), self.angle(row.cells.get("alpha"), "alpha"), self.length(d, "d"), Angle())
        theta = self.angle(row.cells.get("theta"), "theta")
        turning, sliding = sorted(theta.names), sorted(symbols(found.d))
        if kind == "":
            slides = "theta" not in starred and ("d" in starred or (bool(sliding) and not turning))
            kind = "P" if slides else "R" if turning else "F"
        if kind == "R":
            theta += self.variable(turning, f"theta{number}", number, row) + self.angle(offset, "offset")
        along = found.d
        if kind == "P":
            moved = self.variable(sliding, f"d{number}", number, row)
            along = add(along, *(Symbol(name) for name in moved.names), self.length(offset, "offset"))
        return Row(found.a, found.alpha, along, theta)

    def variable(self, named: Sequence[str], fresh: str, number: int, row: RowText) -> Angle:
        """Note the variable of a row among the names in its cell; where there is none, a fresh one to be added."""
        likely = [name for name in named if name.startswith(("theta", "q"))] or list(named)
        name = likely[0] if likely else fresh
        if len(likely) > 1:
            self.problems.append(
                Problem(f"row {number} names {' and '.join(named)}", row.place, "a row moves one joint")
            )
        elif name in self.variables.values():
            self.problems.append(Problem(f"{name} stands in two rows", row.place, "a joint has a row of its own"))
        self.variables[number] = name
        return Angle() if likely else Angle.of(name)

    def parameters(
        self, used: Iterable[str], values: Mapping[str, Cell], turning: Iterable[str]
    ) -> tuple[dict[str, Value | None], dict[str, Formula]]:
        """The names that rows use, and those that these follow from: their values, and what follows from others."""
        found: dict[str, Value | None] = {}
        derived: dict[str, Formula] = {}
        waiting = [name for name in self.scope.names if name in set(used)]
        angles = set(turning)
        while waiting:
            name = waiting.pop(0)
            cell = values.get(name)
            others = symbols(self.parsed(cell)) if cell is not None else frozenset()
            found[name] = self.value(None if others else cell, name, is_angle=name in angles)
            if cell is not None and others:
                unit = "rad" if name in angles else cell.unit
                derived[name] = Formula(in_unit(self.parsed(cell), unit), name in angles)
                angles |= others if name in angles else set()
                waiting += sorted(others - found.keys() - set(waiting))
        if around := circle(derived):
            self.problems.append(Problem(f"{' and '.join(around)} follow from each other", values[around[0]].place))
            return found, {}
        known = {name: value for name, value in found.items() if value is not None}
        try:
            return {**found, **with_derived(derived, known)}, derived
        except DimensionError as error:
            self.problems.append(Problem(error.message, None, error.hint))
            return found, {}

    def limits(self, row: RowText, *, is_angle: bool) -> tuple[Value, Value] | None:
        """The limits of the variable of a row, where it has both."""
        if not {"lower", "upper"} <= row.cells.keys():
            return None
        read = self.angle if is_angle else self.length
        return read(row.cells["lower"], "lower"), read(row.cells["upper"], "upper")

    def value(self, cell: Cell | None, name: str, *, is_angle: bool) -> Value | None:
        """The value of a name; None where it has none."""
        if cell is None:
            return None
        return self.angle(replace(cell, unit="rad"), name) if is_angle else self.length(cell, name)

    def length(self, cell: Cell | None, column: str) -> Expr:
        """A cell of a or d [m]."""
        if cell is None:
            return ZERO
        try:
            return to_length(in_unit(self.parsed(cell), cell.unit or self.units.length))
        except DimensionError as error:
            self.problems.append(Problem(f"{column}: {error.message}", cell.place, error.hint))
        except NotationError as error:
            self.problems += error.problems
        return ZERO

    def angle(self, cell: Cell | None, column: str) -> Angle:
        """A cell of alpha or theta; decimals that are a right angle to their digits are taken as one."""
        if cell is None:
            return Angle()
        try:
            typed = in_unit(self.parsed(cell), cell.unit or self.units.angle)
            said: list[str] = []
            found = to_angle(typed if self.as_typed else with_right_angles(typed, said), bare="refuse")
            self.remarks += [type(remark)(f"{column}: {remark}") for remark in said]
        except DimensionError as error:
            hint = error.hint or "write 90°"
            if "has no unit" in error.message:
                hint = f"{hint}, or the unit in the head: {column} [deg], or --units deg"
            self.problems.append(Problem(f"{column}: {error.message}", cell.place, hint))
        except NotationError as error:
            self.problems += error.problems
        else:
            return found
        return Angle()

    def parsed(self, cell: Cell) -> Expr:
        """A cell without the star of a variable."""
        return parse(_STAR.sub("", cell.text), self.scope, cell.place)
