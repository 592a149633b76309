"""An answer about motion as typed: a table of entries, a column of them, or one."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from dhcli.checking.blanks import refuse_one_expression
from dhcli.checking.entries import Entries, Entry, check_names, count_remark
from dhcli.checking.exercise import Exercise
from dhcli.checking.lists import flat, in_square_brackets, scaled
from dhcli.checking.named import Naming, in_one, in_order, in_rows
from dhcli.checking.pasted import UnreadableError, as_matrix, refuse_blanks, refuse_long, without_label, without_words
from dhcli.checking.units import has_length_unit, length_in_metres
from dhcli.checking.vectors import LENGTHS, as_column, column_of_rows
from dhcli.errors import NotationError, Place
from dhcli.notation.commas import comma_remark
from dhcli.notation.matrix import Cell, parse_matrix
from dhcli.notation.parser import parse
from dhcli.notation.quantity import LENGTH_UNITS, DimensionError, to_plain_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Number, multiply
from dhcli.notation.walk import symbols
from dhcli.regex import regex

_NAMED = regex(r"(^|[,;\n])[ \t]{0,9}(?:\\dot[ {]?)?(?:\\?[^\W\d][\w'_{}\u0307]{0,12})[ \t]{0,9}=")
"""What stands before a number of a list: `tau1 =`, `v_x =`, `\\dot\\theta_1 =`."""

_A_SECOND = r"(?: ?/ ?s(?:ec)?(?![\w^])|[ *·⋅]s(?:\^\{?[-−]1\}?|⁻¹))"  # noqa: RUF001
_SPEED = regex(rf"(?<![A-Za-z_])(mm|cm|m){_A_SECOND}")
_TURNING = regex(rf"(?<![A-Za-z_])(rad|deg|°){_A_SECOND}")
_FORCE = regex(r"(?<=[\d.) ])(?P<prefix>[km]?)N(?: ?[·⋅*.]? ?(?P<arm>mm|cm|m))?(?![\w^])")
"""Units of rates and forces, which no formula has."""
_PREFIXES = {"": Fraction(1), "k": Fraction(1000), "m": Fraction(1, 1000)}

SIX = 6
"""Rows of a whole column of a Jacobian, v and ω."""

SPEED, TURNING, TORQUE, FORCE = "m/s", "rad/s", "N m", "N"
"""The units that an entry of such an answer may have, as they are told."""


def read_cells(
    exercise: Exercise,
    powers: tuple[tuple[int, ...], ...],
    text: str,
    place: Place | None = None,
    units: Sequence[str] = (),
    names: Naming = (),
) -> Entries:
    """Read an answer in the shape of the right one.

    Args:
        exercise: The exercise, for its names and the unit of its sheet.
        powers: For each entry of the right answer the power of a length that it is.
        units: For each entry of a list its unit of rate or force, where a list of these is asked for.
        names: What the rows are called, those of a list or of a Jacobian.
        text: What was typed.
        place: Where it stands, for errors.

    Raises:
        UnreadableError: It has another shape, an unknown name, or cannot be read.
    """
    refuse_long(text)
    shape = len(powers), len(powers[0])
    rows = tuple(str(k + 1) for k in range(len(names)))  # by which the entries of a list may be called, too
    halves = tuple(dict.fromkeys(name[0] for name in names)) if len(names) == SIX else ()  # v = (...), ω = (...)
    body = in_one(text, halves, exercise.scope)
    is_list = shape[1] == 1
    body = in_order(body, (names, rows), exercise.scope) if is_list else in_rows(body, shape, exercise.scope)
    body = without_words(body, exercise.scope) if shape != (1, 1) else body
    body = without_label(as_matrix(body, shape), shape)
    _check_units(body, units, exercise)
    body = _without_units(body, powers, exercise)
    refuse_blanks(body)
    place = place or Place("answer")
    try:
        if shape == (1, 1) and not body.lstrip().startswith(("[", "{", "\\begin", "|")):
            expr = parse(body.strip(), exercise.scope, place)
            cells: tuple[tuple[Cell, ...], ...] = ((Cell(expr, body.strip(), 0, expr),),)
        else:
            body = _bracketed(body, shape, exercise.scope)
            cells = parse_matrix(body, exercise.scope, place)
    except NotationError as error:
        remarks = (*(str(problem) for problem in error.problems), comma_remark(text))
        raise UnreadableError(*filter(None, remarks)) from None
    if 1 in shape and max(shape) > 1:
        refuse_one_expression(body, cells, max(shape), exercise.scope)
    shaped = _shaped(cells, shape)
    if not any(power for row in powers for power in row):  # a unit behind the bracket is that of no number in it
        shaped = tuple(tuple(replace(cell, own=cell.expr) for cell in row) for row in shaped)
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
        found += [(match.start(), TORQUE if match["arm"] else FORCE, match[0]) for match in _FORCE.finditer(body)]
    separators = [at for at, letter in enumerate(body.rstrip("[]() \n;")) if letter in ",;\n"]
    for k, (start, kind, typed) in enumerate(sorted(found)):
        number = k if len(found) == len(wanted) else -1
        if len(separators) == len(wanted) - 1:
            number = sum(at < start for at in separators)
        if number >= 0 and kind != wanted[number]:
            raise UnreadableError(f"number {number + 1} is in {typed}; {wanted[number]} is wanted")
        if kind not in wanted and (wanted or kind in (TORQUE, FORCE)):
            raise UnreadableError(f"{typed} is a unit of another kind: {_instead(wanted)}")


def unit_of_rates(text: str) -> str:
    """The unit of a speed or a rate that stands in an answer, as it was typed; nothing where there is none."""
    found = _SPEED.search(text) or _TURNING.search(text)
    return found[0].strip() if found else ""


def _instead(wanted: Sequence[str]) -> str:
    """What would be right in the place of a unit."""
    return f"write {' or '.join(dict.fromkeys(wanted))}, or numbers alone" if wanted else "write numbers alone"


def _without_units(body: str, powers: tuple[tuple[int, ...], ...], exercise: Exercise) -> str:
    """`0.5 rad/s`, `10 N m` and `90 deg/s` as numbers, `10 N cm` as a hundredth, `40 mm/s` as a length."""
    if any(1 in row for row in powers):
        body = _SPEED.sub(r"\1", body)
    if any(0 in row for row in powers):
        body = _TURNING.sub(lambda match: "" if match[1] == "rad" else "*pi/180", body)
        body = body if "N" in exercise.scope.names else _FORCE.sub(_in_newtons, body)
    return body


def _in_newtons(unit: re.Match[str]) -> str:
    """What a number before a unit of force or torque is to be multiplied with; nothing for N and N m."""
    factor = _PREFIXES[unit["prefix"]] * LENGTH_UNITS[unit["arm"] or "m"]
    return f"*{float(factor):g}" if factor != 1 else ""


def _bracketed(body: str, shape: tuple[int, int], scope: Scope) -> str:
    """A list without brackets, or in round ones, as a matrix."""
    if shape[1] == 1:
        body = _NAMED.sub(r"\1", body).strip()
        if times := scaled(body):
            return times
        body = in_square_brackets(body)
        if shape[0] == LENGTHS[0]:
            return as_column(body, scope, is_axis=False)
        if body.count(";") + body.count("\\\\") + body.count("\n") >= shape[0] - 1 and (
            rows := column_of_rows(body, (shape[0],))
        ):
            return rows
        body = flat(body) if shape[0] > LENGTHS[0] else body
        if "," in body and ";" not in body:
            lines = [line.strip(" ,") for line in body.split("\n") if line.strip()]
            whole = ", ".join(lines).count(",") == shape[0] - 1
            body = ", ".join(lines) if whole else body.replace("\n", " ")
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
    rows = _about_rows(shape[0], wanted[0]) if shape[1] == wanted[1] else ""
    raise UnreadableError(f"the answer is {shape[0]}x{shape[1]}; a {wanted[0]}x{wanted[1]} matrix was asked{rows}")


def _about_rows(typed: int, wanted: int) -> str:
    """What is said of rows that are too many or too few."""
    if typed == 2 * wanted:
        return ": the rows of v or of ω alone"
    if wanted == 2 * typed:
        return ": half of its rows are missing, v or ω"
    return ": rows of zeros are rows, too" if typed < wanted else ""


def _entry(exercise: Exercise, cell: Cell, power: int, place: tuple[int, int]) -> Entry:
    """One entry in metres; without a unit it is in that of the sheet."""
    where, given = f"entry ({place[0] + 1},{place[1] + 1})", cell.expr if power else cell.own
    try:
        refused = power != 1 and (not power or symbols(given)) and has_length_unit(given)
        if refused or (not power and to_plain_length(given) != given):
            raise UnreadableError(f"{where} is no length: leave its unit out")
        expr = as_read(exercise, power, given)
    except DimensionError as error:
        message = error.message if power else error.message.replace("a length", "a number")
        raise UnreadableError(f"{where}: {message}") from None
    check_names(exercise, symbols(expr))
    return Entry(expr, cell.text, given)


def as_read(exercise: Exercise, power: int, expr: Expr) -> Expr:
    """What was typed for an entry that is a power of a length, in metres.

    Raises:
        DimensionError: It is neither a length nor a number.
    """
    if exercise.metres == 1 or not power:
        return to_plain_length(expr, power or 1)
    if power == 1:
        return to_plain_length(length_in_metres(expr, exercise.metres, exercise.scope))
    found = to_plain_length(expr, power)
    return found if symbols(found) or has_length_unit(expr) else multiply(found, Number(exercise.metres**power))
