"""What the picture of an exercise may show: never what an answer would give away."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.questions import (
    CellQuestion,
    ChoiceQuestion,
    CountQuestion,
    FactorsQuestion,
    MatrixQuestion,
    ScalarQuestion,
    TableQuestion,
)

Shown = Literal["axes", "frames"]

MAY_SHOW: Mapping[type, Shown] = {
    TableQuestion: "axes",  # the frames and their lengths are the table
    CellQuestion: "axes",
    FactorsQuestion: "axes",  # each factor is a cell
    ChoiceQuestion: "axes",  # it may ask for a direction or a length
    MatrixQuestion: "frames",  # where the frames are is given; where they lead is asked
    ScalarQuestion: "frames",
    CountQuestion: "frames",
}
"""What a picture may show beside each kind of question: the axes of the joints only, or frames and lengths too."""


def shown(exercise: Exercise) -> Shown | None:
    """What the picture of an exercise may show: the least that any of its parts allows; None if there is no robot."""
    if exercise.robot is None:
        return None
    return "axes" if held_back(exercise) else "frames"


def held_back(exercise: Exercise) -> tuple[Part, ...]:
    """The parts that the frames in a picture would answer."""
    return tuple(part for part in exercise.parts if MAY_SHOW.get(type(part.question), "axes") == "axes")
