"""A DH table cell by cell: angles modulo a full turn, lengths by equality or within a tolerance."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise
from dhcli.checking.symbolic import put, same
from dhcli.checking.tables.spelling import ANGLES
from dhcli.checking.tables.typed_rows import TypedRow
from dhcli.checking.tolerance import Tolerance, judge
from dhcli.checking.verdicts import CellMark, Verdict
from dhcli.kinematics.conventions import Row
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle, magnitude
from dhcli.notation.matrix import bracketed
from dhcli.notation.styles import Joints
from dhcli.notation.tree import ZERO
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write_value

STEP = 15
"""Twists and offsets are drawn in multiples of so many degrees, or given by name."""


def mark_cells(
    typed: Sequence[TypedRow], truth: Sequence[Row], columns: Sequence[str], exercise: Exercise, tolerance: Tolerance
) -> tuple[CellMark, ...]:
    """Judge each cell against that of another table with as many rows; zeros earn nothing."""
    size = size_of(truth, exercise)
    return tuple(
        _mark(row, right, (r, c), columns[c], exercise, tolerance, size)
        for r, (row, right) in enumerate(zip(typed, truth, strict=True))
        for c in range(len(columns))
    )


def spelled(value: Value, joints: Joints) -> str:
    """A cell as a person would type it."""
    return write_value(value, "short", joints)


def dh_table_text(rows: Sequence[Row], columns: Sequence[str], joints: Joints) -> str:
    """A table as a matrix that can be read again."""
    return bracketed((spelled(getattr(row, column), joints) for column in columns) for row in rows)


def on_sheet(rows: Sequence[Row], exercise: Exercise) -> tuple[Row, ...]:
    """Rows in metres as they are written on a sheet: its bare lengths are in the unit of that."""
    return tuple(replace(row, a=exercise.on_sheet(row.a), d=exercise.on_sheet(row.d)) for row in rows)


def settled(row: Row, tolerance: Tolerance) -> Row:
    """The row with angles that were rounded, 1.57 rad or 89.99°, as the multiple of 15° they mean."""
    return Row(row.a, _settled(row.alpha, tolerance), row.d, _settled(row.theta, tolerance))


def size_of(rows: Sequence[Row], exercise: Exercise) -> float:
    """Sum of the lengths in a table at the values known [m]; 0 where there are none."""
    over = Floats(numbers(own_values(exercise)))
    total = 0.0
    for row in rows:
        for expr in (row.a, row.d):
            if symbols(expr) <= own_values(exercise).keys():
                total += abs(over.value(expr))
    return total


def own_values(exercise: Exercise) -> Mapping[str, Value]:
    """Values that the robot and the task have, whether or not the answer may be in numbers."""
    return {**(exercise.robot.known if exercise.robot else {}), **given_values(exercise)}


def given_values(exercise: Exercise) -> dict[str, Value]:
    """Values that the task states for lengths and twists; a table holds for every value of a joint."""
    variables = exercise.robot.variables if exercise.robot else ()
    return {name: value for name, value in exercise.given.items() if name not in variables}


def _mark(  # noqa: PLR0913, PLR0917  everything a cell is judged by
    typed: TypedRow,
    truth: Row,
    place: tuple[int, int],
    column: str,
    exercise: Exercise,
    tolerance: Tolerance,
    size: float,
) -> CellMark:
    right: Value = getattr(truth, column)
    value: Value = getattr(typed.row, column)
    verdict = _judged(value, right, exercise, tolerance, size)
    note = ""
    if verdict is not Verdict.RIGHT and column in ANGLES:
        other: Angle = getattr(typed.swapped, column)
        if other != value and _judged(other, right, exercise, tolerance, size) is Verdict.RIGHT:
            unit = "radians" if other.radians else "degrees"
            note = f"{typed.cells[column].text} would be right in {unit}: write the unit"
    counted = right != Angle() and right != ZERO
    shown = spelled(right if isinstance(right, Angle) else exercise.on_sheet(right), exercise.writing)
    return CellMark(*place, verdict, typed.cells[column].text, shown, note, counted)


def _judged(value: Value, right: Value, exercise: Exercise, tolerance: Tolerance, size: float) -> Verdict:
    if isinstance(value, Angle) and isinstance(right, Angle):
        known = given_values(exercise)
        apart = value.substitute(known) - right.substitute(known)
        if apart.terms:
            apart = Angle() if value.names else apart.substitute(own_values(exercise))
            if value.names or apart.terms:
                return Verdict.WRONG
        off = (float((apart.degrees + 180) % 360) + math.degrees(apart.radians)) % 360 - 180
        return judge(off, 0.0, tolerance.angle)
    if isinstance(value, Angle) or isinstance(right, Angle):
        return Verdict.WRONG
    if same(value, right, given_values(exercise), exercise):
        return Verdict.RIGHT
    value, right = put(value, given_values(exercise)), put(right, own_values(exercise))
    if symbols(value) or symbols(right):
        return Verdict.WRONG
    over = Floats()
    limit = tolerance.position if tolerance.position is not None else 1e-3 * size
    return judge(over.value(value), over.value(right), limit)


def _settled(angle: Angle, tolerance: Tolerance) -> Angle:
    if not angle.radians and angle.degrees.denominator == 1 and angle.degrees.numerator % STEP == 0:
        return angle
    degrees = angle.degrees + Fraction(math.degrees(angle.radians)) if angle.radians else angle.degrees
    meant = STEP * round(Fraction(degrees, STEP))
    if not magnitude(degrees - meant) <= tolerance.angle:
        return angle
    return Angle(angle.terms, meant)
