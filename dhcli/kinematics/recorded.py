"""What was worked out once for a robot and is played again: its products, recorded, and kept with it."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar, cast
from weakref import ref

from dhcli.algebra.compiled import Play, compiled
from dhcli.algebra.program import Program, assemble
from dhcli.algebra.tape import Number, Tape
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers, parameter_values, require
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from dhcli.algebra.kernel import Kernel

T = TypeVar("T")

MOST = 512
"""Things that are kept in one process, whatever the number of robots: some tens of megabytes at most."""

_KEPT: deque[tuple[ref[Robot], Hashable]] = deque()
"""Whose they are, the oldest first."""


def kept(robot: Robot, key: Hashable, make: Callable[[], T]) -> T:
    """What was made for a robot before, or is made now and kept with it until `MOST` others came after it."""
    memory = robot.recorded
    found = memory.get(key)
    if found is None:
        found = memory[key] = make()
        _KEPT.append((ref(robot), key))
        while len(_KEPT) > MOST:
            owner, oldest = _KEPT.popleft()
            if (other := owner()) is not None:
                other.recorded.pop(oldest, None)
    return cast("T", found)


class Recording:
    """The steps from joint values to some numbers, in each of the forms in which they are played."""

    def __init__(
        self,
        variables: Sequence[str],
        values: Mapping[str, Angle | float],
        results: Callable[[Tape, bool], Sequence[Number]],
    ) -> None:
        """Record nothing yet.

        Args:
            variables: The joint variables in order.
            values: Values of the other names: exact angles, radians, metres.
            results: What is wanted, worked out over a tape; with parallel joints merged, which takes far fewer steps
                but loses digits of large angles, or with each joint by itself.
        """
        self._variables, self._values, self._results = tuple(variables), values, results
        self._programs: dict[tuple[bool, bool], Program] = {}
        self._kernels: dict[bool, Kernel | None] = {}
        self._is_asked = False

    def program(self, *, merged: bool, tangents: bool = False) -> Program:
        """The steps.

        Args:
            merged: Whether parallel joints are merged.
            tangents: Whether cosines and sines are taken by the tangent of the half angle, as suits numpy.
        """
        if (merged, tangents) not in self._programs:
            tape = Tape(self._variables, self._values, tangents=tangents)
            self._programs[merged, tangents] = assemble(tape, self._results(tape, merged))
        return self._programs[merged, tangents]

    def kernel(self, *, merged: bool) -> Kernel | None:
        """The steps for the compiled loop; None where it does not know one of them."""
        from dhcli.algebra.kernel import Kernel  # numpy, which one pose does not need

        if merged not in self._kernels:
            try:
                self._kernels[merged] = Kernel(self.program(merged=merged))
            except KeyError:
                self._kernels[merged] = None
        return self._kernels[merged]

    @cached_property
    def one(self) -> Play:
        """The steps as a function of one row of joint values, good at angles of any size."""
        return compiled(self.program(merged=False))

    def again(self, q: Sequence[float]) -> tuple[float, ...] | None:
        """The results for one row of joint values, the same as by the fold.

        What is asked for once is had sooner without recording anything, so the first time there are none; nor are there
        where only the general way can tell what is wrong.
        """
        if not self._is_asked:
            self._is_asked = True
            return None
        try:
            found = self.one(q)
            # what is infinite or no number makes a sum one; a sum of numbers too large goes the long way for nothing
            return found if math.isfinite(sum(q) + sum(found)) else None
        except (ArithmeticError, ValueError):
            return None


def recorded_chain(chain: Chain, variables: Sequence[str], values: Mapping[str, Angle | float]) -> Recording:
    """The 16 entries of the product of a chain, row by row."""

    def entries(tape: Tape, merged: bool) -> list[Number]:  # noqa: FBT001  called by `Recording` alone
        return [entry for row in fold(merge(chain) if merged else chain, tape) for entry in row]

    return Recording(variables, values, entries)


def recorded_pose(robot: Robot, start: str, end: str, values: Mapping[str, Angle | float] | None = None) -> Recording:
    """The 16 entries of a pose, row by row, kept with the robot.

    Args:
        robot: The robot.
        start: The frame it is seen from.
        end: The frame described.
        values: Exact angles, and metres, of the names that are no joints; the robot's own by default.

    Raises:
        RobotError: A name has no value.
    """

    def record() -> Recording:
        known = numbers(parameter_values(robot, {})) if values is None else values
        chain = between(robot, start, end)
        require(robot, chain, {**known, **dict.fromkeys(robot.variables, Angle())})
        return recorded_chain(chain, robot.variables, known)

    return kept(robot, (start, end, None if values is None else tuple(values.items())), record)
