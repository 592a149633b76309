"""An exercise asked part by part on the terminal."""

from __future__ import annotations

import sys

from dhcli.checking.exercise import Part
from dhcli.checking.judge import Judge, PartMark, SheetMark
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.cli.shell.console import write_out
from dhcli.cli.shell.quiz import remember
from dhcli.render.look import Look, render
from dhcli.render.paper import Paper
from dhcli.render.text.marks import question_text, sum_line
from dhcli.render.text.prose import prose_lines

HELP = "An empty line ends a matrix or a table; ? is a hint, an empty answer skips the part, Ctrl-D ends."
AGAIN = "Try again, or go on with an empty line."
_TRY_AGAIN = (Verdict.WRONG, Verdict.CLOSE, Verdict.CANNOT_READ)


def walk(judge: Judge, only: str | None = None) -> SheetMark:
    """Ask each part, judge it, and go on; what was answered counts as progress.

    Args:
        judge: The judge of the exercise.
        only: The one part to ask; all by default.
    """
    exercise, paper = judge.exercise, Paper.of(sys.stdout)
    _write(prose_lines(exercise.title, paper), paper, "bold")
    _write(prose_lines(exercise.task.strip(), paper), paper)
    if exercise.given:
        _write(["", *prose_lines(f"given: {exercise.given_text}", paper)], paper)
    _write(["", *prose_lines(HELP, paper)], paper, "dim")
    marks: list[PartMark] = []
    for part in [exercise.part(only)] if only else exercise.parts:
        write_out(f"\n{question_text(exercise, part, paper)}")
        settled, has_ended = _settle(judge, part, paper)
        marks += settled
        if has_ended:
            break
    asked = {one.part.id for one in marks}
    left = (PartMark(part, Mark(Verdict.SKIPPED)) for part in exercise.parts if part.id not in asked and not only)
    marked = SheetMark(exercise, (*marks, *left))
    if len(marked.parts) > 1:
        write_out(f"\n{sum_line(marked)}\n")
    return marked


def _settle(judge: Judge, part: Part, paper: Paper) -> tuple[tuple[PartMark, ...], bool]:
    """Ask a part until it is solved or left; its last judgement, and whether the input has ended."""
    settled: tuple[PartMark, ...] = ()
    while True:
        answer = _ask(part, paper)
        if answer is None or (settled and not answer.strip()):
            return settled, answer is None
        marked = judge.sheet({part.id: answer}, only=part.id)
        remember(marked)
        settled = marked.parts
        write_out(render("marks", marked, Look(paper=paper)))
        if marked.verdict not in _TRY_AGAIN:
            return settled, False
        _write(prose_lines(AGAIN, paper), paper, "dim")


def _ask(part: Part, paper: Paper) -> str | None:
    """The answer to a part, or None at the end of the input."""
    lines: list[str] = []
    shown = 0
    while True:
        write_out(f"{paper.spell(part.id)}> " if not lines else "... ")
        sys.stdout.flush()
        line = sys.stdin.readline()
        if not line:
            write_out("\n")
            return "\n".join(lines) if lines else None
        if line.strip() == "?":
            hint = part.hints[min(shown, len(part.hints) - 1)] if part.hints else "there is no hint for this part"
            shown += 1
            _write(prose_lines(f"hint: {hint}", paper), paper)
        elif line.strip():
            lines.append(line.rstrip("\n"))
            if part.question.is_whole("\n".join(lines)):
                return "\n".join(lines)
        else:
            return "\n".join(lines)


def _write(lines: list[str], paper: Paper, *inks: str) -> None:
    write_out("".join(f"{paper.ink(line, *inks)}\n" for line in lines))
