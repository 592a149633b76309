"""Drives as they are written, each joint a sum of multiples of motor values, and the motors that they make."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from dhcli.errors import RobotError, did_you_mean, plural
from dhcli.frozen import frozen
from dhcli.kinematics.actuators import ZERO, Actuators, inverse
from dhcli.kinematics.derived import Value, in_floats
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS
from dhcli.notation.tree import Expr, Number, Power, Product, Sum, Symbol, Unit
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

DEGREES = ("deg", "degree", "degrees")


@frozen
class Drive:
    """What a joint is driven by, as it was read.

    Attributes:
        ratios: What each motor's value is multiplied with, and whether that is a length for an angle.
        shift: What is added [deg or m].
    """

    ratios: Mapping[str, tuple[Fraction, bool]]
    shift: Fraction


def read_drive(expr: Expr, motors: Sequence[str], joints: Sequence[str], *, turns: bool) -> Drive:
    """A joint in terms of motors: `m3 + m2`, `-m4/76.04`, `(m3 - m4) * 20 mm/(360°)`.

    Raises:
        RobotError: It is no sum of multiples of motors, or a ratio is no number.
    """
    ratios: dict[str, tuple[Fraction, bool]] = {}
    shift = ZERO
    for name, size, angles, lengths in _terms(expr, motors, joints):
        if not name:
            if size and (angles, lengths) not in (
                {(1, 0)} if turns else {(0, 1), (0, 0)}
            ):  # a bare length is in metres
                raise RobotError("what is added is no " + ("angle" if turns else "length"), "write m2 + 90°, or 20 mm")
            shift += size
            continue
        if (angles, lengths) not in {(0, 0), (-1, 1)} or (lengths and turns):
            wanted = "a number" if turns else "a number, or a length for an angle: 20 mm/(360°)"
            raise RobotError(f"the ratio of {name} is {wanted}")
        if name in ratios and ratios[name][1] != bool(lengths):
            raise RobotError(f"{name} turns and slides here", "a motor does one of the two")
        ratios[name] = (ratios.get(name, (ZERO, False))[0] + size, bool(lengths))
    return Drive(ratios, shift)


def _terms(expr: Expr, motors: Sequence[str], joints: Sequence[str]) -> list[tuple[str, Fraction, int, int]]:
    """A sum as motor, factor, and the powers of angle and length that the factor has."""
    if isinstance(expr, Sum):
        return [term for part in expr.terms for term in _terms(part, motors, joints)]
    found = [("", Fraction(1), 0, 0)]
    for factor in expr.factors if isinstance(expr, Product) else (expr,):
        new = _terms(factor, motors, joints) if isinstance(factor, Sum) else [_leaf(factor, motors, joints)]
        if any(name for name, *_ in found) and any(name for name, *_ in new):
            raise RobotError("it is not linear in the motors", "write a sum of multiples of them")
        found = [
            (name or other, size * factor, angles + turn, lengths + length)
            for name, size, angles, lengths in found
            for other, factor, turn, length in new
        ]
    return found


def _leaf(expr: Expr, motors: Sequence[str], joints: Sequence[str]) -> tuple[str, Fraction, int, int]:
    match expr:
        case Number(value):
            return "", Fraction(value), 0, 0
        case Symbol(name) if name in motors:
            return name, Fraction(1), 0, 0
        case Symbol(name) if name in joints:
            raise RobotError(f"{name} is a joint, and joints are driven by motors", f"motors: {', '.join(motors)}")
        case Symbol(name):
            raise RobotError(f"a ratio is a number, and {name} is a letter", "write its value: 76.04, or 1/76.04")
        case Unit(name) if name in DEGREES:
            return "", Fraction(1), 1, 0
        case Unit(name) if name in LENGTH_UNITS:
            return "", LENGTH_UNITS[name], 0, 1
        case Power(base, exponent) if exponent.denominator == 1 and not symbols(base):
            _, size, angles, lengths = _leaf(base, motors, joints)
            count = int(exponent)
            return "", size**count, angles * count, lengths * count
    if isinstance(expr, Unit) and expr.name in ANGLE_UNITS:
        raise RobotError("a ratio in radians is no exact number", "write the lead for a turn: 20 mm/(360°)")
    raise RobotError(f"{write(expr)} is no ratio", "ratios are numbers: m3 + m2, -m4/76.04")


def actuators(
    joints: Mapping[str, bool], drives: Mapping[str, Drive], motors: Mapping[str, tuple[Value, Value] | None]
) -> Actuators:
    """The motors of a robot.

    Args:
        joints: The joint variables in order, and whether each turns.
        drives: What those that are coupled are driven by; every other joint has a motor of its own, of its own name.
        motors: The motors, with their limits.

    Raises:
        RobotError: There are more motors than joints driven, or fewer; one drives nothing; joints depend on each other.
    """
    if len(motors) != len(drives):
        listed = f"{plural(len(motors), 'motor')}, {', '.join(motors)}, for {plural(len(drives), 'joint')}"
        raise RobotError(f"{listed}, {', '.join(drives)}", "as many motors as joints that they drive together")
    own = iter(motors)
    order = tuple(next(own) if joint in drives else joint for joint in joints)
    turning = {joint for joint, turns in joints.items() if turns}
    kinds = dict[str, bool]()
    for joint, drive in drives.items():
        for motor, (_, leads) in drive.ratios.items():
            turns = joints[joint] or leads
            if kinds.setdefault(motor, turns) != turns:
                raise RobotError(
                    f"{motor} turns for one joint and slides for another", "a slide has a lead: 20 mm/(360°)"
                )
    if idle := [motor for motor in motors if motor not in kinds]:
        raise RobotError(f"{idle[0]} drives no joint", did_you_mean(idle[0], motors) or "leave it out of motors")
    turning |= {motor for motor, turns in kinds.items() if turns}
    ratios, shifts = [], []
    for joint in joints:
        drive = drives.get(joint) or Drive({joint: (Fraction(1), False)}, ZERO)
        ratios.append(tuple(drive.ratios.get(motor, (ZERO, False))[0] for motor in order))
        shifts.append(drive.shift)
    for motor, limits in motors.items():
        _check_limits(motor, limits, turns=kinds[motor])
    inverse(ratios, tuple(joints))  # refuses joints that depend on each other
    kept = {motor: limits for motor, limits in motors.items() if limits is not None}
    return Actuators(tuple(joints), order, frozenset(turning), tuple(ratios), tuple(shifts), kept)


def _check_limits(motor: str, limits: tuple[Value, Value] | None, *, turns: bool) -> None:
    if limits is not None and in_floats(limits[0]) >= in_floats(limits[1]):
        raise RobotError(f"{motor}: the lower limit is not below the upper one", "write [lowest, highest]")
    for value in limits or ():
        if isinstance(value, Angle) != turns and value not in (Number(ZERO), Angle()):
            does, wanted = ("turns", "an angle: 90°") if turns else ("slides", "a length: 0.3 m")
            raise RobotError(f"{motor} {does}, and its limit is {wanted}")
