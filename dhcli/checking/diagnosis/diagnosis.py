"""The cause of a wrong answer: a misprint copied, one mistake, two, or none that is known; never a guess."""

from __future__ import annotations

from dataclasses import replace

from dhcli.checking.counts import COUNTED
from dhcli.checking.diagnosis.asked_again import asked_again
from dhcli.checking.diagnosis.geometry import geometry
from dhcli.checking.diagnosis.result import Diagnosis, Slip
from dhcli.checking.diagnosis.slips import count_slips
from dhcli.checking.diagnosis.table_causes import table_causes
from dhcli.checking.diagnosis.typed import Typed, typed_answer
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.numeric import INVERSE, TOO_FEW, TRANSPOSED
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.questions import (
    CellQuestion,
    ChoiceQuestion,
    CountQuestion,
    FactorsQuestion,
    MatrixQuestion,
    ScalarQuestion,
    TableQuestion,
)
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError
from dhcli.notation.quantity import LENGTH_UNITS

MISPRINT = Slip(
    "misprint", "this is what the document prints; it is a misprint", "the document may be wrong: work it out yourself"
)
OTHER_UNIT = {"mm": "m", "m": "mm"}
HALVES = ("the rotation is right;", "the position is right;")
"""How remarks begin that geometry says more precisely."""


def diagnosed(exercise: Exercise, part: Part, answer: str, mark: Mark) -> Mark:
    """A mark with its diagnosis, where the answer is wrong or only close."""
    if not is_diagnosed(part, mark):
        return mark
    found = diagnose(exercise, part, answer, mark)
    if not found.causes:
        return _told(exercise, part, answer, mark)
    return replace(mark, diagnosis=found, remarks=tuple(r for r in mark.remarks if not _names(r)))


def _names(remark: str) -> bool:
    """Whether a remark says what the slip is, which the diagnosis does when it is asked."""
    return remark in {INVERSE, TRANSPOSED} or COUNTED in remark


def is_diagnosed(part: Part, mark: Mark) -> bool:
    """Whether a slip is looked for behind an answer: not behind a choice, nor behind what is only typed too short."""
    if isinstance(part.question, ChoiceQuestion) or TOO_FEW in mark.remarks:
        return False
    return mark.verdict in (Verdict.WRONG, Verdict.CLOSE)


def _told(exercise: Exercise, part: Part, answer: str, mark: Mark) -> Mark:
    """The mark with what geometry says of an answer without a known cause, in the place of which half is right."""
    question = part.question
    if not isinstance(question, MatrixQuestion):
        return mark
    try:
        typed = typed_answer(exercise, part, question, answer)
    except (UnreadableError, DhcliError):
        return mark
    words = geometry(exercise, question, typed) if typed is not None else ""
    others = tuple(remark for remark in mark.remarks if not remark.startswith(HALVES))
    return replace(mark, remarks=(words, *others)) if words else mark


def diagnose(exercise: Exercise, part: Part, answer: str, mark: Mark) -> Diagnosis:
    """Every cause that gives just the answer typed, the plainest kind; no cause where none is known."""
    if _is_misprint(mark):
        return Diagnosis(((MISPRINT,),))
    try:
        match part.question:
            case MatrixQuestion():
                return Diagnosis(_of_matrix(exercise, part, part.question, answer))
            case TableQuestion():
                return Diagnosis(table_causes(exercise, part, part.question, answer))
            case CountQuestion():
                found = count_slips(part.question)
                return Diagnosis(tuple((slip,) for slip, value in found if str(value) == mark.reading))
            case ScalarQuestion() | CellQuestion() | FactorsQuestion():
                return Diagnosis(tuple((one.slip,) for one in asked_again(exercise, part, answer)))
    except (UnreadableError, DhcliError):
        pass  # what cannot be read has been told already
    return Diagnosis()


def _is_misprint(mark: Mark) -> bool:
    """Whether all that is wrong in an answer is copied from the document."""
    copied = [remark for remark in mark.remarks if "it is a misprint" in remark]
    wrong = sum(cell.verdict in (Verdict.WRONG, Verdict.CLOSE) for cell in mark.cells)
    return bool(copied) and (copied[0].startswith("this is") or len(copied) >= wrong)


def _of_matrix(exercise: Exercise, part: Part, question: MatrixQuestion, answer: str) -> tuple[tuple[Slip, ...], ...]:
    typed = typed_answer(exercise, part, question, answer)
    if typed is None:
        return ()
    for slack in typed.slacks:
        causes = typed.search.causes(typed.values, slack, typed.slacks[0])
        if causes:
            return tuple(cause.slips for cause in causes)
    return _in_other_unit(exercise, typed)


def _in_other_unit(exercise: Exercise, typed: Typed) -> tuple[tuple[Slip, ...], ...]:
    """The one slip besides the unit of the lengths, metres for millimetres or the other way round."""
    if typed.is_general or exercise.unit not in OTHER_UNIT:
        return ()
    unit = OTHER_UNIT[exercise.unit]
    other = typed.scaled(float(LENGTH_UNITS[unit] / LENGTH_UNITS[exercise.unit]))
    if other.values == typed.values:
        return ()
    causes = other.search.causes(other.values, other.slacks[0], stages=("singles",))
    slip = Slip(f"in-{unit}", f"the lengths are in {unit}, not {exercise.unit}", "look at the unit of the sheet")
    return ((*causes[0].slips, slip),) if len(causes) == 1 else ()
