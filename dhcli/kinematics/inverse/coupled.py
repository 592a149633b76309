"""Inverse kinematics of arms whose variables share moves: solved with a variable for each move, and carried back."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.kinematics.inverse.branches import branch_names, factors
from dhcli.kinematics.inverse.carried import Carried
from dhcli.kinematics.inverse.leading import Leading
from dhcli.kinematics.inverse.polishing import SINGULAR
from dhcli.kinematics.inverse.question import ask
from dhcli.kinematics.inverse.solutions import Free, Solutions, in_numbers
from dhcli.kinematics.inverse.solving import least_singular
from dhcli.kinematics.inverse.targets import read_targets
from dhcli.kinematics.inverse.tasks import task_called
from dhcli.kinematics.inverse.turns import limits_of, outside, placed
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhcli.kinematics.inverse.arm import Array


def through(
    solve: Callable[..., Solutions],
    carried: Carried,
    T: ArrayLike | Pose[float],  # noqa: N803
    standing: Mapping[str, float],
    **asked: Any,  # noqa: ANN401
) -> Solutions:
    """Solve for the arm with a variable for each move, and carry the solutions back.

    Args:
        solve: What solves for an arm whose variables each make one move; see `inverse`.
        carried: The robot and that arm.
        T: The pose.
        standing: Joint values, by name, that it was given by.
        **asked: What else `inverse` takes.

    Raises:
        RobotError: As `inverse`.
    """
    robot, near = carried.robot, asked["near"]
    leading = Leading.of(carried, asked)
    if leading.is_needed(asked["hold"]):
        answer = leading.solutions(T, asked, standing)
    else:
        ways = {"near": carried.there(near), "hold": carried.held(asked["hold"])}
        found = solve(carried.arm, T, **{**asked, **ways, "within_limits": False, "all_turns": False})
        answer = _carried(carried, found)
        if not carried.is_whole and any(found.free):  # any value of a move: few of them go with the others
            answer = leading.solutions(T, asked, standing, carried.nearly(found.q))
        elif not carried.is_whole and not len(found):  # how near it comes is not known of the robot
            beyond = f"nor would it if each of its {len(carried.slopes)} moves had a drive of its own"
            why = leading.what_keeps(T) or f"the arm does not reach it, {beyond}"
            answer = replace(answer, why=why, closest=leading.closest(T, asked))
    if not len(answer):
        return answer
    wish = None if near is None else in_numbers(robot, near)
    limits = {key: asked[key] for key in ("within_limits", "all_turns")}
    return placed(answer, wish, periodic=carried.periodic, **limits)


def through_many(
    solve: Callable[..., tuple[Array, NDArray[np.int64]]],
    one: Callable[..., Solutions],
    carried: Carried,
    T: ArrayLike | Pose[float],  # noqa: N803
    each: str,
    *,
    within_limits: bool,
    **asked: Any,  # noqa: ANN401
) -> tuple[Array, NDArray[np.int64]]:
    """The same for many poses; see `inverse_batch`."""
    robot, near = carried.robot, asked["near"]
    threads = asked.pop("threads")
    poses, _ = read_targets(T, task_called(asked["task"]))
    rows, single = list[tuple["Array", int]](), set(range(len(poses)))
    if not Leading.of(carried, asked).is_needed(asked["hold"]):
        ways = {**asked, "near": carried.there(near), "hold": carried.held(asked["hold"])}
        values, index = solve(carried.arm, T, **ways, threads=threads, each="all")
        single = set() if carried.is_whole else _loose(carried.arm, values, index, ways)
        both = zip(index.tolist(), values, strict=True)
        rows = [(row, k) for k, moves in both if k not in single and (row := carried.back(moves)) is not None]
    plain = {"within_limits": False, "all_turns": False, "family": None}
    rows += [(row, k) for k in single for row in through(one, carried, poses[k], {}, **asked, **plain).q]
    rows.sort(key=lambda found: found[1])
    if within_limits:
        limits = limits_of(robot)
        rows = [(row, k) for row, k in rows if not outside(robot, row, limits)]
    if each != "all":
        wish = np.zeros(len(robot.variables)) if near is None else in_numbers(robot, near)
        rows.sort(key=lambda found: (found[1], float(np.linalg.norm(found[0] - wish))))
        rows = [found for n, found in enumerate(rows) if not n or rows[n - 1][1] != found[1]]
    q = np.array([row for row, _ in rows]).reshape(-1, len(robot.variables))
    return q, np.array([k for _, k in rows], dtype=np.int64)


def said_of_many(robot: Robot, **asked: Any) -> str:  # noqa: ANN401
    """What a reader should know of the solutions of many poses: whether some may be missing; else nothing.

    Args:
        robot: A robot whose variables share moves.
        **asked: What is asked of it: task, hold, start, end and parameters; see `inverse_batch`.
    """
    carried = Carried.of(robot, asked["parameters"], asked["start"], asked["end"])
    if carried is None:
        return ""
    leading = Leading.of(carried, asked)
    return leading.said() if leading.is_needed(asked["hold"]) else ""


def _loose(arm: Robot, values: Array, index: NDArray[np.int64], asked: Mapping[str, Any]) -> set[int]:
    """The poses at which the arm may move without moving its end."""
    task, rest = asked["task"], {name: value for name, value in asked.items() if name != "task"}
    question, _ = ask(arm, task, **rest)
    return set(index[least_singular(question.ready, question.motions(values)) < SINGULAR].tolist())


def _carried(carried: Carried, found: Solutions) -> Solutions:
    """The solutions in the robot's variables and named by them, less those that its coupling does not allow."""
    rows = [carried.back(values) for values in found.q]
    kept = [k for k, row in enumerate(rows) if row is not None]
    q = np.array([rows[k] for k in kept]).reshape(-1, len(carried.robot.variables))
    nothing = len(found) > 0 and not kept
    why = (
        f"the arm would reach it if each of its {len(carried.slopes)} moves had a drive of its own"
        if nothing
        else found.why
    )
    closest = carried.back(found.closest) if found.closest is not None and carried.is_whole else None
    residual = None if found.residual is None else found.residual[kept]
    own = frozenset(carried.robot.variables)
    free = [found.free[k] if found.free else () for k in kept]
    if not carried.is_whole:
        free = [tuple(way for way in ways if own.issuperset(way.joints)) for ways in free]
    elif carried.robot.drives is None:
        free = [tuple(_by_variables(carried, way) for way in ways) for ways in free]
    names, product = _named(carried, found, kept, q)
    return replace(
        found,
        robot=carried.robot,
        q=q,
        held=carried.own(found.held),
        branches=names,
        residual=residual,
        beyond=((),) * len(kept),
        free=tuple(free),
        reachable=found.reachable and not nothing,
        why=why,
        closest=closest,
        factors=product,
        shared=carried.shared,
    )


def _named(
    carried: Carried, found: Solutions, kept: list[int], q: Array
) -> tuple[tuple[str, ...], tuple[tuple[str, int], ...]]:
    """Names for those solutions that are kept, and what their number is a product of."""
    ready = found.ready
    if ready is None:
        return tuple(found.branches[k] for k in kept), ()
    order = [carried.arm.variables.index(axis.name) for axis in ready.arm.axes[: ready.arm.joints]]
    motions = found.q[kept][:, order] * ready.arm.factors
    groups: dict[tuple[float, ...], list[int]] = {}  # of a family those with the same values held belong together
    for k, row in enumerate(np.round(motions[:, list(ready.plan.held)], 9).tolist()):
        groups.setdefault(tuple(row), []).append(k)
    names = [""] * len(kept)
    for at in groups.values():
        for k, name in zip(at, branch_names(ready.plan, ready.parts, motions[at], carried.told(q[at])), strict=True):
            names[k] = name
    alone = len(groups) == 1
    return tuple(names), factors(ready.plan, ready.parts, motions, carried.told(q)) if alone else ()


def _by_variables(carried: Carried, way: Free) -> Free:
    """A way to move in the robot's variables, where it names moves that are none of them."""
    names, moves = carried.robot.variables, carried.arm.variables
    back = np.linalg.inv(carried.slopes)[:, [moves.index(name) for name in way.joints]]
    moving = tuple(names[j] for j in np.flatnonzero(np.abs(back).max(axis=1) > 0))
    if moving == way.joints or (set(way.joints) <= set(names) and set(moving) <= set(way.joints)):
        return way
    first = next((name for name in moving if name in carried.alone), moving[0])
    return Free(first, moving, f"{', '.join(moving)} move together, any {first}")
