"""`rpy`, `euler zyz`, `quaternion` and the other ways to say an orientation in numbers; judged as a rotation."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, ClassVar, Self

from dhcli.algebra.floats import Floats
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.entries import check_names
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.forms import Form, form_of
from dhcli.checking.lists import flat, with_unit_inside
from dhcli.checking.named import in_order
from dhcli.checking.orientations import angle_between, transposed, turned
from dhcli.checking.other_unit import RADIANS, WrongUnitError
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading, Shown
from dhcli.checking.tolerance import judge
from dhcli.checking.truth import names_in, truth_of, unvalued
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.checking.wanted import NotAskedError, Wanted, read_wanted
from dhcli.errors import Place, RobotError, plural
from dhcli.frozen import frozen
from dhcli.geometry.euler import Order
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers, symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.brackets import OPENING, split
from dhcli.notation.commas import with_points
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Unit
from dhcli.notation.walk import walk
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.geometry.rotations import Rotation

_FORM = regex(
    r"(?P<form>rpy|quaternion|axis-angle|rotation-vector|(?P<kind>euler|fixed)\s+(?P<axes>[xyz]{3}))\s+(?:of\s+)?(?P<rest>.+)",
    re.DOTALL,
)
_ROTATION_OF = regex(r"\Arotation\s+of\s+")
_LABEL = regex(r"[^\W\d]\w{0,12}\s{0,9}[=:]")
_WORD = regex(r"\s*[^\W\d]\w{0,12}\s+(?=[\[(])")
"""What stands before an axis in brackets without a sign, `axis (0, 0, 1)`."""
LEAST_TURN = 1e-6
"""Turns that differ by less than this are one [rad]."""


@frozen
class Turn:
    """An orientation as typed.

    Attributes:
        values: Its numbers, angles in radians.
        bare: Whether an angle was typed without a unit.
    """

    values: tuple[float, ...]
    bare: bool


@frozen
class OrientationQuestion(Question[Turn]):
    """An orientation in numbers, in one of the forms."""

    wanted: Wanted
    form: Form

    words: ClassVar = ("rpy", "euler", "fixed", "quaternion", "axis-angle", "rotation-vector")
    examples: ClassVar = (
        "rpy of pose 0..3",
        "euler zyz of pose 0..3",
        "quaternion of pose 0..3",
        "quaternion of rotation from rpy(10°, 20°, 30°)",
    )
    is_plain: ClassVar = True

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`rpy of pose 0..3`."""
        match = _FORM.fullmatch(text)
        if match is None:
            raise NotAskedError(text)
        found = read_wanted(f"rotation of {_ROTATION_OF.sub('', match['rest'])}", scope, place)
        return cls(replace(found, is_link=False), form_of(" ".join(match["form"].split())))

    def check(self, robot: Robot | None) -> None:
        self.wanted.check(robot)

    @property
    def needs_table(self) -> bool:
        return self.wanted.needs_table

    def describe(self, _exercise: Exercise) -> str:
        return f"the orientation of {self.wanted.whole}: {self.form.words}"

    def blank(self, _exercise: Exercise) -> tuple[int, int]:
        return 1, len(self.form.parts)

    def notes(self, _exercise: Exercise) -> Iterable[str]:
        if self.form.angles:
            yield "Angles in degrees unless a unit stands with them; any full turn more or less is the same."

    @property
    def names(self) -> frozenset[str]:
        return names_in(self.wanted)

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        return unvalued(self.wanted, exercise) if exercise.numeric else ()

    def expected(self, case: Case, _style: str = "short") -> str:
        return self.form.text(self.form.of(self._right(case))[0])

    def steps(self, case: Case) -> Iterable[Shown]:
        from dhcli.checking.workings import matrix_steps

        yield from matrix_steps(case, self.wanted)
        yield Shown(f"Said as {self.form.words}")

    def read(self, case: Case, text: str, place: Place | None = None) -> Turn:
        exercise = case.exercise
        _, wanted = self.blank(exercise)
        text = in_order(text, self.form.namings, exercise.scope)
        text = _axis_first(text) if self.form.name == "axis-angle" else text
        body = with_unit_inside(with_points(_LABEL.sub(" ", text), (1, wanted)).strip(), wanted)
        body = ", ".join(line for line in flat(body).splitlines() if line.strip())
        rows = parse_matrix(f"[{body}]", exercise.scope, place or Place("answer"))
        cells = [cell.expr for row in rows for cell in row]
        if len(cells) != wanted:
            message = f"{plural(len(cells), 'number')} for {wanted}: {', '.join(self.form.parts)}"
            raise UnreadableError(message)
        over, values, bare = Floats(numbers(exercise.values)), [], False
        for k, (name, expr) in enumerate(zip(self.form.parts, cells, strict=True)):
            try:
                value = self._value(k, expr)
            except DimensionError as error:
                raise UnreadableError(f"{name}: {error.message}") from None
            inside = symbols_of(value)
            check_names(exercise, inside)
            if missing := sorted(inside - exercise.values.keys()):
                raise UnreadableError(f"{name}: a number was asked, and {missing[0]} has no value")
            bare |= k in self.form.angles and not has_angle_unit(expr)
            known = value.substitute(exercise.values) if isinstance(value, Angle) else value
            values.append(known.constant() if isinstance(known, Angle) else over.value(known))
        return Turn(tuple(values), bare)

    def _value(self, k: int, expr: Expr) -> Angle | Expr:
        """A number of the form as it was typed; the length of a rotation vector is an angle in radians.

        Raises:
            DimensionError: It has a unit that it cannot have.
        """
        if k in self.form.angles:
            return to_angle(expr, bare="deg")
        if self.form.name == "rotation-vector" and any(isinstance(one, Unit) for one in walk(expr)):
            return to_angle(expr)
        return to_length(expr)

    def mark(self, case: Case, reading: Reading[Turn]) -> Mark:
        right, turn = self._right(case), reading.value
        off = angle_between(self.form.rotation(turn.values), right)
        limit = case.tolerance.rotation
        verdict = judge(off, 0.0, limit)
        if verdict is not Verdict.RIGHT and turn.bare:
            in_radians = [math.degrees(v) if k in self.form.angles else v for k, v in enumerate(turn.values)]
            if judge(angle_between(self.form.rotation(in_radians), right), 0.0, limit) is Verdict.RIGHT:
                raise WrongUnitError(RADIANS, case.exercise.unit)
        remarks = () if verdict is Verdict.RIGHT else (turned(self.form.rotation(turn.values), right),)
        earned = float(verdict is Verdict.RIGHT)
        return Mark(verdict, self.form.text(turn.values), (), remarks, earned, self.expected(case))

    def slips(self, case: Case) -> Iterator[Slip]:
        right = self._right(case)
        for slip, values in self._mistakes(case):
            if angle_between(self.form.rotation(values), right) > LEAST_TURN:
                yield slip

    def answer_with(self, case: Case, name: str) -> str | None:
        return next((self.form.text(values) for slip, values in self._mistakes(case) if slip.name == name), None)

    def causes(self, case: Case, reading: Reading[Turn]) -> Causes:
        typed, right = self.form.rotation(reading.value.values), self._right(case)
        limit = case.tolerance.rotation
        return tuple(
            (slip,)
            for slip, values in self._mistakes(case)
            if angle_between(self.form.rotation(values), right) > limit
            and angle_between(self.form.rotation(values), typed) <= limit
        )

    def follows(self, case: Case, reading: Reading[Turn], earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
        from dhcli.checking.diagnosis.following import orientation_follows

        return orientation_follows(case, self.wanted, self.form.rotation(reading.value.values), earlier)

    def _right(self, case: Case) -> Rotation[float]:
        truth = truth_of(self.wanted, case)
        if truth.numbers is None:
            unknown = [name for name in unvalued(self.wanted, case.exercise) if name not in case.exercise.known]
            if not unknown:
                raise RobotError("an orientation is said in numbers", "numeric: true")
            hint = f"--set {unknown[0]}=..., or given: in the file of an exercise"
            raise RobotError(f"an orientation is said in numbers, and {unknown[0]} has no value", hint)
        return truth.numbers

    def _mistakes(self, case: Case) -> Iterator[tuple[Slip, tuple[float, ...]]]:
        """Answers of somebody with one slip."""
        right = self._right(case)
        usual = self.form.of(right)[0]
        inverse = Slip(
            "inverse", "this is the inverse: it turns the reference into the frame's axes", "seen from which frame?"
        )
        yield inverse, self.form.of(transposed(right))[0]
        if self.form.order is not None:
            order = self.form.order
            words = f"the three angles stand in the reverse order; {', '.join(self.form.parts)} is asked"
            yield Slip("reversed", words, "which angle comes first?"), usual[::-1]
            other = Order(order.axes, not order.fixed)
            now, then = ("current", "fixed") if order.fixed else ("fixed", "current")
            words = f"these are the angles about the {now} axes; those about the {then} ones are asked"
            yield Slip("other-axes", words, "do the axes turn along?"), other.of(right).numbers
        if self.form.name == "quaternion":
            yield Slip("w-last", "w stands last; w x y z is asked", "which number comes first?"), (*usual[1:], usual[0])
        if self.form.name == "axis-angle":
            x, y, z, angle = usual
            yield (
                Slip("axis-sign", "the axis points the other way", "look at the sense of the turn"),
                (-x, -y, -z, angle),
            )


def _axis_first(text: str) -> str:
    """`60°, (0, 0, 1)` and `θ = 60°, k = [0; 0; 1]` as the axis and then the angle; another text as it is."""
    pieces = [_WORD.sub("", _LABEL.sub("", piece)).strip() for _, piece in split(text)]
    axes = [piece for piece in pieces if piece[:1] in OPENING and piece[-1:] == OPENING[piece[:1]]]
    if len(pieces) != 2 or len(axes) != 1:  # noqa: PLR2004
        return text
    pieces.remove(axes[0])
    return f"({axes[0][1:-1].replace(';', ',')}), {pieces[0].removeprefix('angle')}"
