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
