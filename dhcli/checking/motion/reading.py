"""An answer about motion as typed: a table of entries, a column of them, or one."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.checking.commas import COORDINATES, comma_remark, with_points
from dhcli.checking.entries import LARGEST, Entries, Entry, check_names, count_remark
from dhcli.checking.exercise import Exercise
from dhcli.checking.pasted import UnreadableError, as_matrix, refuse_blanks, without_label
from dhcli.checking.units import length_in_metres
from dhcli.checking.vectors import as_column
from dhcli.errors import NotationError, Place
from dhcli.notation.matrix import Cell, parse_matrix
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_plain_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Number, multiply
from dhcli.notation.walk import symbols
from dhcli.regex import regex

_NAMED = regex(r"(^|[,;\n])[ \t]{0,9}(?:\\dot[ {]?)?(?:\\?[^\W\d][\w'_{}\u0307]{0,12})[ \t]{0,9}=")
"""What stands before a number of a list: `tau1 =`, `v_x =`, `\\dot\\theta_1 =`."""

_A_SECOND = r"(?: ?/ ?s(?:ec)?(?![\w^])|[ *·⋅]s(?:\^\{?[-−]1\}?|⁻¹))"  # noqa: RUF001
_SPEED = regex(rf"(?<![A-Za-z_])(mm|cm|m){_A_SECOND}")
_TURNING = regex(rf"(?<![A-Za-z_])(rad|deg|°){_A_SECOND}")
_FORCE = regex(r"(?<=[\d.) ])N(?: ?[·⋅*.]? ?m)?(?![\w^])")
"""Units of rates and forces, which no formula has."""

SPEED, TURNING, TORQUE, FORCE = "m/s", "rad/s", "N m", "N"
"""The units that an entry of such an answer may have, as they are told."""


def read_cells(
    exercise: Exercise,
    powers: tuple[tuple[int, ...], ...],
    text: str,
    place: Place | None = None,
    units: Sequence[str] = (),
) -> Entries:
    """Read an answer in the shape of the right one.

    Args:
        exercise: The exercise, for its names and the unit of its sheet.
        powers: For each entry of the right answer the power of a length that it is.
        units: For each entry of a list its unit of rate or force, where a list of these is asked for.
        text: What was typed.
        place: Where it stands, for errors.

    Raises:
        UnreadableError: It has another shape, an unknown name, or cannot be read.
    """
    if len(text) > LARGEST:
        raise UnreadableError(f"the answer has {len(text)} characters, more than the {LARGEST} that are read")
    shape = len(powers), len(powers[0])
    body = without_label(as_matrix(text, shape))
    _check_units(body, units, exercise)
    body = _without_units(body, powers, exercise)
    refuse_blanks(body)
    place = place or Place("answer")
    try:
        if shape == (1, 1) and not body.lstrip().startswith(("[", "{", "\\begin", "|")):
            cells: tuple[tuple[Cell, ...], ...] = (
                (Cell(parse(body.strip(), exercise.scope, place), body.strip(), 0),),
            )
        else:
            cells = parse_matrix(_bracketed(body, shape, exercise.scope), exercise.scope, place)
    except NotationError as error:
        remarks = (*(str(problem) for problem in error.problems), comma_remark(text))
        raise UnreadableError(*filter(None, remarks)) from None
    shaped = _shaped(cells, shape)
    return tuple(
        tuple(_entry(exercise, cell, powers[r][c], (r, c)) for c, cell in enumerate(row))
        for r, row in enumerate(shaped)
    )


def _check_units(body: str, wanted: Sequence[str], exercise: Exercise) -> None:
    """Refuse a unit of another kind than is asked for: rad/s for a torque, N where a joint turns.

    Raises:
        UnreadableError: There is one.
    """
    found = [(match.start(), SPEED, match[0]) for match in _SPEED.finditer(body)]
    found += [(match.start(), TURNING, match[0]) for match in _TURNING.finditer(body)]
    if "N" not in exercise.scope.names:
        found += [(match.start(), TORQUE if "m" in match[0] else FORCE, match[0]) for match in _FORCE.finditer(body)]
    separators = [at for at, letter in enumerate(body.rstrip("[]() \n;")) if letter in ",;\n"]
    for k, (start, kind, typed) in enumerate(sorted(found)):
        number = k if len(found) == len(wanted) else -1
        if len(separators) == len(wanted) - 1:
            number = sum(at < start for at in separators)
        if number >= 0 and kind != wanted[number]:
            raise UnreadableError(f"number {number + 1} is in {typed}; {wanted[number]} is wanted")
        if kind not in wanted and (wanted or kind in (TORQUE, FORCE)):
            raise UnreadableError(f"{typed} is a unit of another kind: {_instead(wanted)}")


def _instead(wanted: Sequence[str]) -> str:
    """What would be right in the place of a unit."""
    return f"write {' or '.join(dict.fromkeys(wanted))}, or numbers alone" if wanted else "write numbers alone"


def _without_units(body: str, powers: tuple[tuple[int, ...], ...], exercise: Exercise) -> str:
    """`0.5 rad/s`, `10 N m` and `90 deg/s` as numbers, `40 mm/s` as a length."""
    if any(1 in row for row in powers):
        body = _SPEED.sub(r"\1", body)
    if any(0 in row for row in powers):
        body = _TURNING.sub(lambda match: "" if match[1] == "rad" else "*pi/180", body)
        body = body if "N" in exercise.scope.names else _FORCE.sub("", body)
    return body


def _bracketed(body: str, shape: tuple[int, int], scope: Scope) -> str:
    """A list without brackets, or in round ones, as a matrix."""
    if shape[1] == 1:
        body = _NAMED.sub(r"\1", body).strip()
        body = with_points(body, shape[0]) if shape[0] > 1 else body
        if shape[0] == COORDINATES:
            return as_column(body, scope, is_axis=False)
        if body.startswith("(") and body.endswith(")") and "," in body and ")" not in body[:-1]:
            body = body[1:-1]
        if "," in body and ";" not in body:
            body = body.replace("\n", " ")
        return body if body.startswith(("[", "{", "\\", "|")) else f"[{body}]"
    return body


def _shaped(cells: tuple[tuple[Cell, ...], ...], wanted: tuple[int, int]) -> tuple[tuple[Cell, ...], ...]:
    """The cells in the shape of the answer; a column may be typed as a row."""
    shape = len(cells), len(cells[0])
    if shape == wanted:
        return cells
    if 1 in wanted and 1 in shape and max(shape) == max(wanted):
        flat = [cell for row in cells for cell in row]
        return tuple((cell,) for cell in flat) if wanted[1] == 1 else (tuple(flat),)
    if 1 in wanted:
        if 1 not in shape:
            raise UnreadableError(f"{max(wanted)} numbers were asked; the answer is {shape[0]}x{shape[1]}")
        raise UnreadableError(count_remark(max(shape), max(wanted)))
    if shape == wanted[::-1]:
        raise UnreadableError(
            f"the answer is {shape[0]}x{shape[1]}; {wanted[0]} rows and {wanted[1]} columns were asked"
        )
    half = ": half of its rows are missing, v or ω" if shape == (wanted[0] / 2, wanted[1]) else ""
    raise UnreadableError(f"the answer is {shape[0]}x{shape[1]}; a {wanted[0]}x{wanted[1]} matrix was asked{half}")


def _entry(exercise: Exercise, cell: Cell, power: int, place: tuple[int, int]) -> Entry:
    """One entry in metres; without a unit it is in that of the sheet."""
    where = f"entry ({place[0] + 1},{place[1] + 1})"
    try:
        if power != 1 and to_plain_length(cell.expr) != cell.expr:
            raise UnreadableError(f"{where} is no length: leave its unit out")
        expr = as_read(exercise, power, cell.expr)
    except DimensionError as error:
        wanted = "a length" if power == 1 else "a number"
        raise UnreadableError(f"{where}: {error.message.replace('a length', wanted)}") from None
    check_names(exercise, symbols(expr))
    return Entry(expr, cell.text, cell.expr)


def as_read(exercise: Exercise, power: int, expr: Expr) -> Expr:
    """What was typed for an entry that is a power of a length, in metres.

    Raises:
        DimensionError: It is neither a length nor a number.
    """
    if exercise.metres == 1 or not power:
        return to_plain_length(expr)
    if power == 1:
        return to_plain_length(length_in_metres(expr, exercise.metres, exercise.scope))
    found = to_plain_length(expr)
    return found if symbols(found) else multiply(found, Number(exercise.metres**power))
