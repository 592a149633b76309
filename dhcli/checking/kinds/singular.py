"""`singular when`: what makes a Jacobian lose rank, in any order and up to constants."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, ClassVar, TypeAlias

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.kinds.determinant import DeterminantQuestion
from dhcli.checking.kinds.linked import needed
from dhcli.checking.motion.conditions import Condition, Zero, apart, covers, last_said, read_conditions
from dhcli.checking.motion.task import JacobianTask, found_for, listed
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading, Shown
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import NotationError, Place, are, plural
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.result import Singularities
from dhcli.notation.tree import Trig
from dhcli.notation.trig import cosine, sine
from dhcli.notation.writer import write, write_angle

Conditions: TypeAlias = tuple[Condition, ...]
"""Each is enough by itself; what stands in one is zero at once."""


@frozen
class SingularQuestion(JacobianTask, Question[Conditions]):
    """Where a Jacobian loses rank: the factors of its determinant that joints can make zero, or the conditions."""

    opening: ClassVar = "singular when"
    words: ClassVar = ("singular",)
    examples: ClassVar = ("singular when linear of 0..3", "singular when 0..6")
    needs_table: ClassVar = True
    has_cosines: ClassVar = True

    def check(self, robot: Robot | None) -> None:
        self._found(robot)

    def _found(self, robot: Robot | None) -> Singularities:
        return listed(*self.motion.check(robot), self.form)

    def describe(self, exercise: Exercise) -> str:
        found = self._found(exercise.robot)
        rank = "loses rank" if len(found.rows) != len(found.joints) else "is singular"
        said = "what is zero, each alone" if not _is_joined(found) else "what is zero, alone or at once"
        return f"when the Jacobian {self.motion.where(exercise)}, rows {', '.join(found.rows)}, {rank}: {said}"

    def notes(self, exercise: Exercise) -> Iterable[str]:
        if _is_joined(self._found(exercise.robot)):
            yield "With `and` between what is zero at once, and commas between the cases: s1 = 0 and c3 = 0, s4 = 0."
        else:
            yield "What is zero, with commas between: s1 = 0, a1 + a2*c2 = 0. Or theta1 = 0 or 180°."

    def expected(self, case: Case, style: str = "short") -> str:
        return self._text(case, self._right(case), style)

    def _text(self, case: Case, conditions: Iterable[Condition], style: str = "short") -> str:
        def zero(one: Zero) -> str:
            if one.at is not None and isinstance(one.expr, Trig):
                return f"{write_angle(one.expr.angle, style, case.exercise.writing)} = {float(one.at):g}°"
            return f"{write(one.expr, style, case.exercise.writing)} = 0"

        order = self._order(case)
        said = [" and ".join(map(zero, sorted(one, key=order))) for one in conditions]
        return (", " if not _is_joined(found_for(case, self.motion, self.form)) else "; ").join(said) or "never"

    def _order(self, case: Case) -> Callable[[Zero], tuple[int, str]]:
        """Zeros as the right answer has them, then all others."""
        known = [zero for factor in found_for(case, self.motion, self.form).factors for zero in factor.zeros]
        return lambda one: (known.index(one.expr) if one.expr in known else len(known), str(one.expr))

    def _right(self, case: Case) -> Conditions:
        found = found_for(case, self.motion, self.form)
        return tuple(frozenset(map(Zero, factor.zeros)) for factor in found.factors)

    def steps(self, case: Case) -> Iterable[Shown]:
        found, exercise = found_for(case, self.motion, self.form), case.exercise
        if found.determinant is not None:
            yield Shown(f"The determinant is {write(found.determinant, 'short', exercise.writing)}")
        elif found.factors:
            most = min(len(found.rows), len(found.joints))
            yield Shown(
                f"The rank falls where all determinants of {plural(most, 'row')} and as many columns are zero at once"
            )
        for factor in found.factors:
            said = factor.text("short", exercise.writing) + (f": {factor.angles}" if factor.angles else "")
            lines = [said + (f"; {factor.words}" if factor.words else "")]
            if factor.lost:
                lines.append(f"what is lost there: {factor.lost}")
            yield Shown("\n".join(lines))
        if not found.factors:
            yield Shown(
                f"Everywhere {found.rank} of its {plural(len(found.joints), 'column')} {are(found.rank)} independent"
            )

    def read(self, case: Case, text: str, place: Place | None = None) -> Conditions:
        joined = _is_joined(found_for(case, self.motion, self.form))
        return read_conditions(text, case.exercise, place, joined=joined)

    def mark(self, case: Case, reading: Reading[Conditions]) -> Mark:
        mark, last = self._marked(case, reading.value), last_said(reading.text)
        if mark.verdict is not Verdict.RIGHT or last == reading.text:
            return mark
        try:  # what is said in other words has to be as right by itself
            return self._marked(case, self.read(case, last))
        except (UnreadableError, NotationError):
            return mark

    def _marked(self, case: Case, given: Conditions) -> Mark:
        robot, wanted = needed(case.exercise.robot), self._right(case)
        named = [one for one in wanted if any(_same(one, other, robot) for other in given)]
        half = [one for one in given if any(zero.at is not None for zero in one)]
        half = [one for one in half if not any(covers(other, one, robot) for other in named)]
        half = [one for one in half if any(covers(other, _half_turns(one), robot) for other in wanted)]
        special = [one for one in given if one not in half and any(covers(other, one, robot) for other in wanted)]
        wrong = [one for one in given if one not in half and one not in special]
        is_right = len(named) == len(wanted) and not wrong and not half
        remarks = [f"{len(named)} of {len(wanted)} {are(len(named))} right"] if not is_right and wanted else []
        if wrong:
            remarks.append(f"the rank need not fall where {self._text(case, wrong)}")
        if half:
            remarks.append("one more angle belongs to each of those given: half a turn on")
        if not is_right and (less := [one for one in special if not any(_same(one, two, robot) for two in wanted)]):
            remarks.append(f"{self._text(case, less)} asks for more than is needed")
        earned = max(0, len(named) - len(wrong)) / (len(wanted) or 1)
        verdict = Verdict.RIGHT if is_right else Verdict.WRONG
        text, right = self._text(case, given), self._text(case, wanted)
        return Mark(verdict, text, (), tuple(remarks), 1.0 if is_right else min(earned, 0.99), right)

    # --- Mistakes -----------------------------------------------------------------------------------------------

    def slips(self, case: Case) -> Iterable[Slip]:
        return (slip for slip, _ in self._wrong(case))

    def answer_with(self, case: Case, name: str) -> str | None:
        return next((self._text(case, given) for slip, given in self._wrong(case) if slip.name == name), None)

    def causes(self, case: Case, reading: Reading[Conditions]) -> Causes:
        robot = needed(case.exercise.robot)
        return tuple((slip,) for slip, given in self._wrong(case) if _all_same(given, reading.value, robot))

    def _wrong(self, case: Case) -> Iterator[tuple[Slip, Conditions]]:
        right = self._right(case)
        for k, condition in enumerate(right):
            text, others = self._text(case, [condition]), (*right[:k], *right[k + 1 :])
            in_order = sorted(condition, key=self._order(case))
            name = text.replace(" = 0", "")
            if others:
                hint = "go through the factors of the determinant" if len(condition) == 1 else "go through the cases"
                yield Slip(f"factor-forgotten {name}", f"{text} is missing", hint), others
            if len(condition) > 1:
                words = f"{text} belong together: the rank falls only where all of them are zero"
                slip = Slip(f"apart {name}", words, "is one of them alone enough?")
                yield slip, (*others, *(frozenset({zero}) for zero in in_order))
            for zero in in_order:
                yield from self._in_angle(case, zero, condition - {zero}, others)

    def _in_angle(
        self, case: Case, zero: Zero, rest: Condition, others: Conditions
    ) -> Iterator[tuple[Slip, Conditions]]:
        """One of the two angles at which a sine or cosine is zero, and sine for cosine."""
        if not isinstance(zero.expr, Trig):
            return
        is_sine, text = zero.expr.function == "sin", write(zero.expr, "short", case.exercise.writing)
        words = f"{text} = 0 has two solutions in a turn, half a turn apart"
        half = rest | {Zero(zero.expr, Fraction(0 if is_sine else 90))}
        yield Slip(f"half {text}", words, "where else is it zero?"), (*others, half)
        other = rest | {Zero(cosine(zero.expr.angle) if is_sine else sine(zero.expr.angle))}
        words = f"sine and cosine have changed places in {text}"
        yield Slip(f"sin-cos {text}", words, "draw the arm there"), (*others, other)

    # --- Follow-through -----------------------------------------------------------------------------------------

    def follows(self, case: Case, reading: Reading[Conditions], earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
        robot = needed(case.exercise.robot)
        for other in case.exercise.before(case.part):
            question = other.question
            if other.id not in earlier or not isinstance(question, DeterminantQuestion):
                continue
            if (question.motion.view(robot), question.form) != (self.motion.view(robot), self.form):
                continue
            try:
                factors = apart(earlier[other.id].value[0][0].expr, case.exercise)
            except UnreadableError:
                continue
            if _all_same(tuple(frozenset({Zero(one)}) for one in factors), reading.value, robot):
                return (other.id,)
        return ()


def _is_joined(found: Singularities) -> bool:
    """Whether something must be zero together with something else."""
    return any(len(factor.zeros) > 1 for factor in found.factors)


def _half_turns(condition: Condition) -> Condition:
    """A condition at an angle and half a turn on."""
    return frozenset(replace(zero, at=None) for zero in condition)


def _same(one: Condition, other: Condition, robot: Robot) -> bool:
    return covers(one, other, robot) and covers(other, one, robot)


def _all_same(first: Sequence[Condition], second: Sequence[Condition], robot: Robot) -> bool:
    return all(
        any(_same(one, other, robot) for other in b) for a, b in ((first, second), (second, first)) for one in a
    ) and bool(first) == bool(second)
