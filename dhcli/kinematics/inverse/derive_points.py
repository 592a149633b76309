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


class Points:
    """Random joint values of a robot, with the pose they lead to: what letters are tried on."""

    def __init__(self, robot: Robot, start: str, end: str) -> None:
        """Draw them; lengths without a value are drawn too."""
        draw = random.Random(17)  # noqa: S311  a fixed seed, for the same derivation every time
        self.values_of: list[dict[str, Angle | float]] = []
        chain = between(robot, start, end)
        for _ in range(SAMPLES):
            values: dict[str, Angle | float] = {}
            for name in sorted(symbols_of_chain(robot, start, end)):
                turning = name in robot.angles
                values[name] = draw.uniform(-3, 3) if turning else draw.uniform(0.2, 1.3)
            self.values_of.append({**values, **pose_values(chain, values)})
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


def pose_values(chain: Chain, values: Mapping[str, Angle | float]) -> dict[str, float]:
    """The entries of a pose by their names."""
    rows = fold(chain, Floats(dict(values)))
    named = {f"r{i + 1}{j + 1}": float(rows[i][j]) for i in range(3) for j in range(3)}
    return named | {name: float(rows[i][3]) for i, name in enumerate(POSITION)}


def symbols_of_chain(robot: Robot, start: str, end: str) -> frozenset[str]:
    """The names that stand between two frames."""
    return names(between(robot, start, end))
