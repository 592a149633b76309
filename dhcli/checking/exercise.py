"""An exercise, its parts, and what every kind of question can do; a kind is one class in `kinds`.

An exercise is data. What is worked out for it is kept in a `Memo`, which a `Judge` owns, and handed to a question as a
`Case`: the exercise, the part and the memo. They name one another, and so stand in one file; what a question says of
itself stands in `asking`, what it returns in `returned`.
"""

from __future__ import annotations

import math
import shlex
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from dhcli.checking.asking import Asking
from dhcli.checking.credit import USUAL, Shares
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.returned import Causes, Judged, Matrices, Overlaid, Points, Reading, Shown
from dhcli.checking.tolerance import DEFAULT, Tolerance
from dhcli.checking.units import on_sheet
from dhcli.checking.verdicts import Mark
from dhcli.checking.written import Printed, Range, Trial, answer_scope
from dhcli.errors import DhcliError, Place, RobotError, UnknownNameError, did_you_mean
from dhcli.frozen import FrozenDict, frozen
from dhcli.kinematics.conventions import Row
from dhcli.kinematics.derived import replaced
from dhcli.kinematics.entries import rounded
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.validity import Finding
from dhcli.notation.names import natural_key
from dhcli.notation.quantity import LENGTH_UNITS, value_text
from dhcli.notation.scope import Scope
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Expr
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.kinematics.values import Values

T = TypeVar("T")
R = TypeVar("R")

PLACES = {"mm": 2, "cm": 3, "m": 5}
"""Decimals of a hundredth of a millimetre."""
FIGURES = 3
"""Digits of a distance that is told of an answer in numbers."""
MOST_RECENT = 500
"""Things of one kind that answers bring along and that are kept: entries, mostly, that many students write alike."""

_MISSING = object()
"""Stands for what is not known yet."""

MISPRINTED = "this is what the document prints; it is a misprint"


class Memo:
    """What was worked out for an exercise and need not be again.

    Attributes:
        exercise: The exercise.
        like: The memo of the same exercise with the joints at other values, whose searches save work.
        lasting: What does not depend on the numbers; the same exercise with other numbers shares it.
    """

    def __init__(
        self, exercise: Exercise, like: Memo | None = None, lasting: dict[object, object] | None = None
    ) -> None:
        """Begin with nothing but what others share."""
        self.exercise = exercise
        self.like = like
        self.lasting: dict[object, object] = {} if lasting is None else lasting
        self._known: dict[object, object] = {}
        self._units = {exercise.unit: self}

    def of(self, key: object, make: Callable[[], R]) -> R:
        """What is kept under a key, made when it is first asked for."""
        found = self._known.get(key, _MISSING)
        if found is _MISSING:
            found = self._known[key] = make()
        return cast("R", found)

    def recent(self, kind: object, key: object, make: Callable[[], R]) -> R:
        """The same for what answers bring along, of each kind of which no more is kept than a class has alike."""
        known: dict[object, object] = self.of(kind, dict)
        found = known.get(key, _MISSING)
        if found is _MISSING:
            if len(known) >= MOST_RECENT:
                known.clear()
            found = known[key] = make()
        return cast("R", found)

    def in_unit(self, unit: str) -> Memo:
        """What is worked out for the same exercise with a sheet in another unit; those of all units know each other."""
        if unit not in self._units:
            there = self._units[unit] = Memo(replace(self.exercise, unit=unit))
            there._units = self._units
        return self._units[unit]


class Question(Asking, Generic[T]):
    """A kind of question: how it is asked, what is right, and how an answer is read, judged and explained."""

    __slots__ = ()

    # --- What it says to people ----------------------------------------------------------------------------------

    @abstractmethod
    def describe(self, exercise: Exercise) -> str:
        """What is asked for, in a few words."""

    def describe_form(self, exercise: Exercise) -> str:
        """The same where a task says in its own words what is asked for, and how it is found would give it away."""
        return self.describe(exercise)

    def blank(self, _exercise: Exercise) -> tuple[int, int]:
        """Rows and columns of blanks on a sheet."""
        return 1, 1

    def notes(self, _exercise: Exercise) -> Iterable[str]:
        """What a sheet says above the blanks."""
        return ()

    def pose_drawn(self, _exercise: Exercise) -> Values:
        """A value for every joint, in the pose in which the answer is asked; empty where it is asked in none."""
        return {}

    # --- What is right -------------------------------------------------------------------------------------------

    def unvalued(self, _exercise: Exercise) -> tuple[str, ...]:
        """Names without a value where the right answer needs one; none where letters may stay.

        An exercise whose file leaves one so does not load, and one that was made on the spot is not judged.
        """
        return ()

    @abstractmethod
    def expected(self, case: Case, style: str = "short") -> str:
        """The right answer as a person would type it.

        Raises:
            DhcliError: There is none, such as a table of another convention.
        """

    def shortest(self, case: Case) -> str:
        """The right answer as a solution shows it, to be copied."""
        return self.expected(case)

    def steps(self, _case: Case) -> Iterable[Shown]:
        """What leads to the right answer."""
        return ()

    def findings(self, _case: Case, _where: tuple[str | int, ...]) -> Iterable[Finding]:
        """What an author should mend, besides what holds for every kind."""
        return ()

    # --- How an answer is judged ---------------------------------------------------------------------------------

    @abstractmethod
    def read(self, case: Case, text: str, place: Place | None = None) -> T:
        """Read an answer.

        Raises:
            UnreadableError: It has another form.
            NotationError: It cannot be read.
        """

    @abstractmethod
    def mark(self, case: Case, reading: Reading[T]) -> Mark:
        """Judge an answer that has been read.

        Raises:
            UnreadableError: It cannot be judged; only its unit is wrong, for one.
        """

    def misprinted(self, _case: Case, judged: Judged[T], printed: Judged[T]) -> tuple[str, ...]:
        """Remarks for an answer, or parts of it, that is not right and just what the document prints."""
        return (MISPRINTED,) if judged.mark.reading == printed.mark.reading else ()

    # --- How a wrong answer is explained -------------------------------------------------------------------------

    def slips(self, _case: Case) -> Iterable[Slip]:
        """Every single mistake that changes the right answer."""
        return ()

    def answer_with(self, _case: Case, _name: str) -> str | None:
        """The answer of a student with one mistake, by its name, such as `alpha-sign 2`; None if it cannot be made."""
        return None

    def hidden(self, _case: Case) -> Iterable[Slip]:
        """Mistakes whose answer is right at the values given although it is wrong at others."""
        return ()

    def unclear(self, _case: Case) -> Iterable[str]:
        """Names of mistakes whose answer at the values given is right, or so near that it is hardly wrong."""
        return ()

    def causes(self, _case: Case, _reading: Reading[T]) -> Causes:
        """Every cause that gives just this answer, the plainest kind; none where none is known."""
        return ()

    def told(self, _case: Case, mark: Mark, _reading: Reading[T]) -> Mark:
        """The mark of an answer without a known cause, with what can be said all the same."""
        return mark

    def follows(self, _case: Case, _reading: Reading[T], _earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
        """The earlier parts, by name, from whose own answers a wrong answer is right."""
        return ()

    def differs(self, _mark: Mark) -> bool:
        """Whether later parts may follow from a right answer otherwise than from the solution."""
        return False

    def is_plausible(self, _case: Case, _judged: Judged[T]) -> bool:
        """Whether somebody has worked out an answer, so that what follows from it shows work as well."""
        return True

    def rows(self, _case: Case, _reading: Reading[T]) -> tuple[Row, ...]:
        """The DH rows that an answer draws, one for each link of the robot; none where it draws none."""
        return ()

    def arm(self, _case: Case, _reading: Reading[T]) -> Robot | None:
        """The robot as an answer draws it, with the frames of the exercise; None where it draws none."""
        return None

    def leads(
        self, _case: Case, _reading: Reading[T], _span: tuple[int, int], _points: Points
    ) -> tuple[int, int, Matrices] | None:
        """From which frame to which an answer leads within a span of frames, and the matrices at some points."""
        return None

    def overlaid(self, _case: Case, _reading: Reading[T], _values: Values) -> Overlaid | None:
        """What an answer draws over the arm, at some values of all names unless it has its own; None for nothing."""
        return None


_FRAME = regex(r"\bframe \w+")


@frozen
class Part:
    """One question of an exercise.

    Attributes:
        id: Its name on the sheet.
        question: What is asked.
        prompt: The task in words; empty where the question says it all.
        credit: What it is worth.
        shares: What an answer earns of it; as the exercise says if None.
        withdrawn: Why it is not asked any more; empty for a part that is.
        depends: Parts whose answers it builds on.
        hints: Help, from gentle to plain.
        tolerance: How near is near enough; the exercise's own if None.
        compare: How a table is judged: literal, same-motion or same-robot; empty where the file does not say.
        printed: What the document shows, if it does.
        index: Where it stands among the parts of its file, from 0; two may have one id before that is mended.
    """

    id: str
    question: Question[Any]
    prompt: str = ""
    credit: float = 1.0
    shares: Shares | None = None
    withdrawn: str = ""
    depends: tuple[str, ...] = ()
    hints: tuple[str, ...] = ()
    tolerance: Tolerance | None = None
    compare: str = ""
    printed: Printed | None = None
    index: int = 0

    def heading(self, exercise: Exercise) -> str:
        """What is asked for, in a few words that do not tell more than the task does."""
        return self.question.describe_form(exercise) if self.prompt else self.question.describe(exercise)

    def form(self, exercise: Exercise) -> str:
        """What is to be written, below a prompt that has asked for it: what the prompt says itself is left out."""
        heading = self.heading(exercise)
        what, _, form = heading.rpartition(": ")
        frames = set(_FRAME.findall(what))
        return form if frames and frames <= set(_FRAME.findall(self.prompt)) else heading


@frozen
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
        shares: What answers earn of the credit of their parts.
        also: A second robot that is right too, with its note.
        trials: Submissions the exercise tests itself with.
        shows_expected: Whether feedback may show the right entry.
        variants: What may be drawn by a seed, by name.
        picture: What a picture may show, `none`, `axes` or `frames`; empty where the parts alone say it.
        variant: The seed that `given` was drawn by; empty for the numbers of the file.
        scope: The names that answers may use: the robot's, those given, and those the exercise adds.
        values: Values that may stand for their names: those given and, in numbers, the robot's own.
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
    shares: Shares = USUAL
    also: tuple[Robot, str] | None = None
    trials: tuple[Trial, ...] = ()
    shows_expected: bool = False
    variants: Mapping[str, Range] = field(default_factory=dict)
    variant: str = ""
    picture: str = ""
    scope: Scope = field(init=False, repr=False, compare=False)
    values: Mapping[str, Value] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Work out what follows from the rest."""
        object.__setattr__(self, "given", FrozenDict(self.given))
        object.__setattr__(self, "variants", FrozenDict(self.variants))
        said = (self.task, *(part.prompt for part in self.parts))
        object.__setattr__(self, "scope", answer_scope(self.robot, (*self.given, *self.names), said))
        object.__setattr__(self, "values", self.known if self.numeric else self.given)

    @property
    def known(self) -> Mapping[str, Value]:
        """All values there are, given or the robot's own, for what is asked in numbers whatever the other parts are."""
        return replaced(self.robot.derived, self.robot.parameters, self.given) if self.robot else self.given

    def unvalued(self, names: frozenset[str]) -> tuple[str, ...]:
        """Those of some names that have no value, as people would list them."""
        return tuple(sorted(names - self.values.keys(), key=natural_key))

    @property
    def missing(self) -> tuple[str, ...]:
        """Names without a value that the right answers to its parts need.

        Raises:
            DhcliError: There is no right answer, whatever the values are.
        """
        return tuple(dict.fromkeys(name for part in self.asked for name in part.question.unvalued(self)))

    def need_values(self, part: Part) -> None:
        """Make sure that there is a right answer where numbers are asked for.

        Raises:
            RobotError: A name in it has no value.
        """
        if missing := part.question.unvalued(self):
            hint = f"--set {missing[0]}=..., or given: in the file of an exercise"
            raise RobotError(f"{self.id} asks for numbers, and has no value for {', '.join(missing)}", hint)

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

    @property
    def typed(self) -> str:
        """What is typed behind a command to mean it: its id, and its variant."""
        return f"{self.id} --variant {shlex.quote(self.variant)}" if self.variant else self.id

    @property
    def file_name(self) -> str:
        """What a file about it is called, without its ending."""
        return self.id.split("/")[-1]

    @property
    def asked(self) -> tuple[Part, ...]:
        """The parts that are asked: those that were not withdrawn."""
        return tuple(part for part in self.parts if not part.withdrawn)

    @property
    def credit(self) -> float:
        """What all parts are worth together."""
        return sum(part.credit for part in self.asked)

    def before(self, part: Part) -> Iterator[Part]:
        """The parts that a part builds on, directly or through others, each once."""
        wanted, found = list(part.depends), set[str]()
        while wanted:
            one = self.part(wanted.pop())
            if one.id not in found:
                found.add(one.id)
                wanted += one.depends
                yield one

    def accepts(self, written: str, sheet: str) -> None:
        """Make sure that a sheet was written for this exercise; one that does not say is taken.

        An exercise that was given by its path has no course in its id; that on the sheet is not compared then.

        Raises:
            DhcliError: It names another exercise.
        """
        same = written if "/" in self.id else written.rpartition("/")[2]
        if written and same != self.id:
            raise DhcliError(f"{sheet} is a sheet of {written}, not of {self.id}", f"dhcli check {written} {sheet}")

    @property
    def given_text(self) -> str:
        """The values that it gives, lengths in the unit of its sheet: `theta1 = 30°, d3 = 0.12 m`."""
        return ", ".join(f"{name} = {value_text(value, self.behind.strip())}" for name, value in self.given.items())

    @property
    def behind(self) -> str:
        """What stands behind a length on its sheet: ` mm`; nothing where the task has no unit."""
        return "" if self.unit == "none" else f" {self.unit}"

    def distance(self, metres: float, *, signed: bool = False) -> str:
        """A distance in the unit of the sheet, to a hundredth of a millimetre: `0.0879 m`.

        Args:
            metres: The distance [m].
            signed: Whether a plus stands before one that is positive.
        """
        text = rounded(metres / float(self.metres), PLACES.get(self.unit, 4))
        return f"{'+' * (signed and metres > 0)}{text}{self.behind}"

    def about(self, metres: float) -> str:
        """By how much numbers that were typed are off, to three digits: more than a tolerance of a thousandth says."""
        shown = abs(metres / float(self.metres))
        finest = PLACES.get(self.unit, 4)
        places = FIGURES - 1 - math.floor(math.log10(shown)) if shown and math.isfinite(shown) else finest
        return f"{rounded(metres / float(self.metres), max(0, min(places, finest)))}{self.behind}"

    @property
    def metres(self) -> Fraction:
        """Metres in a bare length of the sheet; 1 where the task has no unit."""
        return LENGTH_UNITS.get(self.unit, Fraction(1))

    @property
    def other_units(self) -> tuple[str, ...]:
        """Units that somebody may have typed bare lengths in instead of that of the sheet; none where it has none."""
        if self.unit not in LENGTH_UNITS:
            return ()
        return tuple(unit for unit in ("mm", "cm", "m") if unit != self.unit)

    def on_sheet(self, length: Expr) -> Expr:
        """A length in metres as it is written on the sheet: its bare numbers are in the unit of that."""
        return on_sheet(length, self.metres, self.scope)

    @property
    def writing(self) -> Joints:
        """How joint angles are written."""
        return self.robot.writing if self.robot else THETAS


@frozen
class Case:
    """A part of an exercise, with what was worked out for the exercise so far."""

    part: Part
    memo: Memo

    @property
    def exercise(self) -> Exercise:
        """The exercise."""
        return self.memo.exercise

    @property
    def tolerance(self) -> Tolerance:
        """How near is near enough."""
        return self.part.tolerance or self.exercise.tolerance

    @property
    def shares(self) -> Shares:
        """What an answer earns of the credit of the part."""
        return self.part.shares or self.exercise.shares
