"""Whether a pose is reached, and in how many ways."""

from __future__ import annotations

import pytest

from dhcli import inverse
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


@pytest.mark.parametrize(
    "ask",
    [
        'count solutions of pose "Trans(0.5, 0.1, 0.2)" within limits',
        'joints of pose "Trans(0.5, 0.1, 0.2)" within limits',
    ],
)
def test_a_solution_tells_what_the_limits_keep_out(ask: str) -> None:
    """Where they count, each solution outside them says by how much; elsewhere nothing is said of them."""
    robot = load_robot("puma560")
    exercise = question_about(robot, ask, numeric=True, given={})
    told = "\n".join(step.text for step in Judge(exercise).solution(exercise.parts[0]))
    found = inverse(robot, ((1, 0, 0, 0.5), (0, 1, 0, 0.1), (0, 0, 1, 0.2), (0, 0, 0, 1)))
    assert 0 < found.within_limits.sum() < len(found)
    assert told.count("outside the limits: theta") == len(found) - found.within_limits.sum()
    free = question_about(robot, ask.removesuffix(" within limits"), numeric=True, given={})
    assert "limits" not in "\n".join(step.text for step in Judge(free).solution(free.parts[0]))
