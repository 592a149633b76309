"""An exercise on one page: its task, what is given, and its parts with the progress so far."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from dhcli.checking.earning import worth_of
from dhcli.checking.exercise import Exercise
from dhcli.checking.figures import subject
from dhcli.files.yaml.beside import given_lines, how_written
from dhcli.render.look import Look
from dhcli.render.text.marks import question_text
from dhcli.render.text.prose import prose_lines
from dhcli.render.text.quantities import in_units


def exercise_table(exercise: Exercise, look: Look) -> str:
    """A page about an exercise."""
    paper = look.paper
    named = f" · robot {exercise.robot.name}" if exercise.robot else ""
    variant = f" · variant {exercise.variant}" if exercise.variant else ""
    about = f"{exercise.id} · {exercise.source}{named}{variant}"
    lines = [
        *(paper.ink(line, "bold") for line in prose_lines(exercise.title, paper)),
        *(paper.ink(line, "dim") for line in prose_lines(about, paper)),
        "",
        *prose_lines(exercise.task.strip(), paper),
    ]
    given = [
        *given_lines(exercise),
        *(text[0].lower() + text[1:] for text in how_written(exercise) if exercise.numeric),
    ]
    if given:
        lines += ["", *(line for text in given for line in prose_lines(text, paper))]
    for part in exercise.asked:
        lines += ["", question_text(exercise, part, paper).rstrip("\n")]
    for part in exercise.parts:
        if part.withdrawn:
            lines += ["", *prose_lines(f"{part.id} was withdrawn: {part.withdrawn}", paper)]
    if worth := worth_of(exercise):
        lines += ["", *prose_lines(f"worth: {worth}", paper)]
    lines += ["", paper.ink(paper.spell(f"dhcli start {exercise.typed} writes a sheet to fill in"), "dim")]
    if drawn := subject(exercise):
        lines.append(paper.ink(paper.spell(f"dhcli draw {exercise.typed} draws {drawn}"), "dim"))
    return "\n".join(lines) + "\n"


def exercise_content(exercise: Exercise, _look: Look) -> dict[str, Any]:
    """An exercise as JSON holds it, without its answers."""
    return {
        "exercise": exercise.id,
        "title": exercise.title,
        "source": exercise.source,
        "robot": exercise.robot.name if exercise.robot else None,
        "task": exercise.task,
        "variant": exercise.variant or None,
        "given": {name: in_units(value) for name, value in exercise.given.items()},
        "picture": subject(exercise) or None,
        "parts": [
            {
                "part": part.id,
                "asks": part.heading(exercise),
                "prompt": part.prompt,
                "credit": part.credit,
                "shares": asdict(part.shares or exercise.shares),
                "depends": list(part.depends),
                "withdrawn": part.withdrawn or None,
            }
            for part in exercise.parts
        ],
    }
