"""What a question asks, in a few words: for sheets, for judgements, and for people about to answer."""

from __future__ import annotations

from dhcli.checking.exercise import Exercise
from dhcli.checking.questions import (
    CellQuestion,
    ChoiceQuestion,
    CountQuestion,
    FactorsQuestion,
    MatrixQuestion,
    Question,
    ScalarQuestion,
    Span,
    TableQuestion,
)
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import ONE, Number, multiply, number
from dhcli.notation.writer import write


def describe(question: Question, exercise: Exercise) -> str:
    """What a part of an exercise asks for, in a few words."""
    match question:
        case MatrixQuestion():
            return _matrix(question, exercise)
        case TableQuestion(convention):
            return f"the {convention.value} DH table"
        case CellQuestion(column, link):
            return f"{column} of link {link}"
        case FactorsQuestion(link):
            return f"the elementary moves of link {link}, in order"
        case ScalarQuestion():
            return "one value"
        case CountQuestion(what, linkage):
            return f"{what} of {linkage}, a whole number"
        case ChoiceQuestion():
            return "the number of one statement"
    raise TypeError(question)


def given_text(exercise: Exercise) -> str:
    """The values that an exercise gives, lengths in the unit of its sheet: `theta1 = 30°, d3 = 0.12 m`."""
    unit = "" if exercise.unit == "none" else exercise.unit
    return ", ".join(f"{name} = {value_text(value, unit)}" for name, value in exercise.given.items())


def coordinates(question: MatrixQuestion, exercise: Exercise) -> str:
    """The point or the vector of a question, in the unit of the sheet: `20, -30, 50`."""
    scale = number(1 / exercise.metres) if exercise.numeric else ONE
    shown = [multiply(scale, value) if isinstance(value, Number) else value for value in question.point]
    return ", ".join(write(value, "short", exercise.writing) for value in shown)


def _matrix(question: MatrixQuestion, exercise: Exercise) -> str:
    if isinstance(question.source, Span):
        start, end = question.source.start, question.source.end
        whole = f"A_{end}" if question.source.link else f"T_{start}{end}"
        whole += f", frame {end} seen from frame {start}"
    else:
        whole = question.source.text
    if question.inverse:
        whole = f"the inverse of {whole}"
    row, column = question.index
    point = coordinates(question, exercise)
    pieces = {
        "pose": f"{whole}: a 4x4 matrix, row by row",
        "rotation": f"the rotation of {whole}: a 3x3 matrix",
        "position": f"the position of {whole}: three lengths",
        "entry": f"entry ({row + 1},{column + 1}) of {whole}",
        "axis": f"the {'xyz'[row]} axis of {whole}: three direction cosines",
        "point": f"the point ({point}) through {whole}: three lengths",
        "vector": f"the vector ({point}) turned by {whole}: three numbers",
    }
    return pieces[question.piece]
