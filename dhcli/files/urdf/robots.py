"""A chain of a URDF as a robot: fixed joints folded into its links, limits, and what was taken for round."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.errors import FileError, Problem, plural
from dhcli.files.urdf.chains import chain_of, with_leaders
from dhcli.files.urdf.model import Joint, read_model
from dhcli.files.urdf.numbers import Meaning, odd_numbers
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.entries import small_length
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.kinematics.validity import InvalidRobotError
from dhcli.notation import turns
from dhcli.notation.angle import Angle
from dhcli.notation.names import canonical
from dhcli.notation.quarters import Slight, remark_on
from dhcli.notation.tree import Expr, Number, Symbol, add, decimal, multiply
from dhcli.regex import regex

_NOTHING = 1e-9
"""What is so little that nobody is told of it [rad or m]."""
_LETTERS = (("theta", "d"), ("phi", "s"), ("psi", "r"))
"""Of variables, the first that would not be the name of another joint."""
_KEPT = regex(r"[A-Za-z]+_?[0-9]+")
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
    beside = frozenset(joint.name for joint in model.joints).difference(joint.name for joint in joints)
    own, alone = with_leaders(joints, beside)
    return robot_of_joints(own, name, model.name or name, said, as_typed=as_typed, told=alone)


def robot_of_joints(
    joints: tuple[Joint, ...], name: str, title: str, source: str, *, as_typed: bool, told: Sequence[str] = ()
) -> Robot:
    """The robot whose joints follow each other, with what is told of it beside.

    Raises:
        FileError: An axis has no direction, or a joint follows another.
    """
    return _Builder(joints, Meaning(as_typed), told).robot(name, title, source)


def _shifted(moves: Sequence[Move], more: Chain) -> list[Move]:
    """Moves and others behind them; a fixed shift behind another is one with it."""
    if moves and more and isinstance(first := moves[-1], Trans) and isinstance(then := more[0], Trans):
        pairs = tuple(zip((first.x, first.y, first.z), (then.x, then.y, then.z), strict=True))
        if all(isinstance(part, Number) for pair in pairs for part in pair):
            x, y, z = (add(*pair) for pair in pairs)
            return [*moves[:-1], Trans(x, y, z), *more[1:]]
    return [*moves, *more]


class _Builder:
    """Builds the links one joint after the other."""

    def __init__(self, joints: tuple[Joint, ...], meaning: Meaning, told: Sequence[str]) -> None:
        self.joints = joints
        self.meaning = meaning
        self.shifts: list[tuple[float, int]] = []
        self.lengths: list[float] = []
        self.remarks = list(told)
        self.none: list[str] = []
        self.moving = tuple(joint for joint in joints if joint.kind != "fixed")

    def robot(self, name: str, title: str, source: str) -> Robot:
        variables = self.variables()
        links: list[Link] = []
        waiting: list[Move] = []
        for joint in self.joints:
            waiting = _shifted(waiting, self.origin(joint))
            if joint.kind == "fixed":
                continue
            leader, factor, offset = self.leader(joint)
            waiting += self.motion(joint, variables[leader.name], factor, offset)
            links.append(Link(len(links) + 1, tuple(waiting)))
            waiting = []
        if links:
            links[-1] = Link(links[-1].number, (*links[-1].moves, *waiting))
        elif waiting:
            links.append(Link(1, tuple(waiting)))
        leaders = (joint for joint in self.moving if joint.mimic is None)
        limits = {variables[joint.name]: found for joint in leaders if (found := self.limits(joint)) is not None}
        return Robot(
            name=name,
            title=title,
            source=source,
            convention=Convention.PRODUCT,
            variables=tuple(variables.values()),
            links=tuple(links),
            limits=limits,
            remarks=(*self.taken(), *self.remarks, *self.left_out(), *odd_numbers(self.joints)),
            called={variable: joint for joint, variable in variables.items() if joint != variable},
        )

    def variables(self) -> dict[str, str]:
        """The variable of each joint that follows no other: its own name where that can be one, else theta1, d2, ..."""
        own = [joint for joint in self.moving if joint.mimic is None]
        if all(_KEPT.fullmatch(joint.name) for joint in own) and self.can_keep(own):
            return {joint.name: joint.name for joint in own}
        for turning, sliding in _LETTERS:
            letters = (sliding if joint.kind == "prismatic" else turning for joint in own)
            found = {joint.name: f"{letter}{i}" for i, (joint, letter) in enumerate(zip(own, letters, strict=True), 1)}
            if not {canonical(joint) for joint, name in found.items() if joint != name} & {*found.values()}:
                break
        return found

    def leader(self, joint: Joint) -> tuple[Joint, Fraction, Fraction]:
        """The joint that another one follows in the end, itself if it follows none, by which factor and offset.

        Raises:
            FileError: It is not on this chain, the joints follow each other in a ring, or a turn follows a slide.
        """
        first, factor, offset = joint, Fraction(1), Fraction(0)
        seen = {joint.name}
        while joint.mimic is not None:
            offset += factor * Fraction(joint.mimic.offset)
            factor *= Fraction(joint.mimic.multiplier)
            found = next((other for other in self.moving if other.name == joint.mimic.joint), None)
            if found is None or found.name in seen:
                where = "which is not on this chain" if found is None else "which follows it"
                hint = "choose another tip, or take the <mimic> out: then it has a variable of its own"
                raise FileError(Problem(f"joint {joint.name} follows {joint.mimic.joint}, {where}", joint.place, hint))
            if found.kind == "prismatic" != first.kind:
                message = f"joint {first.name} turns and follows {found.name}, which slides"
                hint = "take the <mimic> out: then it has a variable of its own"
                raise FileError(Problem(message, first.place, hint))
            joint = found
            seen.add(joint.name)
        return joint, factor, offset

    def can_keep(self, joints: Sequence[Joint]) -> bool:
        """Whether the names of some joints are names of variables."""
        names = tuple(joint.name for joint in joints)
        links = tuple(Link(i, (Rot("z", Angle.of(name)),), None, "") for i, name in enumerate(names, 1))
        try:
            Robot("", "", "", Convention.PRODUCT, names, links)
        except InvalidRobotError:
            return False
        return True

    def origin(self, joint: Joint) -> Chain:
        """Where the joint's frame stands in its parent's: R = Rz(yaw) Ry(pitch) Rx(roll)."""
        lengths = [decimal(Fraction(text)) for text in joint.xyz]
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

    def motion(self, joint: Joint, variable: str, factor: Fraction, offset: Fraction) -> Iterator[Move]:
        """What the joint does, about or along its axis, for a multiple of a variable and an offset."""
        axis = [Fraction(text) for text in joint.axis]
        if not any(axis):
            raise FileError(
                Problem(f"joint {joint.name} has an axis of length zero", joint.place, 'write <axis xyz="0 0 1"/>')
            )
        if joint.kind == "prismatic":
            by = add(multiply(decimal(factor), Symbol(variable)), decimal(offset))
            x, y, z = (multiply(part, by) for part in turns.unit(axis, typed=True))
            yield Trans(x, y, z)
            return
        turned = Angle.of(variable) * factor + (self.angle(str(float(offset))) if offset else Angle())
        for part in turns.about([decimal(part) for part in axis], turned):
            if isinstance(part, turns.Turn):
                yield Rot(part.axis, part.angle)
            else:
                yield Fixed(tuple((row[0], row[1], row[2], row[3]) for row in part.rows[:3]))

    def limits(self, joint: Joint) -> tuple[Value, Value] | None:
        """The limits of a joint, and of those that follow it, where theirs are narrower."""
        low, high = joint.limits or (None, None)
        if low is not None and high is not None and float(low) >= float(high):
            self.none.append(joint.name)
            low = high = None
        for other in self.moving:
            leader, factor, offset = self.leader(other)
            if other.mimic is None or leader is not joint or other.limits is None or not factor:
                continue
            ends = sorted((Fraction(end) - offset) / factor for end in other.limits)
            low = low if low is not None and Fraction(low) >= ends[0] else str(float(ends[0]))
            high = high if high is not None and Fraction(high) <= ends[1] else str(float(ends[1]))
        if low is None or high is None:
            return None
        if joint.kind == "prismatic":
            return decimal(Fraction(low)), decimal(Fraction(high))
        silent = Meaning(self.meaning.as_typed)
        return silent.angle(low)[0], silent.angle(high)[0]

    def taken(self) -> Iterator[str]:
        """What was taken for round angles, and by how much that moves the tip at the most."""
        rounded = self.meaning.rounded
        if not self.shifts:
            return
        text, degrees = rounded[0]
        tip = sum(shift * (sum(self.lengths[behind:]) + self.slides()) for shift, behind in self.shifts)
        seen = max(tip, *(shift for shift, _ in self.shifts))
        if seen < _NOTHING:  # they were typed with all their digits
            return
        count = f"{len(rounded)} of {plural(self.meaning.angles, 'angle')}"
        said = (
            f"taken for multiples of 15°: {count} ({text} -> {degrees}°); the tip moves by at most {small_length(tip)}"
        )
        yield remark_on(f"{said}; --as-typed keeps them", seen)

    def left_out(self) -> Iterator[str]:
        """Which limits are none."""
        if self.none:
            yield Slight(f"the limits of {', '.join(dict.fromkeys(self.none))} are left out: lower is not below upper")

    def slides(self) -> float:
        """How far all sliding joints together reach."""
        limits = (self.limits(joint) for joint in self.moving if joint.kind == "prismatic")
        over = Floats()
        return sum(max(abs(over.value(x)) for x in pair if isinstance(x, Expr)) for pair in limits if pair)
