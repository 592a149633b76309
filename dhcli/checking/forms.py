"""The ways to say an orientation in numbers, by the names that people give them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from dhcli.checking.named import XYZ, Naming
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.tolerance import ZERO
from dhcli.frozen import frozen
from dhcli.geometry.euler import EulerAngles, Order, euler
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.entries import rounded

if TYPE_CHECKING:
    from dhcli.geometry.rotations import Rotation

SLACK = 5e-3
"""What the length of a quaternion or an axis may be off by its rounded digits."""


@frozen
class Form:
    """A way to say an orientation.

    Attributes:
        name: `rpy`, `zyz`, `quaternion`, `axis-angle` or `rotation-vector`.
        parts: What its numbers are called.
        angles: Which of them are angles, in degrees where nothing is said.
        words: The convention, as a heading says it.
        namings: What its numbers may be called where they stand behind names.
        order: About which axes three angles turn.
    """

    name: str
    parts: tuple[str, ...]
    angles: tuple[int, ...]
    words: str
    namings: tuple[Naming, ...]
    order: Order | None = None

    def rotation(self, typed: Sequence[float]) -> Rotation[float]:
        """The matrix; angles in radians.

        Raises:
            UnreadableError: A quaternion or an axis that must have length 1 has another.
        """
        if self.order is not None:
            a, b, c = typed
            return EulerAngles(self.order, (a, b, c)).rotation()
        if self.name == "quaternion":
            return Quaternion(*_unit(typed, "a quaternion")).rotation()
        x, y, z = typed[:3]
        if self.name == "axis-angle":
            x, y, z = _unit((x, y, z), "an axis")
            return AxisAngle((x, y, z), typed[3]).rotation()
        return RotationVector(x, y, z).rotation()

    def of(self, rotation: Rotation[float]) -> tuple[tuple[float, ...], ...]:
        """The numbers that say a rotation, every set of them but for full turns; the usual one first."""
        if self.order is not None:
            found = self.order.of(rotation, free="left" if self.order.product == "zyx" else "right")
            return found.numbers, found.other.numbers
        if self.name == "quaternion":
            usual: tuple[float, ...] = Quaternion.of(rotation).numbers
            return usual, tuple(-x for x in usual)
        if self.name == "axis-angle":
            usual = AxisAngle.of(rotation).numbers
            return usual, tuple(-x for x in usual)
        return (RotationVector.of(rotation).numbers,)

    def text(self, values: Sequence[float]) -> str:
        """Numbers as people type them: angles in degrees."""
        cells = (
            f"{rounded(math.degrees(value), 4)}°" if k in self.angles else rounded(value, 6)
            for k, value in enumerate(values)
        )
        return ", ".join(cells)


def form_of(name: str) -> Form:
    """A way to say an orientation by its name: `rpy`, `quaternion`, `axis-angle`, `rotation-vector`, `euler zyz`.

    Raises:
        UnknownNameError: There is no such order of axes.
    """
    kind, _, axes = name.partition(" ")
    if kind in ("euler", "fixed"):
        order = euler(axes, fixed=kind == "fixed")
        about = "the fixed axes" if order.fixed else "the current axes"
        words = f"three angles about {about} {', '.join(order.axes)}, in this order"
        by_axis = (tuple(order.axes),) if len(set(order.axes)) == len(order.axes) else ()
        spoken = (tuple(map(_SPOKEN.__getitem__, order.axes)),) if order.product == "zyx" else ()
        namings = (*by_axis, *spoken) if order.fixed else (*by_axis, *spoken, *_EULER)
        return Form(name, tuple(f"about {axis}" for axis in order.axes), (0, 1, 2), words, namings, order)
    return _FORMS[kind]


_EULER: tuple[Naming, ...] = (("phi", "theta", "psi"), ("alpha", "beta", "gamma"))
"""What the angles about the current axes are called by all books, in this order; about fixed ones they differ."""

_SPOKEN = dict(zip(XYZ, ("roll", "pitch", "yaw"), strict=True))
"""What the turns of Rz Ry Rx are called by their axes."""

_QUATERNION = ("w", *XYZ)

_FORMS = {
    "rpy": Form(
        "rpy",
        ("roll", "pitch", "yaw"),
        (0, 1, 2),
        "roll, pitch and yaw, R = Rz(yaw) Ry(pitch) Rx(roll)",
        (("roll", "pitch", "yaw"), ("r", "p", "y"), XYZ),
        Order("xyz", fixed=True),
    ),
    "quaternion": Form(
        "quaternion", _QUATERNION, (), "a unit quaternion, w x y z", (_QUATERNION, ("q0", "q1", "q2", "q3"))
    ),
    "axis-angle": Form(
        "axis-angle",
        (*XYZ, "angle"),
        (3,),
        "a unit axis and an angle, x y z angle",
        ((*XYZ, "angle"), (*XYZ, "theta")),
    ),
    "rotation-vector": Form("rotation-vector", XYZ, (), "the unit axis times the angle in radians, x y z", (XYZ,)),
}


def _unit(values: Sequence[float], what: str) -> tuple[Any, ...]:
    length = math.sqrt(sum(x * x for x in values))
    if abs(length - 1) > SLACK:
        raise UnreadableError(f"{what} has length 1; yours has {length:.4g}")
    return tuple(x / max(length, ZERO) for x in values)
