"""A single angle, length or number: read, judged, and spelled as a person would."""

from __future__ import annotations

from dataclasses import dataclass

from dhcli.algebra.floats import Floats
from dhcli.checking.entries import check_names
from dhcli.checking.exercise import Exercise
from dhcli.checking.pasted import UnreadableError, without_label
from dhcli.checking.tolerance import Tolerance, is_rounding_of, judge
from dhcli.checking.verdicts import CellMark, Mark, Verdict
from dhcli.errors import Place
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle, to_length
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write, write_angle


@dataclass(frozen=True, slots=True)
class TypedValue:
    """A value as typed: its text without a label, and the expression."""

    text: str
    expr: Expr


def read_value(exercise: Exercise, text: str, place: Place | None) -> TypedValue:
    """Read a single value.

    Raises:
        NotationError: It is none.
    """
    text = without_label(text)
    return TypedValue(text.strip(), parse(text, exercise.scope, place or Place("answer")))


def mark_value(exercise: Exercise, right: Value, answer: TypedValue, tolerance: Tolerance) -> Mark:
    """Judge a single angle, length or number.

    Raises:
        UnreadableError: It is of another kind, holds an unknown name, or is right in another unit.
    """
    typed_expr = answer.expr
    try:
        typed: Value = to_angle(typed_expr, bare="deg") if isinstance(right, Angle) else to_length(typed_expr)
    except DimensionError as error:
        raise UnreadableError(error.message + (f" ({error.hint})" if error.hint else "")) from None
    check_names(exercise, typed.names if isinstance(typed, Angle) else symbols(typed))
    reading, shown = spelled_value(typed, exercise), spelled_value(right, exercise)
    verdict = _verdict_of_value(exercise, typed, right, typed_expr, tolerance)
    if isinstance(right, Angle) and verdict is not Verdict.RIGHT:
        in_radians = to_angle(typed_expr)
        if _verdict_of_value(exercise, in_radians, right, typed_expr, tolerance) is Verdict.RIGHT:
            raise UnreadableError(f"right in radians; a bare angle is in degrees: write {shown} or {answer.text} rad")
    cell = CellMark(0, 0, verdict, reading, shown)
    earned = float(verdict in (Verdict.RIGHT, Verdict.ROUNDED))
    return Mark(verdict, reading, (cell,), earned=earned, expected=shown)


def _verdict_of_value(
    exercise: Exercise, typed: Value, right: Value, typed_expr: Expr, tolerance: Tolerance
) -> Verdict:
    from dhcli.checking.symbolic import put, same

    if isinstance(right, Angle) or isinstance(typed, Angle):
        difference = constant_of(typed, exercise) - constant_of(right, exercise)
        if difference.terms:
            return Verdict.WRONG
        off = abs((float(difference.degrees) + float(difference.radians) * 57.29577951308232 + 180) % 360 - 180)
        return judge(off, 0.0, tolerance.angle)
    if same(typed, right, exercise.values):
        return Verdict.RIGHT
    typed, right = put(typed, exercise.values), put(right, exercise.values)
    if symbols(typed) or symbols(right):
        return Verdict.WRONG
    over = Floats(numbers(exercise.values))
    truth = over.value(right)
    limit = tolerance.position if tolerance.position is not None else 1e-3 * max(abs(truth), 1e-9)
    verdict = judge(over.value(typed), truth, limit)
    if verdict is not Verdict.RIGHT and is_rounding_of(typed_expr, truth):
        return Verdict.ROUNDED
    return verdict


def spelled_value(value: Value, exercise: Exercise) -> str:
    """A value as a person would type it."""
    if isinstance(value, Angle):
        return write_angle(value, "short", exercise.writing)
    return write(value, "short", exercise.writing)


def quantity_of(expr: Expr, exercise: Exercise) -> Value:
    """An expression as an angle if its units or its names say so, else as a length or number; exact in numbers."""
    inside = symbols(expr)
    if has_angle_unit(expr) or (inside and all(exercise.scope.is_angle(name) for name in inside)):
        try:
            angle = to_angle(expr)
            return constant_of(angle, exercise) if exercise.numeric else angle
        except DimensionError:
            pass  # a cosine of an angle is a number
    return to_length(expr)


def constant_of(value: Value, exercise: Exercise) -> Angle:
    """An angle with the values that the task gives; zero for a length."""
    if not isinstance(value, Angle):
        return Angle()
    return value.substitute({name: v for name, v in exercise.given.items() if isinstance(v, Angle)})
