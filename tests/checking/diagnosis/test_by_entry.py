"""Slips in the entries of a formula, each typed as a student would."""

from __future__ import annotations

from functools import cache

import pytest

from dhcli import check, load_robot
from dhcli.algebra.equality import equal
from dhcli.checking.diagnosis.mistakes.in_terms import IN_ENTRY, Among, TermMaker
from dhcli.checking.diagnosis.record import Mistake
from dhcli.checking.diagnosis.search import search_of
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.registry import read_question
from dhcli.kinematics.values import joint_values
from dhcli.notation.parser import parse
from dhcli.notation.tree import Symbol
from dhcli.notation.writer import write
from tests.judging import answer_with, case_of, expected
from tests.row_by_row import row_by_row


@cache
def about(name: str, ask: str = "") -> Exercise:
    """The pose of a robot, or what else is asked of it."""
    robot = load_robot(name)
    if not ask:
        return question_about(robot, f"pose {robot.frames[1]}..{robot.frames[-2]}", numeric=False, given={})
    return Exercise("e", "", "", "", (Part("pose", read_question(ask, robot.scope)),), robot)


def named(exercise: Exercise, answer: str) -> tuple[str, ...]:
    """The slips that are named, in words."""
    found = check(exercise, "pose", answer).diagnosis
    return () if found is None else found.names


PLANAR = "[c12 -s12 0 a1*c1+a2*c12; s12 c12 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1]"


@pytest.mark.parametrize(
    ("right", "typed", "words"),
    [
        ("a1*c1+a2*c12", "a2*c12", "entry (1,4) lacks a1*c1"),
        ("a1*c1+a2*c12", "a1*c1-a2*c12", "the sign of a2*c12 in entry (1,4) is turned round"),
        ("a1*c1+a2*c12", "2*a1*c1+a2*c12", "a1*c1 is counted twice in entry (1,4)"),
        ("a1*c1+a2*c12", "a1*c1+a2*c12/2", "entry (1,4) has only half of a2*c12"),
        ("a1*c1+a2*c12", "a1*s1+a2*c12", "entry (1,4) has s1 for c1"),
        ("a1*c1+a2*c12", "a1*c1+a2*c2", "entry (1,4) has c2 for c12"),
        ("a1*c1+a2*c12", "a1*c2+a2*c12", "entry (1,4) has c2 for c1"),
        ("a1*c1+a2*c12", "a1*c12+a2*c12", "entry (1,4) has c12 for c1"),
        ("a1*c1+a2*c12", "a1*c1+a2*c1*c2", "entry (1,4) has c1*c2 for c12"),
        ("a1*c1+a2*c12", "a1*c1+a2*(c1+c2)", "entry (1,4) has c1 + c2 for c12"),
        ("a1*c1+a2*c12", "a1*c1+a2*c1*c2+a2*s1*s2", "entry (1,4) has c1*c2 + s1*s2 for c12"),
        ("a1*c1+a2*c12", "a2*c1+a2*c12", "entry (1,4) has a2 for a1"),
        ("a1*c1+a2*c12", "a1*c1+a2", "entry (1,4) has a2 for a2*c12"),
        ("c12", "(c1+c2)", "entries (1,1), (1,4) and (2,2) have c1 + c2 for c12"),
        ("c12", "c1*c2", "entries (1,1), (1,4) and (2,2) have c1*c2 for c12"),
        ("a2*", "a1*", "entries (1,4) and (2,4) have a1 for a2"),
    ],
)
def test_a_slip_in_the_terms_is_named(right: str, typed: str, words: str) -> None:
    """In the entry where it stands, or in all of them at once."""
    assert right in PLANAR
    assert named(about("planar-2r"), PLANAR.replace(right, typed)) == (words,)


def test_c1c2_for_c12_and_s1s2_for_s12_is_one_slip() -> None:
    """Functions multiplied as if they were angles, in every entry."""
    answer = PLANAR.replace("c12", "c1*c2").replace("s12", "s1*s2")
    assert named(about("planar-2r"), answer) == ("6 entries have c1*c2 for c12 and s1*s2 for s12",)


def test_two_slips_in_two_entries_are_named_together() -> None:
    """Each in its own."""
    answer = PLANAR.replace("a1*c1+", "").replace("a1*s1+a2*s12", "a1*s1+a2*s2")
    assert named(about("planar-2r"), answer) == ("entry (1,4) lacks a1*c1 and entry (2,4) has s2 for s12",)


def test_one_wrong_entry_without_a_name_leaves_all_without_one() -> None:
    """Never a guess."""
    assert named(about("planar-2r"), PLANAR.replace("a1*c1+a2*c12", "a1*a2*c1").replace("a1*s1+", "")) == ()


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("- d3*s1", "", "entry (1,4) lacks d3*s1"),
        ("c23", "c2", "12 entries have c2 for c23"),
        ("d4*s23", "d4*s3", "entries (1,4) and (2,4) have s3 for s23"),
        ("c4*c5*c6", "c4*c6", "entries (1,1), (2,1) and (3,1) have c4*c6 for c4*c5*c6"),
    ],
)
def test_a_slip_deep_in_an_entry_is_named(old: str, new: str, words: str) -> None:
    """However deep the brackets."""
    exercise = about("puma560")
    answer = expected(exercise, exercise.parts[0])
    assert old in answer
    assert named(exercise, answer.replace(old, new)) == (words,)


def test_the_form_of_what_was_typed_does_not_matter() -> None:
    """The same slip, multiplied out."""
    exercise = about("puma560", "entry 2 4 of pose 0..6")
    assert named(exercise, "a2*s1*c2 + a3*s1*c23 - d4*s1*s23") == ("d of row 3 is forgotten",)
    found = named(exercise, "s1*(a2*c2 + a3*c2*c3 + a3*s2*s3 - d4*s23) + d3*c1")
    assert found == ("entry (2,4) has c2*c3 + s2*s3 for c23",)


def test_a_slip_in_the_table_is_named_before_one_in_the_terms() -> None:
    """The mistake is where it was made, not where it shows."""
    exercise = about("puma560")
    answer = answer_with(exercise, exercise.parts[0], "d-forgotten 3")
    assert named(exercise, answer) == ("d of row 3 is forgotten",)


def test_numbers_show_no_terms() -> None:
    """There is nothing to look for in them."""
    robot = load_robot("planar-2r")
    exercise = question_about(robot, "pose 0..2", numeric=True, given=joint_values(robot, "25°,40°"))
    search = search_of(exercise.parts[0].question, case_of(exercise, exercise.parts[0]).memo)
    assert search.setting.numeric
    found = check(exercise, "pose", "[0.4 -0.9 0 1.2; 0.9 0.4 0 1; 0 0 1 0; 0 0 0 1]").diagnosis
    assert found is None or not any(name.startswith("term-") for name in found.ids)


@row_by_row("mistake", IN_ENTRY)
def test_each_mistake_changes_an_entry(mistake: Mistake[TermMaker]) -> None:
    """No two ways to make it are called the same and differ."""
    scope = load_robot("planar-2r").scope
    expr = parse("a1*c1 + a2*c12*s1 + a1^2", scope)
    among = Among(("theta1", "theta2"), (Symbol("a1"), Symbol("a2")))
    made = list(mistake.made(expr, among))
    assert made
    for text, changed in made:
        assert not equal(changed, expr), (text, write(changed))
    assert len({text for text, _ in made}) == len(made)
