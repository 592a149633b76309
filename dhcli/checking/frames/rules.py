"""The rules that frames keep, each by its name, and by how much one is broken.

DH1: z lies along the axis of its joint; the axis of a slide may be moved. DH2: x is perpendicular to the z axis of the
neighbour, the one before in the standard convention and the next in the modified one. DH3: it meets that axis. And each
frame is one: x perpendicular to its own z, y = z × x. What a task fixes is a rule as well.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from dhcli.algebra.floats import Floats
from dhcli.checking.frames.reading import TypedFrame
from dhcli.checking.frames.sketch import Sketch
from dhcli.checking.tables.comparing import BASE, END, SENSE
from dhcli.checking.tolerance import SLACK, Tolerance
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, across, cross, dot, length, plus, scaled
from dhcli.kinematics.describe.drawn import Frame, Line
from dhcli.kinematics.describe.linear import Form, Point, Ruler, length_of, mapped, moved
from dhcli.kinematics.describe.process import axis_word
from dhcli.notation.tree import ONE, ZERO, Number
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

DH1, DH2, DH3, FRAME, TASK = "DH1", "DH2", "DH3", "frame", "task"
ORIGIN_CELL, X_CELL, Z_CELL = range(3)
"""Which cell of its row a broken rule makes wrong."""


@frozen
class Broken:
    """A rule that frames break.

    Attributes:
        rule: DH1, DH2, DH3, `frame` or `task`.
        frame: Which frame, from 0.
        cell: Which of its cells is wrong.
        said: By how much, in words.
    """

    rule: str
    frame: int
    cell: int
    said: str


@frozen
class Rules:
    """The rules of a drawing.

    Attributes:
        sketch: The drawing.
        tolerance: Largest errors that count as right.
    """

    sketch: Sketch
    tolerance: Tolerance

    def broken(self, typed: Sequence[TypedFrame]) -> tuple[Broken, ...]:
        """Every rule that frames break, frame by frame."""
        frames = [one.frame for one in typed]
        return tuple(one for k in range(len(frames)) for one in self._of_frame(k, typed[k], frames))

    def _of_frame(self, k: int, typed: TypedFrame, frames: Sequence[Frame]) -> Iterator[Broken]:
        first = list(self._z(k, frames[k]))
        yield from first
        own = self._tilt(frames[k].x, frames[k].z)
        if own:
            yield Broken(FRAME, k, X_CELL, f"{self.name('x', k)} is not perpendicular to {self.name('z', k)}: {own}")
        elif typed.y is not None and not self._along(typed.y, frames[k].y, same=True):
            yield Broken(FRAME, k, X_CELL, self._handed(k, typed.y, frames[k]))
        yield from self._x(k, frames, is_beside=any(one.cell == ORIGIN_CELL for one in first))
        if not first:
            yield from self._task(k, frames[k])

    def _z(self, k: int, frame: Frame) -> Iterator[Broken]:
        """DH1, and the sense of the axis where the task fixes it."""
        line, name = self.sketch.axis_of(k), self.name("z", k)
        if line is None:
            return
        joint, way = self.sketch.joint(line), axis_word(line.direction)
        if not self._along(frame.z, line.direction):
            off = _degrees(math.asin(min(1.0, length(cross(frame.z, line.direction)))))
            yield Broken(DH1, k, Z_CELL, f"{name} is not along the axis of {joint}, {way}: it is {off} off")
            return
        right = self.sketch.frames[k].z
        if SENSE in self.sketch.stated and dot(frame.z, right) < 0:
            said = f"{name} points the other way: the positive sense of {line.name}, which is stated, makes it"
            yield Broken(TASK, k, Z_CELL, f"{said} {axis_word(right)}")
        beside = self._beside(frame, line)
        if beside:
            origin = self.name("o", k)
            yield Broken(DH1, k, ORIGIN_CELL, f"{origin} is off the axis of {joint}: {name} passes {beside} beside it")

    def _x(self, k: int, frames: Sequence[Frame], *, is_beside: bool) -> Iterator[Broken]:
        """DH2 and DH3, the second of them only where the first is kept."""
        other = self.sketch.other_of(k)
        if other is None:
            return
        own, name = self.name("x", k), self.name("z", other)
        frame, line = frames[k], self.sketch.axis_of(other)
        tilt = self._tilt(frame.x, frames[other].z)
        is_astray = line is not None and not self._along(frames[other].z, line.direction)
        if tilt and is_astray and line is not None and not self._tilt(frame.x, line.direction):
            return  # the z axis is the one that is wrong, and that is told
        if tilt:
            yield Broken(DH2, k, X_CELL, f"{own} is not perpendicular to {name}: {tilt}")
            return
        passes = self._passes(frame, frames[other])
        if not passes:
            return
        if line is not None and line.through is not None:
            axis = Frame(z=line.direction, origin=line.through)
            if not self._tilt(frame.x, axis.z) and not self._passes(frame, axis):
                return  # it meets the joint axis, on which the other frame does not stand
        # Between parallel axes only one direction leads from one to the other; else x is square to both wherever it is.
        cell = X_CELL if not is_beside and self._along(frame.z, frames[other].z) else ORIGIN_CELL
        yield Broken(DH3, k, cell, f"{own} does not meet {name}: it passes {passes} beside it")

    def _task(self, k: int, frame: Frame) -> Iterator[Broken]:
        """The frames that the task fixes."""
        last = len(self.sketch.frames) - 1
        for at, what, called in ((0, BASE, "base frame"), (last, END, "end frame")):
            if k != at or what not in self.sketch.stated:
                continue
            right = self.sketch.frames[k]
            fixed = f"frame {self.sketch.first + k} is the {called} that the task states"
            if not self._along(frame.z, right.z, same=True):
                yield Broken(TASK, k, Z_CELL, f"{fixed}: {self.name('z', k)} is {axis_word(right.z)}")
            elif not self._along(frame.x, right.x, same=True):
                yield Broken(TASK, k, X_CELL, f"{fixed}: {self.name('x', k)} is {axis_word(right.x)}")
            elif self.amount(moved(frame.origin, right.origin, -1)):
                yield Broken(TASK, k, ORIGIN_CELL, f"{fixed}: its origin is {self.sketch.written(right.origin)}")

    def name(self, letter: str, k: int) -> str:
        """An axis or an origin by its letter and the number of its frame."""
        return f"{letter}{self.sketch.first + k}"

    def amount(self, gap: Point) -> str:
        """How long a vector is, in words; empty where it is nothing."""
        kept = self._ruler.cleaned_point(gap)
        if not kept or self._is_rounding(kept):
            return ""
        if len(kept) == 1:
            letter, vector = next(iter(kept.items()))
            return self._written({letter: length(vector)})
        return self.sketch.written(kept)

    @property
    def _ruler(self) -> Ruler:
        return Ruler(self.sketch.values, self.sketch.size)

    def _is_rounding(self, gap: Point) -> bool:
        """Whether a vector is nothing within the tolerance, where numbers were typed for letters, or there are none."""
        if ONE not in gap or any(symbols(letter) - self.sketch.values.keys() for letter in gap):
            return False
        over, total = Floats(self.sketch.values), (0.0, 0.0, 0.0)
        for letter, vector in gap.items():
            total = plus(total, vector, over.value(letter))
        limit = self.tolerance.position if self.tolerance.position is not None else 1e-3 * self.sketch.size
        return length(total) <= limit * (1 + SLACK)

    def _along(self, one: Vector, other: Vector, *, same: bool = False) -> bool:
        """Whether two directions are the same, or opposite if that will do."""
        is_parallel = length(cross(one, other)) <= self.tolerance.rotation * (1 + SLACK)
        return is_parallel and (dot(one, other) > 0 or not same)

    def _tilt(self, x: Vector, z: Vector) -> str:
        """The angle between two axes that should be perpendicular, in words; empty where they are."""
        cosine = dot(x, z)
        if abs(cosine) <= self.tolerance.rotation * (1 + SLACK):
            return ""
        angle = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
        is_parallel = min(angle, 180 - angle) < self.tolerance.angle
        return "they are parallel" if is_parallel else f"the angle is {_degrees(math.radians(angle))}"

    def _beside(self, frame: Frame, line: Line) -> str:
        if line.through is None:
            return ""
        gap = moved(frame.origin, line.through, -1)
        return self.amount({letter: across(vector, line.direction) for letter, vector in gap.items()})

    def _passes(self, frame: Frame, other: Frame) -> str:
        """How far the x axis of a frame passes beside the z axis of another to which it is perpendicular."""
        normal = cross(frame.x, other.z)
        unit = scaled(normal, 1 / length(normal))
        gap = moved(frame.origin, other.origin, -1)
        along: Form = self._ruler.cleaned(mapped(gap, lambda vector: dot(vector, unit)))
        if not along or self._is_rounding({letter: scaled(unit, value) for letter, value in along.items()}):
            return ""
        positive = along if self._ruler.is_positive(along) else {letter: -value for letter, value in along.items()}
        return self._written(positive)

    def _handed(self, k: int, y: Vector, frame: Frame) -> str:
        x, own, z = (self.name(letter, k) for letter in "xyz")
        said = f"{own} must be {z} × {x} = {axis_word(frame.y)}"
        return f"{said}: the frame is left-handed" if dot(y, frame.y) < 0 and self._along(y, frame.y) else said

    def _written(self, form: Form) -> str:
        """A length as people write it: of plain metres a few digits, in the unit of the sheet."""
        found = length_of(form)
        return self.sketch.distance(float(found.value)) if isinstance(found, Number) and found != ZERO else write(found)


def _degrees(radians: float) -> str:
    return f"{math.degrees(radians):.3g}°"
