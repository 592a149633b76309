"""Every joint vector that takes a robot to a pose, joints to spare held or sampled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.coupling import is_coupled
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.forward import Given, forward
from dhcli.kinematics.inverse.answering import answer
from dhcli.kinematics.inverse.question import Question, ask
from dhcli.kinematics.inverse.searching import find, nearest_to
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.inverse.targets import read_target
from dhcli.kinematics.inverse.tasks import TaskName
from dhcli.kinematics.inverse.trying import CONFIRMED
from dhcli.kinematics.inverse.turns import placed
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import JointInput, joint_values
from dhcli.notation.angle import Angle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhcli.kinematics.inverse.arm import Array


def inverse(  # noqa: PLR0913  what may be asked of a pose
    robot: Robot,
    T: ArrayLike | Pose[float],  # noqa: N803  the field's name for a pose
    *,
    task: TaskName = "pose",
    near: JointInput = None,
    hold: Mapping[str, float | str | Angle] | None = None,
    family: int | None = None,
    within_limits: bool = False,
    all_turns: bool = False,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    tolerance: float = CONFIRMED,
) -> Solutions:
    """Every joint vector that takes the end of a robot to a pose.

    Args:
        robot: The robot.
        T: The pose of the end frame seen from the start frame, shape (4, 4) [m]; for the position alone also a point
            (3,), for the orientation a matrix (3, 3), for a direction a vector (3,). Or joint values that stand
            there, by name, in text, or as a pose of the robot's: joints that its task leaves over are held at them.
        task: What of it counts: `pose`, `position`, `orientation`, `axis` (position and direction of z), `direction`.
        near: Joint values, in whatever form `forward` takes: solutions are sorted by their distance from them.
        hold: Values of joints that are not to be computed; a robot with more joints than the task needs holds one of
            them in any case, and says which.
        family: Into how many values of the joint held a redundant robot's solutions are sampled.
        within_limits: Whether only solutions inside the joints' limits are wanted; joints to spare are then held
            where there are some, if they can be.
        all_turns: Whether an angle is given in each turn that its limits allow.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame that is placed; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.
        tolerance: Residual up to which joint values count as a solution, in reaches and direction cosines; larger
            than by default only for poses typed with few digits that a robot with few joints meets only nearly.

    Returns:
        The solutions; none, with the reason why, if the pose is out of reach.

    Raises:
        RobotError: T is no pose, a length has no value, or a joint held is none.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    standing: dict[str, float] = {}
    if isinstance(T, str | Mapping):
        standing = {name: in_floats(value) for name, value in joint_values(robot, T).items()} if near is None else {}
        T = forward(robot, T, start=start, end=end, parameters=parameters)  # noqa: N806
    if is_coupled(robot):
        from dhcli.kinematics.inverse.carried import Carried  # few robots are
        from dhcli.kinematics.inverse.coupled import through  # few robots are

        carried = Carried.of(robot, parameters, start, end)
        if carried is not None:
            asked: dict[str, object] = {"near": near, "hold": hold, "within_limits": within_limits, "start": start}
            asked |= {"task": task, "family": family, "end": end, "parameters": parameters, "tolerance": tolerance}
            return through(inverse, carried, T, standing, all_turns=all_turns, **asked)
    question, held = ask(
        robot, task, near=near, hold=hold, start=start, end=end, parameters=parameters, tolerance=tolerance
    )
    question = replace(question, standing=standing)
    ready = question.ready
    pose, remarks = read_target(T, ready.task)
    goal = ready.arm.goal(pose[None])[0]
    nearest = cache(lambda: nearest_to(ready, goal, held))
    solved, said = find(question, goal, held, family, tolerance, nearest)
    found = answer(question, solved, said)
    found = replace(found, remarks=(*remarks, *found.remarks))
    if not len(found):
        from dhcli.kinematics.inverse.unreached import why_not  # not for the poses that are reached

        found = why_not(ready, found, pose, held, nearest(), question.values)
        return replace(found, closest=_easiest(question, found, held, tolerance))
    result = placed(found, question.near, within_limits=within_limits, all_turns=all_turns)
    if len(result) or not said or family:
        return result
    from dhcli.kinematics.inverse.inside import held_inside  # not for the poses that are reached inside all limits

    solved, said = held_inside(question, goal, held, tolerance)
    if not len(solved.motions):
        return replace(result, remarks=(*result.remarks, *said))
    found = replace(answer(question, solved, said), remarks=(*remarks, *said))
    return placed(found, question.near, within_limits=within_limits, all_turns=all_turns)


def _easiest(question: Question, found: Solutions, held: dict[int, float], tolerance: float) -> Array | None:
    """Of all ways to stand in the pose that comes nearest: the one that keeps the limits, nearest to what is best."""
    if found.closest is None:
        return None
    from dhcli.kinematics.inverse.polishing import product

    ready = question.ready
    goal = product(ready.arm, question.motions(found.closest)[None])[0]
    there = question.motions(found.closest), 0.0, 0.0
    solved, _ = find(question, goal, held, None, tolerance, lambda: there)
    if not len(solved.motions):
        return found.closest
    ways = placed(answer(question, solved, []), question.near, within_limits=False, all_turns=False)
    far = ways.distances(question.values(question.best()).tolist())
    return np.asarray(ways.q[min(range(len(ways)), key=lambda k: (not ways.within_limits[k], far[k]))])
