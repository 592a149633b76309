"""Solutions of arms whose variables share moves, where those cannot be solved for one by one and carried back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from math import lcm
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.errors import plural
from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.inverse.anatomy import NOTHING, anatomy, posture
from dhcli.kinematics.inverse.arm import arm_of
from dhcli.kinematics.inverse.branches import with_values
from dhcli.kinematics.inverse.choosing import rank
from dhcli.kinematics.inverse.led import STARTS, Arrived, Driven, arrive, where_reached
from dhcli.kinematics.inverse.question import stands
from dhcli.kinematics.inverse.reasons import too_far, what_never_changes
from dhcli.kinematics.inverse.solutions import (
    Free,
    Solutions,
    held_values,
    in_numbers,
    shown_value,
    turning_joints,
)
from dhcli.kinematics.inverse.targets import read_target
from dhcli.kinematics.inverse.tasks import for_task, task_called
from dhcli.kinematics.inverse.turns import at_rest, limits_of, outside
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.values import joint_values, numbers, parameter_values
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhcli.kinematics.inverse.arm import Array
    from dhcli.kinematics.inverse.carried import Carried

_RATIO = 12
"""Denominators of ratios up to which a turn of a variable is counted on until all moves are where they were."""

_NEARLY = 1e-2
"""A pose that is left by less [reaches, direction cosines] is nearly reached."""

_SAME = 1e-3
"""By what share of it more may be left where it is the same, of several ways to stand."""


@frozen
class Leading:
    """A robot whose variables are led to a pose.

    Attributes:
        carried: The robot, and the arm with a variable for each move.
        driven: The arm's motions by those variables that move the end.
        columns: The numbers of these variables.
        units: What one unit of each is, in radians or metres.
    """

    carried: Carried
    driven: Driven
    columns: tuple[int, ...]
    units: Array

    @classmethod
    def of(cls, carried: Carried, asked: Mapping[str, Any]) -> Leading:
        """The robot for what is asked of it."""
        robot, free = carried.robot, carried.arm
        chain = between(free, *ends(free, asked["start"], asked["end"]))
        task = task_called(asked["task"])
        values = numbers(parameter_values(robot, asked["parameters"]))
        arm = for_task(arm_of(chain, free.variables, values), task)
        rows = [free.variables.index(axis.name) for axis in arm.axes[: arm.joints]]
        slopes = carried.slopes[rows]
        columns = tuple(np.flatnonzero((slopes != 0).any(axis=0)).tolist())
        turning = turning_joints(robot)[list(columns)]
        units = np.where(turning, 1.0, arm.reach)
        mix = arm.factors[:, None] * slopes[:, columns] * units
        period = 2 * np.pi * np.array([_turns(mix[:, k], arm.turning) for k in range(len(columns))])
        half = np.where(turning, np.maximum(period / 2, np.pi), 1.0)
        limits = limits_of(robot)[list(columns)] / units[:, None]
        low, high = (np.where(turning | ~np.isfinite(limits).all(axis=1), s * half, limits[:, k])
                     for k, s in enumerate((-1, 1)))  # fmt: skip
        return cls(
            carried, Driven(arm, task, mix, carried.offsets[rows] * arm.factors, low, high, period), columns, units
        )

    @property
    def moves(self) -> str:
        """How many moves how many variables make, in words."""
        return f"{plural(self.driven.arm.joints, 'move')} by {plural(len(self.columns), 'variable')}"

    def said(self, free: int | None = None) -> str:
        """That the variables are led there from many places, for so many that are not held."""
        places = "many places" if free is None else f"{STARTS * max(free, 1)} places"
        return f"{self.moves}: looked for from {places}, which may not find all"

    def is_needed(self, hold: Mapping[str, float | str | Angle] | None) -> bool:
        """Whether the moves are more than the task determines, or what is held moves with others."""
        names = self.carried.robot.variables
        held = [names.index(name) for name in held_values(hold) if name in names]
        if any(names[j] not in self.carried.alone for j in held):
            return True
        if self.carried.is_whole:
            return False
        arm, at = self.driven.arm, [k for k, j in enumerate(self.columns) if j in held]
        still = tuple(np.flatnonzero(~np.delete(self.driven.mix, at, axis=1).any(axis=1)).tolist())
        return rank(arm, self.driven.task, still) < arm.joints - len(still)

    def solutions(
        self,
        T: ArrayLike | Pose[float],  # noqa: N803
        asked: Mapping[str, Any],
        standing: Mapping[str, float],
        begun: Array | None = None,
    ) -> Solutions:
        """What is found for one pose.

        Args:
            T: The pose.
            asked: What else `inverse` takes.
            standing: Joint values, by name, that it was given by; variables to spare are held at them.
            begun: Values of the robot's variables that may be near to a solution, shape (K, n).
        """
        robot, driven, at = self.carried.robot, self.driven, list(self.columns)
        pose, said = read_target(T, driven.task)
        goal = driven.arm.goal(pose[None])[0]
        best = self._best(asked["near"])
        stood = np.array([standing.get(name, best[j]) for j, name in enumerate(robot.variables)])
        at_stood = stood[at] / self.units
        held = self._asked_to_hold(asked)
        chosen = driven.to_hold(tuple(held))
        more = np.empty((0, len(at))) if begun is None else begun[:, at] / self.units
        at_best = best[at] / self.units
        fixed = [dict(zip(chosen, row, strict=True)) for row in self._held(chosen, at_stood, asked.get("family"))]
        found = [arrive(driven, goal, at_best, held | more_held, more, asked["tolerance"]) for more_held in fixed]
        if not any(len(part.x) for part in found) and chosen and not asked.get("family"):
            other = where_reached(driven, goal, at_stood, held, chosen, asked["tolerance"])
            found = [arrive(driven, goal, at_best, held | other, more, asked["tolerance"])] if other else found
        answer = self._answer(found, best, (*held, *chosen))
        remarks = [*said]
        if chosen:
            names = ", ".join(robot.variables[at[j]] for j in sorted(chosen))
            if len(answer) and not asked.get("family"):
                names = ", ".join(shown_value(robot, at[j], float(answer.q[0, at[j]])) for j in sorted(chosen))
                own = [robot.variables[at[j]] for j in chosen]
                names += stands(dict(zip(robot.variables, answer.q[0].tolist(), strict=True)), own, standing)
            remarks.append(f"{robot.name} has {plural(len(chosen), 'joint')} more than this needs: held {names}")
        remarks.append(self.said(len(at) - len(held) - len(chosen)))
        if not len(answer):
            tried = f"nothing that was tried leads there: {self.moves}"
            why, closest = self.what_keeps(T) or tried, self.closest(T, asked)
            answer = replace(answer, reachable=False, why=why, closest=closest)
        return replace(answer, remarks=tuple(remarks))

    def closest(self, T: ArrayLike | Pose[float], asked: Mapping[str, Any]) -> Array | None:  # noqa: N803
        """Values of the robot's variables (n,) that nearly lead to a pose; None where none do that are found.

        Newton's steps come to rest where the pose is nearest if it is near, and anywhere if it is not.
        """
        driven, at = self.driven, list(self.columns)
        pose, _ = read_target(T, driven.task)
        held = self._asked_to_hold(asked)
        x, left, _ = driven.led(driven.begun(held), driven.arm.goal(pose[None])[0], tuple(held), asked["tolerance"])
        if not left.min() < _NEARLY:
            return None
        alike = np.flatnonzero(left <= left.min() * (1 + _SAME))
        wish, limits = self._best(asked["near"]), limits_of(self.carried.robot)
        rows = np.tile(wish, (len(alike), 1))
        rows[:, at] = driven.wrapped(x[alike]) * self.units
        beyond = [len(outside(self.carried.robot, q, limits)) for q in rows]
        return np.asarray(rows[np.lexsort((np.linalg.norm(rows - wish, axis=1), beyond))[0]])

    def _asked_to_hold(self, asked: Mapping[str, Any]) -> dict[int, float]:
        """Values of the variables to be held, in their units, by their places among those that move the end."""
        robot, at = self.carried.robot, list(self.columns)
        given = joint_values(robot, dict(held_values(asked["hold"])))
        held = {robot.variables.index(name): in_floats(value) for name, value in given.items()}
        return {at.index(j): value / self.units[at.index(j)] for j, value in held.items() if j in at}

    def what_keeps(self, T: ArrayLike | Pose[float]) -> str:  # noqa: N803
        """What no pose of the arm has and this one would need; empty where that is not known."""
        arm, task = self.driven.arm, self.driven.task
        pose, _ = read_target(T, task)
        kept = what_never_changes(arm, task, pose, self.driven.mix, self.driven.zero)
        return "; ".join(list(kept) or too_far(arm, task, arm.goal(pose[None])[0]))

    def _best(self, near: Any) -> Array:  # noqa: ANN401  whatever form joint values have
        """Where variables should stand: near, else at 0 or in the middle of their limits, shape (n,)."""
        robot = self.carried.robot
        return at_rest(robot) if near is None else np.asarray(in_numbers(robot, near))

    def _held(self, chosen: tuple[int, ...], best: Array, family: int | None) -> list[list[float]]:
        """Values of the variables that are held without having been asked for."""
        if not chosen or not family:
            return [[float(best[j]) for j in chosen]]
        low, high = self.driven.low[list(chosen)], self.driven.high[list(chosen)]
        return [(low + (high - low) * share).tolist() for share in np.linspace(0, 1, family)]

    def _answer(self, found: list[Arrived], best: Array, held: tuple[int, ...]) -> Solutions:
        """The solutions in the robot's variables."""
        robot, at = self.carried.robot, list(self.columns)
        x = np.vstack([part.x for part in found])
        q = np.tile(best if len(at) < len(best) else np.zeros(len(best)), (len(x), 1))
        q[:, at] = x * self.units
        names = [robot.variables[j] for j in at]
        free = []
        for part in found:
            for ways, moving in zip(part.free, part.moving, strict=True):
                together = ", ".join(names[j] for j in moving)
                words = {
                    j: f"{together} move together, any {names[j]}" if len(moving) > 1 else f"any {names[j]}"
                    for j in ways
                }
                free.append(tuple(Free(names[j], tuple(names[k] for k in moving), words[j]) for j in ways))
        return Solutions(
            robot,
            self.driven.task.name,
            q,
            self._named(found, q),
            np.concatenate([part.residual for part in found]),
            beyond=((),) * len(q),
            free=tuple(free),
            held=tuple((names[j], float(q[0, at[j]])) for j in held) if len(q) else (),
        )

    def _named(self, found: list[Arrived], q: Array) -> tuple[str, ...]:
        """Names for solutions: of a family those with the same values held belong together."""
        driven, names, first = self.driven, list[str](), 0
        order = [self.carried.arm.variables.index(axis.name) for axis in driven.arm.axes[: driven.arm.joints]]
        parts = anatomy(driven.arm) if order == sorted(order) else NOTHING
        for part in found:
            told = self.carried.told(q[first : first + len(part.x)])
            first += len(part.x)
            names += with_values(told, posture(driven.arm, parts, part.x @ driven.mix.T + driven.zero))
        return tuple(names)


def _turns(ratios: Array, turning: Any) -> int:  # noqa: ANN401
    """After how many turns of a variable all its moves are where they were; 0 for never."""
    if not ratios[turning].any() or np.abs(ratios[~turning]).any():
        return 0
    parts = [Fraction(ratio).limit_denominator(_RATIO) for ratio in ratios[turning].tolist()]
    if any(abs(float(part) - ratio) > 1e-9 for part, ratio in zip(parts, ratios[turning].tolist(), strict=True)):  # noqa: PLR2004
        return 0
    return lcm(*(part.denominator for part in parts))
