"""Mistakes in which frames are meant."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

from dhcli.checking.diagnosis.mistakes.record import Catalogue, Level, Made
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Setting, Work, steps_between
from dhcli.kinematics.frames import View, span_of

OF_FRAMES = Catalogue(Level.PRODUCT)


@OF_FRAMES(
    "tool-forgotten",
    "the tool is forgotten: this ends at the frame of the last link",
    "where does the arm end: at the frame of its last link, or at its tool?",
)
def tool_forgotten(work: Work, _setting: Setting) -> Made:
    """The pose of frame n where that of the tool is asked."""
    if len(work.steps) > 1 and work.steps[-1].name == "tool":
        yield "", replace(work, steps=work.steps[:-1])


@OF_FRAMES(
    "base-forgotten",
    "the base is forgotten: this is seen from the frame of the first joint",
    "from where is it seen: from the base, or from the frame of the first joint?",
)
def base_forgotten(work: Work, _setting: Setting) -> Made:
    """The pose seen from frame 0 where the base is asked."""
    if len(work.steps) > 1 and work.steps[0].name == "base":
        yield "", replace(work, steps=work.steps[1:])


@OF_FRAMES(
    "other-frames",
    "this is the pose of frame {term} seen from frame {entry}",
    "from which frame to which is it asked?",
    rank=Rank.SYMPTOM,
    alone=True,
)
def other_frames(work: Work, setting: Setting) -> Made:
    """The pose of another frame, or seen from another, T_16 or T_03 for T_06; or the next link, A_2 for A_1."""
    robot, source = setting.robot, work.question.source
    if robot is None or not isinstance(source, View):
        return
    asked = sorted(span_of(robot, source))
    for first, last in combinations(range(len(robot.frames)), 2):
        shared = (first == asked[0]) + (last == asked[1])
        is_next = last - first == asked[1] - asked[0] == 1 and abs(first - asked[0]) == 1
        steps = steps_between(robot, setting, first, last) if shared == 1 or is_next else ()
        if steps:
            yield f"{robot.frames[first]} {robot.frames[last]}", replace(work, steps=steps)
