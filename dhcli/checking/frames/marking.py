"""Judging frames: every assignment that keeps the rules is right, and what is drawn otherwise than ours is named."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

from dhcli.checking.exercise import Exercise
from dhcli.checking.frames.reading import TypedFrame
from dhcli.checking.frames.rules import ORIGIN_CELL, X_CELL, Z_CELL, Broken, Rules
from dhcli.checking.frames.sketch import Sketch
from dhcli.checking.tables.cells import dh_table_text, on_sheet
from dhcli.checking.verdicts import CellMark, Mark, Verdict
from dhcli.geometry.vectors import Vector, angle_about, dot
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.describe.drawn import Frame, same_direction
from dhcli.kinematics.describe.exact import exact_angle, exact_factor
from dhcli.kinematics.describe.linear import Ruler, along, coordinates_of, length_of, moved
from dhcli.kinematics.describe.process import axis_word, with_variable
from dhcli.notation.writer import write

MOST_SAID = 4
"""Broken rules that are told; of more, how many there are."""

_NAMES = ("o", "x", "z")


def mark_frames(exercise: Exercise, rules: Rules, typed: Sequence[TypedFrame]) -> Mark:
    """Judge frames by the rules."""
    sketch = rules.sketch
    broken = rules.broken(typed)
    read, right = (
        [frame_text(frame, exercise) for frame in frames] for frames in ([one.frame for one in typed], sketch.frames)
    )
    reading, expected = "; ".join(read), "; ".join(right)
    if not broken:
        remarks = tuple(_freedoms(rules, typed))
        table = on_sheet(table_of(sketch, [one.frame for one in typed]), exercise)
        rows = dh_table_text(table, sketch.robot.columns, exercise.writing)
        told = (*remarks, f"your frames give the table {rows}") if remarks else ()
        return Mark(Verdict.RIGHT, reading, remarks=told, earned=1.0, expected=expected)
    cells = tuple(_cells(right, sketch, typed, broken))
    counted = [cell for cell in cells if cell.counted or cell.verdict is Verdict.WRONG]
    is_work = len(set(read)) > 1
    earned = is_work * sum(cell.verdict is Verdict.RIGHT for cell in counted) / len(counted)
    said = tuple(_said(one) for one in broken[:MOST_SAID])
    more = (f"and {len(broken) - MOST_SAID} more",) if len(broken) > MOST_SAID else ()
    return Mark(Verdict.WRONG, reading, cells, (*said, *more), earned, expected)


def frames_text(frames: Sequence[Frame], exercise: Exercise) -> str:
    """Frames as a person would type them in one line."""
    return "; ".join(frame_text(frame, exercise) for frame in frames)


def frame_text(frame: Frame, exercise: Exercise, *, left: bool = False) -> str:
    """A frame as a person would type it: `(a1, 0, 0) +x +z`; a left-handed one with its y axis."""
    coordinates = (exercise.on_sheet(expr) for expr in coordinates_of(frame.origin))
    origin = f"({', '.join(write(expr, 'short', exercise.writing) for expr in coordinates)})"
    x, z = (_direction(vector) for vector in (frame.x, frame.z))
    if left:
        return f"o = {origin}, x = {x}, y = {_direction((-frame.y[0], -frame.y[1], -frame.y[2]))}, z = {z}"
    return f"{origin} {x} {z}"


def _direction(vector: tuple[float, float, float]) -> str:
    word = axis_word(vector)
    return word if not word.startswith("(") else f"({', '.join(write(exact_factor(part)) for part in vector)})"


def _said(one: Broken) -> str:
    return f"{one.rule}: {one.said}" if one.rule.startswith("DH") else one.said


def _cells(
    texts: Sequence[str], sketch: Sketch, typed: Sequence[TypedFrame], broken: Sequence[Broken]
) -> Iterator[CellMark]:
    """The origin, x and z of each frame.

    What is free earns nothing, nor what lies as the base does, which one need not have found; it only costs something
    where it breaks a rule.
    """
    wrong = {(one.frame, one.cell) for one in broken}
    base = Frame()
    for k, (one, right, shown) in enumerate(zip(typed, sketch.frames, texts, strict=True)):
        has_axis, has_normal = sketch.axis_of(k) is not None, sketch.other_of(k) is not None
        counted = {
            ORIGIN_CELL: (has_axis or has_normal) and bool(right.origin),
            X_CELL: has_normal and dot(right.x, base.x) < 1 - _NEAR,
            Z_CELL: has_axis and dot(right.z, base.z) < 1 - _NEAR,
        }
        for cell, name in enumerate(_NAMES):
            verdict = Verdict.WRONG if (k, cell) in wrong else Verdict.RIGHT
            text = " ".join(one.texts.get(name, "").split())
            yield CellMark(k, cell, verdict, text, shown, counted=counted[cell])


def _freedoms(rules: Rules, typed: Sequence[TypedFrame]) -> Iterator[str]:
    """What is drawn otherwise than in the solution, and may be."""
    sketch = rules.sketch
    for k, (one, right) in enumerate(zip(typed, sketch.frames, strict=True)):
        frame, line = one.frame, sketch.axis_of(k)
        z, x, o = (rules.name(letter, k) for letter in "zxo")
        if line is not None and dot(frame.z, right.z) < 0:
            yield f"your {z} points the other way, and {line.name} counts against it"
        elif dot(frame.z, right.z) < 1 - _NEAR:
            yield f"{z} is {axis_word(frame.z)}, and may be"
        if dot(frame.x, right.x) < -1 + _NEAR:
            yield f"your {x} points the other way"
        elif dot(frame.x, right.x) < 1 - _NEAR:
            yield f"your {x} is {axis_word(frame.x)}, and may be"
        if rules.amount(moved(frame.origin, right.origin, -1)):
            yield f"your {o} stands elsewhere on {z}" if line is not None else f"your {o} stands elsewhere"


_NEAR = 1e-4
"""What two directions may differ by in their cosine and are not told apart."""


def table_of(sketch: Sketch, frames: Sequence[Frame]) -> tuple[Row, ...]:
    """The rows of frames that keep the rules.

    A joint whose z axis points against it moves it the other way. A standard row turns about the z axis of the frame
    before and ends along the x axis of its own frame; a modified one begins with the x axis of the frame before.
    """
    ruler = Ruler(sketch.values, sketch.size)
    is_standard = sketch.convention is Convention.STANDARD
    rows = []
    for k, line in enumerate(sketch.axes):
        here, there = frames[k], frames[k + 1]
        x, z = (there.x, here.z) if is_standard else (here.x, there.z)
        gap = moved(there.origin, here.origin, -1)
        turn, way = angle_about(z, here.x, there.x), ruler.cleaned(along(gap, z))
        own = line if dot(line.direction, z) > 0 else line.reversed()
        joint = with_variable(own, turn, way)
        twist = exact_angle(_twist(x, here.z, there.z))
        rows.append(Row(length_of(ruler.cleaned(along(gap, x))), twist, joint.length, joint.turn))
    return tuple(rows)


def _twist(x: Vector, before: Vector, after: Vector) -> float:
    same = same_direction(before, after)
    return angle_about(x, before, after) if not same else 0.0 if same > 0 else pi
