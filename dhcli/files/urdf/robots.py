"""A chain of a URDF as a robot: fixed joints folded into its links, limits, and what was taken for round."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.errors import FileError, Problem
from dhcli.files.urdf.chains import chain_of
from dhcli.files.urdf.model import Joint, read_model
from dhcli.files.urdf.numbers import Meaning, length
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.kinematics.validity import InvalidRobotError
from dhcli.notation import turns
from dhcli.notation.angle import Angle
from dhcli.notation.tree import HALF, ZERO, Expr, Number, Symbol, multiply, power

_KEPT = re.compile(r"[A-Za-z]+_?[0-9]+")
"""Names of joints that are names of variables too."""


def read_urdf(
    text: str, source: str, name: str, *, base: str | None = None, tip: str | None = None, as_typed: bool = False
) -> Robot:
    """Read a serial chain of a URDF.

    Args:
        text: The XML.
        source: What it is called in errors.
        name: What the robot is called.
        base: The link that is frame 0; by default the root.
        tip: The link that is the last frame; by default the only one at the end of a chain that moves.
        as_typed: Whether 1.5708 stays what it is, and is not taken as 90°.

    Raises:
        FileError: It is no URDF, or has no such chain.
        UnknownNameError: There is no such link.
    """
    model = read_model(text, source)
    joints = chain_of(model, base, tip)
    said = f"the URDF {source}, from link {joints[0].parent} to link {joints[-1].child}"
    return robot_of_joints(joints, name, model.name or name, said, as_typed=as_typed)


def robot_of_joints(joints: tuple[Joint, ...], name: str, title: str, source: str, *, as_typed: bool = False) -> Robot:
    """The robot whose joints follow each other.

    Args:
        joints: From the base to the tip.
        name: What the robot is called.
        title: Its title.
        source: Where it comes from.
        as_typed: Whether 1.5708 stays what it is.

    Raises:
        FileError: An axis has no direction, or a joint follows another.
    """
    return _Builder(joints, Meaning(as_typed)).robot(name, title, source)


class _Builder:
    """Builds the links one joint after the other."""

    def __init__(self, joints: tuple[Joint, ...], meaning: Meaning) -> None:
        self.joints = joints
        self.meaning = meaning
        self.shifts: list[tuple[float, int]] = []
        self.lengths: list[float] = []
        self.remarks: list[str] = []
        self.moving = tuple(joint for joint in joints if joint.kind != "fixed")

    def robot(self, name: str, title: str, source: str) -> Robot:
        variables = self.variables()
        links: list[Link] = []
        waiting: list[Move] = []
        for joint in self.joints:
            waiting += self.origin(joint)
            if joint.kind == "fixed":
                continue
            waiting += self.motion(joint, variables[joint.name])
            links.append(Link(len(links) + 1, tuple(waiting)))
            waiting = []
        if links:
            links[-1] = Link(links[-1].number, (*links[-1].moves, *waiting))
        elif waiting:
            links.append(Link(1, tuple(waiting)))
        limits = {variables[joint.name]: found for joint in self.moving if (found := self.limits(joint)) is not None}
        return Robot(
            name=name,
            title=title,
            source=source,
            convention=Convention.PRODUCT,
            variables=tuple(variables.values()),
            links=tuple(links),
            limits=limits,
            remarks=(*self.taken(), *self.remarks),
            notes="\n".join(
                f"{variable} is the joint {joint}." for joint, variable in variables.items() if joint != variable
            ),
        )

    def variables(self) -> dict[str, str]:
        """The variable of each joint: its own name where that can be one, else theta1, d2, ..."""
        for joint in self.moving:
            if joint.mimic is not None:
                known = any(other.name == joint.mimic.joint for other in self.moving)
                where = "" if known else ", which is not on this chain"
                message = f"joint {joint.name} follows {joint.mimic.joint}{where}"
                raise FileError(
                    Problem(
                        message,
                        joint.place,
                        "choose another tip, or take the <mimic> out: then it has a variable of its own",
                    )
                )
        if all(_KEPT.fullmatch(joint.name) for joint in self.moving) and self.can_keep():
            return {joint.name: joint.name for joint in self.moving}
        letters = ((joint, "d" if joint.kind == "prismatic" else "theta") for joint in self.moving)
        return {joint.name: f"{letter}{i}" for i, (joint, letter) in enumerate(letters, 1)}

    def can_keep(self) -> bool:
        """Whether the names of the joints are names of variables."""
        names = tuple(joint.name for joint in self.moving)
        links = tuple(Link(i, (Rot("z", Angle.of(name)),), None, "") for i, name in enumerate(names, 1))
        try:
            Robot("", "", "", Convention.PRODUCT, names, links)
        except InvalidRobotError:
            return False
        return True

    def origin(self, joint: Joint) -> Chain:
        """Where the joint's frame stands in its parent's: R = Rz(yaw) Ry(pitch) Rx(roll)."""
        lengths = [length(text) for text in joint.xyz]
        self.lengths.append(math.hypot(*(float(number.value) for number in lengths)))
        found: list[Move] = [Trans(*lengths)] if any(number.value for number in lengths) else []
        roll, pitch, yaw = (self.angle(text) for text in joint.rpy)
        turned = (Rot("z", yaw), Rot("y", pitch), Rot("x", roll))
        return (*found, *(turn for turn in turned if not turn.angle.is_zero))

    def angle(self, text: str) -> Angle:
        angle, shift = self.meaning.angle(text)
        if shift:
            self.shifts.append((shift, len(self.lengths)))
        return angle

    def motion(self, joint: Joint, variable: str) -> Iterator[Move]:
        """What the joint does, about or along its axis."""
        axis = [Fraction(text) for text in joint.axis]
        square = sum((part * part for part in axis), Fraction(0))
        if not square:
            raise FileError(
                Problem(f"joint {joint.name} has an axis of length zero", joint.place, 'write <axis xyz="0 0 1"/>')
            )
        if joint.kind == "prismatic":
            size = power(Number(square), HALF)
            parts: list[Expr] = [
                multiply(Number(part), power(size, -1), Symbol(variable)) if part else ZERO for part in axis
            ]
            yield Trans(parts[0], parts[1], parts[2])
            return
        for part in turns.about([Number(number) for number in axis], Angle.of(variable)):
            if isinstance(part, turns.Turn):
                yield Rot(part.axis, part.angle)
            else:
                yield Fixed(tuple((row[0], row[1], row[2], row[3]) for row in part.rows[:3]))

    def limits(self, joint: Joint) -> tuple[Value, Value] | None:
        if joint.limits is None:
            return None
        low, high = joint.limits
        if float(low) >= float(high):
            self.remarks.append(f"the limits of {joint.name}, {low} to {high}, are none and left out")
            return None
        if joint.kind == "prismatic":
            return length(low), length(high)
        silent = Meaning(self.meaning.as_typed)
        return silent.angle(low)[0], silent.angle(high)[0]

    def taken(self) -> Iterator[str]:
        """What was taken for round angles, and by how much that moves the tip at the most."""
        rounded = self.meaning.rounded
        if not self.shifts:
            return
        text, degrees = rounded[0]
        tip = sum(shift * (sum(self.lengths[behind:]) + self.slides()) for shift, behind in self.shifts)
        moved = f"{tip * 1e6:.2g} µm" if tip < 1e-3 else f"{tip * 1e3:.2g} mm"  # noqa: PLR2004
        yield (
            f"{len(rounded)} of {self.meaning.angles} angles are multiples of 15° rounded ({text} -> {degrees}°); "
            f"the tip moves by at most {moved}; --as-typed keeps them"
        )

    def slides(self) -> float:
        """How far all sliding joints together reach."""
        limits = (self.limits(joint) for joint in self.moving if joint.kind == "prismatic")
        over = Floats()
        return sum(max(abs(over.value(x)) for x in pair if isinstance(x, Expr)) for pair in limits if pair)
