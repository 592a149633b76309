"""Frames as people type them, read: unit vectors for axes, and an origin whose lengths may be letters."""

from __future__ import annotations

import math
from collections.abc import Sequence

from dhcli.checking.exercise import Exercise
from dhcli.checking.frames.sketch import Pose
from dhcli.checking.frames.spelling import AXIS, SHAPE, is_minus, named_cells, rows_of, triple
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.units import length_in_metres
from dhcli.errors import NotationError, Place
from dhcli.frozen import frozen
from dhcli.geometry.vectors import ORIGIN, UNITS, Vector, length, scaled
from dhcli.kinematics.describe.drawn import Frame
from dhcli.kinematics.describe.linear import Point, point_of
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_plain_length
from dhcli.notation.tree import ONE, ZERO, Expr
from dhcli.notation.walk import substitute, symbols, symbols_in

LEAST = 1e-9
"""A direction that is shorter was meant to be zero."""


@frozen
class TypedFrame:
    """A frame as it was read.

    Attributes:
        frame: Its axes as unit vectors, and its origin with lengths in metres.
        texts: What was typed, by name: o, x, z, and y where it was typed.
        y: Its y axis, if it was typed.
    """

    frame: Frame
    texts: dict[str, str]
    y: Vector | None = None


def read_frames(text: str, exercise: Exercise, numbers: Sequence[int], pose: Pose) -> tuple[TypedFrame, ...]:
    """Read the frames with some numbers; the values that joints have in the pose drawn are put in for their names.

    Raises:
        UnreadableError: Naming the frame, and what would be read.
    """
    asked = f"frames {numbers[0]} to {numbers[-1]} are asked for"
    found: dict[int, TypedFrame] = {}
    for k, row in enumerate(rows_of(text)):
        typed, cells = named_cells(row)
        number = numbers[0] + k if typed is None else typed
        if number not in numbers:
            raise UnreadableError(f"there is no frame {number}: {asked}")
        if number in found:
            raise UnreadableError(f"frame {number} stands there twice")
        found[number] = _Reader(exercise, pose, number).frame(cells)
    if missing := [number for number in numbers if number not in found]:
        raise UnreadableError(f"frame {missing[0]} is missing: {asked}; {SHAPE}")
    return tuple(found[number] for number in numbers)


@frozen
class _Reader:
    """What the cells of a frame are read with."""

    exercise: Exercise
    pose: Pose
    number: int

    def frame(self, cells: dict[str, str]) -> TypedFrame:
        """A frame of its cells, by name."""
        for name, what in (("o", "origin"), ("x", "x axis"), ("z", "z axis")):
            if name not in cells:
                raise UnreadableError(f"frame {self.number}: its {what} is missing; {SHAPE}")
        x, z = self.direction(cells["x"], "x"), self.direction(cells["z"], "z")
        y = self.direction(cells["y"], "y") if "y" in cells else None
        return TypedFrame(Frame(x, z, self.point(cells["o"])), cells, y)

    def direction(self, text: str, letter: str) -> Vector:
        """`+z`, `-x0` or three numbers, as a unit vector."""
        if match := AXIS.fullmatch(text.strip()):
            return scaled(UNITS["xyz".index(match[2])], -1.0 if is_minus(match[1]) else 1.0)
        name = f"{letter}{self.number}"
        exprs = self.vector(text, name, "+z, -x or (0, 1, 1)")
        if named := sorted(symbols_in(exprs)):
            raise UnreadableError(f"{name}: a direction is three numbers, and {named[0]} is a letter: write (0, 1, 1)")
        direction = point_of(exprs).get(ONE, ORIGIN)
        if length(direction) < LEAST:
            raise UnreadableError(f"{name} is {text.strip()}: a direction is not zero; write +z, -x or (0, 1, 1)")
        return scaled(direction, 1 / length(direction))

    def point(self, text: str) -> Point:
        """Three lengths, bare ones in the unit of the sheet; letters stay letters."""
        if text.strip() in ("0", "o", "O"):
            return {}
        name = f"o{self.number}"
        scope, found = self.exercise.scope, []
        for expr in self.vector(text, name, "(a1, 0, 0)"):
            try:
                found.append(to_plain_length(length_in_metres(expr, self.exercise.metres, scope)))
            except DimensionError as error:
                raise UnreadableError(f"{name}: {error.message} ({error.hint})") from None
        return _finite(found, text, name)

    def vector(self, text: str, name: str, example: str) -> tuple[Expr, ...]:
        """Three expressions, the joints in them in the pose drawn."""
        cells = triple(text)
        if len(cells) != 3:  # noqa: PLR2004
            raise UnreadableError(f"{name}: three values are wanted, not {len(cells)}: write {example}")
        scope, robot = self.exercise.scope, self.exercise.robot
        lengths: dict[str, Expr] = {}
        angles: dict[str, Angle] = {}
        for joint in robot.variables if robot else ():
            value = self.pose.get(joint, Angle() if scope.is_angle(joint) else ZERO)
            if isinstance(value, Angle):
                angles[joint] = value
            else:
                lengths[joint] = value
        try:
            found = tuple(substitute(parse(cell, scope, Place(name)), lengths, angles) for cell in cells)
        except NotationError as error:
            raise UnreadableError(*map(str, error.problems)) from None
        except DimensionError as error:
            raise UnreadableError(f"{name}: {error.message} ({error.hint})") from None
        if not any(symbols(expr) for expr in found) and example.startswith("+"):
            _finite(found, text, name)
        return found


def _finite(coordinates: Sequence[Expr], text: str, name: str) -> Point:
    """A point by its coordinates.

    Raises:
        UnreadableError: One of them is not finite.
    """
    try:
        point = point_of(coordinates)
    except (OverflowError, ZeroDivisionError):
        point = {ONE: (math.inf, 0.0, 0.0)}
    if not all(math.isfinite(value) for vector in point.values() for value in vector):
        raise UnreadableError(f"{name}: {text.strip():.60} is not three finite numbers")
    return {letter: vector for letter, vector in point.items() if any(vector)}
