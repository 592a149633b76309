"""An exercise: a robot, questions, and what the document prints. The answers are computed, never typed in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from dhcli.checking.questions import MatrixQuestion, Question, Span, TableQuestion
from dhcli.checking.tolerance import DEFAULT, Tolerance
from dhcli.checking.variants import Range
from dhcli.errors import DhcliError, UnknownNameError, did_you_mean
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.derived import replaced
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.names import GREEK_NAMES, parts
from dhcli.notation.quantity import LENGTH_UNITS
from dhcli.notation.scope import Scope
from dhcli.notation.styles import THETAS, Joints


@dataclass(frozen=True, slots=True)
class Printed:
    """What a document prints where it answers a part.

    Attributes:
        text: The answer as printed.
        note: What is known about it, such as the row that was lost.
    """

    text: str
    note: str = ""


@dataclass(frozen=True, slots=True)
class Trial:
    """A submission that an exercise tests itself with.

    Attributes:
        part: The part it answers.
        answer: The answer; empty if a mistake makes it.
        mistake: The mistake that makes the answer.
        verdict: What it must be judged.
    """

    part: str
    answer: str
    verdict: str
    mistake: str = ""


@dataclass(frozen=True, slots=True)
class Part:
    """One question of an exercise.

    Attributes:
        id: Its name on the sheet.
        question: What is asked.
        prompt: The task in words; empty where the question says it all.
        credit: What it is worth.
        depends: Parts whose answers it builds on.
        hints: Help, from gentle to plain.
        tolerance: How near is near enough; the exercise's own if None.
        compare: How a table is judged: literal, same-motion or same-robot.
        printed: What the document shows, if it does.
    """

    id: str
    question: Question
    prompt: str = ""
    credit: float = 1.0
    depends: tuple[str, ...] = ()
    hints: tuple[str, ...] = ()
    tolerance: Tolerance | None = None
    compare: str = "same-robot"
    printed: Printed | None = None


@dataclass(frozen=True)
class Exercise:
    """A task with its parts.

    Attributes:
        id: Folder and name, such as `wpi/puma560-links`.
        title: What it is called.
        source: Document and item it comes from.
        task: What to do, in words.
        parts: The questions in order.
        robot: The robot, or None where the exercise has none.
        given: Values that the task states.
        names: Other names that answers may use.
        numeric: Whether answers are numbers; else they are expressions.
        unit: Unit of bare lengths on the sheet; `none` where the task has no unit.
        tolerance: How near is near enough.
        also: A second robot that is right too, with its note.
        trials: Submissions the exercise tests itself with.
        shows_expected: Whether feedback may show the right entry.
        variants: What may be drawn by a seed, by name.
        variant: The seed that `given` was drawn by; empty for the numbers of the file.
        truths: What was worked out so far and need not be again: right answers, searches for mistakes, draws.
        forms: Answers in symbols computed so far, by question; copies with other values share them.
    """

    id: str
    title: str
    source: str
    task: str
    parts: tuple[Part, ...]
    robot: Robot | None = None
    given: Mapping[str, Value] = field(default_factory=dict)
    names: tuple[str, ...] = ()
    numeric: bool = False
    unit: str = "m"
    tolerance: Tolerance = DEFAULT
    also: tuple[Robot, str] | None = None
    trials: tuple[Trial, ...] = ()
    shows_expected: bool = False
    variants: Mapping[str, Range] = field(default_factory=dict)
    variant: str = ""
    truths: dict[object, object] = field(default_factory=dict, init=False, repr=False, compare=False)
    forms: dict[object, object] = field(default_factory=dict, repr=False, compare=False)

    def part(self, name: str) -> Part:
        """A part by its name.

        Raises:
            UnknownNameError: There is no such part; the hint lists those there are.
        """
        for part in self.parts:
            if part.id == name:
                return part
        known = [part.id for part in self.parts]
        raise UnknownNameError(f"{self.id} has no part {name}", did_you_mean(name, known) or ", ".join(known))

    def accepts(self, written: str, sheet: str) -> None:
        """Make sure that a sheet was written for this exercise; one that does not say is taken.

        An exercise that was given by its path has no course in its id; that on the sheet is not compared then.

        Raises:
            DhcliError: It names another exercise.
        """
        same = written if "/" in self.id else written.rpartition("/")[2]
        if written and same != self.id:
            raise DhcliError(f"{sheet} is a sheet of {written}, not of {self.id}", f"dhcli check {written} {sheet}")

    @cached_property
    def scope(self) -> Scope:
        """The names that answers may use: the robot's, those given, and those the exercise adds."""
        return answer_scope(self.robot, (*self.given, *self.names))

    @property
    def metres(self) -> Fraction:
        """Metres in a bare length of the sheet; 1 where the task has no unit."""
        return LENGTH_UNITS.get(self.unit, Fraction(1))

    @property
    def writing(self) -> Joints:
        """How joint angles are written."""
        return self.robot.writing if self.robot else THETAS

    @cached_property
    def values(self) -> Mapping[str, Value]:
        """Values that may stand for their names: those given and, in numbers, the robot's own."""
        if not self.robot or not self.numeric:
            return dict(self.given)
        return replaced(self.robot.derived, self.robot.parameters, self.given)


def answer_scope(robot: Robot | None, extra: tuple[str, ...]) -> Scope:
    """The scope of a robot with further names, whose Greek ones are angles; open where there is neither."""
    if robot is None:
        angles = tuple(name for name in extra if _is_greek(name))
        return Scope(angles=angles, lengths=tuple(n for n in extra if n not in angles), is_open=not extra)
    own = robot.scope
    more = [name for name in extra if name not in own.names]
    return Scope(
        joints=own.joints,
        angles=(*own.angles, *(name for name in more if _is_greek(name))),
        lengths=(*own.lengths, *(name for name in more if not _is_greek(name))),
        aliases=own.aliases,
    )


def question_about(robot: Robot, start: str, end: str, *, numeric: bool, given: Mapping[str, Value]) -> Exercise:
    """An exercise of one part made on the spot: the pose of a frame of a robot."""
    part = Part("pose", MatrixQuestion(Span(start, end)))
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot, given, numeric=numeric)


def question_about_table(robot: Robot, convention: Convention) -> Exercise:
    """An exercise of one part made on the spot: the DH table of a robot in one of the conventions."""
    part = Part("table", TableQuestion(convention))
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot)


def _is_greek(name: str) -> bool:
    return parts(name)[0] in GREEK_NAMES
