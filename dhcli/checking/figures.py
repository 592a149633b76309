"""What the picture of an exercise may show: never what an answer would give away."""

from __future__ import annotations

from typing import Literal, get_args

from dhcli.checking.exercise import Exercise, Part
from dhcli.mobility.linkage import Linkage

Shown = Literal["none", "axes", "frames"]

LEVELS: tuple[str, ...] = get_args(Shown)
"""What a picture shows of an arm: nothing, its bodies with the axes of the joints, or frames and lengths too."""


def shown(exercise: Exercise) -> Shown | None:
    """What the picture of an exercise shows of its arm: what the file says, and never more than each part allows.

    Returns:
        `axes` for the axes of the joints only, `frames` for frames and lengths too; None if there is no picture.
    """
    if exercise.robot is None or exercise.picture == "none":
        return None
    return "axes" if exercise.picture == "axes" or held_back(exercise) else "frames"


def held_back(exercise: Exercise) -> tuple[Part, ...]:
    """The parts that the frames in a picture would answer."""
    return tuple(part for part in exercise.parts if not part.question.may_show_frames)


def linkages(exercise: Exercise) -> tuple[Linkage, ...]:
    """The linkages that are counted and whose points are known: they are drawn without names and numbers.

    One of which only links and joints are known would be drawn as boxes that anybody can count.
    """
    found: dict[str, Linkage] = {}
    for part in exercise.asked if exercise.picture != "none" else ():
        linkage = part.question.linkage_counted
        if linkage is not None and linkage.is_placed:
            found.setdefault(linkage.name, linkage)
    return tuple(found.values())


def subject(exercise: Exercise) -> str:
    """What `dhcli draw` draws of an exercise, in words; empty where that is nothing."""
    arm, count = shown(exercise) is not None, len(linkages(exercise))
    words = ["the arm"] * arm + ["the linkage" if count == 1 else "the linkages"] * bool(count)
    return " and ".join(words)
