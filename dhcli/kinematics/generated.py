"""Functions of the joint values as formulas that share what they have in common, for code in any language."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from dhcli.algebra.program import needed
from dhcli.algebra.tape import Cell, Number, Tape
from dhcli.algebra.written import Lean, Written, written
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.fold import fold, fold_rows
from dhcli.kinematics.frames import View, between
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Trans, names
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values, numbers
from dhcli.kinematics.velocity.form import Form
from dhcli.kinematics.velocity.jacobian import moving_joints, rates_by, six_rows
from dhcli.kinematics.velocity.view import MotionView, joints_between, parts
from dhcli.notation.tree import Expr

COUNTED = ("add", "subtract", "multiply", "divide")


@frozen
class Function:
    """A matrix as a function of joint values and lengths.

    Attributes:
        robot: The robot.
        view: Between which frames, and for a Jacobian along which axes, of which point.
        joints: The joint values that it takes, in joint order [rad, m].
        lengths: The lengths and constant angles that it takes, with the robot's values where it has them [m, rad].
        formulas: Names for what occurs more than once, and the entries row by row.
        moving: The joints between the two frames; a Jacobian has a column for each.
        operations: Binary + - * / in all formulas.
        turns: Cosines and sines in all formulas.
        form: Which rows a Jacobian has; None for a pose.
    """

    robot: Robot
    view: View | MotionView
    joints: tuple[str, ...]
    lengths: Mapping[str, float | None]
    formulas: Written
    moving: tuple[str, ...]
    operations: int
    turns: int
    form: Form | None = None

    @property
    def rows(self) -> tuple[tuple[Expr, ...], ...]:
        """The entries, row by row."""
        flat, width = self.formulas.results, len(self.moving) if self.form else 4
        return tuple(flat[k : k + width] for k in range(0, len(flat), width))


def forward_function(robot: Robot, view: View, values: Values, *, with_values: bool = False) -> Function:
    """The pose between two frames.

    Args:
        robot: The robot.
        view: Which frame, seen from where.
        values: Values of joints and lengths that are put in.
        with_values: Whether the robot's own lengths are put in as well.

    Raises:
        RobotError: An entry is not a real number.
    """
    chain = view.chain(robot)

    def entries(tape: Tape) -> Sequence[Number]:
        return [entry for row in fold(merge(chain), tape) for entry in row]

    joints = joints_between(robot, view.start, view.end)
    return _function(robot, view, (joints, names(chain)), _put_in(robot, values, with_values=with_values), entries)


def jacobian_function(
    robot: Robot, view: MotionView, form: Form, values: Values, *, with_values: bool = False
) -> Function:
    """The Jacobian; every joint between the frames keeps its column, also one whose value is put in.

    Raises:
        RobotError: Nothing moves, or an entry is not a real number.
    """
    joints = moving_joints(robot, view)
    way = (
        *between(robot, view.axes, view.start),
        *between(robot, view.start, view.end),
        *between(robot, view.end, view.place),
        Trans(*view.point),
    )

    def entries(tape: Tape) -> Sequence[Number]:
        linear, angular = six_rows(tuple(parts(robot, view, joints, merged=True)), len(joints), tape)
        if form.analytic:
            chain = merge(between(robot, view.start, view.end))
            angular, _ = rates_by(form, fold_rows(chain, tape), angular, tape)
        return [entry for row in form.chosen(linear, angular) for entry in row]

    known = _put_in(robot, values, with_values=with_values)
    return _function(robot, view, (joints, names(way)), known, entries, form)


def _put_in(robot: Robot, values: Values, *, with_values: bool) -> Values:
    """The values that are no arguments."""
    return {**robot.known, **values} if with_values else values


def _function(
    robot: Robot,
    view: View | MotionView,
    named: tuple[tuple[str, ...], frozenset[str]],
    values: Values,
    entries: Callable[[Tape], Sequence[Number]],
    form: Form | None = None,
) -> Function:
    moving, free = named[0], named[1] - values.keys()
    joints = tuple(name for name in robot.variables if name in free or (name in moving and name not in values))
    lengths = [*(name for name in robot.parameters if name in free)]
    lengths += sorted(free - {*joints, *lengths})
    tape = Lean((*joints, *lengths), numbers(values))
    try:
        results = entries(tape)
        formulas = written(tape, results, robot.writing.index)
    except (ValueError, ArithmeticError):
        raise RobotError("an entry is not a real number", "put in other values") from None
    kept = needed(tape, [result.column for result in results if isinstance(result, Cell)])
    ufuncs = [step.ufunc for step in kept.values()]
    return Function(
        robot,
        view,
        joints,
        {name: _default(robot, name) for name in lengths},
        formulas,
        moving,
        sum(map(ufuncs.count, COUNTED)),
        ufuncs.count("cos") + ufuncs.count("sin"),
        form,
    )


def _default(robot: Robot, name: str) -> float | None:
    value = robot.parameters.get(name)
    return None if value is None else in_floats(value)
