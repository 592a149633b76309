"""What the picture of an exercise may show."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli.checking.exercise import Exercise
from dhcli.checking.figures import held_back, linkages, shown, subject
from dhcli.checking.kinds.registry import KINDS
from dhcli.cli.shell.drawn import of_exercise
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise
from dhcli.kinematics.robot import Robot
from dhcli.mobility.linkage import Linkage
from dhcli.render.pictures.picture import Picture
from tests.nightly import in_turn
from tests.row_by_row import row_by_row


def test_frames_are_shown_beside_these_kinds_of_questions_only() -> None:
    """The table, its cells and its factors are what frames say; a choice may ask for a direction."""
    assert {kind.words[0] for kind in KINDS if kind.may_show_frames} == {"link", "scalar", "count"}


@row_by_row("name", [entry.name for entry in entries(Kind.EXERCISES)])
def test_no_picture_shows_the_frames_where_a_table_is_asked(name: str) -> None:
    """And an exercise without a robot has no picture."""
    exercise = load_exercise(name)
    level = shown(exercise)
    assert (level is None) == (exercise.robot is None or exercise.picture == "none")
    asked = {type(part.question).__name__ for part in exercise.parts}
    if asked & {"TableQuestion", "CellQuestion", "FactorsQuestion"}:
        assert level in (None, "axes")
        assert held_back(exercise)


SHOWN_BESIDE = {
    "link": {"x", "z", "dim", "slide", "turn"},
    "scalar": {"x", "z", "dim", "slide", "turn"},
    "count": {"x", "z", "dim", "slide", "turn"},
}
"""Looks of labels that may stand beside a kind of question, by its first word; any other leaves the axes only."""

ALWAYS = {"number", "caption"}


@pytest.mark.parametrize("name", in_turn([entry.name for entry in entries(Kind.EXERCISES)], 0, 3))
def test_no_label_in_a_picture_says_more_than_every_part_of_the_task_allows(name: str) -> None:
    """What is drawn, label by label, against the list; linkages have no name, no number and no count."""
    exercise = load_exercise(name)
    if not subject(exercise):
        return
    allowed: set[str] = set.intersection(*(SHOWN_BESIDE.get(p.question.words[0], set()) for p in exercise.parts))
    for fields in of_exercise(name, None, solution=False, yes=False):
        figure = Picture(**fields).figure()
        assert {text.look for text in figure.texts} <= ALWAYS | (
            allowed if isinstance(fields["what"], Robot) else set()
        )
        if isinstance(fields["what"], Linkage):
            assert {text.look for text in figure.texts} <= {"caption"}
            assert fields["what"].pattern not in figure.caption
            assert "links" not in figure.caption


def _exercise(picture: str) -> Exercise:
    return replace(load_exercise("yim/planar-in-numbers"), picture=picture)


def test_a_file_may_show_less_than_its_parts_allow_but_never_more() -> None:
    """`picture: frames` beside a table stays at the axes."""
    assert [shown(_exercise(level)) for level in ("", "frames", "axes", "none")] == ["frames", "frames", "axes", None]
    table = load_exercise("wpi/puma560-table")
    assert [shown(replace(table, picture=level)) for level in ("", "frames", "none")] == ["axes", "axes", None]


def test_linkages_are_drawn_once_each_and_only_where_their_points_are_known() -> None:
    """One of which only links and joints are known would be boxes to count."""
    found = linkages(load_exercise("yim/counting-exceptions"))
    assert [linkage.name for linkage in found] == ["four-bar-in-space", "hooke-coupling", "sarrus", "bennett"]
    assert [one.name for one in linkages(load_exercise("zhou/closed-and-open-chain"))] == ["planar-four-bar"]
    assert linkages(load_exercise("yim/counting-freedoms")) == ()
    assert subject(load_exercise("yim/counting-freedoms")) == ""
    assert subject(load_exercise("zhou/closed-and-open-chain")) == "the linkage"
    assert subject(load_exercise("motion/five-bar-loop")) == "the arm and the linkage"
    assert linkages(replace(load_exercise("yim/counting-exceptions"), picture="none")) == ()
