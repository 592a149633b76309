"""A single angle, length or number: read, judged, and spelled as a person would."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.checking.entries import check_names
from dhcli.checking.exercise import Exercise
from dhcli.checking.other_unit import RADIANS, WrongUnitError, is_clear, refuse_right_in
from dhcli.checking.pasted import UnreadableError, without_label
from dhcli.checking.tolerance import NOT_EXACT, Tolerance, is_rounding_of, judge, without_unit
from dhcli.checking.units import is_measure, length_in_metres
from dhcli.checking.verdicts import AGREEING, UNSOLVED, CellMark, Mark, Verdict, too_few
from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import FULL_TURN, Angle
from dhcli.notation.dimensions import has_units
from dhcli.notation.parser import parse
from dhcli.notation.quantity import (
    Bare,
    DimensionError,
    has_angle_unit,
    is_inverse,
    to_angle,
    to_length,
    to_plain_length,
)
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write, write_angle


@frozen
class TypedValue:
    """A value as typed: its text without a label, and the expression."""

    text: str
    expr: Expr


@frozen
class Quantity:
    """A right value, and what it is.

    Attributes:
        value: An exact angle; an expression in radians where an inverse function stands in it; a length [m]; a number.
        is_length: Whether bare numbers for it are in the unit of the sheet.
        is_angle: Whether it is an angle.
    """

    value: Value
    is_length: bool = False
    is_angle: bool = False


def read_typed_value(exercise: Exercise, text: str, place: Place | None) -> TypedValue:
    """Read a single value.

    Raises:
        NotationError: It is none.
    """
    text = without_label(text)
    return TypedValue(text.strip(), parse(text, exercise.scope, place or Place("answer")))


def quantity_of(expr: Expr, exercise: Exercise) -> Quantity:
    """An expression as an angle if its units, its names or its functions say so, else as a length or a number.

    Exact angles have the values of the task put in where answers are numbers.
    """
    from dhcli.checking.angles import in_radians

    scope, inside = exercise.scope, symbols(expr)
    if is_inverse(expr):
        return Quantity(in_radians(expr, scope), is_angle=True)
    if has_angle_unit(expr) or (inside and all(scope.is_angle(name) for name in inside)):
        try:
            angle = to_angle(expr)
            return Quantity(angle.substitute(exercise.given) if exercise.numeric else angle, is_angle=True)
        except DimensionError:
            pass  # a cosine of an angle is a number
    measure = is_measure(expr, scope)
    return Quantity(to_length(length_in_metres(expr, exercise.metres, scope) if measure else expr), measure)


def mark_value(exercise: Exercise, right: Quantity, answer: TypedValue, tolerance: Tolerance) -> Mark:
    """Judge a single angle, length or number.

    Raises:
        UnreadableError: It is of another kind, holds an unknown name, or is right in another unit.
    """
    typed = _known(exercise, right, answer)
    verdict = _verdict_in_unit(exercise, typed, right, answer, tolerance)
    reading, shown = spelled_value(typed, exercise), spelled_value(right, exercise)
    remarks: tuple[str, ...] = ()
    if tolerance.exact and verdict is Verdict.RIGHT and not _is_exact(typed, right, exercise):
        verdict, remarks = Verdict.ROUNDED, (NOT_EXACT,)
    if verdict in UNSOLVED and exercise.numeric and _agrees_to_digits(exercise, right, answer):
        remarks = (too_few(tolerance.decimals),)
    note = _note(typed, right, exercise) if verdict is Verdict.WRONG else ""
    earned = float(verdict in AGREEING)
    return Mark(verdict, reading, (CellMark(0, 0, verdict, reading, shown, note),), remarks, earned, shown)


def is_right_value(exercise: Exercise, right: Quantity, answer: TypedValue, tolerance: Tolerance) -> bool:
    """Whether a single angle, length or number is right, be it rounded; nothing is said about it.

    Raises:
        UnreadableError: As `mark_value` does.
    """
    typed = _known(exercise, right, answer)
    return _verdict_in_unit(exercise, typed, right, answer, tolerance) in AGREEING


def _known(exercise: Exercise, right: Quantity, answer: TypedValue) -> Quantity:
    """What was typed, as the kind of quantity that is asked for and in names that the exercise has.

    Raises:
        UnreadableError: It is of another kind, or holds an unknown name.
    """
    typed = _as_asked(answer.expr, right, exercise, "deg")
    check_names(exercise, typed.value.names if isinstance(typed.value, Angle) else symbols(typed.value))
    return typed


def _verdict_in_unit(
    exercise: Exercise, typed: Quantity, right: Quantity, answer: TypedValue, tolerance: Tolerance
) -> Verdict:
    """The verdict.

    Raises:
        WrongUnitError: Only the unit is wrong.
    """
    verdict = _verdict(exercise, typed, right, answer.expr, tolerance)
    if right.is_angle and verdict is not Verdict.RIGHT:
        in_radians = _as_asked(answer.expr, right, exercise, "rad")
        if _verdict(exercise, in_radians, right, answer.expr, tolerance) is Verdict.RIGHT:
            shown = spelled_value(right, exercise)
            wanted = f"a bare angle is in degrees: write {shown} or {answer.text} rad"
            raise WrongUnitError(RADIANS, exercise.unit, wanted=wanted)
        if exercise.numeric and verdict in UNSOLVED and _is_rounded_in_radians(exercise, right, answer):
            raise WrongUnitError(RADIANS, exercise.unit, ", to the digits typed")

    def is_right(unit: str) -> bool:
        there = replace(exercise, unit=unit)
        moved = _as_asked(answer.expr, right, there, "deg")
        return moved != typed and _verdict(there, moved, right, answer.expr, tolerance) not in UNSOLVED

    is_shown = right.is_length and verdict in UNSOLVED and _shows_unit(right, exercise, tolerance)
    if is_shown and not _is_right_without_lengths(exercise, right, answer, tolerance):
        refuse_right_in(exercise.other_units, exercise.unit, is_right)
    return verdict


def _is_right_without_lengths(exercise: Exercise, right: Quantity, answer: TypedValue, tolerance: Tolerance) -> bool:
    """Whether an answer is right with 0 for its bare lengths: where they are so small, they show no unit."""
    try:
        none = length_in_metres(answer.expr, Fraction(0), exercise.scope)
        return _verdict(exercise, _read_as(none, right, exercise, "deg"), right, none, tolerance) not in UNSOLVED
    except DimensionError:  # one of them divides
        return False


def _is_rounded_in_radians(exercise: Exercise, right: Quantity, answer: TypedValue) -> bool:
    """Whether a bare number is an exact angle in radians, rounded to its digits."""
    if not isinstance(right.value, Angle) or (angle := right.value.substitute(exercise.given)).terms:
        return False
    return is_rounding_of(answer.expr, angle.constant())


def spelled_value(right: Quantity, exercise: Exercise) -> str:
    """A value as a person would type it on the sheet."""
    value = right.value
    if isinstance(value, Angle):
        return write_angle(value, "short", exercise.writing)
    if right.is_angle:
        from dhcli.checking.angles import shown_angle

        return shown_angle(value, exercise)
    if right.is_length:
        value = exercise.on_sheet(value)
    return write(value, "short", exercise.writing)


def _as_asked(expr: Expr, right: Quantity, exercise: Exercise, bare: Bare) -> Quantity:
    """What was typed, read as the kind of quantity that is asked for.

    Raises:
        UnreadableError: It is another kind.
    """
    try:
        return _read_as(expr, right, exercise, bare)
    except DimensionError as error:
        message, hint = error.message, error.hint
        if not right.is_length and message.endswith("a length is wanted"):
            message = message.replace("a length is", "a number is")
            hint = "leave the unit out" if has_units(expr) else ""
        raise UnreadableError(message + (f" ({hint})" if hint else "")) from None


def _read_as(expr: Expr, right: Quantity, exercise: Exercise, bare: Bare) -> Quantity:
    from dhcli.checking.angles import in_radians

    if not right.is_angle:
        length = length_in_metres(expr, exercise.metres, exercise.scope) if right.is_length else expr
        return replace(right, value=to_plain_length(length))
    if isinstance(right.value, Angle) and not is_inverse(expr):
        return replace(right, value=to_angle(expr, bare=bare))
    return replace(right, value=in_radians(expr, exercise.scope, bare))


def _verdict(
    exercise: Exercise, answer: Quantity, quantity: Quantity, typed_expr: Expr, tolerance: Tolerance
) -> Verdict:
    from dhcli.checking.symbolic import about_equal, has_decimals, put, same

    typed, right = answer.value, quantity.value
    if isinstance(typed, Angle) and isinstance(right, Angle):
        difference = typed.substitute(exercise.given) - right.substitute(exercise.given)
        return Verdict.WRONG if difference.terms else judge(_degrees_apart(difference), 0.0, tolerance.angle)
    if isinstance(typed, Angle) or isinstance(right, Angle) or quantity.is_angle:
        from dhcli.checking.angles import in_radians, judge_angle

        scope = exercise.scope
        return judge_angle(in_radians(typed, scope), in_radians(right, scope), exercise, tolerance)
    if same(typed, right, exercise.values, exercise):
        return Verdict.RIGHT

    def read(expr: Expr) -> Expr:
        found = _read_as(expr, quantity, exercise, "deg").value
        assert isinstance(found, Expr)  # noqa: S101  no angle is asked for here
        return found

    if not exercise.numeric and has_decimals(typed_expr) and about_equal(typed_expr, right, exercise, read):
        return Verdict.ROUNDED
    typed, right = put(typed, exercise.values), put(right, exercise.values)
    if symbols(typed) or symbols(right):
        return Verdict.WRONG
    over = Floats(numbers(exercise.values))
    truth = over.value(right)
    verdict = judge(over.value(typed), truth, _limit(truth, tolerance))
    if verdict is not Verdict.RIGHT:
        number, unit = without_unit(typed_expr, float(exercise.metres) if quantity.is_length else 1.0)
        if is_rounding_of(number, truth / unit):
            return Verdict.ROUNDED
    return verdict


def _agrees_to_digits(exercise: Exercise, right: Quantity, answer: TypedValue) -> bool:
    """Whether a length or a number is the right one to the digits typed, however few."""
    from dhcli.checking.symbolic import put

    if isinstance(right.value, Angle) or right.is_angle or symbols(value := put(right.value, exercise.values)):
        return False
    number, unit = without_unit(answer.expr, float(exercise.metres) if right.is_length else 1.0)
    return is_rounding_of(number, Floats(numbers(exercise.values)).value(value) / unit, least=0)


def _limit(truth: float, tolerance: Tolerance) -> float:
    """What a length or a number may be off."""
    return tolerance.position if tolerance.position is not None else 1e-3 * max(abs(truth), 1e-9)


def _shows_unit(right: Quantity, exercise: Exercise, tolerance: Tolerance) -> bool:
    """Whether a length is right in another unit by no chance: one in letters, or one that is not near zero."""
    from dhcli.checking.symbolic import put

    if isinstance(right.value, Angle) or symbols(value := put(right.value, exercise.values)):
        return True
    truth = Floats(numbers(exercise.values)).value(value)
    return is_clear(truth, _limit(truth, tolerance))


def _degrees_apart(difference: Angle) -> float:
    """The constant part of an angle between -180° and 180°, reduced exactly before a float exists."""
    degrees = float(difference.degrees % FULL_TURN) + math.degrees(float(difference.radians) % math.tau)
    return (degrees + 180) % 360 - 180


def _is_exact(typed: Quantity, right: Quantity, exercise: Exercise) -> bool:
    """Whether a value is the right one and not only near it."""
    from dhcli.checking.symbolic import is_exactly

    if isinstance(typed.value, Angle) and isinstance(right.value, Angle):
        apart = typed.value.substitute(exercise.given) - right.value.substitute(exercise.given)
        return not apart.terms and not apart.radians and not apart.degrees % FULL_TURN
    if right.is_angle:
        from dhcli.checking.angles import EXACT, in_radians, judge_angle

        both = in_radians(typed.value, exercise.scope), in_radians(right.value, exercise.scope)
        return judge_angle(both[0], both[1], exercise, EXACT) is Verdict.RIGHT
    return (
        isinstance(typed.value, Expr)
        and isinstance(right.value, Expr)
        and is_exactly(typed.value, right.value, exercise)
    )


def _note(typed: Quantity, right: Quantity, exercise: Exercise) -> str:
    """Where a wrong value holds, if it does anywhere, and numbers to think about."""
    from dhcli.checking.symbolic import counterexample

    if isinstance(typed.value, Expr) and isinstance(right.value, Expr) and not right.is_angle:
        is_open = symbols(typed.value) | symbols(right.value)
        return counterexample(typed.value, right.value, exercise) if is_open and not exercise.numeric else ""
    if isinstance(typed.value, Angle) and isinstance(right.value, Angle):
        return ""
    from dhcli.checking.angles import branch_of, in_radians

    scope = exercise.scope
    return branch_of(in_radians(typed.value, scope), in_radians(right.value, scope), exercise)
