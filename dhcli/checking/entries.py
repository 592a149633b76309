"""An answer as typed, up to the gate before its values: read, known, of the right shape, with a proper bottom row."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field, replace
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.checking.blanks import refuse_one_expression
from dhcli.checking.exercise import Exercise
from dhcli.checking.named import XYZ, in_order
from dhcli.checking.orientations import IN_PLANE
from dhcli.checking.pasted import UnreadableError, as_matrix, refuse_blanks, refuse_long, without_label, without_words
from dhcli.checking.truth import is_length, names_of
from dhcli.checking.units import has_length_unit, length_in_metres
from dhcli.checking.vectors import as_column
from dhcli.checking.wanted import Wanted
from dhcli.errors import NotationError, Place, are, plural
from dhcli.frozen import frozen
from dhcli.kinematics.values import numbers
from dhcli.notation.commas import comma_remark
from dhcli.notation.matrix import Cell, bracketed, parse_matrix
from dhcli.notation.names import suggestion
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_plain_length
from dhcli.notation.tree import ONE, ZERO, Expr, Number, number
from dhcli.notation.walk import decimals, symbols
from dhcli.regex import regex

_MOVES = regex(r"\s*(?:(?:Rot|Trans)_?\{?[xyz]?\}?|[RT]_?\{?[xyz]\}?) ?\(")
LEAST = 1e-12
"""What floating point leaves where an exact 0 or 1 was meant."""


@frozen
class Entry:
    """One entry of an answer.

    Attributes:
        expr: As read, in metres.
        text: As typed.
        typed: As read, in the unit in which it was typed.
        places: The decimal places of its numbers: 0.5 and 1/2 are equal, and may be judged and written differently.
    """

    expr: Expr
    text: str
    typed: Expr
    places: tuple[int | None, ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "places", decimals(self.typed))


Entries: TypeAlias = tuple[tuple[Entry, ...], ...]


def read_entries(question: Wanted, exercise: Exercise, text: str, place: Place | None) -> Entries:
    """Read an answer to a question about a matrix, in the shape of the right one.

    Raises:
        UnreadableError: It has another shape, an unknown name, or cannot be read.
    """
    refuse_long(text)
    body = in_order(text, (XYZ,), exercise.scope) if question.shape == (3, 1) else text
    body = without_words(body, exercise.scope) if question.shape != (1, 1) else body
    body = without_label(as_matrix(body, question.shape), question.shape)
    refuse_blanks(body)
    if _MOVES.match(body):
        raise UnreadableError("these are moves; what they make was asked, number by number")
    if question.shape == (3, 1):
        is_axis = question.piece in ("axis", "vector") and not is_length(question, 0, 0)
        body = as_column(body, exercise.scope, is_axis=is_axis)
    elif not body.lstrip(" \t\n+-").startswith(("[", "(", "{", "\\", "|")):
        body = f"[{body}]" if question.piece == "rotation" else body
    try:
        if question.shape == (1, 1):
            _refuse_matrix(body, exercise)
            expr = parse(body.strip(), exercise.scope, place or Place("answer"))
            return ((_entry(question, exercise, Cell(expr, body.strip(), 0, expr), 0, 0),),)
        cells = parse_matrix(body, exercise.scope, place or Place("answer"))
    except NotationError as error:
        remarks = (*(str(problem) for problem in error.problems), comma_remark(text))
        raise UnreadableError(*filter(None, remarks)) from None
    if question.shape == (3, 1):
        refuse_one_expression(body, cells, question.shape[0], exercise.scope)
    shaped = _shaped(question, cells, text)
    entries = tuple(
        tuple(_entry(question, exercise, cell, r, c) for c, cell in enumerate(row)) for r, row in enumerate(shaped)
    )
    if question.piece == "pose":
        _check_bottom_row(entries)
    return entries


def check_names(exercise: Exercise, names: frozenset[str]) -> None:
    """Refuse names that stand nowhere in a task without a robot; its scope takes any.

    Raises:
        UnreadableError: Naming one of them, and those that are known.
    """
    if not exercise.scope.is_open:
        return
    known = names_of(exercise)
    for name in sorted(names - known):
        hint = suggestion(name, sorted(known))
        raise UnreadableError(f"{name} is not a name that is known here" + (f" ({hint})" if hint else ""))


def _refuse_matrix(text: str, exercise: Exercise) -> None:
    """Say so where a whole matrix was typed for one number; round brackets around an expression are no matrix's."""
    if text.lstrip().startswith(("[", "(", "{", "\\", "|")):
        try:
            cells = parse_matrix(text, exercise.scope)
        except NotationError:
            return
        if text.lstrip().startswith("(") and _is_expression(text, exercise):
            return
        if (len(cells), len(cells[0])) != (1, 1):
            raise UnreadableError(f"this is a matrix, {len(cells)}x{len(cells[0])}; one number was asked")


def _is_expression(text: str, exercise: Exercise) -> bool:
    try:
        parse(text, exercise.scope)
    except NotationError:
        return False
    return True


def _shaped(question: Wanted, cells: tuple[tuple[Cell, ...], ...], text: str) -> tuple[tuple[Cell, ...], ...]:
    """The cells in the shape of the answer; a column may be typed as a row, and a point with its final 1."""
    wanted = question.shape
    shape = (len(cells), len(cells[0]))
    if wanted[1] == 1 and 1 in shape:
        flat = [cell for row in cells for cell in row]
        last = 0 if question.piece in ("vector", "axis") else 1
        if len(flat) == wanted[0] + 1 == 4 and flat[3].expr == number(last):  # noqa: PLR2004  homogeneous
            flat = flat[:3]
        if len(flat) == wanted[0]:
            return tuple((cell,) for cell in flat)
    if shape == wanted:
        return cells
    said = IN_PLANE if question.piece == "pose" and _is_in_plane(cells) else _shape_remark(question, shape)
    raise UnreadableError(*filter(None, (said, comma_remark(text))))


def _is_in_plane(cells: tuple[tuple[Cell, ...], ...]) -> bool:
    """Whether a matrix is 3x3 with the bottom row of a pose, and a position above that."""
    rows = [[cell.expr for cell in row] for row in cells]
    return [len(row) for row in rows] == [3, 3, 3] and rows[2] == [ZERO, ZERO, ONE] and rows[0][2] != ZERO != rows[1][2]


def _shape_remark(question: Wanted, shape: tuple[int, int]) -> str:
    rows, columns = question.shape
    if columns == 1 < rows and 1 in shape:
        return count_remark(max(shape), rows) + (": is z missing?" if max(shape) == rows - 1 else "")
    asked = f"a {rows}x{columns} matrix" if columns > 1 else f"a column of {rows}" if rows > 1 else "one number"
    if question.piece == "pose" and shape == (3, 3):
        return "this is a rotation, 3x3; a pose was asked: add the position as fourth column and the row 0 0 0 1"
    if question.piece == "pose" and shape == (3, 4):
        return "the bottom row is missing: add the row 0 0 0 1"
    if question.piece == "pose" and shape[1] == 3:  # noqa: PLR2004
        return "the rows have 3 entries; a pose has 4 in each row, the position in the fourth"
    if question.piece == "rotation" and shape == (4, 4):
        return "this is a pose, 4x4; only the rotation was asked, its first three rows and columns"
    if question.piece in ("position", "point") and shape == (4, 4):
        return "this is a pose, 4x4; only three coordinates were asked"
    if shape == (1, rows * columns) and min(rows, columns) > 1:
        return f"all {rows * columns} cells stand in one row; {asked} was asked: put ; or a line end behind each row"
    return f"the answer is {shape[0]}x{shape[1]}; {asked} was asked" if rows > 1 else f"{asked} was asked"


def count_remark(count: int, wanted: int) -> str:
    """What to say of another number of numbers than was asked for."""
    return f"{plural(count, 'number')} {are(count)} given, {wanted} {'was' if wanted == 1 else 'were'} asked"


def as_read(question: Wanted, row: int, column: int, exercise: Exercise, expr: Expr) -> Expr:
    """What was typed for an entry, bare lengths and those with a unit in metres.

    Raises:
        DimensionError: It is no length, and no number.
    """
    is_bare = is_length(question, row, column) and exercise.metres != 1
    return to_plain_length(length_in_metres(expr, exercise.metres, exercise.scope) if is_bare else expr)


def _entry(question: Wanted, exercise: Exercise, cell: Cell, row: int, column: int) -> Entry:
    where = f"entry ({row + 1},{column + 1})"
    length = is_length(question, row, column)
    given = cell.expr if length or question.piece != "pose" else cell.own
    if exercise.unit == "none" and length and has_length_unit(given):
        raise UnreadableError(f"{where}: the task names no unit, write a number alone")
    try:
        expr = to_plain_length(given)
        if expr != given and not length:
            raise UnreadableError(f"{where} is a direction cosine and has no unit")
        expr = as_read(question, row, column, exercise, given)
    except DimensionError as error:
        message = error.message if length else error.message.replace("a length is wanted", "a number is wanted")
        raise UnreadableError(f"{where}: {message}") from None
    check_names(exercise, symbols(expr))
    return Entry(expr, cell.text, given)


def in_unit_of(question: Wanted, entries: Entries, exercise: Exercise) -> Entries:
    """Entries that have been read, with their bare lengths in the unit of another sheet."""

    def moved(entry: Entry, row: int, column: int) -> Entry:
        if not is_length(question, row, column):
            return entry
        try:
            return replace(entry, expr=as_read(question, row, column, exercise, entry.typed))
        except DimensionError:  # what is no length in that unit stays wrong
            return entry

    return tuple(tuple(moved(entry, r, c) for c, entry in enumerate(row)) for r, row in enumerate(entries))


def _check_bottom_row(entries: Entries) -> None:
    """Refuse a pose with another bottom row than 0 0 0 1; one that holds the position is a slip that has a name.

    Raises:
        UnreadableError: It is another one.
    """
    last = (ZERO, ZERO, ZERO, ONE)
    if all(_is_about(entry.expr, right) for entry, right in zip(entries[-1], last, strict=True)):
        return
    remark = "the bottom row of a pose is 0 0 0 1"
    if all(_is_about(row[-1].expr, right) for row, right in zip(entries, last, strict=True)):
        remark += "; yours holds the position, which belongs in the last column"
    raise UnreadableError(remark)


def _is_about(expr: Expr, wanted: Number) -> bool:
    """Whether an entry is a number but for what floating point leaves of it."""
    return expr == wanted or (not symbols(expr) and abs(Floats().value(expr) - float(wanted.value)) <= LEAST)


def entries_text(rows: Sequence[Sequence[str]]) -> str:
    """Entries as a matrix that can be read again; a single one by itself."""
    if len(rows) == 1 and len(rows[0]) == 1:
        return rows[0][0]
    return bracketed(rows)


def values_of(entries: Entries, exercise: Exercise) -> tuple[tuple[float, ...], ...]:
    """What was typed in floats, lengths in metres.

    Raises:
        UnreadableError: An entry holds a name without a value, or is not finite.
    """
    over = Floats(numbers(exercise.values))
    typed: list[tuple[float, ...]] = []
    for r, row in enumerate(entries):
        found: list[float] = []
        for c, entry in enumerate(row):
            if missing := sorted(symbols(entry.expr) - exercise.values.keys()):
                raise UnreadableError(f"entry ({r + 1},{c + 1}) holds {', '.join(missing)}, and a number was asked")
            found.append(over.value(entry.expr))
            if not math.isfinite(found[-1]):
                raise UnreadableError(f"entry ({r + 1},{c + 1}), {entry.text}, is not a finite number")
        typed.append(tuple(found))
    return tuple(typed)
