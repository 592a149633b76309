"""Solutions as they are answered: in the robot's own variables, with the names of their branches."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhcli.kinematics.inverse.branches import branch_names, factors
from dhcli.kinematics.inverse.question import Question
from dhcli.kinematics.inverse.solutions import Free, Solutions, relation, turning_joints
from dhcli.kinematics.inverse.solving import Solved

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array
    from dhcli.kinematics.inverse.families import Freedom


def answer(question: Question, solved: Solved, said: list[str]) -> Solutions:
    """The solutions of a question, with what has to be said about them."""
    robot, ready = question.robot, question.ready
    q = question.values(solved.motions)
    free = tuple(tuple(_free(question, row, way) for way in ways) for row, ways in zip(q, solved.freedoms, strict=True))
    held = tuple((ready.arm.axes[j].name, float(q[0, question.order[j]])) for j in ready.plan.held) if len(q) else ()
    names = list[str]()
    once = dict.fromkeys(solved.index.tolist())
    for index in once:
        names += branch_names(ready.plan, ready.parts, solved.motions[solved.index == index])
    return Solutions(
        robot,
        ready.task.name,
        q,
        tuple(names),
        solved.residual,
        free=free,
        held=held,
        remarks=tuple(said),
        factors=factors(ready.plan, ready.parts, solved.motions) if len(once) == 1 else (),
        ready=ready,
    )


def _free(question: Question, q: Array, way: Freedom) -> Free:
    """A way to move, in the robot's own variables."""
    order, factors = question.order, question.ready.arm.factors
    names = tuple(question.robot.variables[order[j]] for j in way.joints)
    parameter = order[way.parameter]
    words = ", ".join(names) + f" move together, any {question.robot.variables[parameter]}"
    if way.straight:
        scale = factors[way.parameter]
        rates = {order[j]: float(way.rates[j] / factors[j] * scale) for j in way.joints}
        words = relation(question.robot.variables, turning_joints(question.robot), q, rates, parameter)
    return Free(question.robot.variables[parameter], names, words)
