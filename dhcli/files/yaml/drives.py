"""The key `actuators` of a robot file: motors with their limits, and which of them drive which joints."""

from __future__ import annotations

from dhcli.errors import NotationError, Place, Problem, RobotError, did_you_mean
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedScalar, PlacedSequence
from dhcli.files.yaml.typed import has_unit_of_angle, read_value
from dhcli.frozen import frozen
from dhcli.kinematics.actuators import Actuators
from dhcli.kinematics.derived import Value
from dhcli.kinematics.description import Description
from dhcli.kinematics.drives import Drive, actuators, read_drive
from dhcli.kinematics.validity import A_NAME
from dhcli.notation.names import canonical
from dhcli.notation.parser import RESERVED, parse
from dhcli.notation.quantity import UNITS, with_unit
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import is_name
from dhcli.regex import regex

_A_TURN = regex(r"/\s*(\d+(?:\.\d+)?)\s*(°|deg\b)")
"""`20 mm / 360°`, which a person reads as millimetres for a turn."""

_EXAMPLE = "motors: {m2: [-60°, 76°], m3: [-70°, 200°]}, then theta2: m2 and theta3: m3 + m2"

Limits = tuple[Value, Value] | None


@frozen
class _Known:
    """What a formula of a drive may name."""

    robot: Description
    motors: dict[str, Limits]
    joints: dict[str, bool]
    unit: str


def read_drives(fields: Fields, robot: Description, unit: str) -> Actuators | None:
    """The motors of a robot, None if they cannot be read; problems are noted."""
    problems = fields.problems
    before = len(problems.found)
    inside = fields.mapping("actuators", example=_EXAMPLE)
    motors = _motors(inside, robot, unit)
    joints = {joint.name: joint.kind == "revolute" for joint in robot.joints}
    known = _Known(robot, motors, joints, unit)
    drives: dict[str, Drive] = {}
    for key, (name, _) in inside.entries.items():
        if key == "motors" or key.startswith("x-"):
            continue
        if key not in joints:
            hint = did_you_mean(key, (*joints, "motors"))
            problems.add(name.place, f"actuators: {key} is no joint of this robot", hint)
            continue
        scalar = inside.scalar(key)
        drive = None if scalar is None else _drive(problems, scalar, key, known)
        if drive is not None:
            drives[key] = drive
    if "motors" not in inside:
        problems.add(fields.place_of("actuators"), "actuators: motors is missing", _EXAMPLE)
    if len(problems.found) > before:
        return None
    try:
        return actuators(joints, drives, motors)
    except RobotError as error:
        place = fields.place_of("actuators")
        problems.found += [Problem(f"actuators: {p.message}", place, p.hint) for p in error.problems]
        return None


def _motors(inside: Fields, robot: Description, unit: str) -> dict[str, Limits]:
    """The motors, with their limits where the file gives them."""
    problems = inside.problems
    node = inside.get("motors")
    if isinstance(node, PlacedSequence):
        names = [scalar for item in node.items if (scalar := problems.scalar(item, "motors")) is not None]
        found: dict[str, Limits] = {scalar.text: None for scalar in names}
        places = {scalar.text: scalar.place for scalar in names}
    else:
        listed = inside.mapping("motors", example="{m2: [-60°, 76°], m3: [-70°, 200°]}")
        found = {key: _limits(listed, key, unit) for key in listed.entries}
        places = {key: listed.place_of(key) for key in listed.entries}
    taken = {canonical(name): name for name in (*robot.variables, *robot.parameters)}
    for name, place in places.items():
        _check_name(problems, name, place, taken)
        taken[canonical(name)] = name
    return found


def _check_name(problems: Problems, name: str, place: Place, taken: dict[str, str]) -> None:
    if not is_name(name):
        problems.add(place, f"motors: {name!r:.60} is not a name", A_NAME)
    elif name in RESERVED or name in UNITS:
        problems.add(place, f"motors: {name} has a meaning of its own", "choose another name, such as m1")
    elif canonical(name) in taken:
        problems.add(place, f"motors: {name} is used twice", f"{taken[canonical(name)]} is declared already")


def _limits(listed: Fields, key: str, unit: str) -> Limits:
    node = listed.get(key)
    if isinstance(node, PlacedScalar) and not node.text and not node.quoted:
        return None
    scalars = [listed.problems.scalar(item, key) for item in listed.sequence(key, "[-60°, 76°]", count=2)]
    is_angle = any(scalar is not None and has_unit_of_angle(scalar) for scalar in scalars)
    known = (scalar for scalar in scalars if scalar is not None)
    values = [read_value(listed.problems, scalar, key, is_angle=is_angle, unit=unit) for scalar in known]
    if len(values) != 2:  # noqa: PLR2004  lowest and highest
        if values:
            listed.problems.add(listed.place_of(key), f"{key}: two values are wanted", "write [lowest, highest]")
        return None
    low, high = values
    return None if low is None or high is None else (low, high)


def _drive(problems: Problems, scalar: PlacedScalar, key: str, known: _Known) -> Drive | None:
    """What a joint is driven by; None if it cannot be read."""
    names = (*known.motors, *known.robot.variables, *known.robot.parameters)
    turns = known.joints[key]
    try:
        expr = parse(_A_TURN.sub(r"/(\1\2)", scalar.text), Scope(lengths=names), scalar.place_of(0))
        expr = expr if turns else with_unit(expr, known.unit)
        return read_drive(expr, tuple(known.motors), known.robot.variables, turns=turns)
    except NotationError as error:
        problems.take(error)
    except RobotError as error:
        problems.found += [Problem(f"{key}: {p.message}", scalar.place, p.hint) for p in error.problems]
    return None
