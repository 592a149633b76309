"""What an arm is there for: the rows of its Jacobian that count, and the point that sentences speak of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.errors import joined
from dhcli.kinematics.forward import put_in
from dhcli.kinematics.frames import ORIGIN, between
from dhcli.kinematics.moves import Chain, Move, Rot, Trans
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.angles import angle_words
from dhcli.kinematics.singular.arm import Arm, Point
from dhcli.kinematics.singular.modular import rank
from dhcli.kinematics.singular.result import Factor, Singularities
from dhcli.kinematics.singular.square import best_places
from dhcli.kinematics.singular.vanishing import fresh
from dhcli.kinematics.singular.words import Place
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.form import Form, Which
from dhcli.kinematics.velocity.jacobian import moving_joints
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.angle import Angle
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.notation.walk import substitute

HALF_DEGREES = 2
"""Residues hold multiples of half a degree."""


def arm_of(robot: Robot, view: MotionView, values: Values) -> Arm:
    """The arm that a view is about, with values put in."""
    joints = moving_joints(robot, view)
    start, end = view.start, view.end
    lengths = {name: value for name, value in values.items() if name not in robot.variables}
    chain = between(robot, start, end)
    if view.point != ORIGIN:
        chain = (*chain, Trans(*view.point))
    named, constants = with_names(put_in(chain, lengths) if lengths else chain)
    return Arm(robot, start, end, joints, named, constants)


def task_at(robot: Robot, view: MotionView, part: Which | None) -> tuple[Which, tuple[int, ...]]:
    """The rows that are taken for the task of a robot, and the places of those among them that its joints can move."""
    arm = arm_of(robot, view, {})
    try:
        point = Point.of(arm, fresh(arm))
    except CannotHoldError:
        task = part or "all"
        return task, tuple(range(6 if task == "all" else 3))
    task = part or task_of(point)
    return task, tuple(k - 3 if task == "angular" else k for k in task_rows(point, task))


def task_of(point: Point) -> Which:
    """The rows of which a robot has as many as joints: of v alone for a 3R arm, of ω alone for a wrist."""
    count = len(point.linear)
    rows = point.rows()
    everything = [k for k in range(6) if any(rows[k])]
    if count > 3 or len(everything) == count:  # noqa: PLR2004  no part has more rows
        return "all"
    if rank(rows[:3], point.field) == count:
        return "linear"
    if rank(rows[3:], point.field) == count:
        return "angular"
    return "linear" if any(map(any, rows[:3])) else "angular"


def task_rows(point: Point, task: Which) -> tuple[int, ...]:
    """The rows of a task that the joints can move at all, along the axes of the start."""
    rows = point.rows()
    return tuple(k for k in Form(task).rows if any(rows[k]))


def place_of(point: Point, kept: Sequence[int]) -> Place:
    """The point that sentences are about: the one which the fewest joints move, or the end's own."""
    arm, end = point.arm, len(point.arm.chain)
    own = len(between(arm.robot, arm.start, arm.end)) == end
    name = f"the origin of {'frame ' if arm.end.isdigit() else ''}{arm.end}" if own else "the point"
    if not kept or kept[-1] < 3 or kept[0] > 2:  # noqa: PLR2004  v alone, or ω alone
        return Place(end, name)
    place = best_places(point, range(len(arm.joints)))[-1]
    still = [
        j for j in range(len(arm.joints)) if any(point.angular[j]) and not any(point.velocity(j, point.origins[place]))
    ]
    if still == list(range(len(arm.joints)))[-3:]:
        return Place(place, "the wrist centre")
    if len(still) > 1:
        return Place(place, f"the point where axes {joined(number_of(arm, j) for j in still)} meet")
    frame = arm.frame_at(place)
    return Place(place, f"the origin of frame {frame}" if frame.isdigit() else name)


def number_of(arm: Arm, joint: int) -> int:
    """The number of a joint as its robot counts."""
    return arm.robot.first + arm.robot.variables.index(arm.joints[joint])


def with_names(chain: Chain) -> tuple[Chain, Mapping[str, Angle]]:
    """A chain with names in the place of angles that no residue stands for, and what they are."""
    known: dict[Angle, str] = {}
    moves: list[Move] = []
    for move in chain:
        constant = Angle(degrees=move.angle.degrees, radians=move.angle.radians) if isinstance(move, Rot) else Angle()
        if isinstance(move, Rot) and (constant.radians or (constant.degrees * HALF_DEGREES).denominator != 1):
            sign = -1 if constant.constant() < 0 else 1
            name = known.setdefault(constant * sign, f"κ{len(known) + 1}")
            moves.append(Rot(move.axis, Angle(move.angle.terms) + Angle.of(name) * sign))
        else:
            moves.append(move)
    return tuple(moves), {name: angle for angle, name in known.items()}


def put_back(found: Singularities, constants: Mapping[str, Angle]) -> Singularities:
    """Singularities with the angles themselves in the place of their names."""
    if not constants:
        return found

    def back(expr: Expr) -> Expr:
        return substitute(expr, {}, constants)

    determinant = None if found.determinant is None else back(found.determinant)
    factors = tuple(_factor(factor, tuple(map(back, factor.zeros)), found.writing) for factor in found.factors)
    return replace(found, determinant=determinant, factors=factors)


def _factor(factor: Factor, zeros: tuple[Expr, ...], joints: Joints) -> Factor:
    return replace(factor, zeros=zeros, angles=angle_words(zeros, joints))
