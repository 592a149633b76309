"""Judgements for people and for programs: a line for each part, and under it what there is to know."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from typing import Any

from dhcli.checking.credit import plain
from dhcli.checking.diagnosis.result import Diagnosis
from dhcli.checking.earning import worth
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import MISPRINT, is_explained
from dhcli.checking.marked import PartMark, SheetMark
from dhcli.checking.verdicts import HALF_TURN_OFF, CellMark, Mark, Verdict
from dhcli.errors import plural
from dhcli.render.code.matrices import csv_line
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.prose import prose_lines
from dhcli.safe import csv_cell

_INKS = {
    Verdict.RIGHT: ("green",),
    Verdict.EQUIVALENT: ("green",),
    Verdict.ROUNDED: ("yellow",),
    Verdict.CLOSE: ("yellow",),
    Verdict.WRONG: ("red",),
    Verdict.CANNOT_READ: ("red",),
    Verdict.SKIPPED: ("dim",),
}
MOST_HINTS = 2
NO_SLIP = "why: no slip that dhcli knows gives this answer"
NOT_SOUGHT = "why: no slip is looked for behind such an answer; hint helps on"
_INDENT = " " * 4
_UNDER_ASKED = " " * 14
"""What stands below an answer, and below what is asked behind its verdict."""
_LONGEST = 60
"""Longest entry that a table of entries shows; longer ones get a line each."""


def marks_table(marked: SheetMark, look: Look) -> str:
    """Every part with its verdict, and the sum."""
    lines = [line for part in marked.parts for line in _part_lines(marked, part, look)]
    if len(marked.parts) > 1:
        lines += ["", sum_line(marked)]
    for part in marked.withdrawn:
        lines += prose_lines(f"{part.id} was withdrawn and does not count: {part.withdrawn}", look.paper)
    return "\n".join(lines) + "\n"


def sum_line(marked: SheetMark) -> str:
    """How many parts are solved, and the credit they earned."""
    solved = sum(part.mark.verdict.passed is True for part in marked.parts)
    return f"{solved} of {plural(len(marked.parts), 'part')} solved, {_earned(marked.earned, marked.credit)}"


def _earned(earned: float, credit: float) -> str:
    return f"{plain(earned)} of {plain(credit)} credit{'s' * (credit != 1)}"


def marks_csv(marked: SheetMark, _look: Look) -> str:
    """One line for each part."""
    lines = [csv_line(["part", "verdict", "earned", "credit"])]
    for one in marked.parts:
        earned, credit = one.mark.earned * one.part.credit, one.part.credit
        lines.append(csv_line([csv_cell(one.part.id), one.mark.verdict.word, plain(earned), plain(credit)]))
    return "".join(lines)


def marks_content(marked: SheetMark, _look: Look) -> dict[str, Any]:
    """The judgement as JSON holds it; the right answer only where the exercise allows."""
    allowed = marked.exercise.shows_expected
    return {
        "exercise": marked.exercise.id,
        "variant": marked.exercise.variant or None,
        "verdict": marked.verdict.word,
        "passed": marked.verdict.passed,
        "earned": marked.earned,
        "credit": marked.credit,
        "parts": [
            {
                "part": one.part.id,
                "verdict": one.mark.verdict.word,
                "passed": one.mark.verdict.passed,
                "earned": one.mark.earned * one.part.credit,
                "credit": one.part.credit,
                "cause": {
                    "rationale": [*one.mark.remarks, *_notes(one.mark)],
                    "help": one.part.hints[0] if one.part.hints else None,
                    "expected": one.mark.expected if allowed else None,
                    "actual": one.mark.reading or None,
                    "diagnosis": _diagnosis(one.mark.diagnosis),
                },
            }
            for one in marked.parts
        ],
        "withdrawn": [{"part": part.id, "reason": part.withdrawn} for part in marked.withdrawn],
    }


def question_text(
    exercise: Exercise, part: Part, paper: Paper, *, whole: bool = False, known: Container[str] = ()
) -> str:
    """What a part asks, for a person who is about to answer; the whole of it for one who sees the solution.

    Args:
        exercise: The exercise.
        part: The part.
        paper: Where it is written.
        whole: Whether all is told.
        known: Notes that this person has seen, and that are left out.
    """
    whole = whole or not part.prompt.strip()
    asked = part.question.describe(exercise) if whole else part.prompt.strip()
    text = " · ".join(filter(None, (f"{part.id}: {asked}", worth(exercise, part))))
    notes = [note for note in part.question.notes(exercise) if note not in known]
    lines = [paper.ink(line, "bold") for line in prose_lines(text, paper)]
    lines += prose_lines(part.prompt.strip() if whole else part.form(exercise), paper)
    lines += [line for note in notes for line in prose_lines(note, paper)]
    for n, option in enumerate(part.question.statements, 1):
        lines += prose_lines(option, paper, f"  {n}: ", "     ")
    return "\n".join(lines) + "\n"


def why_lines(one: PartMark | None, paper: Paper) -> list[str]:
    """The slip behind a wrong answer by its name, for a person who asks; or why there is nothing to name."""
    if one is None or one.mark.verdict is Verdict.SKIPPED:
        said = ["answer first: why names the slip behind a wrong answer"]
    elif one.mark.verdict.passed:
        said = ["your answer is right"]
    elif one.mark.diagnosis and one.mark.diagnosis.follows:
        said = list(one.mark.remarks[:1])
    else:
        none = NO_SLIP if one.part.question.is_explained else NOT_SOUGHT
        said = list(_why(one, named=True)) or list(one.mark.remarks[:1]) or [none]
    return [line for text in said for line in prose_lines(paper.spell(text), paper)]


def _diagnosis(found: Diagnosis | None) -> dict[str, Any] | None:
    """Every cause with its slips, and the earlier parts from which the answer is right."""
    if found is None:
        return None
    return {
        "causes": [[{"name": slip.name, "words": slip.words, "hint": slip.hint} for slip in c] for c in found.causes],
        "follows": list(found.follows),
    }


def _part_lines(marked: SheetMark, one: PartMark, look: Look) -> Iterator[str]:
    paper, mark, exercise = look.paper, one.mark, marked.exercise
    verdict = mark.verdict
    word = paper.ink(f"{f'{paper.spell(verdict.sign)} {verdict.word}':<12}", "bold", *_INKS[verdict])
    asked = one.part.id if marked.walked else f"{one.part.id}: {one.part.heading(exercise)}"
    asked += _partial_credit(one) if len(exercise.asked) > 1 or "/" in exercise.id else ""
    first, *rest = prose_lines(paper.spell(asked), paper, _UNDER_ASKED, _UNDER_ASKED)
    yield f"{word}  {first.removeprefix(_UNDER_ASKED)}"
    yield from rest
    if verdict is Verdict.SKIPPED:
        return
    if mark.reading and verdict not in (Verdict.RIGHT, Verdict.CANNOT_READ):
        yield from _reading(mark, paper)
    for remark in mark.remarks:
        yield from _lines_below(remark, paper)
    yield from _cells(mark, paper)
    if exercise.shows_expected and verdict.passed is not True and mark.expected:
        yield from _lines_below(f"right: {mark.expected}", paper)
    for line in _why(one, named=marked.why, asked="why" if marked.walked else "--why"):
        yield from _lines_below(line, paper)
    if verdict in (Verdict.WRONG, Verdict.CLOSE) and one.part.hints and "/" in exercise.id and not marked.walked:
        yield paper.ink(f"    a hint: dhcli hint {exercise.typed} --part {one.part.id}", "dim")


def _partial_credit(one: PartMark) -> str:
    """The credit of a part that is not solved and earned some all the same; so the sum below can be followed."""
    share, credit = one.mark.earned, one.part.credit
    is_told = share or one.mark.verdict is Verdict.ROUNDED  # which earns all, as a rule
    if one.mark.verdict.passed is True or not is_told or not credit:
        return ""
    if share == 1:
        kept = "credit kept" if one.mark.diagnosis and one.mark.diagnosis.follows else "full credit"
        return f" ({kept}: {plain(credit)})"
    return f" ({_earned(share * credit, credit)})"


def _lines_below(text: str, paper: Paper) -> list[str]:
    """What is said about an answer, below its verdict; line ends that were typed are blanks here."""
    return prose_lines(paper.spell(text), paper, _INDENT, _INDENT)


def _why(one: PartMark, *, named: bool, asked: str = "--why") -> Iterator[str]:
    """Where to look; by name where a person has asked, who is told so where there is none."""
    found = one.mark.diagnosis or Diagnosis()
    if found.causes == ((MISPRINT,),):  # a remark has told which entry
        return
    if not found.causes:
        is_told = any(remark.endswith(HALF_TURN_OFF) for remark in one.mark.remarks)
        if named and is_explained(one.part, one.mark) and not found.follows and not is_told:
            yield NO_SLIP
        return
    if not named:
        more = f"; and {len(found.hints) - MOST_HINTS} more" if len(found.hints) > MOST_HINTS else ""
        yield "; ".join(found.hints[:MOST_HINTS]) + f"{more} ({asked} names the slip)"
        return
    if len(found.names) > 1:
        yield "each of these alone gives just your answer:"
    yield from (f"why: {name}" if len(found.names) == 1 else f"  - {name}" for name in found.names)


def _reading(mark: Mark, paper: Paper) -> Iterator[str]:
    """The echo of what was read, where the entries are not shown anyway."""
    if not (len(mark.cells) > 1 and _fits(mark.cells)):
        yield from _lines_below(f"I read this as: {mark.reading}", paper)


def _fits(cells: Sequence[CellMark]) -> bool:
    return all(len(cell.typed) <= _LONGEST // 3 for cell in cells)


def _cells(mark: Mark, paper: Paper) -> Iterator[str]:
    """Entries that are not right: in the matrix with a sign behind each, and a note for the first of them."""
    bad = [cell for cell in mark.cells if cell.verdict is not Verdict.RIGHT]
    if not bad:
        return
    if len(mark.cells) > 1 and _fits(mark.cells):
        yield from (f"{_INDENT}{line}" for line in _signed(mark.cells, paper))
    elif len(mark.cells) > 1:
        places = ", ".join(f"({cell.row + 1},{cell.column + 1})" for cell in bad)
        yield from _lines_below(f"not right: {places}", paper)
    for note in _notes(mark):
        yield from _lines_below(note, paper)


def _notes(mark: Mark) -> Iterator[str]:
    """The note for the first entry that is not right and has one: where it holds, and numbers to think about."""
    for cell in [cell for cell in mark.cells if cell.note and cell.verdict is not Verdict.RIGHT][:1]:
        yield (f"entry ({cell.row + 1},{cell.column + 1}): " if len(mark.cells) > 1 else "") + cell.note


def _signed(cells: Sequence[CellMark], paper: Paper) -> Iterator[str]:
    """The entries as typed, each with its sign behind it."""
    columns = max(cell.column for cell in cells) + 1
    texts = [f"{paper.spell(cell.typed)} {paper.spell(cell.verdict.sign)}" for cell in cells]
    rows = [texts[i : i + columns] for i in range(0, len(texts), columns)]
    widths = [max(len(row[k]) for row in rows) for k in range(columns)]
    for row in rows:
        yield "   ".join(text.rjust(width) for text, width in zip(row, widths, strict=True))
