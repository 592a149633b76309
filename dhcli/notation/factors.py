"""Products of moves as text: `Trans(8, -6, 14) Rot(y, 90°) [1 0 0 2; ...] inv(Rot_z(theta1))`.

Reads the spelling only; what a move does to a frame is the business of kinematics.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Literal

from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.cells import matching
from dhcli.notation.matrix import read_matrix
from dhcli.notation.operators import DEEPEST
from dhcli.notation.parser import Parser
from dhcli.notation.quantity import DimensionError, to_angle, to_plain_length, with_unit
from dhcli.notation.quarters import with_right_angles
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.tokens import Source, Token, tokenize
from dhcli.notation.tree import ONE, ZERO, Expr
from dhcli.regex import regex

MOST_FACTORS = 200
LONGEST = 20_000

Axis = Literal["x", "y", "z"]
AXES: tuple[Axis, ...] = ("x", "y", "z")

_ROTATION = regex(r"(?:Rot|rot|Rotate|R)_?\{?([xyz])?\}?")
_TRANSLATION = regex(r"(?:Trans|trans|Transl|transl|Translate|T|D)_?\{?([xyz])?\}?")
_INVERSE = frozenset(("inv", "inverse", "Inv"))
_WHERE = frozenset(("fixed", "current"))
_TURNS = {"rpy": 3, "euler": 4, "quaternion": 4, "quat": 4, "rotvec": 3, "rotation_vector": 3}
"""Rotations by several numbers, and how many each takes."""
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


def moves_of(factors: Sequence[Factor]) -> Iterator[list[Factor]]:
    """Factors move by move: a rotation about any axis is one move, and so is what stands in `fixed(...)`."""
    for _, group in groupby(factors, key=lambda factor: factor.start):
        yield list(group)


def in_order_of_motion(factors: Sequence[Factor]) -> list[Factor]:
    """Factors as they are multiplied: a move about the fixed frame stands before all that were typed before it."""
    ordered: list[Factor] = []
    for group in moves_of(factors):
        ordered = group + ordered if group[0].about == "fixed" else ordered + group
    return ordered


@frozen
class _Reading:
    """What the readers of one product share: its text, the names it may use, and where to say what was taken for what.

    Without a place for remarks, angles are taken as they stand.
    """

    source: Source
    scope: Scope
    remarks: list[str] | None
    unit: str = ""


def parse_factors(
    text: str, scope: Scope = OPEN, place: Place | None = None, remarks: list[str] | None = None, unit: str = ""
) -> tuple[Factor, ...]:
    """Read a product of moves and matrices, from left to right.

    Args:
        text: What a person wrote.
        scope: The names it may use.
        place: Where the text stands, for errors.
        remarks: Where to say that 1.5708 rad was taken as 90°; without it such angles are taken as they stand.
        unit: The unit of bare lengths; empty for metres.

    Raises:
        NotationError: With the column, what is wrong there, and what would be read.
    """
    source = Source(text, place or Place("product"))
    tokens = [token for token in tokenize(source, most=LONGEST) if token.kind != "end"]
    factors = tuple(_product(_Reading(source, scope, remarks, unit), tokens, inverse=False))
    if not factors:
        raise source.error(0, "no move is written here", EXAMPLE)
    if len(factors) > MOST_FACTORS:
        raise source.error(factors[MOST_FACTORS].start, f"more than {MOST_FACTORS} moves are not read")
    return factors


def _product(reading: _Reading, tokens: Sequence[Token], *, inverse: bool, depth: int = 0) -> list[Factor]:
    source = reading.source
    if depth > DEEPEST:
        raise source.error(tokens[0].start if tokens else 0, f"brackets nested deeper than {DEEPEST} are not read")
    factors: list[Factor] = []
    i = 0
    while i < len(tokens):
        token = tokens[i]
        if token.kind == "newline" or (token.kind == "sign" and token.text in "*@"):
            i += 1
            continue
        opening = i + 1 if token.kind == "word" and token.text != "begin" else i
        closing = _end_of_environment(tokens, i) if token.text == "begin" else matching(tokens, opening)
        if closing < 0 and tokens[opening : opening + 1] and tokens[opening].text in ("(", "[", "{"):
            raise source.error(tokens[opening].start, f"{tokens[opening].text} is never closed", "close the bracket")
        if closing < 0:
            raise source.error(token.start, f"{token.text!r} is not a move or a matrix", EXAMPLE)
        inside = tokens[opening + 1 : closing]
        end = _inverse_mark(tokens, closing)
        turned = inverse != (end > closing)
        if token.kind == "word" and token.text in _INVERSE:
            part = _product(reading, inside, inverse=not turned, depth=depth + 1)
            factors.extend(part[::-1] if inverse else part)
        elif token.text == "(":
            part = _product(reading, inside, inverse=turned, depth=depth + 1)
            factors.extend(part[::-1] if inverse else part)
        elif token.kind == "word" and token.text in _WHERE:
            if depth or turned:
                raise source.error(token.start, f"{token.text}(...) stands by itself", "not in brackets, nor inverted")
            part = _product(reading, inside, inverse=False, depth=depth + 1)
            about: Literal["fixed", "current"] = "fixed" if token.text == "fixed" else "current"
            text = source.text[inside[0].start : inside[-1].end] if inside else ""
            factors.extend(replace(factor, about=about, start=token.start, text=text) for factor in part)
        elif token.kind == "sign" or token.text in ("begin", "array", "matrix", "Matrix"):
            factors.append(_matrix(reading, tokens[i : closing + 1], inverse=turned))
        else:
            part = _moves(reading, token, inside, tokens[closing], inverse=turned)
            factors.extend(part[::-1] if turned != inverse else part)
        i = end + 1
    return factors[::-1] if inverse else factors


def _end_of_environment(tokens: Sequence[Token], start: int) -> int:
    for i in range(start, len(tokens) - 3):
        if tokens[i].text == "end" and tokens[i + 1].text == "{":
            return i + 3
    return -1


def _inverse_mark(tokens: Sequence[Token], closing: int) -> int:
    """Where `^-1` or `^{-1}` behind a factor ends, or the closing bracket itself."""
    texts = "".join(token.text for token in tokens[closing + 1 : closing + 6])
    for mark, length in (("^-1", 3), ("^{-1}", 5), ("^(-1)", 5)):
        if texts.startswith(mark):
            return closing + length
    return closing


def _matrix(reading: _Reading, tokens: Sequence[Token], *, inverse: bool) -> Factor:
    source = reading.source
    cells = read_matrix(source, tokens, reading.scope)
    start, text = tokens[0].start, source.text[tokens[0].start : tokens[-1].end]
    if [len(row) for row in cells] != [4] * 4:
        shape = f"{len(cells)}x{len(cells[0])}"
        raise source.error(start, f"a pose has 4 rows of 4, this matrix is {shape}", "add the row 0 0 0 1")
    units = ("", "", "", reading.unit)
    rows = tuple(
        tuple(_length(source, cell.expr, cell.start, unit) for cell, unit in zip(row, units, strict=True))
        for row in cells[:3]
    )
    for cell, right in zip(cells[3], (ZERO, ZERO, ZERO, ONE), strict=True):
        if cell.expr != right:
            raise source.error(start, "the last row of a pose is 0 0 0 1", "lengths stand in the fourth column")
    return Factor("matrix", text, rows=rows, inverse=inverse, start=start)


def _moves(reading: _Reading, word: Token, inside: Sequence[Token], close: Token, *, inverse: bool) -> list[Factor]:
    """A move, which several factors may stand for: a rotation about any axis, or by several numbers."""
    source, scope = reading.source, reading.scope
    arguments = _arguments(inside)
    name = word.text if word.text in _TURNS else ""
    any_axis = word.text in ("Rot", "rot") and len(arguments) == 2 and arguments[0][0].text in ("[", "(")  # noqa: PLR2004
    if not name and not any_axis:
        return [_move(reading, word, inside, close, inverse=inverse)]
    from dhcli.notation import turns  # few products have one

    text = source.text[word.start : close.end]

    def angles(parts: list[list[Token]]) -> list[Angle]:
        return [_angle(reading, _parse(source, part, scope, close), part[0].start) for part in parts]

    def numbers(parts: list[list[Token]]) -> list[Expr]:
        return [_length(source, _parse(source, part, scope, close), part[0].start) for part in parts]

    if name and len(arguments) != _TURNS[name]:
        example = turns.EXAMPLES[name]
        raise source.error(word.start, f"{name} takes {_TURNS[name]} values, not {len(arguments)}", f"write {example}")
    if any_axis and len(axis := _arguments(arguments[0][1:-1])) != len(AXES):
        raise source.error(word.start, f"an axis has three coordinates, not {len(axis)}", "write Rot([1, 2, 2], 40°)")
    try:
        if any_axis:
            parts = turns.about(numbers(axis), angles(arguments[1:])[0])
        elif name == "rpy":
            parts = turns.in_order("fixed xyz", angles(arguments))
        elif name == "euler":
            order = source.text[arguments[0][0].start : arguments[0][-1].end]
            parts = turns.in_order(order, angles(arguments[1:]))
        elif name in ("quaternion", "quat"):
            parts = turns.by_quaternion(numbers(arguments))
        else:
            parts = turns.by_vector(angles(arguments))
    except DimensionError as error:
        raise source.error(word.start, error.message, error.hint) from None
    return [
        Factor("rot", text, axis=part.axis, angle=part.angle, inverse=inverse, start=word.start)
        if isinstance(part, turns.Turn)
        else Factor("matrix", text, rows=part.rows, inverse=inverse, start=word.start)
        for part in parts
    ]


def _move(reading: _Reading, word: Token, inside: Sequence[Token], close: Token, *, inverse: bool) -> Factor:
    source, scope = reading.source, reading.scope
    text = source.text[word.start : close.end]
    arguments = _arguments(inside)
    if match := _ROTATION.fullmatch(word.text):
        axis, rest = _axis(source, match[1], arguments, word, close, "Rot(z, 90°)")
        angle = _angle(reading, _parse(source, rest[0], scope, close), rest[0][0].start)
        return Factor("rot", text, axis=axis, angle=angle, inverse=inverse, start=word.start)
    if match := _TRANSLATION.fullmatch(word.text):
        if match[1] or len(arguments) == 2:  # noqa: PLR2004  Trans(z, d1) and Trans_z(d1)
            axis, rest = _axis(source, match[1], arguments, word, close, "Trans(0, 0, d1)")
            length = _length(source, _parse(source, rest[0], scope, close), rest[0][0].start, reading.unit)
            lengths = [length if name == axis else ZERO for name in AXES]
        else:
            if len(arguments) != len(AXES):
                raise source.error(word.start, f"{word.text} takes three lengths", "write Trans(1, 2, 3)")
            lengths = [
                _length(source, _parse(source, part, scope, close), part[0].start, reading.unit) for part in arguments
            ]
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
    if axis not in AXES:
        raise source.error(word.start, f"{word.text} turns or shifts along x, y or z, not {axis or 'nothing'}", example)
    if len(arguments) != 1:
        raise source.error(close.start, f"{word.text} about {axis} takes one value, not {len(arguments)}", example)
    return axis, arguments


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


def _parse(source: Source, tokens: list[Token], scope: Scope, close: Token) -> Expr:
    parser = Parser(source, [*tokens, Token("end", "", close.start, close.start, spaced=False)], scope)
    expr = parser.expression()
    parser.finish()
    return expr


def _angle(reading: _Reading, expr: Expr, start: int) -> Angle:
    if reading.remarks is not None:
        expr = with_right_angles(expr, reading.remarks)
    try:
        return to_angle(expr, bare="refuse")
    except DimensionError as error:
        raise reading.source.error(start, error.message, error.hint) from None


def _length(source: Source, expr: Expr, start: int, unit: str = "") -> Expr:
    try:
        return to_plain_length(with_unit(expr, unit))
    except DimensionError as error:
        raise source.error(start, error.message, error.hint) from None
