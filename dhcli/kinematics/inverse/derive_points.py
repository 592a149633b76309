"""What the letters of a derivation are tried on: random joint values of the robot, and the poses they lead to."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping

from dhcli.algebra.floats import Floats
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derive_levels import POSITION
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Call, Expr

SAMPLES = 24
"""Random poses at which signs are looked at, and every formula is tried."""

VANISHES = 1e-9

_SAYS = 1e-4
"""Sine and cosine of an angle, with what they are multiplied by, come to so much where they say something."""

_HALVED = 40
"""How often the way between two samples is halved, to come to where a condition is 0."""


class Points:
    """Random joint values of a robot, with the pose they lead to: what letters are tried on."""

    def __init__(self, robot: Robot, start: str, end: str) -> None:
        """Draw them; lengths without a value are drawn too."""
        draw = random.Random(17)  # noqa: S311  a fixed seed, for the same derivation every time
        self.values_of: list[dict[str, float]] = []
        self._chain, self._drawn = between(robot, start, end), sorted(symbols_of_chain(robot, start, end))
        self._slides = {name for name in robot.variables if name not in robot.angles}
        for _ in range(SAMPLES):
            values: dict[str, float] = {}
            for name in self._drawn:
                turning = name in robot.angles
                values[name] = draw.uniform(-3, 3) if turning else draw.uniform(0.2, 1.3)
            self.values_of.append({**values, **pose_values(self._chain, values)})
        self._over = [Floats(values) for values in self.values_of]  # each keeps the cosines that formulas share

    def values(self, expr: Expr) -> list[float]:
        """An expression at each of them; not where it is no number."""
        found = (over.value(expr) for over in self._over)
        return [value for value in found if math.isfinite(value)]

    def lives(self, step: Step) -> bool:
        """Whether a step gives a number at most of them, and not because everything in it is 0."""
        value = step.value
        if step.two and isinstance(value, Call) and len(value.arguments) == 2:  # noqa: PLR2004  an atan2
            sizes = [math.hypot(*pair) for pair in zip(*map(self.values, value.arguments), strict=False)]
            if len(sizes) <= SAMPLES // 2 or sorted(sizes)[SAMPLES // 4] <= VANISHES:
                return False
        return len(self.values(step.spread or value)) > SAMPLES // 2

    def serves(self, step: Step, other: Step) -> bool:
        """Whether a step finds the same as another, in as many ways, also where the other says nothing."""
        condition = other.condition
        if condition is None or not step.arc or (step.atom, step.two) != (other.atom, other.two):
            return False
        there = self._zero(condition)
        return there is not None and max(abs(there.value(part)) for part in step.arc) > _SAYS

    def _zero(self, condition: Expr) -> Floats | None:
        """A pose at which a condition is 0, if it has different signs at some two; slides are tried backwards too."""
        begins = self._over[0].value(condition) > 0
        first = {name: self.values_of[0][name] for name in self._drawn}
        back = {name: -value if name in self._slides else value for name, value in first.items()}
        for last in (*self.values_of, back):
            if (self._on_the_way(first, last, 1).value(condition) > 0) != begins:
                near, far = 0.0, 1.0
                for _ in range(_HALVED):
                    half = (near + far) / 2
                    over = self._on_the_way(first, last, half)
                    near, far = (half, far) if (over.value(condition) > 0) == begins else (near, half)
                return over
        return None

    def _on_the_way(self, first: Mapping[str, float], last: Mapping[str, float], part: float) -> Floats:
        """A pose that stands between two, so far from the first to the last."""
        values = {name: value + part * (last[name] - value) for name, value in first.items()}
        return Floats({**values, **pose_values(self._chain, values)})


def pose_values(chain: Chain, values: Mapping[str, Angle | float]) -> dict[str, float]:
    """The entries of a pose by their names."""
    rows = fold(chain, Floats(values))
    named = {f"r{i + 1}{j + 1}": float(rows[i][j]) for i in range(3) for j in range(3)}
    return named | {name: float(rows[i][3]) for i, name in enumerate(POSITION)}


def symbols_of_chain(robot: Robot, start: str, end: str) -> frozenset[str]:
    """The names that stand between two frames."""
    return names(between(robot, start, end))
