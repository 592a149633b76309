"""Mistakes in the joint angles that a Jacobian is worked out at: one counts the other way, or all are in another unit.

They are made by themselves and never beside a second slip: pairs with one for each joint would be too many.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from dhcli.checking.diagnosis.mistakes.changes import CALCULATOR
from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case
from dhcli.checking.motion.columns import Columns
from dhcli.checking.motion.mistakes import rewritten
from dhcli.notation.angle import Angle
from dhcli.notation.walk import substitute

SENSE = "in which sense does each angle count?"


def at_other_angles(case: Case, columns: Columns) -> Iterator[tuple[Slip, Columns]]:
    """The right columns at joint angles that are not those of the task."""
    turning = [one.joint for one in columns.each if one.turns]
    for joint in turning:
        slip = Slip(f"theta-sign {joint}", f"the angle {joint} counts the other way", SENSE, Rank.PLACE)
        yield slip, _at(columns, {joint: -Angle.of(joint)})
    if case.exercise.numeric:
        values = {joint: case.exercise.values.get(joint) for joint in turning}
        others = {joint: _in_other_unit(value) for joint, value in values.items() if isinstance(value, Angle)}
        words = "the joint angles are taken in the wrong unit, degrees for radians or the other way round"
        if others:
            yield Slip("thetas-unit", words, CALCULATOR, Rank.WHOLE), _at(columns, others)


def _at(columns: Columns, angles: Mapping[str, Angle]) -> Columns:
    """Columns with other angles in the place of joint variables."""
    return rewritten(columns, lambda entry: substitute(entry, {}, dict(angles)))


def _in_other_unit(value: Angle) -> Angle:
    """A known angle with its number in the other unit, 40 rad for 40°."""
    return Angle(degrees=value.radians, radians=value.degrees)
