"""The table that frames give: what leads from each of them to the next."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

from dhcli.checking.frames.sketch import Sketch
from dhcli.geometry.vectors import Vector, angle_about, dot
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.describe.drawn import Frame, same_direction
from dhcli.kinematics.describe.exact import exact_angle
from dhcli.kinematics.describe.linear import Ruler, along, length_of, moved
from dhcli.kinematics.describe.process import with_variable


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
