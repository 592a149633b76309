from dataclasses import replace
from functools import cache

import pytest

from dhcli import check, load_exercise, load_robot
from dhcli.checking.diagnosis.mistakes import BY_ID, EVERY
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.registry import read_question
from dhcli.checking.verdicts import Verdict
from dhcli.errors import UnknownNameError
from tests.judging import answer_with, checked, expected, hidden, mark, mark_sheet, slips
from tests.nightly import some

ROBOTS = ("scara", "scara-yim", "stanford", "puma560", "zhou-3r")


@cache
def about(name: str, *, numeric: bool = False) -> Exercise:
    """The pose of a robot as an exercise."""
    robot = load_robot(name)
    given = {}
    if numeric:
        from dhcli.kinematics.values import joint_values

        typed = [f"{25 + 12 * k}°" if j.kind == "revolute" else f"{0.1 + 0.05 * k}" for k, j in enumerate(robot.joints)]
        given = joint_values(robot, ",".join(typed))
    return question_about(robot, f"pose {robot.frames[1]}..{robot.frames[-2]}", numeric=numeric, given=given)


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("numeric", [False, True])
def test_each_mistake_applied_to_the_truth_is_named(name: str, *, numeric: bool) -> None:
    """Whatever one mistake makes is wrong, and among the causes named stands one that makes just that."""
    exercise = about(name, numeric=numeric)
    part = exercise.parts[0]
    every = slips(exercise, part)
    assert len(every) > 20
    tried = some(every, max(1, len(every) // 4))
    for slip in {*tried, *(slip for slip in every if slip.name == "position-as-row")}:
        answer = answer_with(exercise, part, slip.name)
        judged = mark(exercise, part, answer)
        if slip.name == "position-as-row":
            assert judged.verdict is Verdict.CANNOT_READ
            assert "yours holds the position, which belongs in the last column" in judged.remarks[0]
            continue
        assert judged.verdict in (Verdict.WRONG, Verdict.CLOSE), slip.name
        found = checked(exercise, part, answer).diagnosis
        assert found is not None, slip.name
        for cause in found.causes:
            assert len(cause) == 1
            other = answer_with(exercise, part, cause[0].name)
            assert slip.name == cause[0].name or other == answer or numeric, (slip.name, found.ids)


@pytest.mark.parametrize("name", ROBOTS)
def test_the_right_answer_has_no_diagnosis(name: str) -> None:
    """Nothing is said of what is right."""
    exercise = about(name)
    part = exercise.parts[0]
    answer = expected(exercise, part)
    assert checked(exercise, part, answer).diagnosis is None


def test_two_slips_at_once_are_named_together() -> None:
    """No single mistake gives this answer; two do."""
    exercise = load_exercise("scara-rrpr")
    part = next(one for one in exercise.parts if one.id == "t04")
    answer = "[c124 s124 0 a1*c1 - a2*c12; s124 -c124 0 a1*s1 - a2*s12; 0 0 -1 d3-d4; 0 0 0 1]"
    answer = answer.replace("c124", "c(theta1+theta2-theta4)").replace("s124", "s(theta1+theta2-theta4)")
    found = check(exercise, part.id, answer).diagnosis
    assert found is not None
    assert ("a-sign 2", "d-sign 3") in [tuple(slip.name for slip in cause) for cause in found.causes]


@pytest.mark.parametrize(
    ("name", "part", "answer", "cause"),
    [
        ("three-r-arm-tip-in-numbers", "tip", "0.1836 -0.0883 -0.1995", "thetas-unit"),
        ("planar-two-links", "x2", "-s12 c12 0", "other-axis y"),
        ("puma560-at-work-in-mm", "flange", "355.86, 378.72, -121.26", "point-forgotten"),
        ("puma560-at-work-in-mm", "wrist", "139.518, 78.807, -509.006", "thetas-swapped 1 and 2"),
    ],
)
def test_a_mistake_in_the_whole_is_named_before_what_is_far_fetched(
    name: str, part: str, answer: str, cause: str
) -> None:
    """One slip that a student makes, and no two that give the same."""
    found = check(load_exercise(name), part, answer).diagnosis
    assert found is not None
    assert found.ids == (cause,)


def test_every_twist_the_other_way_is_one_slip() -> None:
    """Not one for each row."""
    exercise = about("puma560", numeric=True)
    part = exercise.parts[0]
    found = check(exercise, part.id, answer_with(exercise, part, "alpha-signs")).diagnosis
    assert found is not None
    assert found.names == ("the sign of alpha is turned round in every row",)


def test_an_answer_that_no_mistake_explains_gets_no_name() -> None:
    """Never a guess."""
    exercise = about("scara-yim")
    answer = "[c1 s2 0 a1; s1 c2 0 a2; 0 0 1 d3*d3; 0 0 0 1]"
    assert check(exercise, "pose", answer).diagnosis is None


def test_a_part_that_is_right_from_an_earlier_wrong_one_keeps_its_credit() -> None:
    """The slip is named where it was made."""
    exercise = load_exercise("three-r-arm-tip")
    marked = mark_sheet(
        exercise,
        {
            "t12": "[c2 -s2 0 b*c2; s2 c2 0 b*s2; 0 0 1 0; 0 0 0 1]",
            "t02": "[c12 -s12 0 a*c1 + b*c12; s12 c12 0 a*s1 + b*s12; 0 0 1 0; 0 0 0 1]",
        },
    )
    marks = {one.part.id: one.mark for one in marked.parts}
    assert marks["t12"].diagnosis is not None
    assert marks["t12"].diagnosis.ids == ("misprint",)
    assert marks["t12"].earned == 0
    assert (marks["t02"].verdict, marks["t02"].earned) == (Verdict.WRONG, 1)
    assert marks["t02"].diagnosis is not None
    assert marks["t02"].diagnosis.follows == ("t12",)


def test_a_later_part_that_is_wrong_by_itself_earns_what_is_right_in_it() -> None:
    """It does not follow from the earlier answer."""
    exercise = load_exercise("three-r-arm-tip")
    answers = {"t12": "[c2 -s2 0 b*c2; s2 c2 0 b*s2; 0 0 1 0; 0 0 0 1]", "t02": "[c1 0 0 a; 0 1 0 b; 0 0 1 0; 0 0 0 1]"}
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, answers).parts}
    assert marks["t02"].earned < 1


@pytest.mark.parametrize(
    ("old", "new", "slip"),
    [
        ("- d3*s1", "+ d3*s1", "term-sign 1,4 d3*s1"),
        ("- d4*s23) - d3", "+ d4*s23) - d3", "term-sign 1,4 d4*s23"),
        ("-a2*s2 - a3*s23", "-a2*s2 + a3*s23", "term-sign 3,4 a3*s23"),
    ],
)
def test_the_sign_of_one_term_is_named(old: str, new: str, slip: str) -> None:
    """At any depth of the entry, with the term in words."""
    exercise = about("puma560")
    answer = expected(exercise, exercise.parts[0])
    assert answer.count(old) == 1
    found = check(exercise, "pose", answer.replace(old, new)).diagnosis
    assert found is not None
    assert found.ids == (slip,)
    term = slip.split(" ", 2)[2]
    assert found.names[0].startswith(f"the sign of {term} in entry (")
    assert term not in found.hints[0]


@pytest.mark.parametrize(
    ("asked", "answer", "slip"),
    [
        ("point (1, 2, 5)", "[c12 - 2*s12 + a1*c1 + a2*c12, s12 + 2*c12 + a1*s1 + a2*s12, -5]", "given-sign z"),
        ("point (1, 2, 5)", "[c12 + 2*s12 + a1*c1 + a2*c12, s12 - 2*c12 + a1*s1 + a2*s12, 5]", "given-sign y"),
        ("point (1, 2, 5)", "[-(c12 - 2*s12 + a1*c1 + a2*c12), s12 + 2*c12 + a1*s1 + a2*s12, 5]", "coordinate-sign x"),
        ("vector (1, 2, 0)", "[c12 - 2*s12, -(s12 + 2*c12), 0]", "coordinate-sign y"),
        ("vector (1, 2, 0)", "[2*s12 - c12, -(s12 + 2*c12), 0]", "direction"),
        ("position", "[-(a1*c1 + a2*c12), -(a1*s1 + a2*s12), 0]", "direction"),
    ],
)
def test_the_sign_of_a_coordinate_is_named(asked: str, answer: str, slip: str) -> None:
    """Of what was given, or of what came out."""
    exercise = about("planar-2r")
    question = read_question(f"{asked} of pose 0..2", exercise.scope)
    found = check(replace(exercise, parts=(Part("pose", question),)), "pose", answer).diagnosis
    assert found is not None
    assert slip in found.ids


def test_a_misprint_is_the_cause_only_of_what_it_explains() -> None:
    """One entry is copied from the document, another is wrong in its own right."""
    exercise = load_exercise("three-r-arm-tip")
    part = exercise.part("t12")
    assert part.printed is not None
    copied = "[c2 -s2 0 b*c2; s2 c2 0 b*s2; 0 0 1 0; 0 0 0 1]"
    found = check(exercise, "t12", copied).diagnosis
    assert found is not None
    assert found.ids == ("misprint",)
    worse = check(exercise, "t12", copied.replace("b*c2", "b*c1"))
    assert any("misprint" in remark for remark in worse.remarks)
    assert worse.diagnosis is None or worse.diagnosis.ids != ("misprint",)


def test_a_slip_in_a_table_is_named() -> None:
    """By the motion of the table typed."""
    found = check(load_exercise("three-r-arm-tip"), "table", "[a 0 0 θ1; b 90° 0 θ2; 0 0 0 θ3]").diagnosis
    assert found is not None
    assert found.ids == ("alpha-sign 2",)


def test_a_slip_in_a_count_is_named() -> None:
    """The ground that was not counted."""
    exercise = load_exercise("counting-freedoms")
    part = next(p for p in exercise.parts if slips(exercise, p))
    slip = slips(exercise, part)[0]
    found = check(exercise, part.id, answer_with(exercise, part, slip.name)).diagnosis
    assert found is not None
    assert slip.name in found.ids


def test_a_planar_arm_at_zero_hides_many_mistakes() -> None:
    """At a general pose it hides none of them."""
    robot = load_robot("scara-yim")
    from dhcli.kinematics.values import joint_values

    def at(q: str) -> set[str]:
        exercise = question_about(robot, "pose 0..4", numeric=True, given=joint_values(robot, q))
        return {slip.name for slip in hidden(exercise, exercise.parts[0])}

    at_zero, general = at("0,0,0,0"), at("25°,40°,0.1,65°")
    assert {"theta-sign 1", "theta-sign 2"} <= at_zero
    assert "theta-sign 1" not in general
    assert len(general) < len(at_zero)


def test_an_unknown_mistake_is_refused_with_the_nearest() -> None:
    """Authors mistype too."""
    exercise = about("puma560")
    with pytest.raises(UnknownNameError, match="alpha-sine 2") as caught:
        answer_with(exercise, exercise.parts[0], "alpha-sine 2")
    assert "alpha-sign 2" in caught.value.problems[0].hint


def test_words_say_the_place_as_a_person_would() -> None:
    """The two halves of a place stand where they belong."""
    added = BY_ID["offset-added"].slip("2 90°").words
    assert added == "theta of row 2, which has no offset, has 90° added"
    shift = BY_ID["shift-sign"].slip("1.2 x").words
    assert shift == "the sign of the shift along x in move 1.2 is turned round"


def test_every_record_has_a_name_of_its_own_and_tells_where_to_look() -> None:
    """Words and hint of each can be filled in."""
    assert len(BY_ID) == len(EVERY)
    for mistake in EVERY:
        slip = mistake.slip("1,4 a2*c2")
        assert slip.words
        assert slip.hint not in ("", slip.words)
        assert "{" not in slip.words + slip.hint


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        ("0 -1 0 8; 0 0 1 -6; -1 0 0 14; 0 0 0 1", "factors-swapped 2 and 3"),  # Trans Rot(z) Rot(y)
        ("0 0 1 14; 1 0 0 8; 0 1 0 -6; 0 0 0 1", "first-last"),  # Rot(y) Rot(z) Trans
        ("0 0 1 14; 1 0 0 -6; 0 1 0 -8; 0 0 0 1", "factors-swapped 1 and 2"),  # Rot(y) Trans Rot(z)
        ("0 -1 0 6; 0 0 1 14; -1 0 0 -8; 0 0 0 1", "order-reversed"),  # Rot(z) Rot(y) Trans
        ("0 -1 0 6; 0 0 1 8; -1 0 0 14; 0 0 0 1", "last-first"),  # Rot(z) Trans Rot(y)
    ],
)
def test_three_factors_in_every_wrong_order_are_named(answer: str, name: str) -> None:
    """H = Trans(8, -6, 14) Rot(y, 90°) Rot(z, 90°), worked out by hand in each of the other orders."""
    exercise = load_exercise("bajd/composed-pose")
    found = checked(exercise, exercise.part("h"), answer).diagnosis
    assert found is not None
    assert (name,) in [tuple(slip.name for slip in cause) for cause in found.causes]
