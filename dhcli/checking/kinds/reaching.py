"""`count solutions` and `reach`: how many joint vectors reach a pose, and whether any does."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import partial
from operator import eq
from typing import ClassVar, Self

from dhcli.checking.diagnosis.alternatives import Alternative, AlternativesQuestion
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.pasted import UnreadableError, without_label, without_number_word
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.solving.goal import Target, read_target, solutions
from dhcli.checking.solving.question import GoalQuestion
from dhcli.checking.solving.spare import without_number
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import NotationError, Place, Problem, plural
from dhcli.frozen import frozen
from dhcli.kinematics.validity import Finding
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_LIMITS = regex(r"(?:within\s+limits)?")
MOST_TYPED = 10_000
WORDS = {
    **dict.fromkeys(("yes", "y", "yep", "yeah", "true", "reached", "reachable"), True),
    **dict.fromkeys(("no", "n", "nope", "false", "unreachable", "not reached", "not reachable"), False),
}
_COUNTED = ("solution", "way", "posture", "branch")
_PLAIN = regex(r"\b(?:yes|yep|yeah|nope|true|false|y|n|no(?!t?\s+(?:problem|doubt|matter)))\b", re.IGNORECASE)
"""Words of which one answer has those of one side only."""
_WORD = regex(r"\s*(?:it(?:'s| is) )?(?P<word>not reach(?:ed|able)|[a-z]+)\b.*", re.DOTALL | re.IGNORECASE)


def _asked(text: str, scope: Scope, place: Place | None) -> tuple[Target, bool]:
    target, rest = read_target(text, scope, place)
    if not _LIMITS.fullmatch(rest):
        raise NotationError(Problem(f"'{rest:.60}' is not understood", place, "write within limits, or nothing"))
    return target, bool(rest)


@frozen
class SolutionsQuestion(GoalQuestion[int], AlternativesQuestion[int]):
    """How many joint vectors reach a pose.

    Attributes:
        within_limits: Whether only those inside the limits of the joints count.
    """

    within_limits: bool = False

    words: ClassVar = ("count solutions",)
    examples: ClassVar = ("count solutions of position (0.5, 0.3, 0)",)
    is_plain: ClassVar = True
    has_one_name: ClassVar = False

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`count solutions of position (0.5, 0.3, 0) within limits`."""
        return cls(*_asked(re.sub(r"^count\s+solutions", "", text), scope, place))

    def describe(self, exercise: Exercise) -> str:
        limits = " within the limits of the joints" if self.within_limits else ""
        return f"how many solutions there are{limits} for {self.target.words(exercise)}, a whole number"

    def expected(self, case: Case, _style: str = "short") -> str:
        return str(self._right(case))

    def _right(self, case: Case) -> int:
        found = solutions(case, self.target)
        return int(found.within_limits.sum()) if self.within_limits else len(found)

    def steps(self, case: Case) -> Iterable[Shown]:
        found = solutions(case, self.target)
        named = (found.named(k, limits=self.within_limits) for k in range(len(found)))
        yield Shown("\n".join((f"{plural(len(found), 'solution')}", *filter(None, named))))
        if found.why:
            yield Shown(found.why)

    def findings(self, case: Case, where: tuple[str | int, ...]) -> Iterable[Finding]:
        yield from without_number(case, self.target, where)
        if any(solutions(case, self.target).free):
            message = f"{case.part.id}: this pose is singular, and has solutions without number"
            yield Finding((*where, "ask"), message, "give another pose", is_warning=True)

    def read(self, _case: Case, text: str, _place: Place | None = None) -> int:
        found = without_number_word(without_label(text), _COUNTED).strip().rstrip(".")
        if not found.isdecimal() or int(found[:9]) > MOST_TYPED:
            raise UnreadableError("a number of solutions is a whole number")
        return int(found)

    def mark(self, case: Case, reading: Reading[int]) -> Mark:
        right, typed = self._right(case), reading.value
        verdict = Verdict.RIGHT if typed == right else Verdict.WRONG
        return Mark(verdict, str(typed), earned=float(typed == right), expected=str(right))

    def alternatives(self, case: Case, _name: str = "") -> Iterator[Alternative[int]]:
        """Numbers that come out by one slip."""
        right, found = self._right(case), solutions(case, self.target)
        numbers = {
            Slip("one-branch", "one angle was taken where a cosine has two", "which signs can be chosen freely?"): (
                right // 2 if right > 1 else -1
            ),
            Slip("first-only", "the first solution was taken for the only one", "is there another posture?"): (
                1 if right > 1 else -1
            ),
            Slip("limits", "the limits of the joints were not looked at", "look at the limits"): (
                len(found) if self.within_limits else int(found.within_limits.sum())
            ),
            Slip("counted-twice", "each solution is counted twice", "are two of them the same?"): 2 * right or -1,
            Slip("not-reached", "the pose is out of reach: there is no solution", "how far do the links reach?"): (
                2 if right == 0 else -1
            ),
        }
        seen = {right, -1}
        for slip, number in numbers.items():
            if number not in seen:
                seen.add(number)
                yield Alternative(slip, str(number), partial(eq, number))


@frozen
class ReachQuestion(GoalQuestion[bool]):
    """Whether a pose is reached.

    Attributes:
        within_limits: Whether the limits of the joints count.
    """

    within_limits: bool = False

    words: ClassVar = ("reach",)
    examples: ClassVar = ("reach of position (0.5, 0.3, 0)",)
    is_plain: ClassVar = True
    is_explained: ClassVar = False

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`reach of position (0.5, 0.3, 0) within limits`."""
        return cls(*_asked(text.removeprefix("reach"), scope, place))

    def describe(self, exercise: Exercise) -> str:
        limits = " within the limits of the joints" if self.within_limits else ""
        return f"whether the arm reaches this{limits}, yes or no: {self.target.words(exercise)}"

    def is_whole(self, text: str, _blank: tuple[int, int]) -> bool:
        return text.strip().lower() in WORDS

    def expected(self, case: Case, _style: str = "short") -> str:
        return "yes" if self._right(case) else "no"

    def _right(self, case: Case) -> bool:
        found = solutions(case, self.target)
        return bool(found.within_limits.any()) if self.within_limits else bool(len(found))

    def steps(self, case: Case) -> Iterable[Shown]:
        yield Shown(self._why(case))

    def read(self, _case: Case, text: str, _place: Place | None = None) -> bool:
        word = _word(text) or _word(without_label(text))
        if word not in WORDS:
            raise UnreadableError("write yes or no; a reason may stand behind it")
        return WORDS[word]

    def mark(self, case: Case, reading: Reading[bool]) -> Mark:
        right = self._right(case)
        is_right = reading.value == right
        shown = "yes" if reading.value else "no"
        remarks = (self._why(case),) if is_right else ()
        verdict = Verdict.RIGHT if is_right else Verdict.WRONG
        return Mark(verdict, shown, (), remarks, float(is_right), self.expected(case))

    def _why(self, case: Case) -> str:
        """Why it is reached, or is not."""
        found = solutions(case, self.target)
        if not len(found):
            return found.why
        if self.within_limits and not found.within_limits.any():
            return "it is reached, but each solution has a joint outside its limits"
        return f"it is reached in {plural(len(found), 'way')}"


def _word(text: str) -> str:
    """The word of an answer that is yes or no; empty where it begins with another one, or has both of them."""
    match = _WORD.fullmatch(text)
    word = match["word"].lower() if match else ""
    said = {WORDS[one.lower()] for one in _PLAIN.findall(text)}
    return word if word in WORDS and len(said) < 2 else ""  # noqa: PLR2004
