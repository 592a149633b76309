"""Where a factor is zero, in the values of joints."""

from __future__ import annotations

import math
from collections.abc import Iterable

from dhcli.algebra.arithmetic import evaluate
from dhcli.algebra.floats import Floats
from dhcli.notation.angle import Angle
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Symbol, Trig
from dhcli.notation.walk import operations, symbols, walk
from dhcli.notation.writer import write, write_angle

PROBES = (0.0, math.pi / 2, math.pi, 1.0)
"""Where a sum of a cosine, a sine and a number is told by three values, and proved by the fourth [rad]."""

NEVER = "at no value of"
"""How words begin about a factor that is zero nowhere."""

_ROUNDED = 1e-12


def angle_words(zeros: Iterable[Expr], joints: Joints) -> str:
    """Where factors are zero: `theta5 is 0 or 180°`, `theta3 is 100.35° or -79.65°`; of others nothing is said."""
    said = (_simple(zero, joints) if not operations(zero) else _solved(zero, joints) for zero in zeros)
    return " and ".join(words for words in said if words)


def _simple(factor: Expr, joints: Joints) -> str:
    if isinstance(factor, Trig):
        angle = write_angle(factor.angle, "short", joints)
        return f"{angle} is {'0 or 180°' if factor.function == 'sin' else '90° or -90°'}"
    if isinstance(factor, Symbol):
        return f"{factor.name} is 0"
    return f"{write(factor, 'short', joints)} is 0"


def _solved(factor: Expr, joints: Joints) -> str:
    """A cosine and a sine of one angle, with numbers: `C + B cos + A sin = 0`."""
    angles = {node.angle for node in walk(factor) if isinstance(node, Trig)}
    if len(angles) != 1:
        return ""
    (angle,) = angles
    turning = dict(angle.terms)
    name = next((name for name, share in turning.items() if abs(share) == 1), "")
    if not name or symbols(factor) != frozenset(turning):
        return ""
    rest = dict.fromkeys(turning, 0.0)
    # the others stand at 0, so that this one is the whole sum, or its negative
    front, side, back, probe = (evaluate(factor, Floats({**rest, name: v * float(turning[name])})) for v in PROBES)
    constant, cosine = (front + back) / 2, (front - back) / 2
    sine = side - constant
    size = math.hypot(cosine, sine)
    fitted = constant + cosine * math.cos(PROBES[-1]) + sine * math.sin(PROBES[-1])
    if size < _ROUNDED or abs(fitted - probe) > _ROUNDED * (size + abs(constant)):
        return ""
    label = write_angle(Angle(angle.terms), "short", joints)
    share = -constant / size
    if abs(share) > 1 + _ROUNDED:
        return f"{NEVER} {label}"
    middle, half = math.atan2(sine, cosine), math.acos(max(-1.0, min(1.0, share)))
    roots = sorted((math.remainder(middle + sign * half, math.tau) for sign in (1, -1)), reverse=True)
    return f"{label} is {' or '.join(dict.fromkeys(map(_degrees, roots)))}"


def _degrees(radians: float) -> str:
    """An angle above -180°, up to 180°, to a hundredth of a degree."""
    text = f"{math.degrees(radians):.2f}".rstrip("0").rstrip(".")
    return {"0": "0", "-0": "0", "-180": "180°"}.get(text, f"{text}°")
