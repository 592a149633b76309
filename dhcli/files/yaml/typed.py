"""Fields as what they mean: angles and lengths, plain numbers, whole numbers, yes or no."""

from __future__ import annotations

from collections.abc import Collection

from dhcli.errors import NotationError, Problem, did_you_mean
from dhcli.files.keys.shapes import FLAGS
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, as_text
from dhcli.files.yaml.slips import node_kind
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle, to_plain_length, with_unit
from dhcli.notation.quarters import with_right_angles
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr
from dhcli.regex import regex

MOST_DIGITS = 3
_OTHER_UNIT = regex(r".*[\d)]\s*(?P<unit>(?:[cm]?m|rad|°|deg)\s*/\s*s|k?N\s*[*·]?\s*[cm]?m|k?N|k?g|s|rpm|%)\s*")
"""A number in a unit of something else."""
_A_TURN = regex(r"(.*[\d.)]\s*[cm]?m)\s*(?:/|per)\s*(?:rev|turn|revolution|U)\.?")
_MOVING = "velocities, rates and forces are numbers in ask:, in m/s, rad/s, N and N m"
_RPY = ("roll", "pitch", "yaw")
_MOVES = "Trans(0, 0, 0.1) Rot(z, 90°)"
NOTHING = Scope()
"""A scope without names, for values that must be constants."""


def parsed(scalar: PlacedScalar, scope: Scope) -> Expr:
    """The expression of a scalar.

    Raises:
        NotationError: It is none, has a sine of 30, which nobody means in radians, or is the pitch of a screw a turn.
    """
    if pitch := _A_TURN.fullmatch(scalar.text):
        message = f"{scalar.text} says for each turn, which a pitch is anyway"
        raise NotationError(Problem(message, scalar.place, f"write {pitch[1]}"))
    return parse(scalar.text, scope, scalar.place_of(0))


def read_value(  # noqa: PLR0913  what may be said of a value
    problems: Problems,
    scalar: PlacedScalar,
    key: str,
    *,
    is_angle: bool,
    scope: Scope = NOTHING,
    remarks: list[str] | None = None,
    unit: str = "",
) -> Angle | Expr | None:
    """A scalar as an angle, whose unit must be written, or as a length [m]; None if it is neither.

    Args:
        problems: Where to note what is wrong.
        scalar: The text with its place.
        key: What to call it in a message.
        is_angle: Which of the two is wanted.
        scope: The names it may use.
        remarks: Where to say that 1.5708 rad was taken as 90°; without it such angles are taken as they stand.
        unit: The unit of a bare length; empty for metres.
    """
    try:
        expr = parsed(scalar, scope)
        if not is_angle:
            return to_plain_length(with_unit(expr, unit))
        return to_angle(expr if remarks is None else taken_exactly(expr, key, remarks), bare="refuse")
    except NotationError as error:
        if other := _OTHER_UNIT.fullmatch(scalar.text):
            hint = "a share is a number: write 1/2 or 0.5" if other["unit"] == "%" else _MOVING
            problems.add(scalar.place, f"{key}: {other['unit']} is no unit of an angle or a length", hint)
        else:
            problems.take(error)
    except DimensionError as error:
        problems.add(scalar.place, f"{key}: {error.message}", error.hint)
    return None


def taken_exactly(expr: Expr, key: str, remarks: list[str]) -> Expr:
    """An angle with right angles in the place of their decimals in radians, and a remark on each."""
    found: list[str] = []
    expr = with_right_angles(expr, found)
    remarks += [type(remark)(f"{key}: {remark} (exact: false keeps it)") for remark in found]
    return expr


def read_moves(problems: Problems, node: PlacedNode, key: str) -> PlacedScalar | None:
    """The text of a product of moves; a matrix alone may be a list of its rows. None if it is neither."""
    if isinstance(node, PlacedScalar):
        return problems.scalar(node, key)
    rows = [_texts(item) for item in node.items] if isinstance(node, PlacedSequence) else []
    if isinstance(node, PlacedSequence) and rows and all(rows):
        least = min(map(len, rows))
        items = (PlacedSequence(problems.sequence(item, key, count=least), item.place) for item in node.items)
        return PlacedScalar(as_text(PlacedSequence(tuple(items), node.place)), node.place)
    shift = _texts(node)
    shown = f"Trans({', '.join(shift)})" if len(shift) == len(AXES) else _as_moves(node) or _MOVES
    problems.add(node.place, f"{key}: should be moves, is {node_kind(node)}", f"write {shown}")
    return None


def _as_moves(node: PlacedNode) -> str:
    """The moves of a mapping such as `{x: 0.1, z: 0.2, yaw: 90°}`; empty where it is none."""
    entries = node.entries if isinstance(node, PlacedMapping) else ()
    texts = {key.text: value.text or "0" for key, value in entries if isinstance(value, PlacedScalar)}
    if not entries or len(texts) < len(entries) or texts.keys() - {*AXES, *_RPY}:
        return ""
    moves = (("Trans", AXES), ("rpy", _RPY))
    return " ".join(
        f"{name}({', '.join(texts.get(key, '0') for key in keys)})" for name, keys in moves if texts.keys() & {*keys}
    )


def _texts(node: PlacedNode) -> list[str]:
    """The items of a list of texts; none where it is no such list."""
    items = node.items if isinstance(node, PlacedSequence) else ()
    texts = [item.text for item in items if isinstance(item, PlacedScalar) and item.text]
    return texts if len(texts) == len(items) else []


def has_unit_of_angle(scalar: PlacedScalar) -> bool:
    """Whether degrees, radians or π stand in a text; a text that cannot be read has none."""
    try:
        return has_angle_unit(parse(scalar.text, NOTHING))
    except NotationError:
        return False


def read_number(fields: Fields, key: str, hint: str = "") -> float | None:
    """A plain number, or a length in metres; None if it is not there. The hint says what to write in its place."""
    from dhcli.algebra.floats import Floats

    scalar = fields.scalar(key)
    if scalar is None:
        return None
    own = Problems()
    value = read_value(own, scalar, key, is_angle=False)
    for problem in own.found:
        named = problem.message if problem.message.startswith(f"{key}: ") else f"{key}: {problem.message}"
        fields.problems.add(problem.place or scalar.place, named, hint or problem.hint or "write a number")
    return Floats().value(value) if isinstance(value, Expr) else None


def read_degrees(fields: Fields, key: str) -> float | None:
    """An angle in degrees; None if it is not there."""
    from math import degrees

    scalar = fields.scalar(key)
    value = read_value(fields.problems, scalar, key, is_angle=True) if scalar else None
    return degrees(value.constant()) if isinstance(value, Angle) else None


def read_whole(fields: Fields, key: str) -> int | None:
    """A whole number below a thousand; None if it is not there."""
    scalar = fields.scalar(key)
    if scalar is None:
        return None
    if scalar.text.isdecimal() and scalar.text.isascii() and len(scalar.text) <= MOST_DIGITS:
        return int(scalar.text)
    fields.problems.add(scalar.place, f"{key}: '{scalar.text}' is not a whole number", "write 3")
    return None


def read_flag(fields: Fields, key: str) -> bool:
    """Yes or no, spelled true or false; no if it is not there."""
    scalar = fields.scalar(key)
    word = "false" if scalar is None else scalar.text.lower()
    if scalar is not None and word not in FLAGS:
        message = f"{key}: should be true or false, is '{scalar.text}'"
        fields.problems.add(scalar.place, message, f"write {key}: true, or leave it out")
    return FLAGS.get(word, False)


def read_word(fields: Fields, key: str, words: Collection[str], hint: str = "") -> str:
    """One of some words; empty if it is not there, or none of them, which is told. The hint says what to write."""
    scalar = fields.scalar(key)
    if scalar is None or scalar.text in words:
        return "" if scalar is None else scalar.text
    hint = hint or did_you_mean(scalar.text, words)
    fields.problems.add(scalar.place, f"{key}: '{scalar.text:.60}' is not known", hint)
    return ""


def read_texts(fields: Fields, key: str) -> tuple[str, ...]:
    """The texts of a list."""
    found = (fields.problems.scalar(node, key) for node in fields.sequence(key))
    return tuple(scalar.text for scalar in found if scalar is not None)
