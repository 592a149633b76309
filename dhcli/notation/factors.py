"""One factor of a product as text: `Rot(y, 90°)`, `Trans(8, -6, 14)`, `rpy(10°, 20°, 30°)`, `[1 0 0 2; ...]`.

Reads the spelling only; what a move does to a frame is the business of kinematics.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import read_matrix
from dhcli.notation.parser import Parser
from dhcli.notation.quantity import DimensionError, to_angle, to_plain_length, with_unit
from dhcli.notation.quarters import with_right_angles
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Source, Token
from dhcli.notation.tree import ONE, ZERO, Expr
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.notation.turns import Part

Axis = Literal["x", "y", "z"]
AXES: tuple[Axis, ...] = ("x", "y", "z")

_ROTATION = regex(r"(?:(?i:t?rot(?:ate|ation)?)|R)_?\{?([xyzXYZ])?\}?")
_TRANSLATION = regex(r"(?:(?i:trans(?:l|late|lation)?)|T|D)_?\{?([xyzXYZ])?\}?")
_TURNS = {"rpy": 3, "euler": 4, "quaternion": 4, "quat": 4, "rotvec": 3, "rotation_vector": 3}
"""Rotations by several numbers, and how many each takes."""
_LACKS = {"3x4": "add the row 0 0 0 1", "3x3": "add the position as fourth column, and the row 0 0 0 1"}
"""What a matrix of another shape lacks for a pose."""

EXAMPLE = "write Trans(1, 2, 3) Rot(z, 90°), or a matrix [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]"


@frozen
class Factor:
    """One factor of a product, in the spelling's own terms.

    Attributes:
        kind: What it is.
        text: How it was typed.
        axis: Axis of a rotation.
        angle: Angle of a rotation.
        offset: Three lengths of a translation [m].
        rows: Entries of a literal 4x4 matrix.
        inverse: Whether the inverse is meant.
        start: Offset in the text; factors that one move stands for have the same.
        about: Whether it is said that the move is about the fixed or the current frame; empty if not.
    """

    kind: Literal["rot", "trans", "matrix"]
    text: str
    axis: Axis = "z"
    angle: Angle = Angle()
    offset: tuple[Expr, Expr, Expr] = (ZERO, ZERO, ZERO)
    rows: tuple[tuple[Expr, ...], ...] = ()
    inverse: bool = False
    start: int = 0
    about: Literal["", "fixed", "current"] = ""


@frozen
class Reading:
    """What the readers of one product share: its text, the names it may use, and where to say what was taken for what.

    Without a place for remarks, angles are taken as they stand.
    """

    source: Source
    scope: Scope
    remarks: list[str] | None
    unit: str = ""


def read_matrix_factor(reading: Reading, tokens: Sequence[Token], *, inverse: bool) -> Factor:
    """A literal 4x4 matrix.

    Raises:
        NotationError: It is no pose.
    """
    source = reading.source
    cells = read_matrix(source, tokens, reading.scope)
    start, text = tokens[0].start, source.text[tokens[0].start : tokens[-1].end]
    if [len(row) for row in cells] != [4] * 4:
        shape = f"{len(cells)}x{len(cells[0])}"
        raise source.error(start, f"a pose has 4 rows of 4, this matrix is {shape}", _LACKS.get(shape, ""))
    units = ("", "", "", reading.unit)
    rows = tuple(
        tuple(_in_metres(source, cell.expr, cell.start, unit) for cell, unit in zip(row, units, strict=True))
        for row in cells[:3]
    )
    for cell, right in zip(cells[3], (ZERO, ZERO, ZERO, ONE), strict=True):
        if cell.expr != right:
            raise source.error(start, "the last row of a pose is 0 0 0 1", "lengths stand in the fourth column")
    return Factor("matrix", text, rows=rows, inverse=inverse, start=start)


def read_move(reading: Reading, word: Token, inside: Sequence[Token], close: Token, *, inverse: bool) -> list[Factor]:
    """A move, which several factors may stand for: a rotation about any axis, or by several numbers.

    Raises:
        NotationError: It is no move, or its arguments are none of such a one.
    """
    arguments = _arguments(inside)
    is_about = word.text in ("Rot", "rot") and len(arguments) == 2 and arguments[0][0].text in ("[", "(")  # noqa: PLR2004
    if word.text not in _TURNS and not is_about:
        return [_move(reading, word, arguments, close, inverse=inverse)]
    from dhcli.notation.turns import Turn  # few products have one

    text = reading.source.text[word.start : close.end]
    return [
        Factor("rot", text, axis=part.axis, angle=part.angle, inverse=inverse, start=word.start)
        if isinstance(part, Turn)
        else Factor("matrix", text, rows=part.rows, inverse=inverse, start=word.start)
        for part in _turns(reading, word, arguments, close)
    ]


def _turns(reading: Reading, word: Token, arguments: list[list[Token]], close: Token) -> tuple[Part, ...]:
    """What a rotation about any axis, or by several numbers, is made of."""
    from dhcli.notation import turns

    source, name = reading.source, word.text

    def angles(parts: list[list[Token]]) -> list[Angle]:
        return [_angle(reading, part, close) for part in parts]

    def numbers(parts: list[list[Token]]) -> list[Expr]:
        return [_length(reading, part, close) for part in parts]

    if name in _TURNS and len(arguments) != _TURNS[name]:
        example = turns.EXAMPLES[name]
        raise source.error(word.start, f"{name} takes {_TURNS[name]} values, not {len(arguments)}", f"write {example}")
    try:
        if name == "rpy":
            return turns.in_order("fixed xyz", angles(arguments))
        if name == "euler":
            order = source.text[arguments[0][0].start : arguments[0][-1].end]
            return turns.in_order(order, angles(arguments[1:]))
        if name in ("quaternion", "quat"):
            return turns.by_quaternion(numbers(arguments))
        if name in _TURNS:
            return turns.by_vector(angles(arguments))
        if len(axis := _arguments(arguments[0][1:-1])) != len(AXES):
            hint = "write Rot([1, 2, 2], 40°)"
            raise source.error(word.start, f"an axis has three coordinates, not {len(axis)}", hint)
        return turns.about(numbers(axis), angles(arguments[1:])[0])
    except DimensionError as error:
        raise source.error(word.start, error.message, error.hint) from None


def _move(reading: Reading, word: Token, arguments: list[list[Token]], close: Token, *, inverse: bool) -> Factor:
    source = reading.source
    text = source.text[word.start : close.end]
    if match := _ROTATION.fullmatch(word.text):
        axis, rest = _axis(source, match[1], arguments, word, close, "Rot(z, 90°)")
        angle = _angle(reading, rest[0], close)
        return Factor("rot", text, axis=axis, angle=angle, inverse=inverse, start=word.start)
    if match := _TRANSLATION.fullmatch(word.text):
        if match[1] or len(arguments) == 2:  # noqa: PLR2004  Trans(z, d1) and Trans_z(d1)
            axis, rest = _axis(source, match[1], arguments, word, close, "Trans(0, 0, d1)")
            length = _length(reading, rest[0], close, reading.unit)
            lengths = [length if name == axis else ZERO for name in AXES]
        else:
            if len(arguments) != len(AXES):
                message = f"{word.text} takes three lengths, not {len(arguments)}"
                hint = "; decimals take a point: 0.5" if len(arguments) > len(AXES) else ""
                raise source.error(word.start, message, f"write Trans(1, 2, 3){hint}")
            lengths = [_length(reading, part, close, reading.unit) for part in arguments]
        return Factor("trans", text, offset=(lengths[0], lengths[1], lengths[2]), inverse=inverse, start=word.start)
    raise source.error(word.start, f"{word.text} is not a move", EXAMPLE)


def _axis(
    source: Source, named: str | None, arguments: list[list[Token]], word: Token, close: Token, example: str
) -> tuple[Axis, list[list[Token]]]:
    """The axis in the move's name or as its first argument, primes left out, and the arguments that remain."""
    axis = named
    if axis is None and arguments:
        axis = "".join(token.text for token in arguments[0] if token.text not in ("'", '"'))
        arguments = arguments[1:]
    found = next((one for one in AXES if axis is not None and one == axis.lower()), None)
    if found is None:
        raise source.error(word.start, f"{word.text} turns or shifts along x, y or z, not {axis or 'nothing'}", example)
    if len(arguments) != 1:
        raise source.error(close.start, f"{word.text} about {axis} takes one value, not {len(arguments)}", example)
    return found, arguments


def _arguments(tokens: Sequence[Token]) -> list[list[Token]]:
    parts: list[list[Token]] = [[]]
    depth = 0
    for token in tokens:
        depth += token.kind == "sign" and token.text in "([{"
        depth -= token.kind == "sign" and token.text in ")]}"
        if depth == 0 and token.kind == "sign" and token.text in ",;":
            parts.append([])
        elif token.kind != "newline":
            parts[-1].append(token)
    return [part for part in parts if part]


def _parse(reading: Reading, tokens: list[Token], close: Token) -> Expr:
    end = Token("end", "", close.start, close.start, spaced=False)
    parser = Parser(reading.source, [*tokens, end], reading.scope)
    expr = parser.expression()
    parser.finish()
    return expr


def _angle(reading: Reading, tokens: list[Token], close: Token) -> Angle:
    expr = _parse(reading, tokens, close)
    if reading.remarks is not None:
        expr = with_right_angles(expr, reading.remarks)
    try:
        return to_angle(expr, bare="refuse")
    except DimensionError as error:
        raise reading.source.error(tokens[0].start, error.message, error.hint) from None


def _length(reading: Reading, tokens: list[Token], close: Token, unit: str = "") -> Expr:
    return _in_metres(reading.source, _parse(reading, tokens, close), tokens[0].start, unit)


def _in_metres(source: Source, expr: Expr, start: int, unit: str) -> Expr:
    try:
        return to_plain_length(with_unit(expr, unit))
    except DimensionError as error:
        raise source.error(start, error.message, error.hint) from None
