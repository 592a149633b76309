"""Forces, moments, velocities and rates as people type them: numbers between commas, with the right unit or none."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from dhcli.cli.shell.given import open_scope
from dhcli.errors import DhcliError, Place, Problem, plural
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.view import check_rates
from dhcli.notation.brackets import split
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import PI, Expr, Unit, multiply, number
from dhcli.notation.walk import walk
from dhcli.regex import regex

FORCE = {"N": number(1), "kN": number(1000)}
MOMENT = {
    "N m": number(1),
    "N cm": number(Fraction(1, 100)),
    "N mm": number(Fraction(1, 1000)),
    "kN m": number(1000),
}
SPEED = {"m/s": number(1), "cm/s": number(Fraction(1, 100)), "mm/s": number(Fraction(1, 1000))}
DEGREES = multiply(PI, number(Fraction(1, 180)))
TURNING = {"rad/s": number(1), "°/s": DEGREES, "deg/s": DEGREES}

_MOMENT = regex(r"(k?N)\s*[*·]?\s*(mm|cm|m)")
"""A unit of a moment, `Nm`, `N*m`, `N·mm`."""

_OTHER = regex(r".*\d\s*(?P<unit>kg|kgf|g|lbf?|km/h|mph|ft/s|in/s|rpm|rev/s|J)")
"""A number with a unit of something else."""

_BESIDE = {"--force": "--moment", "--velocity": "--angular"}
"""Where the other three of six numbers stand."""

KNOWN = (FORCE, MOMENT, SPEED, TURNING)


def vector_of(text: str, option: str, units: Mapping[str, Expr], robot: Robot) -> tuple[Expr, Expr, Expr]:
    """Three numbers, or names, between commas.

    Args:
        text: What was typed.
        option: Where.
        units: The units it may have, the first of them where it has none, and what each is worth.
        robot: The robot, whose names may stand in it.

    Raises:
        DhcliError: There are not three, or one has another unit.
        NotationError: One cannot be read.
    """
    pieces = list(split(text))
    place = Place(option, text=text)
    if len(pieces) != 3:  # noqa: PLR2004
        message = f"three numbers are wanted, {text!r} has {plural(len(pieces), 'number')}"
        own = next(iter(units))
        hint = f"write {option} 0,0,10: along x, y and z, in {own}"
        if len(pieces) == 6 and option in _BESIDE:  # noqa: PLR2004
            first, last = (",".join(piece.strip() for _, piece in part) for part in (pieces[:3], pieces[3:]))
            hint = f"write {option} {first} {_BESIDE[option]} {last}"
        raise DhcliError(Problem(message, place, hint))
    scope = open_scope(robot)
    x, y, z = (_read(piece, units, scope, replace(place, column=offset + 1)) for offset, piece in pieces)
    return x, y, z


def rates_of(text: str, robot: Robot, joints: Sequence[str]) -> tuple[Expr, ...]:
    """A rate for each joint, in rad/s, or m/s of a slide.

    Raises:
        DhcliError: There are too many or too few, or one has another unit.
        NotationError: One cannot be read.
    """
    pieces = list(split(text))
    place = Place("--rates", text=text)
    check_rates(pieces, joints, place)
    scope = open_scope(robot)
    found = []
    for joint, (offset, piece) in zip(joints, pieces, strict=True):
        units = TURNING if joint in robot.angles else SPEED
        found.append(_read(piece, units, scope, replace(place, column=offset + 1)))
    return tuple(found)


def _read(text: str, units: Mapping[str, Expr], scope: Scope, place: Place) -> Expr:
    own = next(iter(units))
    bare, worth = _MOMENT.sub(r"\1 \2", text.strip()), units[own]
    for name, value in sorted(((n, v) for known in KNOWN for n, v in known.items()), key=lambda unit: -len(unit[0])):
        before = bare.removesuffix(name).rstrip()
        if before != bare and before[-1:].isdigit():
            if name not in units:
                raise DhcliError(Problem(f"{text.strip()} is in {name}, and {own} is wanted", place, _hint(units)))
            bare, worth = before, value
            break
    other = _OTHER.fullmatch(bare)
    if other and other["unit"] not in scope.names:
        raise DhcliError(Problem(f"{text.strip()} is in {other['unit']}, and {own} is wanted", place, _hint(units)))
    expr = parse(bare, scope, place)
    if unit := next((node.name for node in walk(expr) if isinstance(node, Unit)), ""):
        raise DhcliError(Problem(f"{text.strip()} is in {unit}, and {own} is wanted", place, _hint(units)))
    return multiply(expr, worth)


def _hint(units: Mapping[str, Expr]) -> str:
    return f"units: {', '.join(units)}; a bare number is in {next(iter(units))}"
