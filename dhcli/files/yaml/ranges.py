"""The values that an exercise may draw from: `20°..70° step 5°`, `20°..70° n 11`, or a list of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from dhcli.checking.written import Range
from dhcli.errors import NotationError, RobotError, did_you_mean
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedNode, PlacedScalar, PlacedSequence
from dhcli.files.yaml.typed import NOTHING, read_value
from dhcli.kinematics.ranges import read_count, split_range, spread, steps_between, times, total
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.quantity import LENGTH_UNITS, value_text
from dhcli.notation.tree import ZERO, Constant, Number, Unit
from dhcli.notation.walk import walk
from dhcli.regex import regex

MOST_VALUES = 10_000
LONGEST = 200
"""Characters of a range; nobody types more."""
_PLAIN = regex(r"[-+]?[0-9]{1,12}(?:\.[0-9]{0,12})?")
_BARE = regex(
    rf"\s*(?P<low>{_PLAIN.pattern})\s*\.\.\s*(?P<high>{_PLAIN.pattern})(?:\s+step\s+(?P<step>{_PLAIN.pattern}))?\s*"
)
"""A range of plain numbers, with its step or without."""
_ENDS = regex(r"(-?[0-9]{1,3})(?:°| ?deg)?\s*(?:\.\.+|…|to|-|–)\s*(-?[0-9]{1,3})(?:°| ?deg)?")  # noqa: RUF001  a dash
"""Two whole numbers of degrees in other words than those of a range."""
_SAME = {"deg": "°", "degree": "°", "degrees": "°", "radian": "rad", "radians": "rad", "inch": "in"}


def read_variants(
    fields: Fields, known: Sequence[str], is_angle: Callable[[str], bool], unit: Callable[[str], str]
) -> dict[str, Range]:
    """What varies, by name, from the key `variants` of an exercise.

    Args:
        fields: The fields of the exercise.
        known: Names that may vary: joints and parameters of the robot, and what is given.
        is_angle: Whether one of them is an angle.
        unit: The unit that must stand with the values of one, for a bare number would be another; empty if none must.
    """
    variants: dict[str, Range] = {}
    varying = fields.mapping("variants", example="{theta1: 20°..70° step 5°}")
    for written, (name, node) in varying.entries.items():
        key = next((own for own in known if canonical(own) == canonical(written)), written)
        if key not in known:
            message = f"variants: {key} is neither a joint nor a parameter of the robot, nor given"
            fields.problems.add(name.place, message, did_you_mean(key, tuple(dict.fromkeys(known))))
        elif (range_ := read_range(fields.problems, node, key, is_angle=is_angle(key), unit=unit(key))) is not None:
            variants[key] = range_
    return variants


def read_range(problems: Problems, node: PlacedNode, key: str, *, is_angle: bool, unit: str) -> Range | None:
    """The values under a name of `variants`; None if they cannot be read.

    Args:
        problems: Where to note what is wrong.
        node: A range as text, or a list of values.
        key: The name that varies.
        is_angle: Whether it is an angle; else it is a length or a number.
        unit: The unit that must stand with it; empty if none must.
    """
    if unit and not is_angle and (wanted := _with_unit(node, unit)):
        problems.add(node.place, f"{key}: a length without its unit, on a sheet in {unit}", f"write {wanted}")
        return None
    if isinstance(node, PlacedSequence):
        return _of_list(problems, node, key, is_angle=is_angle)
    scalar = problems.scalar(node, key)
    if scalar is None:
        return None
    written = split_range(scalar.text[:LONGEST], scalar.place_of)
    low, high, more = written.low, written.high, written.more
    if len(scalar.text) > LONGEST or high is None or more is None or not (low.text and high.text and more.text):
        example = "20°..70° step 5°" if is_angle else "100 mm..200 mm step 10 mm"
        if is_angle and (ends := _ENDS.fullmatch(scalar.text.strip())):
            example = f"{ends[1]}°..{ends[2]}° step 5°"
        problems.add(scalar.place, f"{key}: '{scalar.text:.60}' is no range", f"write {example}, or a list of values")
        return None
    stepped = written.word == "step"
    pieces = [
        PlacedScalar(piece.text, piece.place, scalar.quoted)
        for piece in ((low, high, more) if stepped else (low, high))
    ]
    values = [read_value(problems, piece, key, is_angle=is_angle) for piece in pieces]
    if None in values:
        return None
    if not all(isinstance(value, Angle | Number) for value in values):
        problems.add(scalar.place, f"{key}: a range goes from a number to a number", "write them out as a list")
        return None
    if len(units := {unit for piece in pieces for unit in _units(piece)}) > 1:
        listed = ", ".join(sorted(unit or "no unit" for unit in units))
        problems.add(scalar.place, f"{key}: the range mixes units: {listed}", "write all three in one unit")
        return None
    known = [value for value in values if value is not None]
    if stepped:
        return _of_steps(problems, scalar, key, pieces, known)
    counted = PlacedScalar(more.text, more.place)
    return _of_count(problems, scalar, key, counted, known)


def is_bare(text: str) -> bool:
    """Whether a text is a plain number other than 0, of which nobody can say in which unit it is meant."""
    return _PLAIN.fullmatch(text.strip()) is not None and float(text) != 0


def _with_unit(node: PlacedNode, unit: str) -> str:
    """A range or a list of bare numbers with the unit that is missing; empty where units stand, or only zeros."""
    if isinstance(node, PlacedSequence):
        texts = [item.text if isinstance(item, PlacedScalar) else "" for item in node.items]
        return f"[{', '.join(f'{text} {unit}' for text in texts)}]" if _are_bare(texts) else ""
    is_short = isinstance(node, PlacedScalar) and len(node.text) <= LONGEST
    found = _BARE.fullmatch(node.text) if is_short and isinstance(node, PlacedScalar) else None
    if found is None or not _are_bare([found["low"], found["high"]]):
        return ""
    return f"{found['low']} {unit}..{found['high']} {unit} step {found['step'] or 10} {unit}"


def _are_bare(texts: Sequence[str]) -> bool:
    """Whether all are plain numbers, and not all are 0."""
    return all(_PLAIN.fullmatch(text.strip()) for text in texts) and any(map(is_bare, texts))


def _of_steps(
    problems: Problems, scalar: PlacedScalar, key: str, pieces: list[PlacedScalar], values: list[Value]
) -> Range | None:
    """The values from the first to the last, both included."""
    first, last, step = values
    low_text, high_text, step_text = (piece.text for piece in pieces)
    if _amount(first) > _amount(last):
        problems.add(pieces[0].place, f"{key}: {low_text} is above {high_text}", f"write {high_text}..{low_text}")
        return None
    if _amount(step) <= 0:
        problems.add(pieces[2].place, f"{key}: the step is {step_text}", "a step leads upwards: step 5°")
        return None
    steps = steps_between(first, last, step)
    count = int(steps)
    if count != steps:
        below, above = (value_text(total(first, times(step, count + more))) for more in (0, 1))
        message = f"{key}: steps of {step_text} from {low_text} do not meet {high_text}"
        problems.add(pieces[2].place, message, f"end at {below} or at {above}")
        return None
    return _spread(problems, scalar, key, pieces[2], (first, last, count + 1))


def _of_count(
    problems: Problems, scalar: PlacedScalar, key: str, counted: PlacedScalar, values: list[Value]
) -> Range | None:
    """So many values from the first to the last, both included."""
    try:
        count = read_count(counted.text, counted.place, f"[{scalar.text.partition('..')[0].strip()}]")
    except RobotError as error:
        for problem in error.problems:
            problems.add(counted.place, f"{key}: {problem.message}", problem.hint)
        return None
    return _spread(problems, scalar, key, counted, (values[0], values[1], count))


def _spread(
    problems: Problems, scalar: PlacedScalar, key: str, last: PlacedScalar, values: tuple[Value, Value, int]
) -> Range | None:
    if values[2] > MOST_VALUES:
        problems.add(last.place, f"{key}: these are {values[2]:,} values", f"{MOST_VALUES:,} are enough")
        return None
    return Range(scalar.text, spread(*values))


def _of_list(problems: Problems, node: PlacedSequence, key: str, *, is_angle: bool) -> Range | None:
    scalars = [scalar for item in node.items if (scalar := problems.scalar(item, key)) is not None]
    values = [(scalar, read_value(problems, scalar, key, is_angle=is_angle)) for scalar in scalars]
    if not node.items:
        problems.add(node.place, f"{key}: the list is empty", "write [20°, 35°, 50°]")
    known: list[Value] = []
    for scalar, value in values:
        if value in known:
            problems.add(scalar.place, f"{key}: {scalar.text} stands twice", "delete one")
        elif value is not None:
            known.append(value)
    text = "[" + ", ".join(scalar.text for scalar in scalars) + "]"
    return Range(text, tuple(known)) if known else None


def _amount(value: Value) -> Rational:
    """An angle in degrees or radians, whichever it is in; a length in metres."""
    if isinstance(value, Angle):
        return value.degrees + value.radians
    return value.value if isinstance(value, Number) else 0


def _units(piece: PlacedScalar) -> Iterator[str]:
    """The unit of a bound, none for 0; π counts as one, for it is exact degrees and not radians."""
    try:
        nodes = tuple(walk(parse(piece.text, NOTHING)))
    except NotationError:
        return
    found = [_SAME.get(node.name, node.name) for node in nodes if isinstance(node, Unit)]
    if any(isinstance(node, Constant) for node in nodes):
        found = ["π", *(unit for unit in found if unit in LENGTH_UNITS)]
    if found or nodes[:1] != (ZERO,):
        yield from found or [""]
