"""A path of poses followed on one branch: each pose by the solution nearest to the one before it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.coupling import is_coupled
from dhcli.kinematics.forward import Given
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.inverse.batch import BLOCK, by_itself, inverse_batch, solved_blocks
from dhcli.kinematics.inverse.path_led import SHORT, STEADY, led_along
from dhcli.kinematics.inverse.polishing import polished
from dhcli.kinematics.inverse.question import Question, ask
from dhcli.kinematics.inverse.solutions import in_numbers, turning_joints
from dhcli.kinematics.inverse.solving import least_singular
from dhcli.kinematics.inverse.targets import read_targets
from dhcli.kinematics.inverse.tasks import TaskName
from dhcli.kinematics.inverse.trying import CONFIRMED
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import JointInput
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhcli.kinematics.inverse.arm import Array, Ints
    from dhcli.kinematics.inverse.carried import Carried

JUMP = 4.0
"""A step this many times as long as both its neighbours is a jump to another branch."""

LEAST = 0.05
"""No shorter step is a jump [rad, m]."""

SINGULAR = 1e-3
"""Where the least singular value of the Jacobian is below this, the arm passes a singular pose."""


@frozen
class Path:
    """Joint values along a path.

    Attributes:
        q: Joint values, shape (N, n), angles counted on over full turns; NaN where a pose is out of reach.
        lost: Numbers of the poses out of reach.
        jumps: Numbers of the poses to which the arm has to jump, because its branch ends before them.
        singular: Numbers of the poses at which the arm is singular, or nearly.
    """

    q: Array
    lost: tuple[int, ...] = ()
    jumps: tuple[int, ...] = ()
    singular: tuple[int, ...] = ()

    __eq__ = object.__eq__  # each equals itself only
    __hash__ = object.__hash__

    def __len__(self) -> int:
        return len(self.q)

    def numbered(self, places: Sequence[int]) -> Array:
        """The joint values of the poses reached with where each pose stands in front, shape (M, 1 + n)."""
        there = ~np.isnan(self.q).any(axis=1)
        return np.column_stack([np.array(places)[there], self.q[there]])


def joined(blocks: Sequence[Array]) -> Array:
    """Blocks of poses, shapes (N, 4, 4) or (N, 3), as one."""
    return np.concatenate(blocks)


def follow(  # noqa: PLR0913  what may be asked of a path
    robot: Robot,
    T: ArrayLike,  # noqa: N803  the field's name for poses
    near: JointInput,
    *,
    task: TaskName = "pose",
    hold: Mapping[str, float | str | Angle] | None = None,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    tolerance: float = CONFIRMED,
) -> Path:
    """Joint values along a path of poses, each the nearest to those before it.

    Joints that the task leaves over stand where the path begins; where the path can no longer be followed so, they move
    along with the others from there on.

    Args:
        robot: The robot.
        T: The poses in order, shape (N, 4, 4) [m].
        near: Joint values to begin near to, in whatever form `forward` takes; they choose the branch.
        task: What of the poses counts; see `inverse`.
        hold: Values of joints that are not to be computed.
        start: The frame they are seen from; the first numbered one by default.
        end: The frame that is placed; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.
        tolerance: Residual up to which joint values count as a solution.

    Raises:
        RobotError: T is no array of poses, or a length has no value.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    if near is None:
        raise RobotError("a path needs joint values to begin near to", "give near=")
    if is_coupled(robot):
        from dhcli.kinematics.inverse.carried import Carried  # few robots are

        carried = Carried.of(robot, parameters, start, end)
        if carried is not None:
            asked: dict[str, object] = {"task": task, "start": start, "end": end, "parameters": parameters}
            return _coupled(carried, T, near, hold, {**asked, "tolerance": tolerance})
    question, held = ask(
        robot, task, near=near, hold=hold, start=start, end=end, parameters=parameters, tolerance=tolerance
    )
    poses, _ = read_targets(T, question.ready.task)
    turning, goals = turning_joints(robot), question.ready.arm.goal(poses)
    q = np.full((len(poses), len(robot.variables)), np.nan)
    last, stride = in_numbers(robot, near), 0.0
    has_spare = bool(set(question.ready.plan.held) - held.keys())
    is_led = False  # where joints to spare stand as they did the arm is not any more

    def alone(k: int) -> Array:
        wish = {"near": last.tolist(), "hold": hold, "start": start, "end": end, "parameters": parameters}
        return np.asarray(inverse(robot, poses[k], task=task, tolerance=tolerance, **wish).q)

    def in_turn(rows: Array) -> Array:
        return np.where(turning, rows - 2 * np.pi * np.round((rows - last) / (2 * np.pi)), rows)

    for first, found in solved_blocks(question, poses, held, tolerance, search=not has_spare):
        values = question.values(found.motions)
        bounds = np.searchsorted(found.index, np.arange(min(BLOCK, len(poses) - first) + 1))
        for k, (low, high) in enumerate(zip(bounds[:-1].tolist(), bounds[1:].tolist(), strict=True)):
            rows = values[low:high]
            if found.free[low:high].any():  # of a family the member nearest to where the arm is
                rows = alone(first + k)
            rows = in_turn(rows)
            if has_spare:
                most = max(SHORT, STEADY * stride)
                rows, is_led = _going_on(question, goals[first + k], rows, last, most, is_led, tuple(held), tolerance)
                if not len(rows):
                    found_alone = by_itself(question, goals[first + k], held, tolerance, to_the_nearest=False)
                    rows = in_turn(question.values(found_alone.motions))
            if not len(rows):
                continue
            on = rows[int(np.argmin(np.linalg.norm(rows - last, axis=1)))]
            stride = float(np.linalg.norm(on - last))
            q[first + k] = last = on
    there = ~np.isnan(q).any(axis=1)
    sizes = np.full(len(q), np.inf)
    sizes[there] = least_singular(question.ready, question.motions(q[there]))
    return _described(q, in_numbers(robot, near), sizes)


def _going_on(  # noqa: PLR0913, PLR0917  where the arm is, and where it may go
    question: Question,
    goal: Array,
    rows: Array,
    last: Array,
    most: float,
    is_led: bool,  # noqa: FBT001
    still: tuple[int, ...],
    tolerance: float,
) -> tuple[Array, bool]:
    """Joint values to choose from, shape (K, n), and whether joints to spare move along.

    They do where they did so before, or where none of the rows, at which they stand still, is near enough: then
    Newton's steps lead from the pose before to this one.
    """
    if not is_led and np.linalg.norm(rows - last, axis=1).min(initial=np.inf) <= most:
        return rows, False
    ready = question.ready
    motions, left = polished(ready.arm, ready.task, question.motions(last)[None], goal[None], still)
    on = last.copy()
    on[list(question.order)] = question.values(motions[0])[list(question.order)]
    if left[0] <= tolerance and np.linalg.norm(on - last) <= most:
        return on[None], True
    return rows, is_led


def _coupled(
    carried: Carried,
    T: ArrayLike,  # noqa: N803
    near: JointInput,
    hold: Mapping[str, float | str | Angle] | None,
    asked: dict[str, Any],
) -> Path:
    """A path of the arm with a variable for each move, carried back; where that will not do, of the variables led.

    Raises:
        RobotError: As `follow`.
    """
    from dhcli.kinematics.inverse.leading import Leading  # few robots are

    leading = Leading.of(carried, asked)
    if not carried.is_whole or leading.is_needed(hold):
        q, sizes = led_along(inverse_batch, leading, T, {**asked, "near": near, "hold": hold})
        return _described(q, in_numbers(carried.robot, near), sizes)
    path = follow(carried.arm, T, carried.there(near), hold=carried.held(hold), **asked)
    goal = path.q - carried.offsets
    return replace(path, q=np.asarray(np.linalg.solve(carried.slopes, goal.T).T))


def _described(q: Array, begin: Array, sizes: Array) -> Path:
    """A path with what is to be said of it, from the least singular values of its Jacobians."""
    there = np.flatnonzero(~np.isnan(q).any(axis=1))
    lost = np.flatnonzero(np.isnan(q).any(axis=1))
    singular = there[sizes[there] < SINGULAR]
    return Path(q, tuple(lost.tolist()), tuple(_jumps(q, there, begin).tolist()), tuple(singular.tolist()))


def _jumps(q: Array, there: Ints, begin: Array) -> Ints:
    """The poses to which a step leads that is far longer than the steps before and after it."""
    steps = np.linalg.norm(np.diff(np.vstack([begin, q[there]]), axis=0), axis=1)
    inner = steps[1:]
    if not len(inner):
        return there[:0]
    padded = np.concatenate([[np.inf], inner, [np.inf]])
    before, after = padded[:-2], padded[2:]
    usual = np.where(np.isinf(before), after, np.where(np.isinf(after), before, np.maximum(before, after)))
    usual = np.where(np.isinf(usual), 0.0, usual)
    return np.asarray(there[1:][(inner > LEAST) & (inner > JUMP * usual)])
