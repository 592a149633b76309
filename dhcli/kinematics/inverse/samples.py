"""Random poses of an arm, at which equations are tried before any pose is given."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dhcli.kinematics.inverse.matrices import Actions, value_of
from dhcli.kinematics.inverse.pairings import Loop
from dhcli.kinematics.inverse.polishing import product, spread
from dhcli.kinematics.inverse.steps import One

SAMPLES = 12
"""Random poses that an equation is tried at."""

SEED = 5


class Samples:
    """Random poses of an arm with all its joint values."""

    def __init__(self, actions: Actions) -> None:
        """Draw them."""
        axes = actions.arm.axes
        turns = np.array([axis.turns for axis in axes], dtype=bool)
        low, high = np.where(turns, -np.pi, 0.2), np.where(turns, np.pi, 1.2)
        self.actions = actions
        self.values = low + (high - low) * spread(SAMPLES, len(axes), SEED)
        self.goal = product(actions.arm, self.values)

    def loop(self, known: Sequence[int]) -> Loop:
        """The loop at these poses with some joints known."""
        return Loop(self.actions, self.goal, {j: self.values[:, j] for j in known})

    def gap(self, loop: Loop, step: One) -> float:
        """How far the equations of a step are from holding: not at all, unless axes are only nearly parallel."""
        u, v = value_of(self.values[:, step.joint], turns=self.actions.arm.axes[step.joint].turns)
        values = np.stack([np.ones_like(u), u, v], axis=1)
        worst = 0.0
        for equation in step.equations:
            x = self.actions.fixed(equation.cut.kind, equation.cut.second)
            y = self.actions.fixed(equation.cut.kind, equation.cut.first)
            number = y.tolist().index(list(equation.y)) * len(x) + x.tolist().index(list(equation.x))
            rows = loop.tensor(equation.cut, (step.joint,))[:, number]
            worst = max(worst, float(np.abs((rows * values).sum(axis=1)).max()) / equation.size)
        return worst
