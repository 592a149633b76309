"""The square or other piece of a Jacobian that is an arm's task: the rows that its joints can move."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, Self

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Case
from dhcli.checking.motion.asked import Motion, form_of, read_motion
from dhcli.checking.motion.columns import Columns, columns_for, jacobian_grid
from dhcli.checking.motion.grid import Numbers, over
from dhcli.checking.motion.question import MotionQuestion
from dhcli.checking.returned import Shown
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import Place, RobotError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.finding import find
from dhcli.kinematics.singular.result import Singularities
from dhcli.kinematics.values import numbers
from dhcli.kinematics.velocity.form import GEOMETRIC, Form, Which
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_PIECE = regex(r"(?:of\s+)?(?:jacobian)?\s*(?P<form>linear|angular)?")


@frozen
class JacobianTask:
    """What is asked of a Jacobian as a whole, or of its rows of v or ω.

    Attributes:
        motion: Of which frame and point.
        form: All rows, or those of v or ω.
    """

    motion: Motion
    form: Form = GEOMETRIC

    words: ClassVar[tuple[str, ...]]
    opening: ClassVar[str] = ""
    """What stands in front of the Jacobian, `singular when`; by default the first of the words, `determinant`."""

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """The question that a text asks.

        Raises:
            NotAskedError: It asks something else.
        """
        motion, opening = read_motion(text, scope, place), cls.opening or cls.words[0]
        match = _PIECE.fullmatch(motion.head.removeprefix(opening).strip())
        if match is None or motion.rates is not None or not motion.head.startswith(opening):
            raise NotAskedError(text)
        return cls(motion, form_of(match["form"] or "")[0])

    def check(self, robot: Robot | None) -> None:
        """Make sure that a robot has such a Jacobian."""
        self.motion.check(robot)


def jacobian_step(question: MotionQuestion, case: Case, part: Which) -> Shown:
    """The Jacobian that a question is about, as a step of its solution."""
    form = Form(part)
    grid = jacobian_grid(case, columns_for(case, question.motion), form)
    return question.shown(case, f"The Jacobian, rows {', '.join(form.labels)}", grid)


def found_for(case: Case, motion: Motion, form: Form) -> Singularities:
    """Where that Jacobian is singular, worked out once."""
    robot, view = motion.check(case.exercise.robot)
    return case.memo.of(
        ("singular", view, form), lambda: find(robot, view, None if form == GEOMETRIC else form.part, {})
    )


def kept_rows(found: Singularities) -> tuple[int, ...]:
    """The rows of the six that the task has."""
    return tuple(GEOMETRIC.labels.index(label) for label in found.rows)


def square(robot: Robot, view: MotionView, form: Form) -> Singularities:
    """What was found for a Jacobian with as many rows as joints.

    Raises:
        RobotError: It has not, or is singular everywhere.
    """
    found = find(robot, view, None if form == GEOMETRIC else form.part, {})
    if found.determinant is None:
        rows, joints = len(found.rows), len(found.joints)
        if rows != joints:
            hint = "ask for the linear or the angular part" if rows > joints else ""
            raise RobotError(
                f"a Jacobian with {plural(rows, 'row')} and {plural(joints, 'column')} has no determinant", hint
            )
        raise RobotError("this Jacobian is singular everywhere, or its determinant is too long to read")
    if view.axes != view.start and len(found.rows) not in (3, 6):
        raise RobotError("with rows left out the sign of a determinant depends on the axes", "leave in frame out")
    return found


def listed(robot: Robot, view: MotionView, form: Form) -> Singularities:
    """What was found for a Jacobian whose singular poses can be listed, square or not.

    Raises:
        RobotError: It is singular everywhere, or nobody would read the list.
    """
    found = find(robot, view, None if form == GEOMETRIC else form.part, {})
    if found.finding == "everywhere":
        raise RobotError("this Jacobian is singular everywhere", "ask for its rank, or for another part or point")
    if found.finding == "unreadable":
        message = f"where this Jacobian of {len(found.joints)} joints is singular is more than anybody would read"
        raise RobotError(message, "ask for its rank at joint values")
    return found


def values_in(case: Case, columns: Columns, kept: Sequence[int]) -> Numbers:
    """Rows of a Jacobian in floats at the values given; at values that have nothing special about them in symbols."""
    from dhcli.algebra.points import general

    rows, exercise = columns.cut(kept), case.exercise
    if exercise.numeric:
        return over(rows, Floats(numbers(exercise.values)))
    known = numbers(exercise.values)
    point = next(general(exercise.scope.names, 5))
    return over(rows, Floats({**point, **known}))
