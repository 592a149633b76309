"""A class: 2,000 sheets of several exercises, graded by one process beside one process for each processor."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from itertools import cycle, islice
from pathlib import Path
from textwrap import indent

from measure import Row, Task, number, side_by_side

from dhcli import load_exercise
from dhcli.checking.exercise import Exercise
from dhcli.classroom.folder import find_sheets
from dhcli.classroom.grades import Graded
from dhcli.classroom.grading import grade_all

SHEETS = 2000
EXERCISES = (
    "yim/planar-two-links",
    "yim/planar-in-numbers",
    "wpi/puma560-links",
    "bajd/scara-pose-in-mm",
    "yim/counting-freedoms",
    "wpi/puma560-table",
)
PATIENCE = 60.0


def rows(_rounds: int) -> Iterator[Row]:
    """One pair only: it takes a minute."""
    with tempfile.TemporaryDirectory() as folder:
        for k, text in enumerate(islice(cycle(_texts()), SHEETS)):
            path = Path(folder, f"student-{k}", "sheet.yaml")
            path.parent.mkdir()
            path.write_text(text, "utf-8")
        sheets = find_sheets(folder).submissions
        jobs = os.cpu_count() or 1

        def graded(processes: int) -> tuple[Graded, ...]:
            return grade_all(sheets, jobs=processes, timeout=PATIENCE)

        broken = 0

        def same(ours: tuple[Graded, ...], theirs: tuple[Graded, ...]) -> bool:
            nonlocal broken
            broken = sum(bool(sheet.problems) for sheet in ours)
            return ours == theirs

        row = side_by_side(
            "grading a class",
            Task(f"grade_all, jobs={jobs}", lambda: graded(jobs)),
            Task("grade_all, jobs=1", lambda: graded(1)),
            same,
            rounds=1,
        )
        rates = " and ".join(number(SHEETS / taken) for taken in (row.seconds, row.peer_seconds))
        yield replace(row, note=f"{SHEETS} sheets, {broken} of them broken; {rates} a second")


def _texts() -> Iterator[str]:
    """Sheets in turn from each exercise: all right, all wrong, partly blank, blank, and one in ten no sheet at all."""
    exercises = [load_exercise(name) for name in EXERCISES]
    for turn in range(10):
        for exercise in exercises:
            yield "format: 1\nanswers: [" if turn == 9 else _sheet(exercise, turn)


def _sheet(exercise: Exercise, turn: int) -> str:
    """A sheet with answers from the tests that the exercise brings along."""
    text = f"format: 1\nexercise: {exercise.id}\nanswers:\n"
    for place, part in enumerate(exercise.parts):
        trials = [trial for trial in exercise.trials if trial.part == part.id and trial.answer]
        right = [trial for trial in trials if trial.verdict == "RIGHT"]
        chosen = right if turn < 3 else trials if turn < 6 or (turn < 8 and place % 2) else []
        answer = chosen[turn % len(chosen)].answer if chosen else "_"
        text += f"  {part.id}: |\n{indent(answer.strip(), '    ')}\n"
    return text
