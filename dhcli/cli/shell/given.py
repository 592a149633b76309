"""What a person typed for joints, lengths, points and forms, as values."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from dhcli.cli.shell.joints import typed_joints
from dhcli.errors import DhcliError, Place, Problem, UnknownNameError, did_you_mean, plural
from dhcli.kinematics.frames import Point
from dhcli.kinematics.motors import in_motors
from dhcli.kinematics.moves import read_chain
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import given_parameters, parameter_values
from dhcli.notation.brackets import split
from dhcli.notation.dimensions import read_at
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle, to_length
from dhcli.notation.scope import OPEN, Scope

if TYPE_CHECKING:
    from dhcli.cli.shell.chosen import Chosen
    from dhcli.kinematics.moves import Chain


def robot_of(chosen: Chosen) -> Robot:
    """The robot that was typed, with the tool that was, and by its motors if they are meant.

    Raises:
        DhcliError: There is none, it has no such tool, or the frames named do not reach as far as the tool.
    """
    from dhcli.files.yaml.robots import load_robot

    arm = load_robot(chosen.robot, base=chosen.base, tip=chosen.tip, as_typed=chosen.as_typed)
    if chosen.tool is not None:
        arm = _with_tool(arm, chosen, chosen.tool)
    return in_motors(arm) if chosen.motors else arm


def _with_tool(arm: Robot, chosen: Chosen, tool: str) -> Robot:
    if chosen.to is not None and "tool" not in (chosen.from_, chosen.to):
        raise DhcliError(f"--tool is behind the last frame, and --to {chosen.to} does not reach it", "use --to tool")
    return replace(arm, tool=_tool(arm, tool.strip()))


def _tool(robot: Robot, typed: str) -> Chain:
    if typed in robot.tools:
        return robot.tools[typed]
    if typed.replace("-", "_").isidentifier():
        hint = did_you_mean(typed, robot.tools) or "write moves: --tool 'Trans(0,0,0.1)'"
        raise UnknownNameError(Problem(f"{robot.name} has no tool called {typed}", Place("--tool"), hint))
    return read_chain(typed, Scope(lengths=tuple(robot.parameters)), Place("--tool", text=typed))


def lengths_of(robot: Robot, chosen: Chosen, *, symbolic: bool = False) -> dict[str, Value]:
    """Values of lengths and constant angles: in symbols those typed, in numbers the robot's own too.

    Raises:
        DhcliError: In numbers one has no value, or what was typed is none.
    """
    take = given_parameters if symbolic else parameter_values
    settings = chosen.set_ or []
    return take(robot, settings_of(settings), Place("--set", text=" ".join(settings)))


def values_of(robot: Robot, chosen: Chosen, *, symbolic: bool = False) -> dict[str, Value]:
    """Values of joints and parameters: in symbols those typed, in numbers the robot's own lengths too."""
    q, pose = chosen.q, chosen.pose
    lengths = lengths_of(robot, chosen, symbolic=symbolic)
    posed = {} if pose is None else named_pose(robot, pose)
    joints = typed_joints(robot, q, chosen.bare)
    if q is not None and pose is not None and "=" not in q and len(joints) == len(robot.variables):
        raise DhcliError("--q and --pose both say where all joints are", "use one; --q NAME=VALUE varies a pose")
    return {**lengths, **posed, **joints}


def named_pose(robot: Robot, name: str) -> dict[str, Value]:
    """The joint values of a named pose."""
    if name not in robot.poses:
        hint = did_you_mean(name, robot.poses) or (
            f"poses: {', '.join(robot.poses)}" if robot.poses else f"{robot.name} has no named poses; use --q"
        )
        raise UnknownNameError(Problem(f"{robot.name} has no pose called {name}", Place("--pose"), hint))
    return dict(zip(robot.variables, robot.poses[name], strict=True))


def settings_of(settings: Sequence[str]) -> dict[str, str]:
    """`NAME=VALUE` options by name; several may stand in one, between commas."""
    given: dict[str, str] = {}
    for setting in settings:
        parts = setting.split(",") if setting.count("=") == setting.count(",") + 1 else [setting]
        for part in parts:
            name, equals, text = part.partition("=")
            if not equals or not name.strip() or not text.strip():
                raise DhcliError(Problem(f"{part} is not NAME=VALUE", Place("--set"), "write --set l1=0.4 or l1=400mm"))
            if canonical(name.strip()) in map(canonical, given):
                raise DhcliError(Problem(f"{name.strip()} is set twice", Place("--set")))
            given[name.strip()] = text
    return given


def point_of(text: str, option: str, scope: Scope = OPEN) -> Point:
    """Three coordinates, `x, y, z`; names that are not known stay free."""
    pieces = list(split(text))
    place = Place(option, text=text)
    if len(pieces) != 3:  # noqa: PLR2004
        count = plural(len(pieces), "coordinate")
        raise DhcliError(
            Problem(f"a point has three coordinates, {text!r} has {count}", place, f"write {option} 0,0,0.1")
        )
    places = (replace(place, column=offset + 1) for offset, _ in pieces)
    x, y, z = (read_at(at, to_length, parse(piece, scope, at)) for at, (_, piece) in zip(places, pieces, strict=True))
    return x, y, z


def angle_of(text: str, option: str) -> float:
    """An angle without names, in radians where no unit stands [rad]."""
    place = Place(option, text=text)
    angle = read_at(place, to_angle, parse(text, OPEN, place))
    if angle.names:
        raise DhcliError(Problem(f"{', '.join(sorted(angle.names))} is no number", place, f"write {option} 0.01°"))
    return angle.constant()


def open_scope(robot: Robot) -> Scope:
    """The names of a robot, and any other name for itself."""
    return replace(robot.scope, is_open=True)


def names_of(text: str, option: str) -> tuple[str, ...]:
    """Names between commas: `l1, reach`."""
    names = tuple(dict.fromkeys(name.strip() for name in text.split(",") if name.strip()))
    for name in names:
        if not name.replace("_", "a").replace("{", "").replace("}", "").isalnum() or not name[0].isalpha():
            raise DhcliError(
                Problem(f"{name!r:.60} is not a name", Place(option, text=text), f"write {option} l1,reach")
            )
    return names


def forms_of(texts: Iterable[str]) -> tuple[str, ...]:
    """`--as rpy,position --as quaternion` as one list, each once."""
    return tuple(dict.fromkeys(form.strip() for text in texts for form in text.split(",")))


def product_of(words: Sequence[str]) -> tuple[str, Place]:
    """The product that was typed, or that stands on standard input."""
    if list(words) != ["-"]:
        return " ".join(words), Place("product")
    from dhcli.files.reading import read_text, source_of

    return read_text("-"), Place(source_of("-"))
