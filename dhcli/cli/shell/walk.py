"""An exercise asked part by part on the terminal."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass, field, replace
from enum import Enum

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.marked import PartMark, SheetMark
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.cli.shell.console import tell, write_out
from dhcli.cli.shell.lines import Typing, recalled
from dhcli.cli.shell.quiz import remember
from dhcli.files.progress import SOLVED, read_progress
from dhcli.files.yaml.beside import given_lines, how_written
from dhcli.render.kinds import render
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.marks import question_text, sum_line, why_lines
from dhcli.render.text.prose import prose_lines

HELP = "An empty line ends a matrix or a table, and leaves a part. Besides answers: hint, why, back, skip, quit, help."
COMMANDS = {
    "hint": "the next hint; ? is short for it",
    "why": "the slip behind your last answer, by its name",
    "skip": "leave this part and go on, as an empty line does",
    "back": "to the part before",
    "quit": "ends, as q, exit, Ctrl-D and Ctrl-C do, and sums up",
    "help": "this list",
}
ARROWS = "The arrow keys edit a line and bring back what you typed."
GOES_ON = "What you are typing is not judged yet: an empty line ends it."
LEAST_WORD = 3
"""Letters of a word that begins no answer of several cells: `T` and `h` may stand before them, or be the first."""
AGAIN = "Try again, or go on with an empty line."
_TRY_AGAIN = (Verdict.WRONG, Verdict.CLOSE, Verdict.CANNOT_READ)


class Step(Enum):
    """Where to go from a part."""

    ON = 1
    BACK = -1
    END = 0


def walk(judge: Judge, only: str | None = None, *, why: bool = False) -> SheetMark:
    """Ask each part that is not solved yet, judge it, and go on; what was answered counts as progress.

    Args:
        judge: The judge of the exercise.
        only: The one part to ask, solved or not; all by default.
        why: Whether slips are named at once.

    Raises:
        KeyboardInterrupt: Ctrl-C has ended it; it was summed up all the same.
    """
    walked = _Walk(judge, why, {} if only else _solved_before(judge.exercise))
    parts = (judge.exercise.part(only),) if only else judge.exercise.asked
    try:
        walked.begin(parts)
    except KeyboardInterrupt:
        write_out("\n")
        walked.sum_up(parts)
        raise
    return walked.sum_up(parts)


def _solved_before(exercise: Exercise) -> dict[str, PartMark]:
    """The parts that this user has solved; a variant has numbers of its own, which may not have been solved."""
    if "/" not in exercise.id or exercise.variant:
        return {}
    progress, message = read_progress()
    if message:
        tell(f"dhcli: {message}")
    done = progress.get(exercise.id, {})
    best = [(part, done[part.id].best) for part in exercise.asked if part.id in done]
    verdicts = {verdict.word: verdict for verdict in Verdict}
    return {p.id: PartMark(p, Mark(verdicts[word], earned=1.0)) for p, word in best if word in SOLVED}


@dataclass(slots=True)
class _Walk:
    """A walk, as far as it has come.

    Attributes:
        judge: The judge of the exercise.
        names: Whether slips are named at once.
        marks: The last judgement of each part.
        answers: The last answer to each part, from which later ones may follow.
        hints: How many hints were shown for each part.
        notes: What was said about how to write an answer to the part before.
        typing: Where lines come from.
        paper: Where it is written.
    """

    judge: Judge
    names: bool
    marks: dict[str, PartMark]
    answers: dict[str, str] = field(default_factory=dict)
    hints: dict[str, int] = field(default_factory=dict)
    notes: frozenset[str] = frozenset()
    typing: Typing = field(default_factory=Typing)
    paper: Paper = field(default_factory=lambda: Paper.of(sys.stdout))

    def begin(self, parts: tuple[Part, ...]) -> None:
        """Ask the parts in order, those that are solved only on the way back."""
        self.introduce()
        if self.marks.keys() >= {part.id for part in parts}:
            again = f"dhcli check {self.judge.exercise.typed} --part {parts[0].id}"
            self.write(f"All parts are solved; {again} asks one again.")
            return
        if self.marks:
            self.write(f"Solved already, and not asked again: {', '.join(self.marks)}.", "dim")
        place = self.next_open(parts, 0)
        while place < len(parts):
            self.pose(parts[place])
            step = self.settle(parts[place])
            if step is Step.END:
                return
            if step is Step.ON:
                place = self.next_open(parts, place + 1)
            elif place:
                place -= 1
            else:
                self.write("This is the first part.", "dim")

    def pose(self, part: Part) -> None:
        """Ask a part; how to write an answer is told once, and not again where the part before had the same notes."""
        exercise = self.judge.exercise
        write_out(f"\n{question_text(exercise, part, self.paper, known=self.notes)}")
        self.notes = frozenset(part.question.notes(exercise))

    def next_open(self, parts: tuple[Part, ...], place: int) -> int:
        """The next part that is not solved, from a place on; beyond the end if all are."""
        done = {name for name, one in self.marks.items() if one.mark.verdict.passed}
        return next((k for k in range(place, len(parts)) if parts[k].id not in done), len(parts))

    def introduce(self) -> None:
        """The task, and how answers are given."""
        exercise = self.judge.exercise
        self.write(exercise.title, "bold")
        self.write(exercise.task.strip())
        for number, text in enumerate(given_lines(exercise)):
            self.write(text if number else f"\n{text}")
        for number, text in enumerate((*how_written(exercise), HELP)):
            self.write(text if number else f"\n{text}", "dim")

    def settle(self, part: Part) -> Step:
        """Ask a part until it is solved or left."""
        is_tried = False
        while True:
            answer = self.ask(part)
            if isinstance(answer, Step):
                return answer
            if is_tried and not answer.strip():
                return Step.ON
            marked = self.judged(part, answer)
            write_out(render("marks", replace(marked, why=self.names, walked=True), Look(paper=self.paper)))
            if marked.verdict not in _TRY_AGAIN and not marked.parts[0].mark.is_too_short:
                return Step.ON
            is_tried = True
            self.write(AGAIN, "dim")

    def judged(self, part: Part, answer: str) -> SheetMark:
        """An answer judged, beside those before it that it may follow from."""
        before = {one.id for one in self.judge.exercise.before(part)}
        earlier = {name: text for name, text in self.answers.items() if name in before}
        marked = self.judge.sheet({**earlier, part.id: answer}, only=part.id)
        remember(marked)
        if marked.verdict is not Verdict.SKIPPED:
            self.answers[part.id] = answer
            self.marks[part.id] = marked.parts[0]
        return marked

    def ask(self, part: Part) -> str | Step:
        """The answer to a part, or where to go without one."""
        lines: list[str] = []
        blank = part.question.blank(self.judge.exercise)
        while True:
            line = self.typing.line("... " if lines else f"{self.paper.spell(part.id)}> ")
            if line is None:
                if lines:
                    break
                return Step.END
            word = "" if line.strip() in self.judge.exercise.scope.names else line.strip().lower()
            if word in ("skip", "back"):
                return Step.ON if word == "skip" else Step.BACK
            if word in ("quit", "exit", "q"):
                return Step.END
            if word in ("?", "hint", "why", "help"):
                self.tell(part, word)
                if lines and word == "why":
                    self.write(GOES_ON, "dim")
                continue
            if not lines and math.prod(blank) > 1 and len(word) >= LEAST_WORD and word.isalpha():
                self.refuse(part, word)
                continue
            lines.append(line)
            if not line.strip() or part.question.is_whole("\n".join(lines), blank):
                break
        self.typing.keep(recalled(lines, is_matrix=part.question.in_rows or blank[0] > 1))
        return "\n".join(lines)

    def refuse(self, part: Part, word: str) -> None:
        """Say at once that a word is none of those known: as the first row of a matrix it would wait for the others."""
        self.write(f"'{word}' is no answer, and none of the words {', '.join(COMMANDS)}.")
        if word == "solution":
            self.write(f"dhcli solution {self.judge.exercise.typed} --part {part.id} works it out, behind quit.")

    def tell(self, part: Part, word: str) -> None:
        """What a person asks for besides answering."""
        if word == "help":
            width = max(map(len, COMMANDS))
            for name, text in COMMANDS.items():
                self.write(text, first=f"  {name:{width}}  ", rest=" " * (width + 4))
            self.write(ARROWS)
        elif word == "why":
            for line in why_lines(self.marks.get(part.id), self.paper):
                write_out(f"{line}\n")
        elif part.hints:
            number = min(self.hints.get(part.id, 0), len(part.hints) - 1)
            self.hints[part.id] = number + 1
            self.write(f"hint {number + 1} of {len(part.hints)}: {part.hints[number]}")
        else:
            self.write("there is no hint for this part")

    def sum_up(self, parts: tuple[Part, ...]) -> SheetMark:
        """The last judgement of each part, with the sum told; what was not answered is skipped."""
        blank = Mark(Verdict.SKIPPED)
        marked = SheetMark(
            self.judge.exercise, tuple(self.marks.get(part.id) or PartMark(part, blank) for part in parts)
        )
        if len(parts) > 1:
            write_out(f"\n{sum_line(marked)}\n")
        sys.stdout.flush()
        return marked

    def write(self, text: str, *inks: str, first: str = "", rest: str = "") -> None:
        """Prose on the terminal."""
        lead = "\n" if text.startswith("\n") else ""
        lines = prose_lines(text, self.paper, first, rest)
        write_out(lead + "".join(f"{self.paper.ink(line, *inks)}\n" for line in lines))
