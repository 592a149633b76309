"""Values of joints and lengths: what people type, what a robot knows, and what is missing."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeAlias

from dhcli.errors import NotationError, Place, Problem, RobotError, did_you_mean, plural
from dhcli.kinematics.derived import Value, in_floats, replaced
from dhcli.kinematics.description import Description
from dhcli.kinematics.given import mapping_of, real
from dhcli.kinematics.moves import Chain, names
from dhcli.notation.angle import Angle
from dhcli.notation.brackets import OPENING, split
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.quantity import Bare, DimensionError, to_angle, to_plain_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, decimal
from dhcli.notation.walk import symbols
from dhcli.regex import regex

if TYPE_CHECKING:
    from numpy.typing import NDArray

Values: TypeAlias = Mapping[str, Value]
"""Value of each name: exact angles, and lengths in metres."""

JointInput: TypeAlias = "str | Sequence[float | str | Angle] | NDArray[Any] | Mapping[str, float | str | Angle] | None"
"""What a caller may give for the joints: text, a list or an array in joint order, a mapping by name, or nothing."""

_ASSIGNS = regex(r"[=:]")
_PENDANT = regex(r"\A(?:(?i:j|joint|axis|rax)[ _]?|A)(?=[0-9])")
"""How makers number joints: `J1`, `Joint 1`, `A1`, `rax_1`."""
_ONE_VALUE = regex(r"([^\s=:,;]+[=:])?[-+−–]?(\d|\.|√|π|pi|\()[^\s;]*(?<!,)")  # noqa: RUF001
"""A value without a blank in it, or a name with one."""


def joint_values(
    robot: Description, q: JointInput, *, bare: Bare = "rad", place: Place | None = None
) -> dict[str, Value]:
    """Values of the joints that are given, in whatever form.

    Args:
        robot: The robot.
        q: `"0.3, 30°, 432mm"`, `"theta1=30°, d3=0.1"`, the name of a pose, a list in joint order, or a mapping.
        bare: What a number without a unit means for a revolute joint; prismatic ones are metres.
        place: Where a text comes from, for errors.

    Raises:
        RobotError: Too few or too many values, an unknown joint, NaN.
        NotationError: A value that cannot be read, with its column.
    """
    if q is None:
        return {}
    if isinstance(q, str):
        return _from_text(robot, q, bare, place or Place("q"))
    if isinstance(q, Mapping):
        return {
            (joint := joint_called(robot, name, place)): _value(robot, joint, value, bare, place)
            for name, value in mapping_of(q, "q").items()
        }
    try:
        given = list(q)
    except TypeError:
        raise RobotError(Problem(f"{q!r} is no list of joint values", place, _joints_hint(robot, place))) from None
    _check_count(robot, len(given), place)
    return {n: _value(robot, n, v, bare, place) for n, v in zip(robot.variables, given, strict=True)}


def given_parameters(
    robot: Description, given: Mapping[str, float | str | Value] | None, place: Place | None = None
) -> dict[str, Value]:
    """Values of those lengths and constant angles that a person gives.

    Raises:
        RobotError: An unknown name.
        NotationError: A value that cannot be read.
    """
    named = {
        _parameter(robot, name, place): value
        for name, value in mapping_of({} if given is None else given, "parameters").items()
    }
    return {name: _value(robot, name, value, "refuse", place) for name, value in named.items()}


def parameter_values(
    robot: Description, given: Mapping[str, float | str | Value] | None, place: Place | None = None
) -> dict[str, Value]:
    """Values of all lengths and constant angles that have one: the robot's own, and those given instead.

    What follows from those given follows; see `derived`.
    """
    instead = given_parameters(robot, given, place)
    try:
        return replaced(robot.derived, robot.parameters, instead)
    except DimensionError as error:
        raise RobotError(Problem(f"with these values: {error.message}", place, error.hint)) from None


def require(robot: Description, chain: Chain, values: Mapping[str, object]) -> None:
    """Make sure that every name of a chain has a value.

    Raises:
        RobotError: Naming all that are missing, and how to give them.
    """
    missing = names(chain) - values.keys()
    joints = [name for name in robot.variables if name in missing]
    lengths = sorted(missing - set(joints))
    problems = []
    if joints:
        problems.append(
            Problem(f"no value for {', '.join(joints)}", None, f"{_joints_hint(robot, Place('--q'))}; or --symbolic")
        )
    if lengths:
        hint = " ".join(f"--set {name}={'30°' if name in robot.angles else '0.4'}" for name in lengths)
        have = "has" if len(lengths) == 1 else "have"
        problems.append(Problem(f"{', '.join(lengths)} of {robot.name} {have} no value", None, f"give one: {hint}"))
    if problems:
        raise RobotError(problems)


def symbols_of(value: Value) -> frozenset[str]:
    """Names that a value still holds."""
    return value.names if isinstance(value, Angle) else symbols(value)


def numbers(values: Values) -> dict[str, Angle | float]:
    """The same values for the arithmetic of floats."""
    return {name: value if isinstance(value, Angle) else in_floats(value) for name, value in values.items()}


def read_named(robot: Description, name: str, text: str, *, bare: Bare, place: Place) -> Value:
    """Read the value of one name, an angle or a length by what the name stands for."""
    expr = parse(text, Scope(), place)
    try:
        if name in robot.angles:
            return to_angle(expr, bare=bare)
        return to_plain_length(expr)
    except DimensionError as error:
        joint = next((j for j in robot.joints if j.name == name), None)
        kind = f", and {name} {'turns' if joint.kind == 'revolute' else 'slides'}" if joint else f", for {name}"
        raise NotationError(Problem(error.message + kind, place, error.hint)) from None


def joint_called(robot: Description, name: str, place: Place | None = None) -> str:
    """The joint variable that a person means: `θ1`, `theta_1`, `q1` and, as pendants write it, `J1` or `A1` are theta1.

    A name that a joint has where the robot comes from, `shoulder_pan_joint` of a URDF, comes before all others.

    Raises:
        RobotError: There is no such joint; the hint has the nearest.
    """
    if (known := next((joint for joint, own in robot.called.items() if own == name.strip()), None)) is not None:
        return known
    counted = _PENDANT.sub("q", name)
    for candidate in (canonical(name), robot.scope.aliases.get(canonical(counted), "")):
        for variable in robot.variables:
            if canonical(variable) == canonical(candidate):
                return variable
    hint = did_you_mean(name, (*robot.variables, *robot.called.values())) or did_you_mean(name, robot.variables)
    raise RobotError(Problem(f"{robot.name} has no joint {name:.60}", place, hint))


def _from_text(robot: Description, text: str, bare: Bare, place: Place) -> dict[str, Value]:
    if text.strip() in robot.poses:
        return dict(zip(robot.variables, robot.poses[text.strip()], strict=True))
    parts = list(_split(text))
    if len(parts) != len(robot.variables):
        parts = _between_blanks(robot, text) or parts
    if any(_ASSIGNS.search(part) for _, part in parts):
        return _assignments(robot, parts, text, bare, place)
    if len(parts) == 1 and not parts[0][1]:
        parts = []
    if len(parts) == 1 and len(robot.variables) != 1 and parts[0][1].strip().replace("_", "a").isidentifier():
        hint = did_you_mean(parts[0][1].strip(), robot.poses) or _joints_hint(robot, place)
        raise RobotError(Problem(f"{robot.name} has no pose called {text.strip()}", place, hint))
    _check_count(robot, len(parts), place)
    return {
        name: read_named(robot, name, part, bare=bare, place=_at(place, text, offset))
        for name, (offset, part) in zip(robot.variables, parts, strict=True)
    }


def _assignments(
    robot: Description, parts: list[tuple[int, str]], text: str, bare: Bare, place: Place
) -> dict[str, Value]:
    values: dict[str, Value] = {}
    for offset, part in parts:
        sign = _ASSIGNS.search(part)
        where = _at(place, text, offset)
        if sign is None:
            raise RobotError(Problem(f"{part.strip()} has no name", where, "write q1=0.3, q2=0.5, or only values"))
        joint = joint_called(robot, part[: sign.start()].strip().strip('"'), where)
        if joint in values:
            raise RobotError(Problem(f"{joint} is given twice", where))
        start, value = _stripped(part[sign.end() :], offset + sign.end())
        values[joint] = read_named(robot, joint, value, bare=bare, place=_at(place, text, start))
    return values


def _split(text: str) -> Iterator[tuple[int, str]]:
    """Pieces between commas or semicolons outside brackets, with their offsets; brackets around all are left out."""
    start, end = 0, len(text)
    if (bracket := text.strip()[:1]) in ("[", "{"):
        start, end = text.index(bracket) + 1, len(text.rstrip().removesuffix(OPENING[bracket]))
    for at, piece in split(text[start:end]):
        yield _stripped(piece, start + at)


def _between_blanks(robot: Description, text: str) -> list[tuple[int, str]]:
    """A value for each joint with only blanks or semicolons between them, with offsets; nothing if it is not that.

    `0.3 30° 0,1` and `0,3; 0,5; 0,1`: a comma between such values is a decimal one.
    """
    inner = re.sub(r"^\s*\[|\]\s*$", " ", text)
    pieces = [(found.start(), found[0]) for found in re.finditer(r"[^\s;]+", inner)]
    named = all(_ASSIGNS.search(piece) for _, piece in pieces)
    if not all(_ONE_VALUE.fullmatch(piece) for _, piece in pieces):
        return []
    return pieces if len(pieces) > 1 and (named or len(pieces) == len(robot.variables)) else []


def _stripped(piece: str, offset: int) -> tuple[int, str]:
    """A piece without the blanks before it, and where it begins."""
    bare = piece.lstrip()
    return offset + len(piece) - len(bare), bare


def _at(place: Place, text: str, offset: int) -> Place:
    return Place(place.source, place.line, (place.column or 1) + offset, place.text or text)


def _value(robot: Description, name: str, value: float | str | Value, bare: Bare, place: Place | None) -> Value:
    if isinstance(value, Angle | Expr):
        return value
    if isinstance(value, str):
        return read_named(robot, name, value, bare=bare, place=place or Place(name))
    try:
        number = real(value)
    except (TypeError, ValueError):
        hint = "forward_batch takes a row for each pose" if isinstance(value, Iterable) else ""
        raise RobotError(Problem(f"{name} wants one number, not {value!r:.60}", place, hint)) from None
    except OverflowError:
        raise RobotError(Problem(f"{name} is beyond what a float can hold", place)) from None
    if not math.isfinite(number):
        raise RobotError(Problem(f"{name} = {number} is not a number that a joint can have", place))
    exact = Fraction(repr(number))  # 0.1 is a tenth, as it was typed, and not the binary fraction nearest to it
    if name not in robot.angles:
        return decimal(exact)
    return Angle(degrees=exact) if bare == "deg" else Angle(radians=exact)


def _parameter(robot: Description, name: str, place: Place | None) -> str:
    for parameter in robot.parameters:
        if canonical(parameter) == canonical(name):
            return parameter
    if canonical(name) in {canonical(variable) for variable in robot.variables}:
        raise RobotError(Problem(f"{name} is a joint of {robot.name}", place, f"write --q {name}=..."))
    hint = did_you_mean(name, robot.parameters) or "it has no lengths to set"
    raise RobotError(Problem(f"{robot.name} has no length called {name}", place, hint))


def _check_count(robot: Description, count: int, place: Place | None) -> None:
    wanted = len(robot.variables)
    if count != wanted:
        message = f"{robot.name} has {plural(wanted, 'joint')}, {plural(count, 'value')} given"
        raise RobotError(Problem(message, place, _joints_hint(robot, place)))


def _joints_hint(robot: Description, place: Place | None) -> str:
    """What the joints want: by `--q` where it was typed, and for a program without a word of the command line."""
    is_typed = place is not None and place.source.startswith("--")
    if not robot.variables:
        return "it has no joint: leave --q out" if is_typed else "it has no joint: leave q out"
    kinds = {joint.name: "rad" if joint.kind == "revolute" else "m" for joint in robot.joints}
    listed = ", ".join(f"{name} [{kinds.get(name, '')}]" for name in robot.variables)
    return f"--q takes {listed}" if is_typed else f"wanted: {listed}"


def size(given: object, what: str) -> float:
    """A number that is 0 or positive.

    Raises:
        RobotError: It is none.
    """
    try:
        found = float(given) if not isinstance(given, str | bytes | bool) else math.nan  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        found = math.nan
    if not 0 <= found < math.inf:
        raise RobotError(f"{what} is 0 or a positive number, not {given!r:.60}")
    return found
