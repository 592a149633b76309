"""`angle`: a formula for a joint, with all its values; judged at random poses on all branches."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.kinds.linked import needed
from dhcli.checking.other_unit import refuse_right_in
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading, Shown
from dhcli.checking.solving import covering
from dhcli.checking.solving.covering import Asked, Outcome
from dhcli.checking.solving.derived import (
    derivation_of,
    moving_joints,
    slipped,
    steps_shown,
)
from dhcli.checking.solving.formulas import Formula, read_formula
from dhcli.checking.solving.goal import Target, of_robot
from dhcli.checking.solving.told import told
from dhcli.checking.solving.typed import exprs_of, formula_of, typed_text, values_of
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import NotationError, Place, Problem, RobotError, UnknownNameError
from dhcli.frozen import frozen
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION, ROTATION
from dhcli.kinematics.inverse.derive_terms import name_of
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.names import canonical
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Number, Symbol, multiply
from dhcli.regex import regex

_ASKED = regex(
    r"(?:angle|joint)\s+(?P<joints>[\w+ ]+?)\s+(?:(?P<start>base|\d{1,4})\s*\.\.\s*(?P<end>tool|\d{1,4})\s+)?"
    r"of\s+(?P<task>pose|position|orientation)\s*"
)
FIRST = 3
"""Solutions at which a formula is looked at before it is tried at all of them."""
EARNED_TOO_MUCH = 0.5
"""What a formula earns that has every value, and others besides."""

_OF_ALL = ("joint values", "joint torques")
"""How a question about all joints begins that is asked otherwise."""


@frozen
class JointFormulaQuestion(Question[Formula]):
    """A formula for a joint, or for a sum of joints, from the entries of a pose.

    Attributes:
        joints: The joints whose sum is asked for, mostly one.
        target: What is given: a pose, a position or an orientation, in letters.
        turns: Whether they are angles.
    """

    joints: tuple[str, ...]
    target: Target
    turns: bool = True

    words: ClassVar = ("angle", "joint")
    examples: ClassVar = ("angle theta2 of position", "angle theta3 of pose", "joint d3 of pose")
    needs_table: ClassVar = True
    has_cosines: ClassVar = True

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`angle theta2 of position`."""
        match = _ASKED.fullmatch(text.strip())
        if match is None and text.startswith(_OF_ALL):
            raise NotAskedError(text)
        if match is None:
            message = f"'{text.strip():.60}' asks for no joint"
            raise NotationError(Problem(message, place, "write angle theta2 of position, or of pose"))
        joints = tuple(part.strip() for part in match["joints"].split("+"))
        for name in joints:
            if not scope.has(name):
                raise NotationError(Problem(f"{name} is no joint", place, ", ".join(scope.joints)))
        frames = (match["start"], match["end"]) if match["start"] else None
        return cls(joints, Target(match["task"], match["task"], frames=frames), scope.is_angle(joints[0]))

    def check(self, robot: Robot | None) -> None:
        self.target.ends(robot)
        moving = moving_joints(needed(robot), self.target)
        for name in self.joints:
            if name not in moving:
                raise UnknownNameError(f"{name} is no joint between these frames", ", ".join(moving))

    def describe(self, exercise: Exercise) -> str:
        start, end = self.target.ends(exercise.robot)
        given = {
            "position": f"the position px, py, pz of frame {end}",
            "orientation": f"the direction cosines r11 to r33 of frame {end}",
        }.get(self.target.task, f"the pose of frame {end}, its entries r11 to r33 and px, py, pz")
        return f"a formula for {self._name} with all its values, from {given} seen from frame {start}"

    def notes(self, exercise: Exercise) -> Iterable[str]:
        if exercise.metres != 1:
            yield f"Numbers that stand for lengths are in {exercise.unit}."
        yield "Write ± for two signs, or several values with commas: atan2(y, x), acos(x), sqrt(x)."
        yield "Several ± are read both ways: all together, with ∓ against them, and each by itself."
        yield "Other joints may stand in it. A long part may get a name of its own: D = ..."

    def expected(self, case: Case, _style: str = "short") -> str:
        return typed_text(self._derivation(case), self.joints)

    def steps(self, case: Case) -> Iterable[Shown]:
        yield from steps_shown(self._derivation(case), self._name)

    def read(self, case: Case, text: str, place: Place | None = None) -> Formula:
        robot = needed(case.exercise.robot)
        labels = [*self.joints, self._name.replace(" ", "")] if len(self.joints) == 1 else [self._name.replace(" ", "")]
        labels += [self._sum_name] if len(self.joints) > 1 else []
        aliases = [alias for alias, name in robot.scope.aliases.items() if (name,) == self.joints]
        scope = self._scope(case.exercise)
        formula = read_formula(
            text, [*map(canonical, labels), *aliases], scope, place or Place("answer"), case.exercise.metres
        )
        if set(self.joints) <= formula.names:
            raise UnreadableError(f"{self._name} itself stands in it; it may hold the pose, lengths and other joints")
        return formula

    def mark(self, case: Case, reading: Reading[Formula]) -> Mark:
        derivation = self._derivation(case)
        formula = reading.value
        cases, robot = self._cases(case), derivation.robot
        outcome = covering.tried(formula, cases, self._asked, robot)
        expected = typed_text(derivation, self.joints)
        if outcome.is_right:
            return Mark(Verdict.RIGHT, formula.text, earned=1.0, expected=expected)
        if formula.has_measures:
            exercise = case.exercise
            refuse_right_in(exercise.other_units, exercise.unit, partial(self._is_right_in, case, reading.text))
        earned, remarks = 0.0, tuple(told(outcome, cases, self._asked, self._candidates(derivation), formula.text))
        if outcome.is_sound:
            earned = outcome.share
        elif outcome.is_covering:
            earned = EARNED_TOO_MUCH
        return Mark(Verdict.WRONG, formula.text, remarks=remarks, earned=earned, expected=expected)

    def _is_right_in(self, case: Case, text: str, unit: str) -> bool:
        """Whether all numbers of a formula are right lengths in another unit."""
        there = Case(case.part, case.memo.in_unit(unit))
        formula = self.read(there, text)
        return covering.tried(formula, self._cases(there), self._asked, self._derivation(there).robot).is_right

    def slips(self, case: Case) -> Iterator[Slip]:
        return (slip for slip, _, _ in self._showing(case))

    def answer_with(self, case: Case, name: str) -> str | None:
        return next((text for slip, text, _ in self._showing(case) if slip.name == name), None)

    def causes(self, case: Case, reading: Reading[Formula]) -> Causes:
        outcome = covering.tried(reading.value, self._cases(case), self._asked, self._derivation(case).robot)
        typed = outcome.values
        found = tuple((slip,) for slip, _, values in self._showing(case) if self._agree(typed, values))
        if not found and not any(outcome.hits):
            # a slip, and of its values not all: `atan2(px, py)` where two angles are asked for
            found = tuple((slip,) for slip, _, values in self._showing(case) if self._agree(typed, values, partly=True))
        return found or tuple((slip,) for slip in self._more_slips(case, reading.value))

    def _more_slips(self, case: Case, formula: Formula) -> tuple[Slip, ...]:
        """A slip in the functions or the terms of a formula, of which there are too many to have them all ready."""
        from dhcli.checking.solving.formula_slips import slips_in_terms
        from dhcli.checking.solving.mended import mended_functions, mended_terms, mended_zero

        derivation, cases = self._derivation(case), self._cases(case)
        robot = derivation.robot

        def outcomes(other: Formula) -> Iterator[Outcome]:
            """At a few solutions first, at which most are seen to be wrong."""
            return (covering.tried(other, those, self._asked, robot) for those in (cases[:FIRST], cases))

        def is_right(other: Formula) -> bool:
            return all(outcome.is_right for outcome in outcomes(other))

        def is_sound(other: Formula) -> bool:
            return all(outcome.is_sound for outcome in outcomes(other))

        return (
            mended_functions(formula, self._name, is_right)
            or slips_in_terms(formula, formula_of(derivation, self.joints), robot, self._asked, cases)
            or mended_terms(formula, self._name, robot.writing, is_right)
            or (mended_zero(formula, self._name, is_sound) if self.turns else ())
        )

    # --- Its parts -------------------------------------------------------------------------------------------------

    @property
    def _name(self) -> str:
        return " + ".join(self.joints)

    @property
    def _sum_name(self) -> str:
        return name_of(tuple((name, 1) for name in self.joints))

    @property
    def _entries(self) -> tuple[str, ...]:
        """The names of what is given."""
        return {"position": POSITION, "orientation": ROTATION}.get(self.target.task, (*POSITION, *ROTATION))

    @property
    def _asked(self) -> Asked:
        return Asked(tuple((name, 1) for name in self.joints), turns=self.turns)

    def _scope(self, exercise: Exercise) -> Scope:
        own = exercise.scope
        entries = self._entries
        new = tuple(name for name in entries if name not in own.names)
        aliases = dict(own.aliases)
        for name in POSITION if POSITION[0] in entries else ():
            aliases |= {other: name for other in (name[1], f"p_{name[1]}") if not own.has(other)}
        return Scope(own.joints, own.angles, (*own.lengths, *new), aliases)

    def _derivation(self, case: Case) -> Derivation:
        found = derivation_of(case, self.target, case.exercise.metres)
        if found is None:
            name = needed(case.exercise.robot).name
            raise RobotError(f"{name} has no textbook form by these rules", "ask for numbers: joints of")
        return found

    def _candidates(self, derivation: Derivation) -> tuple[tuple[str, Expr], ...]:
        """What may tell where a formula holds."""
        entries = [(name, Symbol(name)) for name in self._entries]
        return (*entries, *covering.arguments(exprs_of(derivation, self.joints), derivation.robot))

    def _cases(self, case: Case) -> tuple[covering.Case, ...]:
        def drawn() -> tuple[covering.Case, ...]:
            derivation = self._derivation(case)
            robot, textbook = derivation.robot, values_of(formula_of(derivation, self.joints))
            scale = Number(1 / case.exercise.metres)
            given = of_robot(robot, case.exercise.values).items()
            lengths = {name: v if isinstance(v, Angle) else multiply(scale, v) for name, v in given}
            return covering.points(derivation, robot, lengths, self._asked, Formula(textbook, "", 0))

        return case.memo.of(("points", self.joints, self.target), drawn)

    def _showing(self, case: Case) -> tuple[tuple[Slip, str, Sequence[list[float]]], ...]:
        """Every slip whose formula is wrong, with that formula and its values."""
        return case.memo.of(("formula slips", self.joints, self.target), lambda: tuple(self._found(case)))

    def _found(self, case: Case) -> Iterator[tuple[Slip, str, Sequence[list[float]]]]:
        derivation = self._derivation(case)
        right, seen = typed_text(derivation, self.joints), set[str]()
        for one in slipped(derivation, derivation.robot):
            text = typed_text(one.derivation, self.joints)
            if text == right or one.slip.name in seen:
                continue
            formula = Formula(values_of(formula_of(one.derivation, self.joints)), text, 0)
            outcome = covering.tried(formula, self._cases(case), self._asked, derivation.robot)
            if not outcome.is_right:
                seen.add(one.slip.name)
                yield one.slip, text, outcome.values

    def _agree(self, typed: Sequence[list[float]], values: Sequence[list[float]], *, partly: bool = False) -> bool:
        """Whether two formulas have the same values everywhere; for `partly`, the first some of those of the second."""

        def within(first: list[float], second: list[float]) -> bool:
            return all(any(self._asked.same(a, b) for b in second) for a in first)

        pairs = list(zip(typed, values, strict=True))
        return any(a for a, _ in pairs) and all(within(a, b) and (partly or within(b, a)) for a, b in pairs)
