"""What a student needs beside the task: what is given, the lengths of the robot, and how answers are written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from dhcli.checking.exercise import Exercise
from dhcli.files.library.entries import Kind, holds
from dhcli.notation.names import parts
from dhcli.notation.quantity import value_text


def given_lines(exercise: Exercise) -> Iterator[str]:
    """What is given, and what is known of the robot."""
    if exercise.given:
        yield f"given: {exercise.given_text}"
    if robot := _robot_line(exercise):
        yield robot


def _robot_line(exercise: Exercise) -> str:
    """The robot's own values, and the command for its table: `robot: a1 = 0.4 m; dhcli show NAME shows its table`.

    An exercise that asks for the table, or for what can be read off it, does not say where it is; one in letters needs
    no values. Empty where there is nothing to say.
    """
    own = {name: text for name, text in values_text(exercise).items() if name not in exercise.given}
    said = [", ".join(f"{name} = {text}" for name, text in own.items())] if own else []
    if exercise.robot is not None and _needs_table(exercise) and holds(Kind.ROBOTS, exercise.robot.name):
        said.append(f"dhcli show {exercise.robot.name} shows its table")
    return f"robot: {'; '.join(said)}" if said else ""


def values_text(exercise: Exercise) -> Mapping[str, str]:
    """Every value that the right answers of an exercise are computed with, lengths in the unit of its sheet."""
    unit = exercise.behind.strip()
    return {name: value_text(value, unit) for name, value in exercise.values.items()}


def _needs_table(exercise: Exercise) -> bool:
    """Whether a pose of the robot is asked for, and nothing that its table would give away."""
    questions = [part.question for part in exercise.asked]
    return any(question.needs_table for question in questions) and not any(one.is_in_table for one in questions)


def how_written(exercise: Exercise) -> Iterator[str]:
    """How numbers, or symbols, are written in the answers."""
    questions = [part.question for part in exercise.asked]
    if all(question.is_plain for question in questions):
        return
    if exercise.numeric:
        has_unit = exercise.unit != "none"
        unit = f": lengths in {exercise.unit} unless a unit stands with them" if has_unit else " without a unit"
        yield f"Numbers{unit}; 0.7071 or sqrt(2)/2 are both fine."
    elif any(question.has_cosines for question in questions):
        yield from _symbols(exercise, in_rows=any(question.in_rows for question in questions))
        if exercise.unit not in ("m", "none"):
            yield f"Numbers beside letters: lengths in {exercise.unit} unless a unit stands with them."


def _symbols(exercise: Exercise, *, in_rows: bool) -> Iterator[str]:
    """How symbols are written; the joint of a general link has a letter for its index, and c1 means nothing there."""
    joints = [name for name in exercise.robot.variables if name in exercise.robot.angles] if exercise.robot else []
    index = parts(joints[0])[1] if joints else ""
    if index.isalpha():
        short, glued, spaced = f"c_{index} for cos({joints[0]})", f"d_{index}*c_{index}", f"d_{index} c_{index}"
    else:
        short, glued, spaced = "c1 for cos(theta1), s23 for sin(theta2 + theta3)", "a1*c1 or a1c1", "a1 c1"
    yield f"Symbols: {short}, or written out."
    rows = f"; in a row of a matrix, where a blank begins the next cell, {glued}" if in_rows else ""
    yield f"Products: {glued.replace(' or ', ', ')} or {spaced}{rows}."
