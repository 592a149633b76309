"""How near joint vectors are to the pose asked for and to its solutions."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise
from dhcli.checking.orientations import angle_between, angle_of, turned
from dhcli.checking.other_unit import RADIANS, is_clear
from dhcli.checking.solving.goal import Rows, Target, of_robot
from dhcli.checking.solving.reading import Vector
from dhcli.checking.tolerance import CLOSE_FACTOR, Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import LENGTH_UNITS

FAR = 0.5
"""Joint values farther than this from any solution [rad or reaches] are not taken for one of them."""


@frozen
class Landing:
    """Where joint values lead.

    Attributes:
        off: Error in tolerances: up to 1 is right.
        solution: The number of the solution that is meant; None where none is near.
        words: By how much the pose is missed.
    """

    off: float
    solution: int | None
    words: str

    @property
    def verdict(self) -> Verdict:
        """Right, close or wrong."""
        if self.off <= 1:
            return Verdict.RIGHT
        return Verdict.CLOSE if self.off <= CLOSE_FACTOR else Verdict.WRONG


def other_units(field: Range) -> tuple[str, ...]:
    """Units that somebody may have typed joint values in, instead of those of the sheet."""
    kinds = {name in field.robot.angles for name in field.joints}
    return (*((RADIANS,) if True in kinds else ()), *(field.exercise.other_units if False in kinds else ()))


def in_unit(field: Range, one: Vector, unit: str) -> Vector:
    """The same with the mere numbers for angles in radians, or with those for lengths in another unit."""
    is_angle = unit == RADIANS
    factor = math.degrees(1) if is_angle else float(LENGTH_UNITS[unit] / field.exercise.metres)
    meant = tuple(
        value * factor if bare and (name in field.robot.angles) is is_angle else value
        for name, value, bare in zip(field.joints, one.values, one.bare, strict=True)
    )
    return replace(one, values=meant)


def shows_unit(field: Range, meant: Sequence[Vector], unit: str, tolerance: Tolerance) -> bool:
    """Whether vectors are right in another unit by no chance: some length that has no unit is not near zero."""
    limit = field.limit(tolerance)
    return unit == RADIANS or any(
        bare and name not in field.robot.angles and is_clear(value, limit)
        for one in meant
        for name, value, bare in zip(field.joints, one.values, one.bare, strict=True)
    )


def chain_of(robot: Robot, target: Target, exercise: Exercise) -> Chain:
    """The moves between the frames asked about, with the values of an exercise."""
    from dhcli.kinematics.forward import put_in
    from dhcli.kinematics.frames import between
    from dhcli.kinematics.merge import merge

    return merge(put_in(between(robot, *target.ends(robot)), of_robot(robot, exercise.known)))


def apart(robot: Robot, joints: Sequence[str], one: Sequence[float], other: Sequence[float]) -> list[float]:
    """By how much each joint differs, whole turns aside [rad, m]."""
    return [
        abs(math.remainder(a - b, math.tau)) if name in robot.angles else abs(a - b)
        for name, a, b in zip(joints, one, other, strict=True)
    ]


@frozen
class Range:
    """What a vector is judged against.

    Attributes:
        robot: The robot.
        joints: The joints that are answered.
        target: The pose asked for.
        rows: The same in numbers, shape (4, 4) [m].
        solutions: Every joint vector that reaches it.
        free: For each the joints that may stand anywhere.
        exercise: The exercise, for its values.
        size: Length of the whole arm [m].
        chain: The moves between the frames asked about.
        lengths: Values of the names in it besides the joints.
    """

    robot: Robot
    joints: tuple[str, ...]
    target: Target
    rows: Rows
    solutions: tuple[tuple[float, ...], ...]
    free: tuple[frozenset[str], ...]
    exercise: Exercise
    size: float
    chain: Chain
    lengths: Mapping[str, Angle | float]

    def elsewhere(self, robot: Robot, target: Target, rows: Rows) -> Range:
        """The same for another robot or another pose, of which no solutions are known."""
        chain = chain_of(robot, target, self.exercise)
        return replace(self, robot=robot, target=target, rows=rows, chain=chain, solutions=(), free=())

    def limit(self, tolerance: Tolerance) -> float:
        """What a length may be off [m]."""
        return tolerance.position if tolerance.position is not None else 1e-3 * max(self.size, 1e-9)

    def landing(self, values: Sequence[float], tolerance: Tolerance) -> Landing:
        """Where joint values lead; right if the pose is met, or if they are a solution's but for rounding."""
        limit = self.limit(tolerance)
        off, words = self._missed(dict(zip(self.joints, values, strict=True)), limit, tolerance.rotation)
        off, nearest = self._beside(values, off, limit, tolerance)
        return Landing(off, nearest, "; ".join(word() for word in words))

    def verdict(self, values: Sequence[float], tolerance: Tolerance) -> Verdict:
        """The verdict on where joint values lead, without a word about it."""
        limit = self.limit(tolerance)
        off, _ = self._missed(dict(zip(self.joints, values, strict=True)), limit, tolerance.rotation)
        return Landing(self._beside(values, off, limit, tolerance)[0], None, "").verdict

    def _beside(
        self, values: Sequence[float], off: float, limit: float, tolerance: Tolerance
    ) -> tuple[float, int | None]:
        """The error of joint values, no more than by which they differ from a solution, and which one that is."""
        nearest, best = None, math.inf
        for k, (solution, free) in enumerate(zip(self.solutions, self.free, strict=True)):
            gaps = apart(self.robot, self.joints, values, solution)
            shares = [
                gap / (math.radians(tolerance.angle) if name in self.robot.angles else limit)
                for name, gap in zip(self.joints, gaps, strict=True)
                if name not in free
            ]
            worst = max(shares, default=0.0)
            if worst < best:
                nearest, best = k, worst
            if not free:
                off = min(off, worst)
        near = best * math.radians(tolerance.angle) <= FAR
        return off, nearest if near else None

    def _missed(self, q: Mapping[str, float], limit: float, rotation: float) -> tuple[float, list[Callable[[], str]]]:
        """By how many tolerances the pose is missed, and what can be said of that."""
        there = fold(self.chain, Floats({**self.lengths, **q}))
        said, off = list[Callable[[], str]](), 0.0
        if self.target.task in ("pose", "position", "axis"):
            far = math.dist([row[3] for row in there[:3]], [row[3] for row in self.rows[:3]])
            off = far / limit
            if off > 1:
                said.append(partial(self._far_words, there, far))
        if self.target.task in ("pose", "orientation"):
            typed, right = ([row[:3] for row in rows[:3]] for rows in (there, self.rows))
            turn = angle_between(typed, right) / rotation
            off = max(off, turn)
            if turn > 1:
                said.append(partial(turned, typed, right))
        if self.target.along:
            typed_z, right_z = ([row[2] for row in rows[:3]] for rows in (there, self.rows))
            turn = angle_of(typed_z, right_z) / rotation
            off = max(off, turn)
            if turn > 1:
                words = f"z points {math.degrees(turn * rotation):.3g}° away from where it should"
                said.append(partial(str, words))
        return off, said

    def _far_words(self, there: Rows, far: float) -> str:
        place = ", ".join(f"{round(row[3] / float(self.exercise.metres), 4) + 0.0:g}" for row in there[:3])
        words = f"these joint values lead to ({place}){self.exercise.behind}"
        return f"{words}, {self.exercise.about(far)} away from the place asked for"
