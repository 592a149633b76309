"""What the picture of an exercise may show."""

from __future__ import annotations

import pytest

from dhcli.checking.figures import held_back, shown
from dhcli.checking.kinds.registry import KINDS
from dhcli.files.library.lookup import Kind, entries
from dhcli.files.yaml.exercises import load_exercise


def test_frames_are_shown_beside_these_kinds_of_questions_only() -> None:
    """The table, its cells and its factors are what frames say; a choice may ask for a direction."""
    assert {kind.words[0] for kind in KINDS if kind.may_show_frames} == {"link", "scalar", "count"}


@pytest.mark.parametrize("name", [entry.name for entry in entries(Kind.EXERCISES)])
def test_no_picture_shows_the_frames_where_a_table_is_asked(name: str) -> None:
    """And an exercise without a robot has no picture."""
    exercise = load_exercise(name)
    level = shown(exercise)
    assert (level is None) == (exercise.robot is None)
    asked = {type(part.question).__name__ for part in exercise.parts}
    if asked & {"TableQuestion", "CellQuestion", "FactorsQuestion"}:
        assert level in (None, "axes")
        assert held_back(exercise)
