"""Where a robot loses motions, by rules: the task, its determinant in factors or its conditions, and what they mean."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations
from itertools import product as every

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.equality import equal
from dhcli.errors import RobotError, joined
from dhcli.kinematics.forward import Given
from dhcli.kinematics.recorded import kept
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.singular.angles import NEVER, angle_words
from dhcli.kinematics.singular.arm import Arm, Point
from dhcli.kinematics.singular.conditions import UnreadableError, conditions, moving
from dhcli.kinematics.singular.modular import determinant, rank
from dhcli.kinematics.singular.polynomial import TooLongError, product
from dhcli.kinematics.singular.result import MOST_JOINTS, Factor, Singularities
from dhcli.kinematics.singular.square import factored
from dhcli.kinematics.singular.task import arm_of, number_of, place_of, put_back, task_of, task_rows
from dhcli.kinematics.singular.vanishing import fresh, here_and_elsewhere, right_angles, variables_of
from dhcli.kinematics.singular.words import Geometry, Place
from dhcli.kinematics.values import Values, given_parameters
from dhcli.kinematics.velocity import cramer
from dhcli.kinematics.velocity.form import GEOMETRIC, Which, check_part
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.tree import Expr, Trig, negate
from dhcli.notation.walk import operations
from dhcli.notation.writer import write

MOST_TOGETHER = 2
"""Joints that are put at right angles at once where no list is readable."""


def singularities(
    robot: Robot,
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    point: Iterable[float | str] | None = None,
    part: Which | None = None,
    parameters: Given | None = None,
) -> Singularities:
    """Where the Jacobian of a robot loses rank: its determinant in factors, or conditions where it is not square.

    The determinant is the product of the factors for all joint values, sign included: that is proved in residues, with
    an error below 2^-100. It is that of the rows which the joints can move at all, in the axes of `start`.

    Args:
        robot: The robot.
        start: The frame that is held still; the first numbered one by default.
        end: The frame that moves, and whose origin the velocity is of; the last numbered one by default.
        point: A point of the end frame whose velocity is meant instead of its origin's, numbers [m] or names.
        part: The task: `all` rows, `linear` or `angular`; by default all, or for up to three joints one of the others
            if that has as many freedoms as there are joints.
        parameters: Lengths and angles to put in exactly; all others stay symbols.

    Returns:
        What was found, with the picture and the lost motion of each factor in words.

    Raises:
        RobotError: Nothing of the robot moves, or it has a number that no residue stands for.
        UnknownNameError: The robot has no such frame or length.
    """
    check_robot(robot)
    if part is not None:
        check_part(part)
    view = MotionView.of(robot, start=start, end=end, point=point)
    return find(robot, view, part, given_parameters(robot, parameters))


def find(robot: Robot, view: MotionView, part: Which | None, values: Values) -> Singularities:
    """The same for a view, with values that are known, kept with the robot; see `singularities`."""

    def found() -> Singularities:
        arm = arm_of(robot, view, values)
        try:
            return put_back(_found(arm, part), arm.constants)
        except CannotHoldError:
            message = f"{robot.name} has a number for which singularities cannot be proved"
            raise RobotError(message, "give it a name, and its value under parameters") from None

    return kept(robot, ("singular", view, part, tuple(values.items())), found)


def _found(arm: Arm, part: Which | None) -> Singularities:
    point = Point.of(arm, fresh(arm))
    task = part or task_of(point)
    kept = task_rows(point, task)
    labels = tuple(GEOMETRIC.labels[k] for k in kept)
    rows = [point.rows()[k] for k in kept]
    reached = rank(rows, point.field) if kept else 0
    still = tuple(joint for j, joint in enumerate(arm.joints) if not any(row[j] for row in rows))
    place = place_of(point, kept)

    def found(finding: str, **more: object) -> Singularities:
        return Singularities(
            finding,  # type: ignore[arg-type]
            arm.start,
            arm.end,
            task,
            labels,
            arm.joints,
            reached,
            still,
            place.words,
            writing=arm.robot.writing,
            **more,  # type: ignore[arg-type]
        )

    wanted = min(len(kept), len(arm.joints))
    if reached < wanted or (still and len(arm.joints) <= 3):  # noqa: PLR2004  rows of a part: a 3x3 of rank 2
        return found("everywhere")
    if len(arm.joints) > MOST_JOINTS:
        return found("unreadable")
    try:
        if len(kept) == len(arm.joints):
            whole, factors = _square(arm, point, kept)
            described = tuple(_described(arm, point, place, kept, (one,), n) for one, n in factors.items())
            return found("factors" if described else "never", determinant=whole, factors=described)
        listed = conditions(arm, point, kept)
        described = tuple(_described(arm, point, place, kept, zeros, 1) for zeros in listed)
    except (UnreadableError, TooLongError):
        return found("unreadable", probed=probed(arm, kept, reached))
    return found("conditions" if described else "never", factors=described)


def _square(arm: Arm, point: Point, kept: Sequence[int]) -> tuple[Expr, dict[Expr, int]]:
    """The determinant, and those of its factors that joints can make zero."""
    found = factored(arm, point, range(len(arm.joints)), kept)
    if found is None:
        raise UnreadableError
    value, factors, _ = found
    whole = product(value, factors)
    point = Point.of(arm, fresh(arm))  # another one than the structure was read off
    rows = point.rows()
    true = determinant([rows[k] for k in kept], point.field)
    seen = point.over.value(whole)
    if (seen - true) % point.field.prime:
        if (seen + true) % point.field.prime:
            raise ArithmeticError("the factors of a determinant do not multiply to it")
        whole = negate(whole)
    movable = moving(factors, arm)
    return whole, {factor: exponent for factor, exponent in factors.items() if factor in movable}


def _described(
    arm: Arm, point: Point, place: Place, kept: Sequence[int], zeros: tuple[Expr, ...], exponent: int
) -> Factor:
    """A factor or condition with what it means."""
    simple = sorted(zeros, key=lambda zero: (not isinstance(zero, Trig), operations(zero)))
    angles = angle_words(simple, arm.robot.writing)
    plain = Factor(zeros, exponent, variables_of(zeros, arm.joints), angles)
    points = None if angles.startswith(NEVER) else here_and_elsewhere(arm, simple, point)
    if points is None:
        return plain
    numbers = [number_of(arm, j) for j in range(len(arm.joints))]
    geometry = Geometry(*points, place, numbers)
    part, dependent = geometry.moving_alike(kept)
    names = tuple(arm.joints[j] for j in dependent)
    together = f"the columns of {joined(names)} become dependent" if names else ""
    words = next(geometry.sentences(dependent), together)
    if len(zeros) > 1:
        words = _one_by_one(arm, point, place, simple) or words
    return Factor(zeros, exponent, plain.joints, angles, words, names, geometry.lost(kept, part))


def _one_by_one(arm: Arm, point: Point, place: Place, zeros: Sequence[Expr]) -> str:
    """What each of several zeros means by itself; empty if one cannot be said so."""
    numbers = [number_of(arm, j) for j in range(len(arm.joints))]
    said = []
    for zero in zeros:
        points = here_and_elsewhere(arm, (zero,), point)
        if points is None:
            return ""
        geometry = Geometry(*points, place, numbers)
        plain = angle_words((zero,), arm.robot.writing) or f"{write(zero, 'short', arm.robot.writing)} is 0"
        said.append(next(geometry.sentences(range(len(arm.joints))), plain))
    return " and ".join(dict.fromkeys(said))


def probed(arm: Arm, kept: Sequence[int], full: int) -> tuple[Mapping[str, int], ...]:
    """Where the rank falls when one or two joints stand at right angles and all others anywhere.

    Returns:
        For each finding the joints and their multiples of a right angle, none of which follows from another.
    """
    turning = [joint for joint, hinge in zip(arm.joints, arm.is_hinge, strict=True) if hinge]
    found: list[dict[str, int]] = []
    for count in range(1, MOST_TOGETHER + 1):
        for names in combinations(turning, count):
            for quarters in every(range(4), repeat=count):
                turns = dict(zip(names, quarters, strict=True))
                if any(known.items() <= turns.items() for known in found):
                    continue
                over = right_angles(arm, turns)
                linear, angular = arm.velocities(over)
                rows = (*zip(*linear, strict=True), *zip(*angular, strict=True))
                if rank([rows[k] for k in kept], over.field) < full:
                    found.append(turns)
    return tuple(found)


def neat_determinant(
    robot: Robot, view: MotionView, part: Which, values: Values, rows: Sequence[Sequence[Expr]]
) -> Expr:
    """The determinant of some rows of a Jacobian along any axes; the factors are proved to be just that.

    Args:
        robot: The robot.
        view: What the Jacobian is of.
        part: Which rows it has, before those are left out that no joint moves.
        values: Values that have been put in.
        rows: The rows that are left, as many as columns.
    """
    plain = cramer.determinant(rows)
    try:
        factored = find(robot, view, part, values).determinant
    except RobotError:
        return plain
    if factored is not None and equal(factored, plain):
        return factored
    if factored is not None and equal(negate(factored), plain):
        return negate(factored)
    return plain
