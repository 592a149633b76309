"""A kind of question that dhcli does not have, in one file as every kind is: whether a number is even or odd."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading, Shown
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import NotationError, Place, Problem
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.validity import Finding
from dhcli.notation.scope import Scope

WORDS = ("even", "odd")
OTHER_WAY = Slip("other-way", "even and odd have changed places", "count in twos")


@dataclass(frozen=True, slots=True)
class ParityQuestion(Question[int]):
    """Whether the number of the robot's joints, or a number, is even or odd."""

    text: str

    words: ClassVar = ("parity",)
    examples: ClassVar = ("parity joints",)
    is_plain: ClassVar = True

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`parity joints` or `parity 7`."""
        rest = text.removeprefix("parity").strip()
        if rest != "joints" and not rest.isdecimal():
            raise NotationError(Problem(f"'{rest}' is neither even nor odd", place, "write parity joints"))
        return cls(rest)

    def check(self, robot: Robot | None) -> None:
        """A robot that can be counted is there."""
        assert robot is not None or self.text != "joints"

    def describe(self, _exercise: Exercise) -> str:
        """What is asked."""
        return f"even or odd: {self.text}"

    def is_whole(self, text: str, _blank: tuple[int, int]) -> bool:
        """One word is enough."""
        return text.strip() in WORDS

    def expected(self, case: Case, _style: str = "short") -> str:
        """The word."""
        return WORDS[self._right(case)]

    def steps(self, case: Case) -> Iterable[Shown]:
        """Half of it."""
        yield Shown(f"Half of it leaves {self._right(case)}")

    def read(self, _case: Case, text: str, _place: Place | None = None) -> int:
        """One of the two words."""
        if text.strip() not in WORDS:
            raise UnreadableError("write even or odd")
        return WORDS.index(text.strip())

    def mark(self, case: Case, reading: Reading[int]) -> Mark:
        """Right or wrong."""
        right = reading.value == self._right(case)
        verdict = Verdict.RIGHT if right else Verdict.WRONG
        return Mark(verdict, WORDS[reading.value], earned=float(right), expected=self.expected(case))

    def slips(self, _case: Case) -> Iterable[Slip]:
        """The one there is."""
        yield OTHER_WAY

    def answer_with(self, case: Case, name: str) -> str | None:
        """The other word."""
        return WORDS[1 - self._right(case)] if name == OTHER_WAY.name else None

    def causes(self, case: Case, reading: Reading[int]) -> Causes:
        """The other word is the one slip."""
        return ((OTHER_WAY,),) if reading.value != self._right(case) else ()

    def findings(self, case: Case, where: tuple[str | int, ...]) -> Iterable[Finding]:
        """Seven is too easy."""
        if self.text == "7":
            yield Finding(where, f"{case.part.id}: everybody knows 7")

    def _right(self, case: Case) -> int:
        robot = case.exercise.robot
        number = len(robot.variables) if self.text == "joints" and robot else int(self.text)
        return number % 2
