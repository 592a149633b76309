"""Robots as the text of a file that loads, with the same numbers to the last digit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from dhcli.errors import DhcliError, RobotError
from dhcli.kinematics.conventions import ORDER, Convention
from dhcli.kinematics.describe.description import Described
from dhcli.kinematics.describe.drawn import Drawing
from dhcli.kinematics.describe.exact import exact_factor
from dhcli.kinematics.describe.linear import Point, coordinates_of
from dhcli.kinematics.describe.process import axis_word
from dhcli.kinematics.describe.products import end_of, pitch_of
from dhcli.kinematics.describe.screws import ScrewAxis
from dhcli.kinematics.moves import Chain, angle_names, product_text
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.angle import Angle, Rational, magnitude
from dhcli.notation.tree import Number, places_of
from dhcli.notation.writer import write, write_number
from dhcli.safe import yaml_scalar


def robot_text(robot: Robot) -> str:
    """The text of a file with a robot's table or products.

    Raises:
        RobotError: A motor turns and stands in lengths alone, behind a ball screw: a file would say that it slides.
    """
    if lost := sorted(robot.turning - angle_names(robot.chain)):
        message = f"{', '.join(lost)} would slide in a file: it turns, and stands in lengths alone"
        raise RobotError(message, "save the robot by its joints; its file holds the actuators")
    lines = [*_head(robot, robot.convention.value), *_parameters(robot)]
    if robot.first != 1:
        lines.append(f"first: {robot.first}")
    lines += _end("base", robot.base)
    lines += ["", f"# {ORDER[robot.convention].removeprefix('A_i = ')}", "links:"]
    for link in robot.links:
        if link.row is None or robot.convention is Convention.PRODUCT:
            lines.append(f"  - {_quoted(link.text or product(link.moves))}")
        else:
            cells = ", ".join(f"{column}: {cell(quantity(getattr(link.row, column)))}" for column in robot.columns)
            lines.append(f"  - {{{cells}}}")
    lines += [*_end("tool", robot.tool), *_tools(robot), *_limits(robot), *_motors(robot), *_poses(robot)]
    return _as_it_is(lines)


def save_robot(robot: Robot, path: str | Path, *, overwrite: bool = False) -> None:
    """Write a robot into a file that `load_robot` reads, a URDF where the name of the file ends so.

    Raises:
        FileError: The file exists already, or cannot be written.
        RobotError: It cannot be a URDF, or a motor would slide in the file that turns.
    """
    from dhcli.storage.atomic import write_whole

    if str(path).lower().endswith(".urdf"):
        from dhcli.files.urdf.writing import urdf_text

        write_whole(path, urdf_text(robot), overwrite=overwrite)
    else:
        write_whole(path, robot_text(robot), overwrite=overwrite)


def described_text(described: Described) -> str:
    """The text of a file with a robot in the description that was asked for.

    Raises:
        RobotError: It is axes or screws, of which each has a variable of its own in a file, and here some share one; or
            a joint of axes moves by another multiple of its variable than 1.
    """
    robot, drawing = described.robot, described.drawing
    if described.shared and described.form not in ("standard", "modified", "product"):
        message = (
            f"{next(iter(described.shared))} has no variable of its own, as in a file of {described.form} each has"
        )
        raise RobotError(message, "--as standard, modified or product writes the same motion")
    if described.screws and drawing is not None:
        frame = "space" if described.form == "screws" else "body"
        rows = [f"  - {{{screw.name}: ({', '.join(_six(screw))})}}" for screw in described.screws]
        body = [f"frame: {frame}", "# ω, then v", "screws:", *rows, f"home: {_quoted(product(end_of(drawing.end)))}"]
        return _drawn_text(robot, "screws", body)
    if described.form == "axes" and drawing is not None:
        if fast := next((line for line in drawing.lines if line.rate != 1), None):
            message = f"{fast.name} moves its joint by {fast.rate} of its own value, which a file of axes cannot say"
            raise RobotError(message, "--as screws, standard, modified or product writes the same motion")
        drawn = {line.name: line.drawn for line in drawing.lines if not _is_zero(line.drawn)}
        shown = ", ".join(f"{name}: {quantity(value, 'm')}" for name, value in drawn.items())
        rows = list(_axes(drawing))
        pose = [f"drawn: {{{shown}}}"] if drawn or "drawn" in robot.poses else []
        return _drawn_text(robot, "axes", [*pose, "axes:", *rows, f"end: {_quoted(product(end_of(drawing.end)))}"])
    return robot_text(robot)


def quantity(value: Value, unit: str = "") -> str:
    """An angle or a length as a file spells it, exactly."""
    if isinstance(value, Angle):
        return _angle(value)
    if isinstance(value, Number):
        text = _number(value.value)
        return f"{text} {unit}".rstrip() if value.value else "0"
    return write(value, "full")


def cell(text: str) -> str:
    """A text as a value between braces."""
    return yaml_scalar(text) if set(text) & set("{}[],'\":#") or not text.isprintable() else text


def product(moves: Chain) -> str:
    """A product of moves; where there is none, no translation."""
    return product_text(moves) or "Trans(0, 0, 0)"


def _drawn_text(robot: Robot, convention: str, body: list[str]) -> str:
    poses = {name: values for name, values in robot.poses.items() if name != "drawn" or convention != "axes"}
    lines = [*_head(robot, convention), *_parameters(robot), "", *body, *_limits(robot), *_motors(robot)]
    return _as_it_is([*lines, *_poses(robot, poses)])


def _as_it_is(lines: list[str]) -> str:
    """The text of a file that is read as it stands: 1.571 rad would be taken as 90°, unless the file says no."""
    from dhcli.files.yaml.robots import robot_of

    text = "\n".join(lines) + "\n"
    try:
        taken = robot_of(text, "text", "robot").remarks
    except DhcliError:
        return text  # whoever reads it says why
    head = next(line for line in lines if line.startswith("convention: "))
    return text.replace(f"\n{head}\n", f"\n{head}\nexact: false\n", 1) if taken else text


def _head(robot: Robot, convention: str) -> Iterator[str]:
    yield "format: 1"
    yield f"title: {_quoted(robot.title)}"
    yield f"source: {_quoted(robot.source)}"
    if not robot.notes.replace("\n", "").isprintable():
        yield f"notes: {yaml_scalar(robot.notes)}"
    elif robot.notes:
        yield "notes: |"
        yield from (f"  {line}".rstrip() for line in robot.notes.rstrip().split("\n"))
    yield ""
    yield f"convention: {convention}"
    yield f"variables: [{', '.join(map(cell, robot.variables))}]"
    if robot.called:
        yield "called:"
        yield from (f"  {cell(name)}: {yaml_scalar(own)}" for name, own in robot.called.items())


def _parameters(robot: Robot) -> Iterator[str]:
    shown = [f"{cell(name)}: {_parameter(robot, name)}".rstrip() for name in robot.parameters]
    if None in robot.parameters.values():
        yield from ("parameters:", *(f"  {entry}" for entry in shown))
    elif shown:
        yield f"parameters: {{{', '.join(shown)}}}"


def _parameter(robot: Robot, name: str) -> str:
    """A value, a formula where it follows from others, or nothing where it is open."""
    if name in robot.derived:
        return cell(write(robot.derived[name].expr, "full"))
    value = robot.parameters[name]
    return "" if value is None else quantity(value, "m")


def _end(name: str, chain: Chain) -> list[str]:
    return [f"{name}: {_quoted(product(chain))}"] if chain else []


def _tools(robot: Robot) -> Iterator[str]:
    if robot.tools:
        yield "tools:"
        yield from (f"  {cell(name)}: {_quoted(product(chain))}" for name, chain in robot.tools.items())


def _limits(robot: Robot) -> Iterator[str]:
    if robot.limits:
        yield ""
        yield "limits:"
        for name, (low, high) in robot.limits.items():
            yield f"  {name}: [{quantity(low, 'm')}, {quantity(high, 'm')}]"


def _motors(robot: Robot) -> Iterator[str]:
    """The coupled drives."""
    driven = robot.actuators
    if driven is None:
        return
    own = [motor for motor in driven.motors if motor not in driven.joints]
    limits = {name: f"[{', '.join(quantity(value, 'm') for value in pair)}]" for name, pair in driven.limits.items()}
    yield ""
    yield "actuators:"
    if limits:
        yield from ("  motors:", *(f"    {cell(motor)}: {limits.get(motor, '')}".rstrip() for motor in own))
    else:
        yield f"  motors: [{', '.join(map(cell, own))}]"
    yield from (f"  {sentence.replace(' = ', ': ', 1)}" for sentence in driven.sentences(exact=True))


def _poses(robot: Robot, poses: Mapping[str, tuple[Value, ...]] | None = None) -> Iterator[str]:
    named = robot.poses if poses is None else poses
    if named:
        yield ""
        yield "poses:"
        for name, values in named.items():
            yield f"  {cell(name)}: [{', '.join(quantity(value, 'm') for value in values)}]"


def _axes(drawing: Drawing) -> Iterator[str]:
    for line in drawing.lines:
        x, y, z = line.direction
        word = axis_word(line.direction)
        exact = (
            word if not word.startswith("(") else f"({', '.join(quantity(exact_factor(part)) for part in (x, y, z))})"
        )
        through = "" if line.through is None else f", through: {_point(line.through)}"
        kept = "" if line.turns or line.name.startswith("d") else ", slides: true"
        pitch = f", pitch: {quantity(pitch_of(line))}" if line.pitch else ""
        yield f"  - {{{line.name}: {exact}{through}{pitch}{kept}}}"


def _six(screw: ScrewAxis) -> Iterator[str]:
    yield from (quantity(exact_factor(part)) for part in screw.omega)
    yield from (quantity(expr) for expr in coordinates_of(screw.v))


def _point(point: Point) -> str:
    return f"({', '.join(quantity(expr) for expr in coordinates_of(point))})"


def _angle(angle: Angle) -> str:
    pieces = []
    for name, factor in angle.terms:
        size = "" if abs(factor) == 1 else f"{_number(magnitude(factor))}*"
        pieces.append(("-" if factor < 0 else "+", f"{size}{name}"))
    if angle.degrees:
        pieces.append(("-" if angle.degrees < 0 else "+", f"{_number(magnitude(angle.degrees))}°"))
    if angle.radians:
        pieces.append(("-" if angle.radians < 0 else "+", f"{_number(magnitude(angle.radians))} rad"))
    text = "".join(f" {sign} {piece}" for sign, piece in pieces).removeprefix(" + ")
    return ("-" + text.removeprefix(" - ") if text.startswith(" - ") else text) or "0"


def _number(value: Rational) -> str:
    """A decimal where one says it, else a fraction."""
    return write_number(value, places_of(value))


def _is_zero(value: Value) -> bool:
    return value.is_zero if isinstance(value, Angle) else isinstance(value, Number) and not value.value


def _quoted(text: str) -> str:
    """A text as a scalar of one line."""
    flat = " ".join(text.split())
    is_plain = (
        flat.isprintable() and flat[:1] not in "[{'\"&*!|>%@`-?:,#" and ": " not in f"{flat} " and " #" not in flat
    )
    return flat if flat and is_plain else yaml_scalar(flat)
