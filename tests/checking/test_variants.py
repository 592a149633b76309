"""Numbers drawn by a seed: the same everywhere, and never such that mistakes hide behind them."""

from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import islice

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking import variants as drawing
from dhcli.checking.degenerate import flaw
from dhcli.checking.diagnosis import bench
from dhcli.checking.diagnosis.search import Search, search_of
from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.verdicts import Verdict
from dhcli.checking.written import Range
from dhcli.errors import DhcliError
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number
from tests.judging import expected, hidden, judge_of, mark, vary
from tests.nightly import NIGHT, examples, in_turn

VARIED = ("yim/planar-in-numbers", "yim/scara-in-numbers", "yim/stanford-in-numbers", "zhou/three-r-arm-tip-in-numbers")
SEEDS = [str(number) for number in range(1, 41 if NIGHT else 7)]
FIFTY = [str(number) for number in range(1, 51 if NIGHT else 13)]


@cache
def variant(name: str, seed: str) -> Exercise:
    """A variant of an exercise, drawn once for all tests."""
    return vary(load_exercise(name), seed)


varied = pytest.mark.parametrize("name", VARIED)


def angles(*values: int) -> Range:
    """A range of angles in degrees."""
    return Range("", tuple(Angle.in_degrees(value) for value in values))


def lengths(*values: str) -> Range:
    """A range of lengths in metres."""
    return Range("", tuple(Number(Fraction(value)) for value in values))


def given_of(exercise: Exercise) -> dict[str, str]:
    """What an exercise gives, exactly, as text."""
    return {
        name: str(value.degrees) if isinstance(value, Angle) else str(value.value)
        for name, value in exercise.given.items()
        if isinstance(value, Angle | Number)
    }


def hides(exercise: Exercise) -> frozenset[tuple[str, str]]:
    """The mistakes that an exercise hides, each by its part and its name."""
    return frozenset((part.id, slip.name) for part in exercise.parts for slip in hidden(exercise, part))


def test_a_seed_always_gives_the_same_numbers() -> None:
    """Written down once: whoever changes them takes the numbers away from a class that has begun."""
    planar, stanford = load_exercise("yim/planar-in-numbers"), load_exercise("yim/stanford-in-numbers")
    assert given_of(vary(planar, "alice")) == {"theta1": "35", "theta2": "60"}
    assert given_of(vary(stanford, "alice")) == {
        "theta1": "50",
        "theta2": "25",
        "d3": "7/10",
        "theta4": "30",
        "theta5": "20",
        "theta6": "-55",
    }


def test_the_same_text_is_the_same_seed() -> None:
    """An é may be one character or two, and blanks around a name mean nothing."""
    planar = load_exercise("yim/planar-in-numbers")
    assert vary(planar, " Rene\u0301 ").given == vary(planar, "Ren\u00e9").given


def test_the_numbers_do_not_depend_on_how_the_exercise_is_called() -> None:
    """By the id of the library, or by the path of its file."""
    planar = load_exercise("yim/planar-in-numbers")
    assert vary(replace(planar, id="planar-in-numbers"), "alice").given == vary(planar, "alice").given


def test_students_get_different_numbers() -> None:
    """And each name is drawn on its own."""
    drawn = [given_of(variant("yim/stanford-in-numbers", seed)) for seed in SEEDS]
    assert len({tuple(one.values()) for one in drawn}) == len(drawn)
    assert len({(one["theta1"], one["theta2"]) for one in drawn}) > len(drawn) / 2


@varied
def test_every_drawn_value_is_one_of_its_range(name: str) -> None:
    """What does not vary stays as it is, and the file's own numbers are untouched."""
    exercise = load_exercise(name)
    for seed in SEEDS:
        drawn = variant(name, seed)
        assert drawn.variant == seed
        for key, value in drawn.given.items():
            assert value in exercise.variants[key].values if key in exercise.variants else value == exercise.given[key]
    assert exercise.variant == ""


@varied
def test_the_solution_of_every_variant_is_right(name: str) -> None:
    """And that of another variant is not, in one part at least."""
    exercise = load_exercise(name)
    first = vary(exercise, "first")
    for seed in in_turn(SEEDS[:10], 0, 2):
        drawn = variant(name, seed)
        answers = {part.id: expected(drawn, part) for part in drawn.parts}
        assert {mark(drawn, part, answers[part.id]).verdict for part in drawn.parts} == {Verdict.RIGHT}
        assert any(mark(first, part, answers[part.id]).verdict is not Verdict.RIGHT for part in first.parts)


@varied
@examples(0.3 if NIGHT else 0.15)
@given(seed=st.text(min_size=1, max_size=20).filter(lambda text: text.strip().isprintable() and text.strip() != ""))
def test_no_draw_is_degenerate(name: str, seed: str) -> None:
    """No angle is a right one or half of one, and no two differ by one or add up to it."""
    drawn = vary(load_exercise(name), seed)
    q = [value.degrees for value in drawn.given.values() if isinstance(value, Angle)]
    assert all(angle % 45 for angle in q)
    assert all((a - b) % 90 and (a + b) % 90 for i, a in enumerate(q) for b in q[:i])


@pytest.mark.parametrize(
    ("variants", "what"),
    [
        ({"theta1": angles(90)}, "theta1 is a multiple of 45°"),
        ({"theta1": angles(45)}, "theta1 is a multiple of 45°"),
        ({"theta1": angles(135)}, "theta1 is a multiple of 45°"),
        ({"theta1": angles(-45)}, "theta1 is a multiple of 45°"),
        ({"theta1": angles(30), "a1": lengths("0.3")}, "a1 and a2 are equal"),
        ({"a1": lengths("0")}, "a1 is 0"),
    ],
)
def test_a_pose_that_hides_mistakes_is_never_drawn(variants: dict[str, Range], what: str) -> None:
    """Where there is no other, the error names the ranges."""
    exercise = replace(load_exercise("yim/planar-in-numbers"), variants=variants)
    with pytest.raises(DhcliError, match="1000 draws gave no pose at which mistakes show") as caught:
        vary(exercise, "alice")
    assert what in caught.value.problems[0].message
    assert "widen the variants, " in caught.value.problems[0].hint


def test_joints_that_add_up_to_a_right_angle_are_never_drawn() -> None:
    """Sine of one is cosine of the other."""
    exercise = load_exercise("yim/planar-in-numbers")
    drawn = replace(exercise, variants={"theta1": angles(60)}, given={"theta1": Angle.in_degrees(60)} | exercise.given)
    assert flaw(replace(drawn, given={"theta1": Angle.in_degrees(60), "theta2": Angle.in_degrees(30)})) == (
        "theta1 and theta2 add up to a multiple of 90°"
    )
    assert flaw(replace(drawn, given={"theta1": Angle.in_degrees(115), "theta2": Angle.in_degrees(25)})) == (
        "theta1 and theta2 differ by a multiple of 90°"
    )


@varied
def test_no_mistake_hides_behind_a_draw(name: str) -> None:
    """Every mistake that some student of fifty could be caught at, all of them can."""
    found = [hides(variant(name, seed)) for seed in in_turn(FIFTY, 0, 5)]
    assert set(found) == {frozenset.intersection(*found)}


def test_the_rules_alone_would_let_mistakes_hide() -> None:
    """So that the draws are looked at one by one: variant 9 of the SCARA is not the first that breaks no rule."""
    scara = load_exercise("yim/scara-in-numbers")
    first = [next(drawing._fair(judge_of(scara), seed)).exercise for seed in FIFTY]
    hiding = [drawn for drawn in first if hides(drawn)]
    assert 0 < len(hiding) < len(first) / 4
    for drawn in hiding:
        assert vary(scara, drawn.variant).given != drawn.given
    assert any(vary(scara, drawn.variant).given == drawn.given for drawn in first)


def test_what_the_question_itself_hides_stops_no_draw() -> None:
    """Joint 2 stands at a right angle for everybody: the first draw is as good as any other."""
    planar = load_exercise("yim/planar-in-numbers")
    fixed = {**planar.given, "theta2": Angle.in_degrees(90)}
    exercise = replace(planar, given=fixed, variants={"theta1": angles(*range(20, 45, 4))})
    found = [hides(vary(exercise, seed)) for seed in in_turn(FIFTY, 0, 3)]
    assert found[0]
    assert set(found) == {frozenset.intersection(*found)}
    assert vary(exercise, "alice").given == next(drawing._fair(judge_of(exercise), "alice")).exercise.given


def test_where_every_draw_hides_something_the_one_that_hides_least_is_taken() -> None:
    """At a tolerance of 20 mm, one of two poses hides one mistake and the other more."""
    planar = load_exercise("yim/planar-in-numbers")
    coarse = replace(planar, tolerance=replace(planar.tolerance, position=0.02))
    exercise = replace(coarse, variants={"theta1": angles(30), "theta2": angles(20, 55)})
    poses = [replace(exercise, given={"theta1": Angle.in_degrees(30), "theta2": Angle.in_degrees(q)}) for q in (20, 55)]
    worse, better = (judge_of(pose).unclear() for pose in poses)
    assert len(worse) > len(better) == 1
    assert not worse & better
    assert {given_of(vary(exercise, seed))["theta2"] for seed in FIFTY} == {"55"}


def test_a_counted_number_of_draws_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """However much each of them hides; the same numbers are looked at once."""
    planar = load_exercise("yim/planar-in-numbers")
    looked: list[dict[str, str]] = []
    monkeypatch.setattr(
        drawing,
        "hidden_by_numbers",
        lambda drawn, _: looked.append(given_of(drawn.exercise)) or {("tip", "transposed")},
    )
    taken = vary(planar, "alice")
    fair = [
        given_of(drawn.exercise) for drawn in islice(drawing._fair(judge_of(planar), "alice"), drawing.MOST_LOOKED_AT)
    ]
    assert looked == [one for k, one in enumerate(fair) if one not in fair[:k]]
    assert given_of(taken) == fair[0]


@varied
def test_a_search_that_is_moved_to_a_draw_is_that_of_the_draw(name: str) -> None:
    """The same mistakes, and each leads to the same numbers, whether or not most of the work was done before."""
    exercise = load_exercise(name)
    for seed in in_turn(SEEDS[:5], VARIED.index(name), 4):
        drawn = variant(name, seed)
        for question in {part.question for part in drawn.parts if isinstance(part.question, MatrixQuestion)}:
            afresh, moved = (
                Search(Memo(drawn), question),
                Search(Memo(drawn), question, search_of(question, judge_of(exercise).memo)),
            )
            assert [one.slips for one in moved.singles] == [one.slips for one in afresh.singles]
            assert [moved.entries(one.work) for one in moved.singles] == [
                afresh.entries(one.work) for one in afresh.singles
            ]


def test_what_draws_share_stays_in_its_bounds(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many values the ranges of a class have; what was forgotten is worked out again."""
    monkeypatch.setattr(bench, "MOST_KNOWN", 7)
    exercise = replace(load_exercise("yim/planar-in-numbers"))  # one that shares nothing with the other tests
    question = next(part.question for part in exercise.parts if isinstance(part.question, MatrixQuestion))
    shared = search_of(question, judge_of(exercise).memo)
    for seed in SEEDS[:5]:
        drawn = vary(exercise, seed)
        afresh, moved = Search(Memo(drawn), question), Search(Memo(drawn), question, shared)
        assert len(shared.folds._known) <= 7
        assert [moved.entries(one.work) for one in moved.singles] == [
            afresh.entries(one.work) for one in afresh.singles
        ]


def test_no_arm_is_drawn_near_a_singularity() -> None:
    """Fifty variants of the arm that has singular poses in its range, by numpy's singular values."""
    arms = [variant("yim/stanford-in-numbers", seed) for seed in FIFTY]
    weakest = [np.linalg.svd(_jacobian(arm), compute_uv=False)[-1] for arm in arms]
    assert min(weakest) > 0.03


@pytest.mark.parametrize(("theta5", "near"), [(1, True), (2, True), (43, False), (67, False)])
def test_a_pose_near_a_singularity_is_never_drawn(theta5: int, *, near: bool) -> None:
    """The wrist of the Stanford arm is singular where joint 5 is straight; numpy's singular values agree."""
    stanford = load_exercise("yim/stanford-in-numbers")
    pose = {"theta1": 20, "theta2": 55, "theta4": 40, "theta5": theta5, "theta6": -65}
    drawn = replace(stanford, given={**stanford.given, **{name: Angle.in_degrees(q) for name, q in pose.items()}})
    assert (flaw(drawn) == "the arm is near a singularity") is near
    assert (np.linalg.svd(_jacobian(drawn), compute_uv=False)[-1] < 0.03) is np.bool_(near)


def _jacobian(exercise: Exercise) -> np.ndarray:
    """The Jacobian of the end frame by differences of poses, lengths in units of half a metre."""
    from dhcli.kinematics.forward import forward

    robot = exercise.robot
    assert robot is not None
    q = [
        value.constant() if isinstance(value, Angle) else float(value.value)
        for name in robot.variables
        if isinstance(value := exercise.given[name], Angle | Number)
    ]

    def pose(values: list[float]) -> np.ndarray:
        return forward(robot, values).matrix

    columns = []
    for k in range(len(q)):
        step = [value + 1e-6 * (i == k) for i, value in enumerate(q)]
        slope = (pose(step) - pose(q)) / 1e-6
        spin = slope[:3, :3] @ pose(q)[:3, :3].T
        columns.append([*(slope[:3, 3] / 0.5), spin[2, 1], spin[0, 2], spin[1, 0]])
    return np.array(columns).T


@pytest.mark.parametrize("seed", ["", "  ", "two\nlines", "x" * 101, "\x1b[2J"])
def test_what_is_no_seed_is_refused(seed: str) -> None:
    """It stands on the sheet, and in a file name."""
    with pytest.raises(DhcliError, match="the name of a variant is a short text"):
        vary(load_exercise("yim/planar-in-numbers"), seed)


def test_an_exercise_without_variants_says_so() -> None:
    """Its numbers are the same for everybody."""
    with pytest.raises(DhcliError, match="has no variants"):
        vary(load_exercise("wpi/puma560-links"), "alice")


def test_a_parameter_of_the_robot_may_vary() -> None:
    """The drawn length takes the place of the robot's own."""
    head = "format: 1\ntitle: T\nsource: S\ntask: Do it\nrobot: planar-2r\nnumeric: true\ngiven: {theta1: 30°}\n"
    text = head + "variants: {a1: 0.5 m..0.7 m step 0.1 m}\nparts:\n  - {id: x, ask: entry 1 4 of link 1}\n"
    drawn = vary(read_exercise(text, "my.yaml", "my/own"), "alice")
    length = drawn.given["a1"]
    assert isinstance(length, Number)
    assert mark(drawn, drawn.part("x"), f"{float(length.value)} cos(30°)").verdict is Verdict.RIGHT
    assert mark(drawn, drawn.part("x"), "0.4 cos(30°)").verdict is Verdict.WRONG


def test_the_library_has_exercises_with_variants() -> None:
    """These four at least."""
    with_variants = {entry.name for entry in entries(Kind.EXERCISES) if load_exercise(entry.name).variants}
    assert set(VARIED) <= with_variants


def test_what_a_document_prints_answers_the_numbers_of_the_file_alone() -> None:
    """In a variant the same answer is another number: it is no misprint, nor what anybody printed."""
    text = """\
format: 1
title: A tip
source: a test
robot: planar-2r
task: Where is the tip?
numeric: true
given: {theta1: 35°, theta2: 20°}
variants: {theta1: 20°..70° step 1°}
parts: [{id: tip, ask: position of pose 0..2}]
printed: {tip: "0.4997, 0.4752, 0"}
"""
    exercise = read_exercise(text, "test", "tip")
    drawn = vary(exercise, "alice")
    part = exercise.part("tip")
    assert part.printed is not None
    assert mark(exercise, part, part.printed.text).verdict is Verdict.RIGHT
    judged = mark(drawn, drawn.part("tip"), part.printed.text)
    assert judged.verdict is Verdict.WRONG
    assert not any("document" in remark for remark in judged.remarks)
