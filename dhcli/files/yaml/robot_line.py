"""What a student needs of the robot beside the task: its lengths, and where its table is to be seen."""

from __future__ import annotations

from collections.abc import Mapping

from dhcli.checking.exercise import Exercise
from dhcli.files.library.entries import Kind, holds
from dhcli.notation.quantity import value_text


def robot_line(exercise: Exercise) -> str:
    """The robot's own values, and the command for its table: `Robot: a1 = 0.4 m; dhcli show NAME shows its table`.

    An exercise that asks for the table, or for what can be read off it, does not say where it is; one in letters needs
    no values. Empty where there is nothing to say.
    """
    own = {name: text for name, text in values_text(exercise).items() if name not in exercise.given}
    said = [", ".join(f"{name} = {text}" for name, text in own.items())] if own else []
    if exercise.robot is not None and _needs_table(exercise) and holds(Kind.ROBOTS, exercise.robot.name):
        said.append(f"dhcli show {exercise.robot.name} shows its table")
    return f"Robot: {'; '.join(said)}" if said else ""


def values_text(exercise: Exercise) -> Mapping[str, str]:
    """Every value that the right answers of an exercise are computed with, lengths in the unit of its sheet."""
    unit = exercise.behind.strip()
    return {name: value_text(value, unit) for name, value in exercise.values.items()}


def _needs_table(exercise: Exercise) -> bool:
    """Whether a pose of the robot is asked for, and nothing that its table would give away."""
    questions = [part.question for part in exercise.asked]
    return any(question.needs_table for question in questions) and not any(one.is_in_table for one in questions)
