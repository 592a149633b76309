"""Frames that were typed, over the arm in the pose drawn."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.algebra.floats import Floats
from dhcli.checking.frames.reading import TypedFrame
from dhcli.checking.frames.rules import Rules
from dhcli.checking.frames.sketch import Sketch, at_values
from dhcli.checking.returned import Overlaid
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import Values, numbers
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO
from dhcli.scene.traced import Traced
from dhcli.scene.vectors import Frame


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


def joints_drawn(sketch: Sketch) -> dict[str, Value]:
    """The value of every joint in the pose drawn."""
    turns = {line.name: line.turns for line in sketch.axes}
    return {name: sketch.pose.get(name, Angle() if turn else ZERO) for name, turn in turns.items()}
