"""Rules about what gets lost: comments that were meant as text, and values that nothing uses."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.lint.linting import Broken, assert_told, cases, findings
from tests.lint.test_exercises import CLEAN
from tests.lint.test_linkages import CLEAN as LINKAGE
from tests.lint.test_robots import CLEAN as ROBOT

QUOTED = "if it is one: 'Exercise #3 of 5'"


@cases(
    Broken(
        "title: Two links",
        "title: Exercise #3 of 5",
        "2:8",
        "'#3 of 5' is a comment, and no part of the text",
        QUOTED,
        is_warning=True,
    ),
    Broken(
        "theta2: 20°}",
        "theta2: 20°, a_3: 4 mm}",
        "7:40",
        "a_3: nothing uses it",
        "known: theta1, theta2, a1, a2",
        is_warning=True,
    ),
)
def test_what_gets_lost_in_an_exercise_is_told(broken: Broken, tmp_path: Path) -> None:
    """A number sign without a blank behind it, and a name that is none of the robot's and stands in no text."""
    assert_told(tmp_path, CLEAN, broken)


@pytest.mark.parametrize("clean", [ROBOT, LINKAGE])
def test_a_number_sign_is_told_in_every_kind_of_file(tmp_path: Path, clean: str) -> None:
    """Comments have a blank behind theirs, and a sign in quotes is text."""
    start = clean.index("title: ")
    line = clean[start : clean.index("\n", start)]
    (found,) = findings(tmp_path, clean.replace(line, "title: Exercise #3 of 5"))
    assert (found.hint, found.is_warning) == (QUOTED, True)
    for fine in ("title: Exercise # 3 of 5", "title: 'Exercise #3 of 5'", "title: Exercise#3 of 5"):
        assert findings(tmp_path, clean.replace(line, fine)) == []


@pytest.mark.parametrize(
    ("given", "is_used"),
    [("a3: 4 mm", False), ("theta3: 4°", False), ("e: 4 mm", True), ("f_x: 10", True), ("dtheta1: 2", True)],
)
def test_only_a_name_like_those_of_the_robot_can_be_lost(tmp_path: Path, given: str, *, is_used: bool) -> None:
    """Others are brought along by questions, such as the rates of joints; one that stands in a text is used."""
    text = CLEAN.replace("given: {", f"given: {{{given}, ")
    assert ([one.message for one in findings(tmp_path, text) if "nothing uses it" in one.message] == []) is is_used
    name = given.partition(":")[0]
    assert findings(tmp_path, text.replace("Find the pose of the end.", f"It is {name} away.")) == []
