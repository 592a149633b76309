"""What a person should know of many joint values that can be computed all the same: said once, with how often."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import plural
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.limits import SLACK
from dhcli.kinematics.placement import locked_words
from dhcli.kinematics.robot import Robot

if TYPE_CHECKING:
    from numpy.typing import NDArray

_ROWS_IN_ONE = 64
"""Rows that lie in one where the least of each column is looked for."""


class Tally:
    """Counts rows of joint values that a person would be warned about one by one."""

    def __init__(self, robot: Robot) -> None:
        """Count nothing yet."""
        self.rows = 0
        self._robot = robot
        self._limits = {name: (in_floats(low), in_floats(high)) for name, (low, high) in robot.limits.items()}
        self._outside: Counter[str] = Counter()
        self._turning: Counter[str] = Counter()
        self._any_outside = 0
        self._locked: Counter[str] = Counter()

    def take(
        self, q: NDArray[np.float64], in_radians: tuple[bool, ...], *, locked: Mapping[str, int] | None = None
    ) -> None:
        """Look at rows.

        Args:
            q: Joint values, shape (N, n); radians and metres.
            in_radians: Whether each joint's values were taken for radians.
            locked: Of each form of three angles, in how many of them only two can be told.
        """
        self.rows += len(q)
        self._locked.update(locked or {})
        if not len(q):
            return
        outside = np.zeros(len(q), dtype=np.bool_)
        extremes = zip(_along(np.minimum, q), _along(np.maximum, q), strict=True)
        for k, (joint, (least, most)) in enumerate(zip(self._robot.joints, extremes, strict=True)):
            low, high = self._limits.get(joint.name, (-math.inf, math.inf))
            if least < low - SLACK or most > high + SLACK:
                beyond = (q[:, k] < low - SLACK) | (q[:, k] > high + SLACK)
                self._outside[joint.name] += int(beyond.sum())
                outside |= beyond
            if in_radians[k] and joint.kind == "revolute" and max(-least, most) > math.tau:
                self._turning[joint.name] += int((np.abs(q[:, k]) > math.tau).sum())
        self._any_outside += int(outside.sum())

    def warnings(self) -> Iterator[str]:
        """One sentence for each thing to know."""
        if turning := _listed(self._turning):
            yield f"more than a turn: {turning} of {plural(self.rows, 'row')}; did you mean degrees, --deg?"
        if outside := _listed(self._outside):
            yield f"{self._any_outside} of {plural(self.rows, 'row')} outside the limits of a joint: {outside}"
        for form, count in self._locked.items():
            if count:
                yield locked_words(form, f" in {count} of {plural(self.rows, 'row')}")


def _along(chosen: np.ufunc, q: NDArray[np.float64]) -> list[float]:
    """The least or the most of each column, of which there is a row or more.

    Many rows lie in one: numpy compares two rows so long in a fraction of the time that it takes for two short ones.
    """
    whole = len(q) - len(q) % _ROWS_IN_ONE
    if whole:
        wide = chosen.reduce(q[:whole].reshape(-1, _ROWS_IN_ONE * q.shape[1]))
        q = np.concatenate((wide.reshape(_ROWS_IN_ONE, -1), q[whole:]))
    chosen_of_each: list[float] = chosen.reduce(q).tolist()
    return chosen_of_each


def _listed(counts: Counter[str]) -> str:
    """`theta1 in 3, theta2 in 5`."""
    return ", ".join(f"{name} in {count}" for name, count in counts.items() if count)
