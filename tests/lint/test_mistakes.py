import re
from itertools import combinations

from dhcli import load_exercise, load_robot
from dhcli.checking.kinds.made import question_about
from dhcli.files.yaml.exercises import read_exercise
from dhcli.kinematics.values import joint_values
from dhcli.lint.exercises import findings as rules
from dhcli.lint.mistakes import POSES, findings
from tests.judging import judge_of

TEXT = """
format: 1
title: Two links
source: a test
robot: planar-2r
task: Find the pose.
parts:
  - {id: t02, ask: pose 0..2, hints: [multiply]}
tests:
  - {part: t02, answer: "c12 -s12 0 a1*c1+a2*c12; s12 c12 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1", verdict: RIGHT}
  - {part: t02, mistake: MISTAKE, verdict: WRONG}
"""


def test_a_test_that_names_a_mistake_makes_it() -> None:
    """The answer with the mistake is judged wrong, as the test says."""
    assert list(rules(judge_of(read_exercise(TEXT.replace("MISTAKE", "a-sign 2"), "f", "c/n")))) == []


def test_a_mistake_that_nobody_can_make_is_told() -> None:
    """With the nearest one."""
    (found,) = rules(judge_of(read_exercise(TEXT.replace("MISTAKE", "a-sine 2"), "f", "c/n")))
    assert found.where == ("tests", 1, "mistake")
    assert "a-sign 2" in found.hint


def test_a_pose_that_hides_mistakes_is_told_with_one_that_shows_them() -> None:
    """At zero a planar arm shows half of the mistakes at best; the angles proposed show more."""
    robot = load_robot("scara-yim")
    at_zero = question_about(robot, "pose 0..4", numeric=True, given=joint_values(robot, "0,0,0.1,0"))
    (found,) = findings(judge_of(at_zero))
    assert "does not show" in found.message
    assert re.search(r" shows all \d+$", found.hint)


def test_the_poses_proposed_break_no_rule() -> None:
    """No angle is a right one or half of one, and no two differ by one or add up to it."""
    for pose in POSES:
        assert all(angle % 45 for angle in pose)
        assert all((a + b) % 90 and (a - b) % 90 for a, b in combinations(pose, 2))


def test_one_mistake_is_a_mistake_and_two_are_two() -> None:
    """At 45° sine and cosine agree; where most is hidden it is an error, not a warning."""
    robot = load_robot("planar-2r")
    (one,) = findings(judge_of(question_about(robot, "pose 0..2", numeric=True, given=joint_values(robot, "25°,45°"))))
    assert one.message == "pose: this pose does not show a mistake: sin-cos 2"
    assert (one.where, one.is_warning) == (("parts", 0), True)
    assert one.hint == "given: {theta1: 25°, theta2: 40°} shows it"
    head = TEXT[: TEXT.index("tests:")].replace("task:", "numeric: true\ngiven: {theta1: 0, theta2: 0}\ntask:")
    (many,) = findings(
        judge_of(read_exercise(head.replace("ask: pose 0..2", "ask: entry 2 1 of pose 0..2"), "f", "c/n"))
    )
    assert re.fullmatch(r"t02: this pose does not show 17 mistakes: [^,]+, [^,]+, [^,]+, \.\.\.", many.message)
    assert not many.is_warning


def test_where_no_other_angles_show_more_there_is_nothing_to_do() -> None:
    """As where no joint turns."""
    robot = load_robot("cartesian")
    (found,) = findings(
        judge_of(question_about(robot, "pose 0..3", numeric=True, given=joint_values(robot, "0.1, 0.2, 0")))
    )
    assert "d-sign 3" in found.message
    assert found.hint == "nothing to do if it is meant so"


def test_an_exercise_in_symbols_hides_nothing() -> None:
    """Letters are every pose at once."""
    assert list(findings(judge_of(load_exercise("three-r-arm-tip")))) == []
