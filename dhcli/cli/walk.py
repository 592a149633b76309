"""An exercise asked part by part on the terminal."""

from __future__ import annotations

import sys

from dhcli.checking.describe import given_text
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.sheetmark import PartMark, SheetMark, mark_sheet
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.cli.console import write_out
from dhcli.cli.quiz import remember
from dhcli.render.look import Look, render
from dhcli.render.marks import question_text
from dhcli.render.paper import Paper

HELP = "An empty line ends an answer; ? is a hint, an empty answer skips the part, Ctrl-D ends."


def walk(exercise: Exercise, only: str | None = None) -> SheetMark:
    """Ask each part, judge it, and go on; what was answered counts as progress.

    Args:
        exercise: The exercise.
        only: The one part to ask; all by default.
    """
    paper = Paper.of(sys.stdout)
    write_out(f"{paper.ink(paper.spell(exercise.title), 'bold')}\n")
    for line in exercise.task.strip().splitlines():
        write_out(f"{paper.spell(line)}\n")
    if exercise.given:
        write_out(f"\n{paper.spell(f'given: {given_text(exercise)}')}\n")
    write_out(f"\n{paper.ink(HELP, 'dim')}\n")
    marks: list[PartMark] = []
    for part in [exercise.part(only)] if only else exercise.parts:
        answer = _ask(exercise, part, paper)
        if answer is None:
            break
        marked = mark_sheet(exercise, {part.id: answer}, only=part.id)
        remember(marked)
        marks += marked.parts
        write_out(render("marks", marked, Look(paper=paper)))
    asked = {one.part.id for one in marks}
    left = (PartMark(part, Mark(Verdict.SKIPPED)) for part in exercise.parts if part.id not in asked and not only)
    return SheetMark(exercise, (*marks, *left))


def _ask(exercise: Exercise, part: Part, paper: Paper) -> str | None:
    """The answer to a part, or None at the end of the input."""
    write_out(f"\n{question_text(exercise, part, paper)}")
    lines: list[str] = []
    shown = 0
    while True:
        write_out(f"{part.id}> " if not lines else "... ")
        sys.stdout.flush()
        line = sys.stdin.readline()
        if not line:
            write_out("\n")
            return "\n".join(lines) if lines else None
        if line.strip() == "?":
            hint = part.hints[min(shown, len(part.hints) - 1)] if part.hints else "there is no hint for this part"
            shown += 1
            write_out(f"hint: {paper.spell(hint)}\n")
        elif line.strip():
            lines.append(line.rstrip("\n"))
            if _is_whole(lines):
                return "\n".join(lines)
        else:
            return "\n".join(lines)


def _is_whole(lines: list[str]) -> bool:
    """Whether an answer is plainly complete: one line whose brackets close, with no row still to come."""
    text = "\n".join(lines)
    opened = sum(text.count(bracket) for bracket in "[({")
    closed = sum(text.count(bracket) for bracket in "])}")
    return opened == closed and (
        text.lstrip().startswith(("[", "array", "np.")) or (len(lines) == 1 and opened == 0 and " " not in text.strip())
    )
