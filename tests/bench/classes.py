"""A class: 500 sheets of four exercises, hardly two alike, graded by one process beside one for each processor."""

from __future__ import annotations

import json
import os
import random
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from itertools import cycle, islice
from pathlib import Path
from textwrap import indent

from measure import Row, Task, number, side_by_side
from startup import run

from dhcli import load_exercise
from dhcli.checking.judge import Judge
from dhcli.checking.variants import vary

SHEETS = 500
EXERCISES = (
    "wpi/puma560-in-two-steps",
    "wpi/puma560-table",
    "yim/planar-in-numbers",
    "yim/scara-in-numbers",
)
MISTAKEN = 0.45
"""Share of the answers that hold a mistake."""

PATIENCE = "60s"


def rows(rounds: int) -> Iterator[Row]:
    """The class graded both ways in turn, each time by a command from its start to its end."""
    with tempfile.TemporaryDirectory() as folder:
        for k, text in enumerate(islice(_texts(), SHEETS)):
            path = Path(folder, f"student-{k}", "sheet.yaml")
            path.parent.mkdir()
            path.write_text(text, "utf-8")
        jobs = os.cpu_count() or 1
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

        def graded(processes: int) -> str:
            words = ["grade", folder, "--jobs", str(processes), "--timeout", PATIENCE, "--format", "json"]
            return run([sys.executable, "-m", "dhcli", *words]).stdout

        wrong = 0

        def same(ours: str, theirs: str) -> bool:
            nonlocal wrong
            report = json.loads(ours)["data"]
            wrong = sum(part["earned"] < part["credit"] for row in report["results"] for part in row["parts"])
            return ours == theirs and report["graded"] == SHEETS

        row = side_by_side(
            "grading a class",
            Task(f"dhcli grade, --jobs {jobs}", lambda: graded(jobs)),
            Task("dhcli grade, --jobs 1", lambda: graded(1)),
            same,
            rounds=rounds,
        )
        rates = " and ".join(number(SHEETS / taken) for taken in (row.seconds, row.peer_seconds))
        yield replace(row, note=f"{SHEETS} sheets, {wrong} wrong answers; {rates} a second")


def _texts() -> Iterator[str]:
    """Sheets in turn from each exercise, in a variant for each student where there are any."""
    judges = [Judge(load_exercise(name)) for name in EXERCISES]
    draw = random.Random(1)  # noqa: S311
    for student, judge in enumerate(cycle(judges)):
        yield _sheet(vary(judge, f"student {student}") if judge.exercise.variants else judge, draw)


def _sheet(judge: Judge, draw: random.Random) -> str:
    """A sheet with right answers, in either spelling, and some that one of the known mistakes leads to."""
    exercise = judge.exercise
    text = f"format: 1\nexercise: {exercise.id}\n"
    text += f"variant: {exercise.variant}\n" if exercise.variant else ""
    text += "answers:\n"
    for part in exercise.asked:
        slips = judge.slips(part) if draw.random() < MISTAKEN else ()
        style = draw.choice(("short", "full"))
        answer = judge.answer_with(part, draw.choice(slips).name) if slips else judge.expected(part, style)
        text += f"  {part.id}: |\n{indent(answer.strip(), '    ')}\n"
    return text
