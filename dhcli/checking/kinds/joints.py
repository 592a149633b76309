"""`joints`: joint values that reach a pose; judged by where they take the arm, then by the branch asked for."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, Self

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import needed
from dhcli.checking.lists import untransposed
from dhcli.checking.other_unit import refuse_right_in
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading, Shown
from dhcli.checking.solving.goal import read_target, solutions
from dhcli.checking.solving.question import Vectors, WantedJoints
from dhcli.checking.solving.reading import bracketed, read_vectors
from dhcli.checking.solving.spare import spare_joints, without_number
from dhcli.checking.solving.vectors import in_unit, other_units, shows_unit
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.checking.whole import ends_in_bracket, is_closed
from dhcli.errors import NotationError, Place, Problem, RobotError, did_you_mean, plural
from dhcli.frozen import frozen
from dhcli.kinematics.validity import Finding
from dhcli.notation.scope import Scope
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.solutions import Solutions

_SEVERAL = regex(r";|\bor\b|\band\b|\)[^()]*\(")
"""What stands between solutions in one line."""
_WHICH = regex(
    r"(?P<limits>within\s+limits\s*)?(?:(?P<all>all)|(?P<any>any)|branch\s+(?P<branch>[\w +,-]+))?", re.DOTALL
)


@frozen
class JointsQuestion(WantedJoints):
    """Joint values that take a frame to a pose."""

    words: ClassVar = ("joints",)
    examples: ClassVar = (
        "joints of position (0.5, 0.3, 0)",
        "joints of position (0.5, 0.3, 0) all",
        "joints of position (0.5, 0.3, 0) branch elbow up",
        'joints of pose "Trans(0.4, 0, 0.3) Rot(y, 90°)"',
        "joints of position (0.4, 0, 0.3) pointing (0, 0, -1)",
    )
    is_plain: ClassVar = True
    in_rows: ClassVar = True

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`joints of position (0.5, 0.3, 0) all`."""
        target, rest = read_target(text.removeprefix("joints"), scope, place)
        match = _WHICH.fullmatch(rest)
        if match is None:
            hint = "write all, any, branch elbow up, within limits all, or nothing"
            raise NotationError(Problem(f"'{rest:.60}' says no solution", place, hint))
        words = tuple(word.strip() for word in (match["branch"] or "").split(",") if word.strip())
        which = "all" if match["all"] else "branch" if words else "any"
        return cls(target, which, words, bool(match["limits"]))

    def describe(self, exercise: Exercise) -> str:
        which = {"all": "every solution, a row each", "any": "one solution"}.get(self.which)
        which = which or f"the solution with {' and '.join(self.branch)}"
        limits = " within the limits of the joints" if self.within_limits else ""
        return f"joint values for {self.target.words(exercise)}: {which}{limits}"

    def blank(self, exercise: Exercise) -> tuple[int, int]:
        return 1, len(self.joints_of(exercise))

    def is_whole(self, text: str, _blank: tuple[int, int]) -> bool:
        """Of several solutions nobody knows which is the last, unless they stand in brackets or in one line."""
        is_set = self.which == "all" and text.strip()[:1] not in ("[", "{")
        return is_closed(text) and (not is_set or ends_in_bracket(text) or bool(_SEVERAL.search(text)))

    def notes(self, exercise: Exercise) -> Iterable[str]:
        joints = self.joints_of(exercise)
        yield f"In this order: {', '.join(joints)}."
        yield "Angles in degrees unless a unit stands with them."
        if self.which == "all":
            yield "A row for each solution; whole turns more or less are the same."

    def expected(self, case: Case, _style: str = "short") -> str:
        wanted = self.wanted(case)
        if not wanted:
            raise self._none_found(solutions(case, self.target))
        field = self.range_of(case)
        rows = [self.spelled(field, field.solutions[k]) for k in (wanted if self.which == "all" else wanted[:1])]
        return f"[{'; '.join(rows)}]" if self.which == "all" else rows[0]

    def steps(self, case: Case) -> Iterable[Shown]:
        from dhcli.checking.solving.derived import derivation_of, steps_shown

        derivation = derivation_of(case, self.target)
        if derivation is not None:
            yield from steps_shown(derivation)
        found = solutions(case, self.target)
        field = self.range_of(case)
        named = (found.named(k, limits=self.within_limits) for k in range(len(found)))
        lines = [
            f"{self.spelled(field, q)}{f' ({name})' if name else ''}"
            for q, name in zip(field.solutions, named, strict=True)
        ]
        free = " and ".join(spare_joints(case, self.target))
        more = f", for {free} as here: other values have others" if free else ""
        yield Shown("\n".join((f"In numbers that is {plural(len(lines), 'solution')}{more}:", *lines)))

    def read(self, case: Case, text: str, place: Place | None = None) -> Vectors:
        exercise = case.exercise
        robot = needed(exercise.robot)
        joints, several = self.joints_of(exercise), self.which == "all"
        found = read_vectors(exercise, robot, joints, text, place or Place("answer"), several=several)
        if len(found) > 1 and self.which != "all":
            raise UnreadableError(f"{len(found)} rows, and one solution is asked for")
        return tuple(found)

    def mark(self, case: Case, reading: Reading[Vectors]) -> Mark:
        from dhcli.checking.solving.marking import mark_one, mark_set

        marked = mark_set if self.which == "all" else mark_one
        field, found, wanted = self.range_of(case), solutions(case, self.target), self.wanted(case)
        if not wanted:
            raise self._none_found(found)
        mark = marked(self, case, field, found, wanted, reading.value)

        def is_right(unit: str) -> bool:
            meant = tuple(in_unit(field, one, unit) for one in reading.value)
            plain = meant != reading.value and shows_unit(field, meant, unit, case.tolerance)
            return plain and marked(self, case, field, found, wanted, meant).verdict is Verdict.RIGHT

        if mark.verdict.passed is False:
            refuse_right_in(other_units(field), case.exercise.unit, is_right)
            if self.which == "all" and len(reading.value) == len(field.joints) > 1:
                return self._with_rows_told(
                    mark, reading.text, lambda text: marked(self, case, field, found, wanted, self.read(case, text))
                )
        return mark

    @staticmethod
    def _with_rows_told(mark: Mark, text: str, marked: Callable[[str], Mark]) -> Mark:
        """A wrong square of values, of which nobody can see whether its rows or its columns are the solutions.

        Raises:
            UnreadableError: It is right the other way round.
        """
        plain = untransposed(text.strip())
        is_turned = plain != text.strip()
        try:
            is_right = marked(plain if is_turned else f"{bracketed(plain)}^T").verdict is Verdict.RIGHT
        except (UnreadableError, NotationError):
            is_right = False
        if is_right and is_turned:
            raise UnreadableError(
                "right without the sign of a transposition, which makes columns of the rows: leave it out"
            )
        if is_right:
            raise UnreadableError("right if the columns are the solutions: write each solution in a row")
        said = "by the sign of a transposition the columns that you typed are the solutions"
        return replace(mark, remarks=(*mark.remarks, said)) if is_turned else mark

    def findings(self, case: Case, where: tuple[str | int, ...]) -> Iterable[Finding]:
        found = solutions(case, self.target)
        if len(found) and self.which == "branch" and not self.wanted(case):
            listed = "; ".join(dict.fromkeys(branch for branch in found.branches if branch))
            message = f"{case.part.id}: no solution is {' and '.join(self.branch)}"
            yield Finding((*where, "ask"), message, f"branches here: {listed or 'none has a name'}")
        if self.which != "any":
            yield from without_number(case, self.target, where)
        if self.which == "all" and any(found.free):
            message = f"{case.part.id}: this pose is singular, and a solution stands for a whole family"
            yield Finding((*where, "ask"), message, "ask for one solution, or give another pose", is_warning=True)

    def slips(self, case: Case) -> Iterator[Slip]:
        from dhcli.checking.solving.slips import showing

        return (one.slip for one in showing(self, case))

    def answer_with(self, case: Case, name: str) -> str | None:
        from dhcli.checking.solving.slips import showing

        return next((one.text for one in showing(self, case) if one.slip.name == name), None)

    def causes(self, case: Case, reading: Reading[Vectors]) -> Causes:
        from dhcli.checking.solving.slips import causes_of

        return tuple((slip,) for slip in causes_of(self, case, reading.value))

    def _none_found(self, found: Solutions) -> RobotError:
        """Why no solution is as asked for."""
        if not len(found):
            return RobotError(found.why, "give a pose that the arm reaches")
        there = list(dict.fromkeys(word for branch in found.branches for word in branch.split(", ") if word))
        for word in self.branch:
            if word not in there:
                return RobotError(
                    f"no solution is {word}", did_you_mean(word, there) or f"there are: {', '.join(there)}"
                )
        asked = " and ".join(self.branch) or "within the limits of the joints"
        return RobotError(f"no solution is {asked}", "give another pose, or ask for another solution")
