"""What the picture of an exercise may show: never what an answer would give away."""

from __future__ import annotations

from typing import Literal

from dhcli.checking.exercise import Exercise, Part

Shown = Literal["axes", "frames"]


def shown(exercise: Exercise) -> Shown | None:
    """What the picture of an exercise may show: the least that any of its parts allows; None if there is no robot.

    Returns:
        `axes` for the axes of the joints only, `frames` for frames and lengths too.
    """
    if exercise.robot is None:
        return None
    return "axes" if held_back(exercise) else "frames"


def held_back(exercise: Exercise) -> tuple[Part, ...]:
    """The parts that the frames in a picture would answer."""
    return tuple(part for part in exercise.parts if not part.question.may_show_frames)
