"""Coupled drives: joints moved by sums of multiples of motor values, exactly, and the way back.

Ratios are exact fractions in degrees and metres, so that a ball screw of 20 mm a turn has one, too: 1/18000 m for 1°.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError, did_you_mean, plural
from dhcli.frozen import frozen
from dhcli.kinematics.derived import Value
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS, value_text
from dhcli.notation.tree import PI, Expr, Number, Power, Product, Sum, Symbol, Unit, add, multiply, number, power
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

Row = tuple[Fraction, ...]
ZERO = Fraction(0)
DEGREES = ("deg", "degree", "degrees")


@frozen
class Actuators:
    """Which motors drive which joints, and how: q = ratios m + shifts.

    Attributes:
        joints: The joint variables in order, driven through gears or each by a motor of its own.
        motors: The motors in order, as many; one that drives a joint alone and directly has the joint's name.
        turning: The joints and motors that turn; the others slide.
        ratios: For each joint its motion for each motor's, in degrees or metres for a degree or metre.
        shifts: Where each joint stands when all motors stand at 0 [deg or m].
        limits: Lowest and highest value of motors.
    """

    joints: tuple[str, ...]
    motors: tuple[str, ...]
    turning: frozenset[str]
    ratios: tuple[Row, ...]
    shifts: Row
    limits: Mapping[str, tuple[Value, Value]] = field(default_factory=dict, hash=False)

    @property
    def formulas(self) -> dict[str, Value]:
        """Each joint in terms of the motors."""
        return {joint: self._formula(joint, *self._ratios_of(k)) for k, joint in enumerate(self.joints)}

    @property
    def back(self) -> tuple[tuple[Row, ...], Row]:
        """The way back, m = ratios q + shifts, exactly."""
        rows = inverse(self.ratios, self.joints)
        return rows, tuple(-sum((a * b for a, b in zip(row, self.shifts, strict=True)), ZERO) for row in rows)

    def joint_values(self, motors: Mapping[str, Value]) -> dict[str, Value]:
        """Values of the joints for constant values of the motors."""
        return self._values(self.joints, self.motors, (self.ratios, self.shifts), motors)

    def motor_values(self, joints: Mapping[str, Value]) -> dict[str, Value]:
        """Values of the motors for constant values of the joints."""
        return self._values(self.motors, self.joints, self.back, joints)

    def sentences(self, *, back: bool = False) -> Iterator[str]:
        """Each joint that is coupled in terms of motors; or each such motor in terms of joints."""
        rows, shifts = self.back if back else (self.ratios, self.shifts)
        of, by = (self.motors, self.joints) if back else (self.joints, self.motors)
        for name, row, shift in zip(of, rows, shifts, strict=True):
            if self.joints[of.index(name)] != self.motors[of.index(name)]:
                yield self._sentence(name, by, row, shift)

    def slopes(self, *, back: bool = False) -> tuple[tuple[float, ...], ...]:
        """The ratios, or those of the way back, in radians and metres; shape (n, n)."""
        rows, of, by = (self.back[0], self.motors, self.joints) if back else (self.ratios, self.joints, self.motors)
        return tuple(
            tuple(float(x) * self._size(other) / self._size(name) for other, x in zip(by, row, strict=True))
            for name, row in zip(of, rows, strict=True)
        )

    def offsets(self, *, back: bool = False) -> tuple[float, ...]:
        """The shifts, or those of the way back, in radians and metres; shape (n,)."""
        shifts, of = (self.back[1], self.motors) if back else (self.shifts, self.joints)
        return tuple(float(shift) / self._size(name) for shift, name in zip(shifts, of, strict=True))

    def _size(self, name: str) -> float:
        return math.degrees(1) if name in self.turning else 1.0

    def _ratios_of(self, k: int) -> tuple[list[tuple[str, Fraction]], Fraction]:
        return [(motor, ratio) for motor, ratio in zip(self.motors, self.ratios[k], strict=True) if ratio], self.shifts[
            k
        ]

    def _formula(self, joint: str, pairs: Sequence[tuple[str, Fraction]], shift: Fraction) -> Value:
        if joint in self.turning:
            return sum((Angle.of(motor) * ratio for motor, ratio in pairs), Angle.in_degrees(shift))
        turned = (number(180), power(PI, -1))  # a motor that turns stands there in radians
        terms = (multiply(number(x), *(turned if m in self.turning else ()), Symbol(m)) for m, x in pairs)
        return add(*terms, number(shift))

    def _values(
        self, of: Sequence[str], by: Sequence[str], how: tuple[Sequence[Row], Row], given: Mapping[str, Value]
    ) -> dict[str, Value]:
        """Exact where an angle is in degrees, and where it stays an angle."""
        found: dict[str, Value] = {}
        for name, row, shift in zip(of, *how, strict=True):
            turns = name in self.turning
            total, angle = shift, Angle.in_degrees(shift)
            for other, ratio in zip(by, row, strict=True):
                value = given[other]
                if isinstance(value, Angle) and turns:
                    angle += value * ratio
                elif ratio:
                    size = Fraction(math.degrees(value.constant())) if isinstance(value, Angle) else metres(value)
                    size = value.degrees if isinstance(value, Angle) and not value.radians else size
                    total, angle = total + size * ratio, angle + Angle.in_degrees(size * ratio)
            found[name] = angle if turns else number(total)
        return found

    def _sentence(self, name: str, others: Sequence[str], row: Row, shift: Fraction) -> str:
        """`theta3 = m2 + m3`, `d3 = 20 mm/360° * m3`, `m3 = 18 °/mm * d3`."""
        pieces = [
            (ratio, self.factor(name, other, abs(ratio)) + other) for other, ratio in zip(others, row, strict=True)
        ]
        size = Angle.in_degrees(abs(shift)) if name in self.turning else number(abs(shift))
        return f"{name} = {total_text([*pieces, (shift, value_text(size))])}"

    def factor(self, name: str, other: str, size: Fraction) -> str:
        """What another's value is multiplied with in the motion of a joint or a motor, as a person writes it."""
        if name in self.turning and other not in self.turning:
            return f"{exact_text(size / 1000)}°/(1 mm) * "
        if name not in self.turning and other in self.turning:
            return f"{exact_text(size * 360_000)} mm/(360°) * "
        return "" if size == 1 else f"{exact_text(size)}*"


def metres(value: Expr) -> Fraction:
    """A constant length; exactly where it is a plain number."""
    return value.value if isinstance(value, Number) else Fraction(Floats().value(value))


def total_text(pieces: Sequence[tuple[Fraction, str]]) -> str:
    """A sum of pieces, each with what gives its sign; those added stand first, those that are 0 are left out."""
    ordered = sorted((piece for piece in pieces if piece[0]), key=lambda piece: piece[0] < 0)
    told = "".join(f" {'-' if sign < 0 else '+'} {text}" for sign, text in ordered)
    return f"{'-' * told.startswith(' -')}{told[3:]}" or "0"


def exact_text(value: Fraction) -> str:
    """A decimal of a few digits where one says it exactly, else a fraction."""
    short = f"{float(value):.10g}"
    return short if Fraction(short) == value else str(value)


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

    Args:
        expr: The expression.
        motors: The motors there are.
        joints: The joints there are.
        turns: Whether the joint turns.

    Raises:
        RobotError: It is no sum of multiples of motors, or a ratio is no number.
    """
    ratios: dict[str, tuple[Fraction, bool]] = {}
    shift = ZERO
    for name, size, angles, lengths in _terms(expr, motors, joints):
        if not name:
            if size and (angles, lengths) != ((1, 0) if turns else (0, 1)):
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
            return "", value, 0, 0
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
    if limits is not None and _constant(limits[0]) >= _constant(limits[1]):
        raise RobotError(f"{motor}: the lower limit is not below the upper one", "write [lowest, highest]")
    for value in limits or ():
        if isinstance(value, Angle) != turns and value not in (Number(ZERO), Angle()):
            does, wanted = ("turns", "an angle: 90°") if turns else ("slides", "a length: 0.3 m")
            raise RobotError(f"{motor} {does}, and its limit is {wanted}")


def _constant(value: Value) -> float:
    return value.constant() if isinstance(value, Angle) else float(metres(value))


def inverse(rows: Sequence[Row], names: Sequence[str]) -> tuple[Row, ...]:
    """The inverse of a square matrix of fractions.

    Args:
        rows: The matrix.
        names: What its rows are called.

    Raises:
        RobotError: A row is a sum of multiples of others; it says which.
    """
    count = len(rows)
    unit = [[Fraction(i == j) for j in range(count)] for i in range(count)]
    # beside each row how it is made of those given
    work = [[list(row), own] for row, own in zip(rows, unit, strict=True)]
    for column in range(count):
        pivot = next((k for k in range(column, count) if work[k][0][column]), None)
        if pivot is None:
            continue
        work[column], work[pivot] = work[pivot], work[column]
        size = work[column][0][column]
        work[column] = [[x / size for x in part] for part in work[column]]
        for k in range(count):
            if k != column and (factor := work[k][0][column]):
                work[k] = [
                    [x - factor * y for x, y in zip(mine, other, strict=True)]
                    for mine, other in zip(work[k], work[column], strict=True)
                ]
    for row, made in work:
        if not any(row):
            raise RobotError(_dependence(made, names), "give each joint that the motors drive a motion of its own")
    return tuple(tuple(made) for _, made in work)


def _dependence(made: Sequence[Fraction], names: Sequence[str]) -> str:
    """Which rows add up to nothing, in words: `theta3 = 2*theta2 whatever the motors do`."""
    parts = [(name, factor) for name, factor in zip(names, made, strict=True) if factor]
    last, factor = parts[-1]
    others = add(*(multiply(number(-f / factor), Symbol(name)) for name, f in parts[:-1]))
    return f"{last} = {write(others)} whatever the motors do"
