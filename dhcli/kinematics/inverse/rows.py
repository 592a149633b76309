"""Candidates on their way through a plan: for each the pose it is for, the joints known, and how it came about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.motions import Entry, carried, expanded, form, rotated, translated
from dhcli.kinematics.inverse.pairings import GOAL, Loop

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags, Ints
    from dhcli.kinematics.inverse.matrices import Actions
    from dhcli.kinematics.inverse.steps import Equation

NOISE = 1e-15
"""What rounding leaves in an equation before anything is known."""

ROUNDED = 1e-12
"""An equation that holds to this holds, and only rounding keeps it from doing so exactly."""


@dataclass
class Rows:
    """Candidates, one a row.

    Attributes:
        actions: How the joints act.
        goal: The poses asked for, entry by entry, shape (12, P): nine direction cosines, three lengths.
        index: The pose of each row, shape (N,).
        known: For each joint known cosine and sine, or length and half its square, each (N,).
        path: The choices among roots that led to each row, as digits, shape (N,).
        free: Joints that may take any value in each row, as bits, shape (N,).
        draw: Which of the values tried for them, shape (N,).
        loss: How far rounding may have moved what is known, shape (N,).
    """

    actions: Actions
    goal: Array
    index: Ints
    known: dict[int, tuple[Array, Array]]
    path: Ints
    free: Ints
    draw: Ints
    loss: Array
    _memo: dict[object, Sequence[Entry]] = field(default_factory=dict)

    @classmethod
    def start(cls, actions: Actions, goal: Array, held: Mapping[int, tuple[Array, Array]], slack: float = 0.0) -> Rows:
        """A row for each pose (P, 4, 4), with the values of joints that are held."""
        columns = np.ascontiguousarray(np.concatenate([goal[:, :3, :3].reshape(-1, 9), goal[:, :3, 3]], axis=1).T)
        zeros = np.zeros(len(goal), dtype=np.int64)
        index = np.arange(len(goal))
        return cls(
            actions,
            columns,
            index,
            dict(held),
            zeros,
            zeros,
            zeros,
            np.full(len(goal), max(NOISE, slack if slack > ROUNDED else 0.0)),
        )

    def __len__(self) -> int:
        return len(self.index)

    def take(self, at: Ints | Flags) -> Rows:
        """Some of the rows, or some of them several times."""
        known = {j: (u[at], v[at]) for j, (u, v) in self.known.items()}
        path, free, draw = self.path[at], self.free[at], self.draw[at]
        return Rows(self.actions, self.goal, self.index[at], known, path, free, draw, self.loss[at])

    def joined(self, other: Rows) -> Rows:
        """These rows and others."""
        if not len(self) or not len(other):
            return other if not len(self) else self
        both = {
            j: (np.concatenate([u, other.known[j][0]]), np.concatenate([v, other.known[j][1]]))
            for j, (u, v) in self.known.items()
        }
        pairs = (
            (self.index, other.index),
            (self.path, other.path),
            (self.free, other.free),
            (self.draw, other.draw),
        )
        index, path, free, draw = (np.concatenate(pair) for pair in pairs)
        return Rows(self.actions, self.goal, index, both, path, free, draw, np.concatenate([self.loss, other.loss]))

    def poses(self) -> Array:
        """The pose asked for in each row, shape (N, 4, 4)."""
        result = np.zeros((len(self), 4, 4))
        columns = self.goal[:, self.index]
        result[:, :3, :3] = columns[:9].T.reshape(-1, 3, 3)
        result[:, :3, 3] = columns[9:].T
        result[:, 3, 3] = 1
        return result

    def motions(self, count: int) -> Array:
        """Motions of the joints, shape (N, count), those not known 0."""
        result = np.zeros((len(self), count))
        for j, (u, v) in self.known.items():
            if j < count:
                result[:, j] = np.arctan2(v, u) if self.actions.arm.axes[j].turns else u
        return result

    def loop(self) -> Loop:
        """The loop with what is known, for work with whole matrices."""
        count = len(self.actions.arm.axes)
        motions = self.motions(count)
        return Loop(self.actions, self.poses(), {j: motions[:, j] for j in self.known})

    def coefficients(self, equation: Equation, joint: int) -> tuple[Entry, Entry, Entry]:
        """The three coefficients of an equation in one joint."""
        total: list[Entry] = [0.0, 0.0, 0.0]
        cut = equation.cut
        for sign, walk, back in ((1.0, cut.between, False), (-1.0, cut.around, True)):
            if joint not in walk:
                total[0] = total[0] + sign * form(cut.kind, equation.y, self._walk(cut.kind, equation.x, walk, back))
                continue
            at = walk.index(joint)
            x = self._walk(cut.kind, equation.x, walk[:at], back)
            y = self._walk(cut.kind, equation.y, walk[:at:-1], not back)
            axis = self.actions.arm.axes[joint]
            parts = [form(cut.kind, y, part) for part in expanded(cut.kind, x, axis)]
            turned = (1.0, 1.0, -1.0) if axis.turns else (1.0, -1.0, 1.0)
            for k in range(3):
                total[k] = total[k] + (sign * turned[k] if back else sign) * parts[k]
        return total[0], total[1], total[2]

    def carry(self, kind: int, thing: Sequence[Entry], walk: Sequence[int]) -> Sequence[Entry]:
        """A thing carried by the joints of a walk."""
        return self._walk(kind, thing, tuple(walk), back=False)

    def _walk(self, kind: int, thing: Sequence[Entry], walk: tuple[int, ...], back: bool) -> Sequence[Entry]:  # noqa: FBT001
        """A thing carried along a walk; what was carried before is kept."""
        if not walk:
            return thing
        key = kind, thing, walk, back
        if key not in self._memo:
            before = self._walk(kind, thing, walk[:-1], back)
            self._memo[key] = self._step(kind, before, walk[-1], back=back)
        return self._memo[key]

    def _step(self, kind: int, thing: Sequence[Entry], joint: int, *, back: bool) -> Sequence[Entry]:
        if joint != GOAL:
            return carried(kind, thing, self.actions.arm.axes[joint], self.known[joint], back=back)
        g = self._columns()
        if back:
            return translated(kind, rotated(kind, thing, (g[0:3], g[3:6], g[6:9])), g[9:])
        there = translated(kind, thing, [-part for part in g[9:]])
        return rotated(kind, there, (g[0:9:3], g[1:9:3], g[2:9:3]))

    def _columns(self) -> Sequence[Entry]:
        """The entries of the pose asked for, a column each."""
        if GOAL not in self._memo:
            self._memo[GOAL] = list(self.goal[:, self.index])
        return self._memo[GOAL]
