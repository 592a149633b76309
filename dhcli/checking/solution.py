"""The worked solution of a part, step by step, as a lecturer would write it on the board."""

from __future__ import annotations

from dataclasses import dataclass

from dhcli.algebra.terms import TERMS
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.marking import expected
from dhcli.checking.questions import Composed, FactorsQuestion, MatrixQuestion, Span
from dhcli.checking.truth import chain_of
from dhcli.kinematics.conventions import ORDER
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import pose_of_chain, put_in, spelled, symbolic_pose
from dhcli.kinematics.frames import frame
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot
from dhcli.notation.tree import Expr


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a solution.

    Attributes:
        text: What is done, in words.
        pose: The matrix it gives, if it gives one.
    """

    text: str
    pose: Pose[Expr] | None = None


def solution(exercise: Exercise, part: Part) -> tuple[Step, ...]:
    """The steps that lead to the right answer; the last one holds it."""
    question = part.question
    if isinstance(question, MatrixQuestion):
        return (*_product_steps(exercise, question), Step(f"So the answer is {expected(exercise, part)}"))
    if isinstance(question, FactorsQuestion) and exercise.robot is not None:
        return (Step(ORDER[exercise.robot.convention]), Step(f"So the answer is {expected(exercise, part)}"))
    return (Step(f"The answer is {expected(exercise, part)}"),)


def _product_steps(exercise: Exercise, question: MatrixQuestion) -> tuple[Step, ...]:
    source = question.source
    if isinstance(source, Span) and exercise.robot is not None:
        steps = _robot_steps(exercise, exercise.robot, source)
    elif isinstance(source, Composed):
        steps = _move_steps(source)
    else:
        steps = ()
    if question.inverse:
        chain = put_in(chain_of(question, exercise.robot), exercise.given)
        back = "The inverse: the moves undone in the opposite order, R transposed and -R^T p"
        steps = (*steps, Step(back, pose_of_chain(chain, "1", "0", "inverse", exercise.writing)))
    return steps


def _robot_steps(exercise: Exercise, robot: Robot, span: Span) -> tuple[Step, ...]:
    """Each link matrix, then the products from right to left, which keep the brackets small."""
    given = exercise.given
    first, last = (robot.frames.index(frame(robot, name)) for name in (span.start, span.end))
    low, high = min(first, last), max(first, last)
    steps = [Step(ORDER[robot.convention])]
    for i in range(low, high):
        before, after = robot.frames[i], robot.frames[i + 1]
        pose = symbolic_pose(robot, given, before, after)
        steps.append(Step(f"From frame {before} to frame {after}", pose))
    for i in range(high - 2, low - 1, -1):
        start, end = robot.frames[i], robot.frames[high]
        middle = robot.frames[i + 1]
        text = f"T_{start}{end} = T_{start}{middle} T_{middle}{end}"
        steps.append(Step(text, symbolic_pose(robot, given, start, end)))
    return tuple(steps)


def _move_steps(source: Composed) -> tuple[Step, ...]:
    """The frame after each move, from left to right."""
    steps = []
    for count, move in enumerate(source.chain, 1):
        pose = Pose(fold(source.chain[:count], TERMS), "0", str(count), f"after {spelled(move)}")
        steps.append(Step(f"Move {count}: {spelled(move)}", pose))
    return tuple(steps)
