"""Whether a pose is reached, and in how many ways."""

from __future__ import annotations

import pytest

from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import NotationError
from dhcli.files.yaml.robots import load_robot

POSE = 'of pose "Trans(0.5, 0.2, 0.3) Rot(z, 20°) Rot(y, 110°) Rot(z, 40°)"'


def judged(answer: str, ask: str, robot: str = "planar-2r") -> Mark:
    """An answer, explained where it is wrong."""
    exercise = question_about(load_robot(robot), ask, numeric=True, given={})
    return Judge(exercise).check(exercise.parts[0], answer)


@pytest.mark.parametrize(
    ("ask", "right"),
    [
        ("reach of position (0.5, 0.3, 0)", "yes"),
        ("reach of position (0.6, 0.5, 0)", "no"),
        ("reach of position (0.05, 0.05, 0)", "no"),
        ("reach of position (0.5, 0.3, 0.1)", "no"),
    ],
)
def test_reach_is_yes_or_no(ask: str, right: str) -> None:
    """A reason may stand behind the word; why is told with what is right."""
    mark = judged(f"{right}, because", ask)
    assert mark.verdict is Verdict.RIGHT
    assert mark.remarks[0]
    assert judged({"yes": "No", "no": "YES"}[right], ask).verdict is Verdict.WRONG
    assert judged("perhaps", ask).verdict is Verdict.CANNOT_READ


@pytest.mark.parametrize(
    ("robot", "ask", "right"),
    [
        ("planar-2r", "count solutions of position (0.5, 0.3, 0)", 2),
        ("planar-2r", "count solutions of position (0.42, 0.56, 0)", 1),
        ("planar-2r", "count solutions of position (0.6, 0.5, 0)", 0),
        ("articulated", "count solutions of position (0.3, 0.4, 0.7)", 4),
        ("puma560", f"count solutions {POSE}", 8),
        ("puma560", f"count solutions {POSE} within limits", 7),
    ],
)
def test_solutions_are_counted(robot: str, ask: str, right: int) -> None:
    """Any other number is wrong, and what is no number cannot be read."""
    assert judged(str(right), ask, robot).verdict is Verdict.RIGHT
    assert judged(str(right + 1), ask, robot).verdict is Verdict.WRONG
    assert judged("2.5", ask, robot).verdict is Verdict.CANNOT_READ
    word = ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight"][right]
    assert judged(f"{word.title()}.", ask, robot).verdict is Verdict.RIGHT


def test_a_miscount_has_its_reason() -> None:
    """Half of them, or the limits forgotten."""
    half = judged("4", f"count solutions {POSE}", "puma560")
    assert half.diagnosis is not None
    assert "one-branch" in half.diagnosis.ids
    forgotten = judged("8", f"count solutions {POSE} within limits", "puma560")
    assert forgotten.diagnosis is not None
    assert forgotten.diagnosis.ids == ("limits",)


@pytest.mark.parametrize("ask", ["count solutions", "reach of", "reach of position (0, 0, 0) soon"])
def test_a_question_that_gives_no_pose_is_refused(ask: str) -> None:
    """With what would be read."""
    with pytest.raises(NotationError):
        judged("1", ask)
