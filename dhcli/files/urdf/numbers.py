"""Numbers of a URDF as they were meant: 1.5708 is a right angle; only what was typed is judged, never a result."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from dhcli.files.urdf.model import Joint
from dhcli.notation.angle import Angle

_STEPS = ((90, 2e-3), (45, 1e-3), (15, 1e-4))
"""Multiples of so many degrees, and how far a rounded one may be from them [rad]."""
_LEAST = 1e-6
_A_TURN = 7.0
_THREE_TURNS, _IN_DEGREES = 19.0, 1080.0
"""Three turns in radians, and in degrees."""
_FAR = 10.0
"""What no roll and no length of a robot is beyond [rad and m]; in degrees and millimetres they are."""


@dataclass(slots=True)
class Meaning:
    """Reads angles, and counts what it takes for round ones.

    Attributes:
        as_typed: Whether it leaves every number as it is.
        angles: How many angles were read.
        rounded: Each angle that was taken for a round one: its text, and degrees.
    """

    as_typed: bool = False
    angles: int = 0
    rounded: list[tuple[str, int]] = field(default_factory=list)

    def angle(self, text: str) -> tuple[Angle, float]:
        """An angle, and by how much it differs from the text [rad]."""
        self.angles += 1
        value = Fraction(text)
        if not value:
            return Angle(), 0.0
        degrees = None if self.as_typed else round_degrees(text)
        if degrees is None:
            return Angle(radians=value), 0.0
        self.rounded.append((text, degrees))
        return Angle.in_degrees(degrees), abs(math.radians(degrees) - float(value))


def round_degrees(text: str) -> int | None:
    """The multiple of 15° that a number of radians is the rounded value of; None if it is none.

    >>> round_degrees("1.5708"), round_degrees("-3.14"), round_degrees("0.3"), round_degrees("1.5")
    (90, -180, None, None)
    """
    value = float(text)
    digit = _last_digit(text)
    for step, cap in _STEPS:
        degrees = round(math.degrees(value) / step) * step
        if degrees and abs(math.radians(degrees) - value) <= min(max(digit, _LEAST), cap):
            return degrees
    return None


def odd_numbers(joints: Sequence[Joint]) -> Iterator[str]:
    """What is said of numbers that are hardly meant in radians and metres."""
    turned = {joint.name: text for joint in joints for text in joint.rpy if abs(float(text)) > _A_TURN}
    if turned:
        names, text = ", ".join(turned), next(iter(turned.values()))
        yield f"rpy of {names}: {text} is more than a turn; angles are in radians, and 90° is 1.5708"
    wide = {j.name: text for j in joints if j.kind == "revolute" for text in j.limits or () if _is_wide(float(text))}
    if wide:
        names, text = ", ".join(wide), next(iter(wide.values()))
        yield f"limits of {names}: {text} is more than three turns; angles are in radians, and 90° is 1.5708"
    away = {joint.name: text for joint in joints for text in joint.xyz if abs(float(text)) > _FAR}
    if away:
        names, text = ", ".join(away), next(iter(away.values()))
        yield f"xyz of {names}: {text} is longer than any arm; lengths are in metres, and 300 mm is 0.3"


def _is_wide(limit: float) -> bool:
    """Whether a limit is hardly one in radians, and may be one in degrees; what is larger still stands for none."""
    return _THREE_TURNS < abs(limit) <= _IN_DEGREES


def _last_digit(text: str) -> float:
    """What the last digit counts: 0.0001 for 1.5708."""
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return float(10.0 ** (int(exponent or 0) - decimals))
