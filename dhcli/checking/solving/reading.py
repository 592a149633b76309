"""Joint vectors as they are typed: a row each, in brackets or behind names, with points or with decimal commas."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from dhcli.algebra.floats import Floats
from dhcli.checking.entries import check_names
from dhcli.checking.exercise import Exercise
from dhcli.checking.lists import with_unit_inside
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.tolerance import without_unit
from dhcli.checking.units import has_length_unit
from dhcli.errors import DhcliError, Place, UnknownNameError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_called, numbers, symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.commas import comma_remark, with_points
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle, to_plain_length
from dhcli.notation.tree import Expr, Symbol
from dhcli.regex import regex

_LABEL = regex(r"(?P<name>[^\W\d]\w{0,40})\s{0,9}=(?!=)")
_TEXT = regex(r"\A\s*(?P<name>[^\W\d]\w*)\s*=\s*(?=\[|\([^()]*[,;|])")
_NUMBERED = regex(r"(?m)^[ \t]*1?\d\.[ \t]+(?=[(\[+−-]?[\w.])")  # noqa: RUF001
_BESIDE = regex(r"(?<![\w.=])(?P<name>[^\W\d]\w{0,40})[ \t]{1,9}(?=[+−-]?[\d.(√])")  # noqa: RUF001
"""What may name the joint of the value behind it, `θ1 30°`."""
_ABOUT = regex(r"(?<=\w)[ \t]*≈")
_COLON = regex(r"(?<=\d)[ \t]*:(?=[ \t]*[(\d.+−-])")  # noqa: RUF001
_ROW_LABEL = regex(
    r"(^|[;\n])[ \t]*(?:\(?(?:1?\d|[a-h])\)|1?\d:|[A-Za-z][A-Za-z ]{1,30}(?: 1?\d)?:)[ \t]*(?=[(\[\w.]|[+−-][\d.(])"  # noqa: RUF001
)
"""What stands before a row, `1)`, `b)`, `Solution 1:` and `elbow up:`; a sign that stands apart is no row's."""

_VALUE = regex(r"[+−-]?[\d.]{1,30}°?")  # noqa: RUF001
_SPACED = regex(rf"\s*{_VALUE.pattern}(?:[ \t]+{_VALUE.pattern})*\s*")

_IN_BRACKETS = regex(
    r"\s{0,9}[\[({](?P<inside>[^\[\](){}]{1,400})[\])}]\s{0,9}(?:\^\s?\{?\s?\\?(?:T|top)\s?\}?|')?\s{0,9}[,;]?\s{0,9}"
)
"""A vector in brackets, with the sign of a transposition and what separates it from the next."""

_BETWEEN = regex(r",?[ \t]{1,20}(?:or|and)[ \t]{1,20}|[ \t]{0,20}\n[ \t]{0,20}(?:or|and)[ \t\n]{1,20}")
_BETWEEN_NAMED = regex(rf"(?:{_BETWEEN.pattern})(?=[^\W\d]\w{{0,40}}[ \t]{{0,9}}=)")


@frozen
class Vector:
    """Joint values as typed.

    Attributes:
        values: Radians and metres, in joint order.
        bare: For each whether it was typed as a mere number, so that its unit is that of the sheet.
        shown: As they were read.
    """

    values: tuple[float, ...]
    bare: tuple[bool, ...]
    shown: str


def read_vectors(
    exercise: Exercise, robot: Robot, joints: Sequence[str], text: str, place: Place, *, several: bool
) -> list[Vector]:
    """Read joint vectors, a row each: `30°, 45°; 60°, -45°`, `(30, 45), (60, -45)`, or `theta1 = 30°, theta2 = 45°`.

    Args:
        exercise: The exercise, for its names, values and unit.
        robot: The robot.
        joints: The joints that are answered, in order.
        text: What was typed.
        place: Where it stands, for errors.
        several: Whether there may be more than one vector; of one alone the decimals may have commas.

    Raises:
        UnreadableError: A row has too few or too many values, an angle stands for a length, a name has no value.
        NotationError: It cannot be read.
    """
    text = _with_signs(robot, _TEXT.sub("", _tidied(text, joints, several=several)))
    if _LABEL.search(text):
        rows = _labelled(exercise, robot, joints, text, place)
        return [_vector(exercise, robot, joints, row) for row in rows]
    body = ";".join(line for line in text.splitlines() if line.strip(" ;,"))
    groups = _groups(body)
    lines = (_lines(text, len(joints)) or _between_commas(body, len(joints))) if several else []
    pieces = groups or lines or (body.split(";") if several else [body])
    pieces = [with_points(piece, (1, len(joints))) for piece in pieces]
    body = "; ".join(piece.replace(";", ",") if groups else piece for piece in pieces)
    rows = [[cell.expr for cell in row] for row in parse_matrix(bracketed(body), exercise.scope, place)]
    rows = _without_heads(rows, joints)
    if all(len(row) == 1 for row in rows) and len(rows) == len(joints):
        rows = [[row[0] for row in rows]]  # a column
    for row in rows:
        if len(row) != len(joints):
            message = f"{plural(len(row), 'value')} in a row, and there are {len(joints)} joints: {', '.join(joints)}"
            remarks = (message + "; each solution stands in a row of its own", comma_remark(text))
            raise UnreadableError(*filter(None, remarks))
    return [_vector(exercise, robot, joints, row) for row in rows]


def _without_heads(rows: list[list[Expr]], joints: Sequence[str]) -> list[list[Expr]]:
    """Rows without one above them that holds the names of the joints, in the order of these."""
    heads = [expr.name for expr in rows[0] if isinstance(expr, Symbol)]
    if len(rows) == 1 or sorted(heads) != sorted(joints) or any(len(row) != len(joints) for row in rows):
        return rows
    return [[row[heads.index(name)] for name in joints] for row in rows[1:]]


def _tidied(text: str, joints: Sequence[str], *, several: bool) -> str:
    """Without what people write around vectors: numbers and names of rows, `or` between them, a unit behind each."""
    if len(_NUMBERED.findall(text)) == sum(bool(line.strip()) for line in text.splitlines()) > 1:
        text = _NUMBERED.sub("", text)
    text = _COLON.sub("=", _ABOUT.sub("=", _ROW_LABEL.sub(r"\1", text.strip().rstrip(".")))).replace("≈", "")
    between = _BETWEEN_NAMED if _LABEL.search(text) else _BETWEEN
    text = between.sub("; " if several else ", ", text).strip()
    return with_unit_inside(_side_by_side(text, len(joints)), len(joints))


def _side_by_side(text: str, count: int) -> str:
    """Vectors in brackets of their own, columns or rows, each as a row: `[30; 45], [60; -45]`; others as they are."""
    groups = [match["inside"].strip() for match in _IN_BRACKETS.finditer(text)]
    if len(groups) < 2 or _IN_BRACKETS.sub("", text).strip():  # noqa: PLR2004
        return text
    rows = [_apart(inside) for inside in groups]
    return "; ".join(f"({', '.join(row)})" for row in rows) if all(len(row) == count for row in rows) else text


def _apart(inside: str) -> list[str]:
    """The values of a vector: between semicolons or lines, else between commas, else between blanks."""
    for separator in (";", "\n", ",", None):
        if separator is None or separator in inside:
            return [value.strip() for value in inside.split(separator)]
    return [inside]


def bracketed(body: str) -> str:
    """Rows in the brackets of a matrix, where they have none."""
    return body if body.startswith(("[", "\\begin")) else f"[{body}]"


def _lines(text: str, count: int) -> list[str]:
    """Rows as programs write them where 0,5 is a half: lines, each with semicolons between its values; else none."""
    lines = [line.strip(" \t;") for line in text.splitlines() if line.strip(" ;,")]
    rows = [with_points(line, (1, count)) for line in lines]
    if len(lines) < 2 or any(row.count(";") != count - 1 or "," in row for row in rows):  # noqa: PLR2004
        return []
    return [row.replace(";", ",") for row in rows]


def _between_commas(text: str, count: int) -> list[str]:
    """Rows with blanks between their values and commas between the rows, `30 45, 60 -45`; else none."""
    rows = [_VALUE.findall(row) if _SPACED.fullmatch(row) else [] for row in text.split(",")]
    is_whole = len(rows) > 1 < count and all(len(row) == count for row in rows)
    return [", ".join(row) for row in rows] if is_whole else []


def _groups(text: str) -> list[str]:
    """The insides of round brackets side by side, `(30, 45), (60, -45)`; none where something else stands there."""
    inside = text[1:-1] if text[:1] in ("[", "{") and text[-1:] in ("]", "}") else text
    inside = inside[1:-1] if inside.startswith("((") and inside.endswith("))") else inside
    found, start, depth = list[str](), 0, 0
    for i, letter in enumerate(inside):
        if letter == "(":
            depth, start = depth + 1, start if depth else i + 1
        elif letter == ")":
            depth -= 1
            if not depth:
                found.append(inside[start:i].replace("|", ","))
        elif not depth and letter not in " ,;\t":
            return []
    return found if all("," in group or ";" in group for group in found) else []


def _with_signs(robot: Robot, text: str) -> str:
    """`θ1 30°, θ2 45°` with the signs that these names lack; a value is a number, and no product of a joint."""

    def named(match: re.Match[str]) -> str:
        try:
            return f"{joint_called(robot, match['name'])} = "
        except DhcliError:
            return match[0]

    return text if "=" in text else _BESIDE.sub(named, text)


def _labelled(exercise: Exercise, robot: Robot, joints: Sequence[str], text: str, place: Place) -> list[list[Expr]]:
    """The values behind the names of joints, in the order of these; whoever names them once more begins a new row."""
    found = list(_LABEL.finditer(text))
    try:
        named = [joint_called(robot, match["name"]) for match in found]
    except (UnknownNameError, DhcliError) as error:
        raise UnreadableError(str(error.problems[0].message), f"joints: {', '.join(joints)}") from None
    ends = [*(match.start() for match in found[1:]), len(text)]
    values = [text[match.end() : end].strip(" \t\n,;()[]") for match, end in zip(found, ends, strict=True)]
    rows = []
    for k in range(0, len(named), len(joints)):
        row = dict(zip(named[k : k + len(joints)], values[k : k + len(joints)], strict=True))
        if sorted(row) != sorted(joints):
            raise UnreadableError(f"each joint is named once in a row: {', '.join(joints)}")
        rows.append([parse(row[name], exercise.scope, place) for name in joints])
    return rows


def _vector(exercise: Exercise, robot: Robot, joints: Sequence[str], row: Sequence[Expr]) -> Vector:
    values, shown, bare = list[float](), list[str](), list[bool]()
    known = exercise.known
    over = Floats(numbers(known))
    for name, expr in zip(joints, row, strict=True):
        turns = name in robot.angles
        number, unit = without_unit(expr, 1.0 if turns else float(exercise.metres))
        try:
            value = to_angle(expr, bare="deg") if turns else to_plain_length(number)
        except DimensionError as error:
            raise UnreadableError(f"{name}: {error.message}") from None
        inside = symbols_of(value)
        check_names(exercise, inside)
        if missing := sorted(inside - known.keys()):
            raise UnreadableError(f"{name}: a number was asked, and {missing[0]} has no value")
        bare.append(not inside and not (has_angle_unit(expr) if turns else has_length_unit(expr)))
        values.append(value.substitute(known).constant() if isinstance(value, Angle) else over.value(value) * unit)
        if not math.isfinite(values[-1]):
            raise UnreadableError(f"{name} is no real number")
        shown.append(spelled(exercise, robot, name, values[-1]))
    return Vector(tuple(values), tuple(bare), ", ".join(shown))


def spelled(exercise: Exercise, robot: Robot, name: str, value: float) -> str:
    """A joint value as a person would type it on the sheet."""
    if name in robot.angles:
        return f"{round(math.degrees(value), 4) + 0.0:g}°"
    return f"{round(value / float(exercise.metres), 6) + 0.0:g}{exercise.behind}"
