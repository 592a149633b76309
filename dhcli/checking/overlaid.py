"""What an answer puts over the arm: frames, or the one of a matrix, a rotation or a position."""

from __future__ import annotations

import math
from collections.abc import Sequence

from dhcli.algebra.floats import Floats
from dhcli.checking.entries import Entries
from dhcli.checking.exercise import Exercise
from dhcli.checking.frames.reading import TypedFrame
from dhcli.checking.frames.rules import Rules
from dhcli.checking.frames.sketch import at_values
from dhcli.checking.returned import Overlaid
from dhcli.checking.wanted import Wanted
from dhcli.geometry.vectors import Vector, plus
from dhcli.kinematics.frames import View
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values, numbers
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.traced import Traced
from dhcli.scene.vectors import Frame

DRAWN = frozenset({"pose", "rotation", "position"})
"""Pieces of a matrix that say where a frame is, or how it is turned."""


def overlaid_matrix(exercise: Exercise, question: Wanted, entries: Entries, values: Values) -> Overlaid | None:
    """The frame that a matrix describes, seen from the right one that it is measured in.

    What an answer leaves out is taken from the right frame: the place of a rotation, the directions of a position.
    """
    robot, source = exercise.robot, question.source
    if robot is None or not isinstance(source, View) or question.piece not in DRAWN:
        return None
    start, end = (source.end, source.start) if question.inverse else (source.start, source.end)
    floats = Floats(numbers({**values, **exercise.given}))
    rows = [[floats.value(entry.expr) for entry in row] for row in entries]
    if not all(math.isfinite(value) for row in rows for value in row):
        return None
    skeleton = Skeleton.of(robot, values)
    place = dict(zip(robot.frames, _states(robot.frames, skeleton), strict=True))
    seen_from, right = place[start], place[end]
    columns = list(zip(*rows, strict=True))
    x, y, z, origin = right
    if question.piece != "position":
        x, y, z = (seen_from.direction(_vec(column)) for column in columns[:3])
    if question.piece != "rotation":
        origin = plus(seen_from.direction(_vec(columns[-1])), seen_from.origin)
    frame = Frame(x, y, z, origin)
    shown = next(name for name, state in reversed(skeleton.numbered) if skeleton.states[state] is place[end])
    return Overlaid(robot, Traced("your answer", ((end, frame),), (origin,), ((shown, end),)), values)


def overlaid_frames(rules: Rules, typed: Sequence[TypedFrame], robot: Robot, values: Values) -> Overlaid:
    """The frames, the first that breaks a rule marked."""
    over, broken = Floats(numbers(values)), rules.broken(typed)
    frames = [
        (str(rules.sketch.first + k), Frame(one.frame.x, one.frame.y, one.frame.z, at_values(one.frame.origin, over)))
        for k, one in enumerate(typed)
    ]
    wrong = frames[broken[0].frame][0] if broken else None
    line = tuple(frame.origin for _, frame in frames)
    return Overlaid(robot, Traced("your frames", tuple(frames), line, (), wrong=wrong), values)


def _states(frames: tuple[str, ...], skeleton: Skeleton) -> list[Frame]:
    """Where each frame of the robot is; one without a base or a tool has that in the place of its neighbour."""
    known = dict(skeleton.numbered)
    first, last = skeleton.states[0], skeleton.states[-1]
    return [skeleton.states[known[name]] if name in known else first if name == "base" else last for name in frames]


def _vec(column: tuple[float, ...]) -> Vector:
    return column[0], column[1], column[2]
