"""A direction that lies along an axis may be typed as that axis, wherever a direction is asked for."""

from __future__ import annotations

import pytest

from dhcli import load_exercise
from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Verdict

ABOUT_Y = "about_y"
"""The unit vector along z, turned about y: it ends along x."""


@pytest.mark.parametrize("answer", ["+x", "x", "x axis", "+x axis", "1, 0, 0", "i", "x0"])
def test_an_axis_is_read_for_a_turned_direction(answer: str) -> None:
    """As coordinates and i, j, k are."""
    judge = Judge(load_exercise("bajd/rotate-a-vector"))
    assert judge.check(judge.exercise.part(ABOUT_Y), answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize("answer", ["-x", "+z", "-y axis"])
def test_another_axis_is_wrong_and_not_unreadable(answer: str) -> None:
    """It is an answer, to be judged."""
    judge = Judge(load_exercise("bajd/rotate-a-vector"))
    assert judge.check(judge.exercise.part(ABOUT_Y), answer).verdict is Verdict.WRONG
