"""Inverse kinematics of many poses at once: the plan runs on all of them together, block by block."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Literal

import numpy as np

from dhcli.errors import RobotError, did_you_mean
from dhcli.kinematics.coupling import is_coupled
from dhcli.kinematics.forward import Given
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.inverse.found import Found
from dhcli.kinematics.inverse.question import Question, ask
from dhcli.kinematics.inverse.reasons import too_far
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.searching import SEARCHED, find, nearest_to, sampled
from dhcli.kinematics.inverse.solving import Solved, least_singular, representatives, tries
from dhcli.kinematics.inverse.targets import read_targets
from dhcli.kinematics.inverse.tasks import TaskName
from dhcli.kinematics.inverse.trying import CONFIRMED
from dhcli.kinematics.inverse.turns import are_inside, in_turn
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.sharing import check_threads, shared
from dhcli.kinematics.values import JointInput
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhcli.kinematics.inverse.arm import Array

BLOCK = 2048
"""Poses at a time: with eight branches a column of numbers then fills 128 kB."""

NEAREST = 64
"""Poses of a block behind which the nearest one is looked for: where many are beyond reach, that would take hours."""

_TOGETHER = 64
"""Poses that are searched together for where joints to spare have to be held."""

Each = Literal["all", "nearest", "first"]
"""Which solutions of a pose are wanted: all, the one nearest to some joint values, or one."""


def inverse_batch(  # noqa: PLR0913  what may be asked of poses
    robot: Robot,
    T: ArrayLike | Pose[float],  # noqa: N803  the field's name for a pose
    *,
    task: TaskName = "pose",
    each: Each = "all",
    near: JointInput = None,
    hold: Mapping[str, float | str | Angle] | None = None,
    within_limits: bool = False,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    tolerance: float = CONFIRMED,
    threads: int = 1,
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Joint vectors that take the end of a robot to many poses.

    Of an arm with joints to spare, and of one whose joints do not follow one by one, a pose for which the plan finds
    nothing is looked for by itself, as `inverse` does, with joints to spare held elsewhere; that takes some
    milliseconds each. The nearest pose, which may be the pose itself where all of it is singular, takes some hundredths
    of a second: it is looked for behind the first 64 such poses of each 2,048 alone.

    Args:
        robot: The robot.
        T: The poses, shape (N, 4, 4) [m]; for positions also (N, 3), for orientations (N, 3, 3).
        task: What of them counts; see `inverse`.
        each: Which solutions of each pose are wanted; `nearest` goes by `near`.
        near: Joint values in whatever form `forward` takes.
        hold: Values of joints that are not to be computed.
        within_limits: Whether only solutions inside the joints' limits are wanted; of a pose for which there are none,
            joints to spare are held elsewhere.
        start: The frame they are seen from; the first numbered one by default.
        end: The frame that is placed; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.
        tolerance: Residual up to which joint values count as a solution.
        threads: How many threads share the poses; the same is found with any number, to the last digit.

    Returns:
        Joint values, shape (M, n), radians and metres, and for each the number of its pose, shape (M,), in rising
        order. A pose out of reach has no row; of a family there is one member.

    Raises:
        RobotError: T is no array of poses, a length has no value, or that is no number of threads.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    if str(each) not in {"all", "nearest", "first"}:
        raise RobotError(f"there is no {each!r:.60} of solutions", did_you_mean(str(each), ("all", "nearest", "first")))
    if each == "nearest" and near is None:
        raise RobotError("nearest to what?", "give near=")
    check_robot(robot)
    check_threads(threads)
    if is_coupled(robot):
        from dhcli.kinematics.inverse.carried import Carried  # few robots are
        from dhcli.kinematics.inverse.coupled import through_many  # few robots are

        carried = Carried.of(robot, parameters, start, end)
        if carried is not None:
            asked: dict[str, object] = {"task": task, "near": near, "hold": hold, "start": start, "end": end}
            asked |= {"parameters": parameters, "tolerance": tolerance, "threads": threads}
            return through_many(inverse_batch, inverse, carried, T, each, within_limits=within_limits, **asked)
    question, held = ask(
        robot, task, near=near, hold=hold, start=start, end=end, parameters=parameters, tolerance=tolerance
    )
    poses, _ = read_targets(T, question.ready.task)
    values, indices = [], []
    for first, found in solved_blocks(question, poses, held, tolerance, threads):
        if within_limits:
            found = _inside(question, poses[first : first + BLOCK], held, tolerance, found)  # noqa: PLW2901
        q, index = _in_turn(question, found), found.index
        if each != "all":
            kept = _one_each(question, q, index)
            q, index = q[kept], index[kept]
        values.append(q)
        indices.append(index + first)
    if not values:
        return np.empty((0, len(robot.variables))), np.empty(0, dtype=np.int64)
    return np.concatenate(values), np.concatenate(indices)


def numbered(places: Sequence[int], index: NDArray[np.int64], q: Array) -> Array:
    """Joint values, shape (M, n), with where the pose of each stands in front, shape (M, 1 + n)."""
    return np.column_stack([np.array(places)[index], q])


def solved_blocks(
    question: Question, poses: Array, held: dict[int, float], tolerance: float, threads: int = 1, *, search: bool = True
) -> Iterator[tuple[int, Found]]:
    """The number of the first pose of each block, and all solutions of the block, block by block.

    Poses for which the plan finds nothing are looked for by themselves, if that is wanted.
    """

    def solved(first: int) -> tuple[int, Found]:
        goals = question.ready.arm.goal(poses[first : first + BLOCK])
        plan, best = question.ready.plan, question.best()
        fixed = {j: np.full(len(goals), held.get(j, float(best[j]))) for j in plan.held}
        found = _solved_block(question, goals, fixed, tolerance)
        if not search or (plan.rules == ("ONE",) and len(plan.held) == len(held)):
            return first, found  # equations in one joint each lose none
        return first, _searched(question, goals, held, tolerance, found)

    return shared(solved, range(0, len(poses), BLOCK), threads)


def _solved_block(question: Question, goals: Array, fixed: dict[int, Array], tolerance: float) -> Found:
    """What the plan finds of a block of poses with joints held, sorted by pose; of a family one member."""
    ready = question.ready
    found = run(ready.plan, ready.task, goals, tries(ready, question.best()), fixed, tolerance)
    loose = np.flatnonzero(np.isin(found.index, found.index[found.free != 0]))
    if len(loose):
        least = np.ones(len(found.index))
        least[loose] = least_singular(ready, found.motions[loose])
        found = found.take(representatives(ready, found, least)[0])
    return found


def _searched(question: Question, goals: Array, held: dict[int, float], tolerance: float, found: Found) -> Found:
    """What was found, and what is found of each other pose by itself, with joints to spare held elsewhere."""
    ready = question.ready
    near = [k for k in _lost(found, goals) if not too_far(ready.arm, ready.task, goals[k])]
    if chosen := [j for j in ready.plan.held if j not in held]:
        for at in (near[k : k + _TOGETHER] for k in range(0, len(near), _TOGETHER)):
            more = _held_elsewhere(question, goals[at], held, chosen, tolerance)
            found = found.joined(replace(more, index=np.array(at)[more.index]))
        left = set(_lost(found, goals))
        near = [k for k in near if k in left][:NEAREST]
    alone = [
        by_itself(question, goals[k], held, tolerance, to_the_nearest=rank < NEAREST) for rank, k in enumerate(near)
    ]
    if not any(len(each.motions) for each in alone):
        return found
    motions, residual = (np.concatenate([getattr(each, part) for each in alone]) for part in ("motions", "residual"))
    index = np.repeat(near, [len(each.motions) for each in alone])
    none = np.zeros_like(index)
    return found.joined(Found(index, motions, residual, none, none, none))


def _in_turn(question: Question, found: Found) -> Array:
    """Joint values of solutions, shape (M, n), angles in the turn that limits allow."""
    return in_turn(question.robot, question.values(found.motions), question.near)


def _inside(question: Question, poses: Array, held: dict[int, float], tolerance: float, found: Found) -> Found:
    """What of a block is inside all limits; of a pose of which nothing is, with joints to spare held where some is."""
    found = found.take(are_inside(question.robot, _in_turn(question, found)))
    ready, goals = question.ready, question.ready.arm.goal(poses)
    if not (chosen := [j for j in ready.plan.held if j not in held]):
        return found
    near = [k for k in _lost(found, goals) if not too_far(ready.arm, ready.task, goals[k])]
    for at in (near[k : k + _TOGETHER] for k in range(0, len(near), _TOGETHER)):
        more = _held_elsewhere(question, goals[at], held, chosen, tolerance, within_limits=True)
        found = found.joined(replace(more, index=np.array(at)[more.index]))
    return found


def _lost(found: Found, goals: Array) -> list[int]:
    """The poses for which nothing was found."""
    return np.flatnonzero(np.bincount(found.index, minlength=len(goals)) == 0).tolist()


def _held_elsewhere(
    question: Question,
    goals: Array,
    held: dict[int, float],
    chosen: list[int],
    tolerance: float,
    *,
    within_limits: bool = False,
) -> Found:
    """The solutions of each pose with joints to spare where they do, as near as can be to where they should stand."""
    best = question.best(chosen)
    values = sampled(question, held, chosen, best, SEARCHED)
    fixed = {j: np.tile(each, len(goals)) for j, each in values.items()}
    found = _solved_block(question, np.repeat(goals, SEARCHED, axis=0), fixed, tolerance)
    if within_limits:
        found = found.take(are_inside(question.robot, _in_turn(question, found)))
    pose = found.index // SEARCHED
    away = np.abs(found.motions[:, chosen] - best[chosen]).sum(axis=1)
    order = np.lexsort((away, pose))
    first = order[np.diff(pose[order], prepend=-1) > 0]
    kept = np.isin(found.index, found.index[first])
    return replace(found, index=pose).take(kept)


def by_itself(
    question: Question, goal: Array, held: dict[int, float], tolerance: float, *, to_the_nearest: bool
) -> Solved:
    """What is found of one pose with joints to spare held elsewhere, or behind the pose that comes nearest to it."""
    nowhere = np.zeros(question.ready.arm.joints), np.inf, np.inf
    nearest = partial(nearest_to, question.ready, goal, held) if to_the_nearest else lambda: nowhere
    return find(question, goal, held, None, tolerance, nearest)[0]


def _one_each(question: Question, q: Array, index: NDArray[np.int64]) -> NDArray[np.int64]:
    """For each pose the row nearest to what is wanted, or to 0."""
    distance = np.linalg.norm(q - (0.0 if question.near is None else question.near), axis=1)
    order = np.lexsort((distance, index))
    first = np.concatenate([[True], index[order][1:] != index[order][:-1]]) if len(order) else np.empty(0, dtype=bool)
    return np.asarray(order[first])
