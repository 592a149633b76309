"""The judge of an exercise: every answer is read once, marked, and explained where it is wrong."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from dhcli.checking.diagnosis.result import Diagnosis, Slip
from dhcli.checking.earning import earned
from dhcli.checking.exercise import MISPRINTED, Case, Exercise, Memo, Part
from dhcli.checking.letters import numbers_for_letters
from dhcli.checking.lists import unit_for_all
from dhcli.checking.marked import PartMark, SheetMark
from dhcli.checking.other_unit import WrongUnitError
from dhcli.checking.pasted import UnreadableError, refuse_blanks
from dhcli.checking.returned import Causes, Judged, Reading, Shown
from dhcli.checking.verdicts import COUNTED, INVERSE, TRANSPOSED, UNSOLVED, Mark, Verdict
from dhcli.errors import DhcliError, NotationError, Place, UnknownNameError, did_you_mean
from dhcli.kinematics.robot import Value
from dhcli.kinematics.validity import Finding
from dhcli.notation.screens import unstyled
from dhcli.regex import regex

BLANK = regex(r"[\s\[\](){},;.…_?–-]*")  # noqa: RUF001
MISPRINT = Slip("misprint", MISPRINTED, "the document may be wrong: work it out yourself")


class Judge:
    """Judges answers to the parts of an exercise, and keeps what is worked out for it.

    Attributes:
        exercise: The exercise.
        memo: What was worked out so far.
    """

    def __init__(self, exercise: Exercise, like: Judge | None = None) -> None:
        """Take an exercise.

        Args:
            exercise: The exercise.
            like: The judge of the same exercise with other numbers, if there is one: most of its work is shared.
        """
        self.exercise = exercise
        moved = like is not None and _only_moved(exercise, like.exercise)
        self.memo: Memo = Memo(exercise, like.memo if like and moved else None, like.memo.lasting if like else None)

    def with_given(self, given: Mapping[str, Value], **changes: Any) -> Judge:  # noqa: ANN401  fields of an exercise
        """The judge of the same exercise with other values given."""
        return Judge(replace(self.exercise, given=given, **changes), self)

    def check(self, part: Part, answer: str, place: Place | None = None) -> Mark:
        """Judge an answer to one part, and say why where it is wrong.

        Args:
            part: The part that is answered.
            answer: What the student typed; blank is skipped.
            place: Where it stands, for errors.
        """
        return self.explained(part, self.judged(part, answer, place))

    def mark(self, part: Part, answer: str, place: Place | None = None) -> Mark:
        """Judge an answer to one part, without looking for the slip behind a wrong one.

        Returns:
            The judgement. An answer that cannot be read gets one too: CAN'T READ, with what would be read.
        """
        return self.judged(part, answer, place).mark

    def sheet(
        self,
        answers: Mapping[str, str],
        places: Mapping[str, Place] | None = None,
        only: str | None = None,
        unread: Mapping[str, str] | None = None,
    ) -> SheetMark:
        """Judge the answers of a sheet; a part without an answer is skipped.

        Args:
            answers: Text by part.
            places: Where each answer stands, for errors.
            only: The one part to look at; all by default.
            unread: What is wrong with answers that the file does not hold as texts.

        Raises:
            UnknownNameError: An answer, or the part asked for, belongs to no part of the exercise.
            DhcliError: The part asked for was withdrawn.
        """
        for name in (*answers, *((only,) if only else ())):
            self.exercise.part(name)
        judged: dict[str, Judged[Any]] = {}
        for part in self.exercise.parts:
            answer, problem = answers.get(part.id, ""), (unread or {}).get(part.id, "")
            one = _unread(answer, problem) if problem else self.judged(part, answer, (places or {}).get(part.id))
            one = replace(one, mark=self.explained(part, one))
            judged[part.id] = replace(one, mark=self._followed(part, one, judged))
        parts = [part for part in self.exercise.asked if only in (None, part.id)]
        if not parts:
            raise DhcliError(f"{only} was withdrawn: {self.exercise.part(only or '').withdrawn}")
        blank = Verdict.SKIPPED
        gone = (part for part in self.exercise.parts if part.withdrawn and judged[part.id].mark.verdict is not blank)
        marks = tuple(PartMark(part, judged[part.id].mark) for part in parts)
        return SheetMark(self.exercise, marks, withdrawn=() if only else tuple(gone))

    def expected(self, part: Part, style: str = "short") -> str:
        """The right answer to a part as a person would type it."""
        return part.question.expected(self._case(part), style)

    def shortest(self, part: Part) -> str:
        """The right answer to a part in few words and digits, as it is shown."""
        return part.question.shortest(self._case(part))

    def solution(self, part: Part) -> tuple[Shown, ...]:
        """The steps that lead to the right answer; the last one holds it as it may be typed."""
        steps = tuple(part.question.steps(self._case(part)))
        if part.question.statements:
            return steps
        answer = self.shortest(part)
        return (*steps, Shown(f"So the answer is {answer}" if steps else f"The answer is {answer}"))

    def findings(self, part: Part, where: tuple[str | int, ...]) -> tuple[Finding, ...]:
        """What an author should mend about a question of this kind."""
        return tuple(part.question.findings(self._case(part), where))

    def slips(self, part: Part) -> tuple[Slip, ...]:
        """Every single mistake that changes the right answer to a part."""
        return tuple(part.question.slips(self._case(part)))

    def hidden(self, part: Part) -> tuple[Slip, ...]:
        """Mistakes whose answer is right at the values given although it is wrong at others."""
        return tuple(part.question.hidden(self._case(part)))

    def unclear(self) -> frozenset[tuple[str, str]]:
        """Mistakes that the values given do not show plainly, each as the name of a part and that of a slip."""
        parts = self.exercise.parts
        return frozenset((part.id, name) for part in parts for name in part.question.unclear(self._case(part)))

    def answer_with(self, part: Part, name: str) -> str:
        """The answer that a student with one mistake would type.

        Args:
            part: The part.
            name: Name of a slip, such as `alpha-sign 2`.

        Raises:
            UnknownNameError: No such mistake can be made here; the hint names those that can.
        """
        answer = part.question.answer_with(self._case(part), name)
        if answer is not None:
            return answer
        known = [slip.name for slip in self.slips(part)]
        hint = did_you_mean(name, known) or f"mistakes here: {', '.join(known)}"
        raise UnknownNameError(f"{part.id}: the mistake '{name}' cannot be made here", hint)

    def _case(self, part: Part) -> Case:
        """What a question is handed; nothing is asked of one whose answer needs a value that nobody gave.

        Raises:
            RobotError: A name has no value.
        """
        self.memo.of(("valued", part.id), lambda: self.exercise.need_values(part))
        return Case(part, self.memo)

    def judged(self, part: Part, answer: str, place: Place | None = None) -> Judged[Any]:
        """Read an answer and mark it, beside what the document prints if it does."""
        if BLANK.fullmatch(answer):
            return Judged(Mark(Verdict.SKIPPED))
        one = self._read_and_marked(part, answer, place)
        text = part.printed.text if part.printed else ""
        if not text or one.mark.verdict.passed is True:
            return one
        printed = self.memo.of(("printed", part.id, text), lambda: self._read_and_marked(part, text, None))
        remarks = part.question.misprinted(self._case(part), one, printed)
        return replace(one, mark=replace(one.mark, remarks=(*remarks, *one.mark.remarks))) if remarks else one

    def _read_and_marked(self, part: Part, answer: str, place: Place | None) -> Judged[Any]:
        case, reading = self._case(part), None
        try:
            refuse_blanks(answer)
            text = unstyled(answer)
            reading = Reading(text, part.question.read(case, text, place))
            mark = part.question.mark(case, reading)
            if mark.verdict in UNSOLVED:
                _refuse_lone_unit(case, text)
            return Judged(_credited(case, mark), reading)
        except WrongUnitError as error:
            is_there = unit_for_all(answer.strip())[1] == error.unit
            said = (_lone(error.unit),) if is_there else error.remarks
            mark = Mark(Verdict.CANNOT_READ, answer.strip(), remarks=said, other_unit=error.unit)
            return Judged(_credited(case, mark), reading)
        except UnreadableError as error:
            remarks = error.remarks
        except NotationError as error:
            remarks = tuple(str(problem) for problem in error.problems)
        return replace(_unread(answer, *remarks), reading=reading)

    def explained(self, part: Part, judged: Judged[Any]) -> Mark:
        """The mark with the slip behind a wrong answer, or with what can be said of one that has no name."""
        mark, reading = judged.mark, judged.reading
        if reading is None or not is_explained(part, mark):
            return mark
        case = self._case(part)
        causes: Causes = ((MISPRINT,),)
        if not _is_misprint(mark):
            try:
                causes = part.question.causes(case, reading)
            except (UnreadableError, DhcliError):  # what cannot be read has been told already
                causes = ()
        causes = causes or numbers_for_letters(case, reading.text)
        if not causes:
            return part.question.told(case, mark, reading)
        remarks = tuple(remark for remark in mark.remarks if not _names_slip(remark))
        return replace(mark, diagnosis=Diagnosis(causes), remarks=remarks)

    def _followed(self, part: Part, judged: Judged[Any], earlier: Mapping[str, Judged[Any]]) -> Mark:
        """A wrong answer that is right from earlier ones: its credit is earned, the slip is where it was made."""
        mark = judged.mark
        if mark.verdict not in UNSOLVED or judged.reading is None:
            return mark
        own = {
            name: one.reading
            for name, one in earlier.items()
            if one.reading is not None and self._may_lead(self.exercise.part(name), one)
        }
        used = part.question.follows(self._case(part), judged.reading, own)
        if not used:
            return mark
        whose = f"right from your {' and '.join(used)}"
        is_right = all(earlier[name].mark.verdict not in UNSOLVED for name in used)
        remark = f"{whose}, which has other frames" if is_right else f"{whose}: the slip is there"
        return replace(
            mark, earned=1.0, remarks=(f"{remark}; this part keeps its credit",), diagnosis=Diagnosis(follows=used)
        )

    def _may_lead(self, part: Part, judged: Judged[Any]) -> bool:
        """Whether an answer differs from the solution, and is one that a person may go on from."""
        if part.question.differs(judged.mark):
            return True
        return judged.mark.verdict in UNSOLVED and part.question.is_plausible(self._case(part), judged)


def check(exercise: Exercise, part: str, answer: str) -> Mark:
    """Judge an answer to one part of an exercise, named by its id, and say why where it is wrong.

    Args:
        exercise: The exercise, from `load_exercise`.
        part: Name of the part.
        answer: What the student typed.

    Raises:
        UnknownNameError: There is no such part; the hint lists those there are.
        DhcliError: What was given is no exercise, or no text.
    """
    if not isinstance(exercise, Exercise):
        raise DhcliError(f"an Exercise is wanted, not {exercise!r:.60}", "load_exercise loads one")
    if not all(isinstance(text, str) for text in (part, answer)):
        raise DhcliError("the name of a part and the answer to it are texts", 'check(exercise, "a1", "[c1 -s1 ...]")')
    return Judge(exercise).check(exercise.part(part), answer)


def _unread(answer: str, *remarks: str) -> Judged[Any]:
    """What is said of an answer that cannot be read."""
    return Judged(Mark(Verdict.CANNOT_READ, answer.strip(), remarks=remarks))


def _credited(case: Case, mark: Mark) -> Mark:
    """A mark with what it earns by the rules of the exercise; one that is too short earns by what is right in it."""
    share = earned(case.shares, case.part.question, mark, numeric=case.exercise.numeric)
    return replace(mark, earned=share).with_digits_told()


def _refuse_lone_unit(case: Case, text: str) -> None:
    """Ask about a wrong list whose last number alone has a unit, where it is right if that is the unit of all.

    Raises:
        UnreadableError: It is such a one.
    """
    meant, unit = unit_for_all(text)
    if not meant:
        return
    try:
        mark = case.part.question.mark(case, Reading(meant, case.part.question.read(case, meant, None)))
    except (UnreadableError, NotationError):
        return
    if mark.verdict not in UNSOLVED:
        raise UnreadableError(_lone(unit))


def _lone(unit: str) -> str:
    return (
        f"{unit} stands behind the last number alone: if it is that of all, write it behind each, or behind a bracket"
    )


def is_explained(part: Part, mark: Mark) -> bool:
    """Whether a slip is looked for behind an answer: not behind a choice, nor behind what is only typed too short."""
    return part.question.is_explained and not mark.has_few_digits and mark.verdict in UNSOLVED


def _only_moved(exercise: Exercise, other: Exercise) -> bool:
    """Whether two exercises differ in the values of joints alone, among what matters for a search."""
    variables = exercise.robot.variables if exercise.robot else ()
    names = exercise.given.keys() | other.given.keys()
    same = exercise.robot is other.robot and exercise.tolerance == other.tolerance and exercise.unit == other.unit
    return same and all(name in variables or exercise.given.get(name) == other.given.get(name) for name in names)


def _names_slip(remark: str) -> bool:
    """Whether a remark says what the slip is, which the diagnosis does when it is asked."""
    return remark in {INVERSE, TRANSPOSED} or COUNTED in remark


def _is_misprint(mark: Mark) -> bool:
    """Whether all that is wrong in an answer is copied from the document."""
    copied = [remark for remark in mark.remarks if "it is a misprint" in remark]
    wrong = sum(cell.verdict in UNSOLVED for cell in mark.cells)
    return bool(copied) and (copied[0].startswith("this is") or len(copied) >= wrong)
