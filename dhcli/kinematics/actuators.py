"""Coupled drives: joints moved by sums of multiples of motor values, exactly, and the way back.

Ratios are exact fractions in degrees and metres, so that a ball screw of 20 mm a turn has one, too: 1/18000 m for 1°.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from fractions import Fraction

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.derived import Value, in_floats, metres
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import PI, Symbol, add, multiply, number, power
from dhcli.notation.writer import write

Fractions = tuple[Fraction, ...]
ZERO = Fraction(0)


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
    ratios: tuple[Fractions, ...]
    shifts: Fractions
    limits: Mapping[str, tuple[Value, Value]] = field(default_factory=dict, hash=False)

    @property
    def formulas(self) -> dict[str, Value]:
        """Each joint in terms of the motors."""
        return {joint: self._formula(joint, *self._ratios_of(k)) for k, joint in enumerate(self.joints)}

    @property
    def back(self) -> tuple[tuple[Fractions, ...], Fractions]:
        """The way back, m = ratios q + shifts, exactly."""
        rows = inverse(self.ratios, self.joints)
        return rows, tuple(-sum((a * b for a, b in zip(row, self.shifts, strict=True)), ZERO) for row in rows)

    def joint_values(self, motors: Mapping[str, Value]) -> dict[str, Value]:
        """Values of the joints for constant values of the motors."""
        return self._values(self.joints, self.motors, (self.ratios, self.shifts), motors)

    def motor_values(self, joints: Mapping[str, Value]) -> dict[str, Value]:
        """Values of the motors for constant values of the joints."""
        return self._values(self.motors, self.joints, self.back, joints)

    def sentences(self, *, back: bool = False, exact: bool = False) -> Iterator[str]:
        """Each joint that is coupled in terms of motors; or each such motor in terms of joints.

        Args:
            back: The other way round.
            exact: Whether a ratio without a short decimal stands there as a fraction, else with six digits.
        """
        rows, shifts = self.back if back else (self.ratios, self.shifts)
        of, by = (self.motors, self.joints) if back else (self.joints, self.motors)
        for k, (name, row, shift) in enumerate(zip(of, rows, shifts, strict=True)):
            if self.joints[k] != self.motors[k]:
                pieces = [(x, self.piece(name, other, abs(x), exact=exact)) for other, x in zip(by, row, strict=True)]
                size = Angle.in_degrees(abs(shift)) if name in self.turning else number(abs(shift))
                yield f"{name} = {total_text([*pieces, (shift, value_text(size))])}"

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

    def reach(self, joint: str) -> tuple[float, float] | None:
        """The widest range that the limits of its motors leave a joint [rad or m]; None where one of them has none."""
        k = self.joints.index(joint)
        low = high = self.offsets()[k]
        for motor, slope in zip(self.motors, self.slopes()[k], strict=True):
            if slope and motor not in self.limits:
                return None
            if slope:
                ends = sorted(slope * in_floats(limit) for limit in self.limits[motor])
                low, high = low + ends[0], high + ends[1]
        return low, high

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
        self,
        of: Sequence[str],
        by: Sequence[str],
        how: tuple[Sequence[Fractions], Fractions],
        given: Mapping[str, Value],
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
                    size = Fraction(value.degrees) if isinstance(value, Angle) and not value.radians else size
                    total, angle = total + size * ratio, angle + Angle.in_degrees(size * ratio)
            found[name] = angle if turns else number(total)
        return found

    def piece(self, name: str, other: str, size: Fraction, *, exact: bool = False, called: str = "") -> str:
        """What another gives to the motion of a joint or a motor: `m2`, `0.5*m2`, `m4/76.036`, `20 mm/(360°) * m3`.

        Args:
            name: The joint or motor that moves.
            other: What it is moved by.
            size: The ratio, positive.
            exact: See `sentences`.
            called: What is written for the other; its name by default.
        """
        called = called or other
        if name in self.turning and other not in self.turning:
            return f"{exact_text(size / 1000, exact=exact)}°/(1 mm) * {called}"
        if name not in self.turning and other in self.turning:
            return f"{exact_text(size * 360_000, exact=exact)} mm/(360°) * {called}"
        if size == 1:
            return called
        if size and short(size) is None and (below := short(1 / size)) is not None:
            return f"{called}/{below}"
        return f"{exact_text(size, exact=exact)}*{called}"


def total_text(pieces: Sequence[tuple[Fraction, str]]) -> str:
    """A sum of pieces, each with what gives its sign; those added stand first, those that are 0 are left out."""
    ordered = sorted((piece for piece in pieces if piece[0]), key=lambda piece: piece[0] < 0)
    told = "".join(f" {'-' if sign < 0 else '+'} {text}" for sign, text in ordered)
    return f"{'-' * told.startswith(' -')}{told[3:]}" or "0"


def short(value: Fraction) -> str | None:
    """A decimal of a few digits, where one says it exactly."""
    text = f"{float(value):.10g}"
    return text if Fraction(text) == value else None


def exact_text(value: Fraction, *, exact: bool) -> str:
    """A decimal of a few digits where one says it, else a fraction, or a rounded decimal."""
    return short(value) or (str(value) if exact else f"{float(value):.6g}")


def inverse(rows: Sequence[Fractions], names: Sequence[str]) -> tuple[Fractions, ...]:
    """The inverse of a square matrix of fractions, whose rows have names for errors.

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
