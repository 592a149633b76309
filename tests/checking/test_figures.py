"""What the picture of an exercise may show."""

from __future__ import annotations

from typing import get_args

import pytest

from dhcli.checking import questions
from dhcli.checking.figures import MAY_SHOW, held_back, shown
from dhcli.checking.questions import TableQuestion
from dhcli.files.library.lookup import Kind, entries
from dhcli.files.yaml.exercises import load_exercise


def test_every_kind_of_question_says_what_its_picture_may_show() -> None:
    """A new kind must be placed before it may exist."""
    assert set(get_args(questions.Question)) == set(MAY_SHOW)


@pytest.mark.parametrize("name", [entry.name for entry in entries(Kind.EXERCISES)])
def test_no_picture_shows_the_frames_where_a_table_is_asked(name: str) -> None:
    """And one without a robot has no picture."""
    exercise = load_exercise(name)
    level = shown(exercise)
    assert (level is None) == (exercise.robot is None)
    if any(isinstance(part.question, TableQuestion) for part in exercise.parts):
        assert level in (None, "axes")
        assert held_back(exercise)
