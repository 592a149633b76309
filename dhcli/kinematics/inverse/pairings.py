"""Where the loop may be cut, and the equations that this gives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.matrices import Actions, acting, forms, value_of
from dhcli.kinematics.inverse.motions import SIZES

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

GOAL = -1
"""The place of the pose asked for in a walk around the loop."""


@frozen
class Cut:
    """The loop cut in two by a run that leaves y fixed and a run that leaves x fixed.

    The equation is `<y, E_l ... E_r x> = <y, (E_1 ... E_k)^-1 G (E_m ... E_n)^-1 x>`.

    Attributes:
        kind: What kind of thing x and y are.
        first: The joints that leave y fixed; empty where y may be anything.
        second: The joints that leave x fixed.
        between: The joints from one run to the other, in the order in which they meet x.
        around: The joints the other way around, undone in this order, with `GOAL` among them.
    """

    kind: int
    first: tuple[int, ...]
    second: tuple[int, ...]
    between: tuple[int, ...]
    around: tuple[int, ...]


def cuts(count: int, unknown: Sequence[int], wanted: Sequence[int]) -> Iterator[Cut]:
    """Every way to cut the loop so that of all unknown joints only those wanted stay in it.

    Args:
        count: How many axes the arm has.
        unknown: The axes that are not known yet.
        wanted: Those of them in which equations are looked for.
    """
    others = [j for j in unknown if j not in wanted]
    for split in range(max(len(others), 1)):
        first, second = others[:split], others[split:]
        a = range(first[0], first[-1] + 1) if first else range(0)
        b = range(second[0], second[-1] + 1) if second else range(wanted[-1] + 1, wanted[-1] + 1)
        if any(j in a or j in b for j in wanted):
            continue
        if not first:
            before = [j for j in wanted if j < b.start]
            a = range(before[0], before[0]) if before else range(0)
        between = tuple(range(b.start - 1, a.stop - 1, -1))
        around = (*range(b.stop, count), GOAL, *range(a.start))
        for kind in range(len(SIZES)):
            yield Cut(kind, tuple(a), tuple(b), between, around)


class Loop:
    """The loop at known values of some joints, for many poses at once.

    Attributes:
        actions: How the joints act.
    """

    def __init__(self, actions: Actions, goal: Array, known: Mapping[int, Array]) -> None:
        """Take poses (N, 4, 4) as `Arm.goal` gives them, and values (N,) of the motions of the joints known."""
        self.actions = actions
        self._goal = goal
        self._known = known
        self._matrices: dict[tuple[int, int, bool], Array] = {}

    def tensor(self, cut: Cut, unknown: Sequence[int]) -> Array:
        """Coefficients of the equations of a cut in some joints.

        Returns:
            Shape (N, m, 3, ..., 3), an axis of three for each unknown, in which 0 stands for 1, and 1 and 2 for
            cosine and sine, or for the length and half its square. The equations are `sum = 0`.
        """
        x = self.actions.fixed(cut.kind, cut.second).T
        y = self.actions.fixed(cut.kind, cut.first) @ forms(cut.kind)
        total = np.zeros((len(self._goal), len(y) * x.shape[1], *(3 for _ in unknown)))
        for sign, walk, back in ((1.0, cut.between, False), (-1.0, cut.around, True)):
            met = [j for j in unknown if j in walk]
            place = tuple(slice(None) if j in met else 0 for j in unknown)
            total[(slice(None), slice(None), *place)] += sign * self.walked(cut.kind, x, y, walk, met, back=back)
        return total

    def walked(
        self, kind: int, x: Array, y: Array, walk: Sequence[int], unknown: Sequence[int], *, back: bool
    ) -> Array:
        """One side of the equations: things x carried along a walk, and paired with things y.

        Args:
            kind: What kind of thing.
            x: A thing in each column.
            y: A thing in each row, as the form takes it.
            walk: The joints met, with `GOAL` among them.
            unknown: Those of them that are unknown.
            back: Whether the joints are undone; the pose asked for is then done.

        Returns:
            Shape (N, m, 3, ..., 3), with N = 1 where nothing on the walk depends on the pose.
        """
        state, met = x[None], list[int]()
        for joint in walk:
            if joint in unknown:
                state = np.stack([part @ state for part in self.actions.signed(kind, joint, back=back)])
                met.insert(0, joint)
            else:
                state = self._matrix(kind, joint, back=back) @ state
        state = y @ state
        # the axes of three come first, the last one met in front: bring them to the order asked for
        order = [state.ndim - 3, state.ndim - 2, state.ndim - 1, *(met.index(j) for j in unknown)]
        state = state.transpose(order)
        return np.asarray(state.reshape(len(state), -1, *state.shape[3:]))

    def _matrix(self, kind: int, joint: int, *, back: bool) -> Array:
        key = kind, joint, back
        if key not in self._matrices:
            if joint == GOAL:
                found = acting(kind, self._goal)
                found = found if back else np.asarray(np.linalg.inv(found))
            else:
                turns = self.actions.arm.axes[joint].turns
                found = self.actions.moved(kind, joint, value_of(self._known[joint], turns=turns), back=back)
            self._matrices[key] = found
        return self._matrices[key]
