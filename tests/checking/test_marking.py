"""Judging: tolerances, digits, units and credit; and answers that nobody means well with."""

from __future__ import annotations

import ast
import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge, check
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.marked import SheetMark
from dhcli.checking.orientations import angle_between, not_orthonormal
from dhcli.checking.tolerance import is_rounding_of, judge, typed_decimals
from dhcli.checking.verdicts import Mark, Verdict, too_few
from dhcli.errors import DhcliError, UnknownNameError
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import forward
from dhcli.kinematics.values import joint_values
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.tree import Number, number
from dhcli.notation.writer import write
from dhcli.render.kinds import render
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from tests.judging import expected, mark, mark_sheet
from tests.nightly import NIGHT, examples, paired
from tests.row_by_row import row_by_row
from tests.strategies import polynomials

COSINE, SINE = math.cos(math.radians(75)), math.sin(math.radians(75))
X = 0.4 * math.cos(math.radians(30)) + 0.3 * COSINE
Y = 0.4 * math.sin(math.radians(30)) + 0.3 * SINE
SIZE = 0.7
"""Lengths of the planar arm [m]: 0.4 and 0.3."""

SEEN_ENOUGH = examples(0.5 if NIGHT else 0.3)


@cache
def planar(unit: str = "m", more: str = "") -> Exercise:
    """The planar arm at 30° and 45°, in numbers."""
    text = f"""
        format: 1
        title: x
        source: x
        task: x
        robot: planar-2r
        numeric: true
        unit: {unit}
        given: {{theta1: 30°, theta2: 45°}}
        {more}
        parts:
          - {{id: pose, ask: pose 0..2}}
          - {{id: rotation, ask: rotation of pose 0..2}}
          - {{id: position, ask: position of pose 0..2}}
    """
    return read_exercise(text, "planar.yaml", "planar")


def pose(angle: float = math.radians(75), x: float = X, y: float = Y) -> str:
    """A pose of the planar arm in all digits."""
    c, s = math.cos(angle), math.sin(angle)
    return f"[{c!r} {-s!r} 0 {x!r}; {s!r} {c!r} 0 {y!r}; 0 0 1 0; 0 0 0 1]"


def verdict(answer: str, part: str = "pose", exercise: Exercise | None = None) -> Verdict:
    """How the planar arm's answer is judged."""
    return check(exercise or planar(), part, answer).verdict


# ---------------------------------------------------------------------------------------------------- tolerances


@row_by_row(
    ("error", "found"),
    [
        (0.0, Verdict.RIGHT),
        (1.0, Verdict.RIGHT),
        (-1.0, Verdict.RIGHT),
        (1.0001, Verdict.CLOSE),
        (10.0, Verdict.CLOSE),
        (-10.0, Verdict.CLOSE),
        (10.0001, Verdict.WRONG),
        (math.inf, Verdict.WRONG),
        (math.nan, Verdict.WRONG),
    ],
)
def test_the_boundary_belongs_to_the_tolerance(error: float, found: Verdict) -> None:
    """RIGHT up to the tolerance, CLOSE up to ten times, WRONG beyond."""
    assert judge(5.0 + error * 0.25, 5.0, 0.25) is found


def test_a_length_is_right_within_a_thousandth_of_the_arm() -> None:
    """0.7 mm for links of 0.4 m and 0.3 m, whatever the joint values."""
    assert verdict(pose(x=X + 0.999e-3 * SIZE)) is Verdict.RIGHT
    assert verdict(pose(x=X + 1.001e-3 * SIZE)) is Verdict.CLOSE
    assert verdict(pose(x=X - 10.01e-3 * SIZE)) is Verdict.WRONG


@given(st.floats(-0.02, 0.02), st.floats(-0.02, 0.02))
@SEEN_ENOUGH
def test_metres_and_millimetres_give_the_same_verdict(dx: float, dy: float) -> None:
    """And the same credit; distances are told in the unit of the sheet."""
    metres = check(planar("m"), "pose", pose(x=X + dx, y=Y + dy))
    millimetres = check(planar("mm"), "pose", pose(x=1000 * (X + dx), y=1000 * (Y + dy)))
    assert (metres.verdict, metres.earned) == (millimetres.verdict, millimetres.earned)
    told = [re.sub(r"(-?[\d.]+) m\b", lambda m: f"{float(m[1]) * 1000:.2f} mm", one) for one in metres.remarks]
    both = [
        [re.sub(r"-?[\d.]+", lambda m: f"{float(m[0]):.2f}", one) for one in some]
        for some in (told, millimetres.remarks)
    ]
    assert both[0] == both[1]


@given(st.floats(1e-3, 1e3), st.floats(-8, 8))
@SEEN_ENOUGH
def test_a_wrong_orientation_is_as_wrong_on_a_long_arm(size: float, degrees: float) -> None:
    """Rotation and position never share a norm."""
    robot = load_robot("planar-2r")
    values = {"theta1": Angle.in_degrees(75), "theta2": Angle()}
    lengths = {"a1": Number(parse(f"{size:.9f}").value), "a2": number(0)}  # type: ignore[union-attr]
    exercise = question_about(robot, "pose 0..2", numeric=True, given={**values, **lengths})
    long = float(lengths["a1"].value)
    answer = pose(math.radians(75 + degrees), long * COSINE, long * SINE)
    rotation = check(
        planar(),
        "rotation",
        "["
        + "; ".join(row.rsplit(" ", 1)[0] for row in pose(math.radians(75 + degrees)).strip("[]").split("; ")[:3])
        + "]",
    )
    assert check(exercise, "pose", answer).verdict is rotation.verdict


def test_a_pose_of_an_arm_without_lengths_must_stay_at_the_origin() -> None:
    """A size of 0 is no tolerance of 0: what floating point leaves of a zero is a zero."""
    robot = load_robot("planar-2r")
    nothing = {name: number(0) for name in ("a1", "a2")}
    given_ = {"theta1": Angle.in_degrees(30), "theta2": Angle(), **nothing}
    exercise = question_about(robot, "pose 0..2", numeric=True, given=given_)
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    right = f"[{c} {-s} 0 6e-17; {s} {c} 0 -0; 0 0 1 0; 0 0 0 1]"
    assert check(exercise, "pose", right).verdict is Verdict.RIGHT
    assert check(exercise, "pose", right.replace("6e-17", "0.1")).verdict is Verdict.WRONG


# -------------------------------------------------------------------------------------------------------- digits


@given(st.integers(2, 6), st.data(), st.sampled_from([-1, 1]))
def test_rounding_and_cutting_off_are_recognised(places: int, draw: st.DataObject, sign: int) -> None:
    """One unit further on is neither."""
    unit = 10.0**-places
    cut = draw.draw(st.integers(12, 99)) * 10 ** (places - 2)
    part = draw.draw(st.one_of(st.floats(0.01, 0.49), st.floats(0.51, 0.99)))
    truth, rounded = (cut + part) * unit, cut + round(part)

    def typed(units: int) -> bool:
        expr = parse(f"{sign * units * unit:.{places}f}")
        return is_rounding_of(expr, sign * truth)

    assert typed(rounded)
    assert typed(cut)
    assert not typed(cut + 2)
    assert not typed(cut - 1)


@pytest.mark.parametrize("text", ["0.9", "1.", "1", "0.05", "0.00"])
def test_less_than_two_significant_decimals_are_no_rounding(text: str) -> None:
    """Whoever types 0.9 may have guessed."""
    assert not is_rounding_of(parse(text), float(text))


@pytest.mark.parametrize(("text", "places"), [("0.50", 2), ("-0.500", 3), ("1/2", None), ("7", None), ("0.5*a1", None)])
def test_digits_typed_are_counted(text: str, places: int | None) -> None:
    """Zeros at the end count."""
    assert typed_decimals(parse(text)) == places


@given(st.integers(2, 3))
def test_fewer_digits_than_the_tolerance_wants_are_rounded_and_earn_all(places: int) -> None:
    """ROUNDED asks for more digits; the work was done."""
    exercise = planar(more="tolerance: {rotation: 0.00001, position: 0.01 mm}")
    cells = (COSINE, -SINE, X, SINE, COSINE, Y)
    c, s, x, sn, cn, y = (f"{value:.{places}f}" for value in cells)
    judged = check(exercise, "pose", f"[{c} {s} 0 {x}; {sn} {cn} 0 {y}; 0 0 1 0; 0 0 0 1]")
    assert (judged.verdict, judged.earned) == (Verdict.ROUNDED, 1)


FEW = too_few(None)


@pytest.mark.parametrize(
    ("answer", "verdict", "remark"),
    [
        ("0.3 0.36 -0.11", Verdict.ROUNDED, "right to the digits typed"),  # 0.3 for 0.299 is within the tolerance
        ("0.30 0.36 -0.11", Verdict.ROUNDED, "right to the digits typed"),
        ("0.3 0.4 -0.1", Verdict.ROUNDED, FEW),
        ("0.3 0.3 -0.1", Verdict.ROUNDED, FEW),  # cut off
        ("0.3 0.5 -0.1", Verdict.WRONG, ""),
    ],
)
def test_digits_that_are_right_but_too_few_are_told_as_such(answer: str, verdict: Verdict, remark: str) -> None:
    """An entry within the tolerance needs no second digit; one digit for an entry outside is no proof of work."""
    judged = check(load_exercise("zhou/three-r-arm-tip-in-numbers"), "tip", answer)
    assert judged.verdict is verdict
    assert any(said.startswith(remark) for said in judged.remarks) or not remark
    assert judged.is_too_short == (remark == FEW)
    assert (judged.earned == 1) == (verdict is Verdict.ROUNDED and remark != FEW)


@pytest.mark.parametrize("degrees", range(5, 90, 5))
def test_two_decimals_are_rounded_however_small_an_entry_is(degrees: int) -> None:
    """Such as 0.09 beside 1.00; with one decimal they are too few."""
    robot = load_robot("planar-2r")
    exercise = question_about(robot, "pose 0..2", numeric=True, given=joint_values(robot, f"0,{degrees}°"))
    for places, is_enough in ((2, True), (1, False)):
        rows = forward(robot, (0, math.radians(degrees))).rows
        answer = "; ".join(" ".join(f"{float(entry):.{places}f}" for entry in row) for row in rows)
        judged = check(exercise, "pose", answer)
        assert judged.verdict in (Verdict.RIGHT, Verdict.ROUNDED)
        assert judged.is_too_short is not is_enough
        assert (judged.earned == 1) is is_enough


@pytest.mark.parametrize("degrees", range(5, 90, 5))
def test_two_decimals_are_as_many_in_a_jacobian(degrees: int) -> None:
    """One rule for the entries of every kind of answer: 0.03 beside -0.31 is 0.0261, 0.0 beside 0.3 is nothing."""
    robot = load_robot("articulated")
    given = joint_values(robot, f"{degrees}°,10°,5°")
    exercise = question_about(robot, "jacobian linear of 0..3", numeric=True, given=given)
    judge = Judge(exercise)
    rows = ast.literal_eval(judge.expected(exercise.parts[0]))
    for places, is_enough in ((2, True), (1, False)):
        answer = "; ".join(" ".join(f"{entry:.{places}f}" for entry in row) for row in rows)
        judged = judge.check(exercise.parts[0], answer)
        assert judged.verdict in (Verdict.RIGHT, Verdict.ROUNDED)
        assert judged.is_too_short is not is_enough
        assert (judged.earned == 1) is is_enough


@pytest.mark.parametrize(
    ("sheet", "part", "answer", "verdict", "is_short"),
    [
        ("motion/planar-rates-in-numbers", "w", "0.1", Verdict.ROUNDED, True),  # 0.11276
        ("motion/planar-rates-in-numbers", "w", "0.11", Verdict.ROUNDED, False),
        ("motion/planar-rates-in-numbers", "w", "0.2", Verdict.WRONG, False),
        ("motion/planar-rates-in-numbers", "jacobian", "-0.4 -0.3; 0.3 0.0; 0 0", Verdict.ROUNDED, True),
        ("motion/planar-rates-in-numbers", "jacobian", "-0.4 -0.3; 0.3 0.1; 0 0", Verdict.WRONG, False),
    ],
)
def test_one_decimal_is_too_few_in_every_kind_of_answer(
    sheet: str, part: str, answer: str, verdict: Verdict, *, is_short: bool
) -> None:
    """A single number and the entries of a Jacobian as well as those of a matrix."""
    judged = check(load_exercise(sheet), part, answer)
    assert (judged.verdict, judged.is_too_short, judged.earned < 1) == (
        verdict,
        is_short,
        verdict is not Verdict.ROUNDED or is_short,
    )


@given(st.integers(-179, 180), st.integers(0, 5), st.sampled_from([-0.3, -0.2, 0.2, 0.3]))
@examples(1 if NIGHT else 0.5)
def test_an_entry_that_is_no_rounding_of_the_truth_is_wrong_however_few_digits_it_has(
    degrees: int, at: int, off: float
) -> None:
    """Two tenths are more than any rounding or cutting off to one decimal leaves out."""
    robot = load_robot("planar-2r")
    exercise = question_about(robot, "pose 0..2", numeric=True, given=joint_values(robot, f"{degrees}°,30°"))
    rows = [list(map(float, row)) for row in forward(robot, (math.radians(degrees), math.radians(30))).rows]
    row, column = at // 3, (0, 1, 3)[at % 3]
    rows[row][column] += off
    answer = "; ".join(" ".join(f"{entry:.1f}" for entry in line) for line in rows)
    judged = check(exercise, "pose", answer)
    assert not judged.is_too_short
    assert judged.verdict in (Verdict.WRONG, Verdict.CLOSE)


# ------------------------------------------------------------------------------------------------------ geometry


NOT_SHARP = "the axes point the right way, but their direction cosines need more digits"


@pytest.mark.parametrize(
    ("digits", "shift", "verdict", "remarks"),
    [
        ("0.7058", "0.2121", Verdict.CLOSE, (NOT_SHARP,)),
        ("0.7058", "0.2", Verdict.WRONG, (NOT_SHARP, "the position is off by -0.0121 m along x, -0.0121 m along y")),
        ("0.7", "0.3", Verdict.WRONG, (NOT_SHARP, "the position is off by 0.0879 m along x, 0.0879 m along y")),
        ("0.7", "0.2", Verdict.ROUNDED, (FEW,)),
    ],
)
def test_too_few_digits_are_no_turned_orientation(
    digits: str, shift: str, verdict: Verdict, remarks: tuple[str, ...]
) -> None:
    """No angle of 0° is told; the position is spoken of where it is wrong, too."""
    answer = f"{digits} -{digits} 0 {shift}; {digits} {digits} 0 {shift}; 0 0 1 0; 0 0 0 1"
    judged = check(load_exercise("planar-in-numbers"), "a2", answer)
    assert (judged.verdict, judged.remarks) == (verdict, remarks)


@example(0.99999, "mm")
@given(st.floats(1e-3, 100), st.sampled_from(["m", "cm", "mm"]))
def test_a_distance_is_told_to_three_digits(metres: float, unit: str) -> None:
    """Or to a hundredth of a millimetre, where that is less; whole numbers keep their digits."""
    text, behind = replace(load_exercise("planar-in-numbers"), unit=unit).about(-metres).split()
    shown = metres / {"m": 1, "cm": 0.01, "mm": 0.001}[behind]
    assert behind == unit
    assert float(text) == pytest.approx(-shown, rel=0.005 + 1e-9)
    assert len(text.lstrip("-0.").replace(".", "")) <= max(3, len(str(round(shown))))


@given(st.floats(-math.pi, math.pi), st.floats(-math.pi, math.pi))
def test_the_angle_between_two_orientations_is_that_of_the_turn_between_them(first: float, second: float) -> None:
    """Small angles keep their digits."""

    def about_z(angle: float) -> list[list[float]]:
        c, s = math.cos(angle), math.sin(angle)
        return [[c, -s, 0], [s, c, 0], [0, 0, 1]]

    turned = abs((second - first + math.pi) % (2 * math.pi) - math.pi)
    assert angle_between(about_z(first), about_z(second)) == pytest.approx(turned, abs=1e-12)
    assert not_orthonormal(about_z(first)) == ""


@pytest.mark.parametrize(
    ("rotation", "said"),
    [
        ([[2, 0, 0], [0, 1, 0], [0, 0, 1]], "column 1 has length 2"),
        ([[1, 0, 0], [0, 1, 1], [0, 0, 0]], "columns 2 and 3 are not perpendicular"),
        ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], "left-handed"),
    ],
)
def test_what_is_no_rotation_is_said_first(rotation: list[list[float]], said: str) -> None:
    """With the columns at fault."""
    assert said in not_orthonormal(rotation)


# ------------------------------------------------------------------------------------------------------- symbols

FORMULAS = """
format: 1
title: x
source: x
task: x
names: [theta1, theta2, theta3, theta4, a1, a2, d3, d4]
parts:
  - {id: short, ask: "scalar a1*cos(theta1 + theta2) - d3*sin(theta3)"}
"""


@cache
def formulas() -> Exercise:
    """One expression in four angles and four lengths."""
    return read_exercise(FORMULAS, "formulas.yaml", "formulas")


@given(polynomials)
@SEEN_ENOUGH
def test_what_cancels_does_not_matter(extra: object) -> None:
    """An expression with anything added and taken away again is the same."""
    text = write(extra, "full")  # type: ignore[arg-type]
    assume(len(text) < 300)
    judged = check(formulas(), "short", f"({text}) + a1*cos(theta1+theta2) - d3*sin(theta3) - ({text})")
    assert judged.verdict in (Verdict.RIGHT, Verdict.CANNOT_READ)
    assert judged.verdict is Verdict.RIGHT or any("zero" in r or "large" in r for r in judged.remarks), judged.remarks


@given(polynomials)
@SEEN_ENOUGH
def test_what_does_not_cancel_is_wrong(extra: object) -> None:
    """However small: a billionth of something is not nothing."""
    text = write(extra, "full")  # type: ignore[arg-type]
    assume(len(text) < 300)
    nothing = check(formulas(), "short", f"a1*cos(theta1+theta2) - d3*sin(theta3) + ({text})")
    doubled = check(formulas(), "short", f"a1*cos(theta1+theta2) - d3*sin(theta3) + 2*({text})")
    assert nothing.verdict is doubled.verdict  # both are right if the extra is 0, else both are wrong
    billionth = check(formulas(), "short", f"a1*cos(theta1+theta2) - d3*sin(theta3) + ({text})/10^9")
    assert billionth.verdict is nothing.verdict


# -------------------------------------------------------------------------------------------------------- sheets


def test_a_sheet_is_as_good_as_its_worst_part() -> None:
    """And earns the credit of each."""
    exercise = planar()
    answers = {"pose": pose(), "rotation": "[1 0 0; 0 1 0; 0 0 1]"}
    marked = mark_sheet(exercise, answers)
    words = [one.mark.verdict for one in marked.parts]
    assert words == [Verdict.RIGHT, Verdict.WRONG, Verdict.SKIPPED]
    assert (marked.verdict, marked.earned, marked.credit) == (Verdict.WRONG, 1, 3)


def test_one_part_of_a_sheet_is_judged_alone() -> None:
    """The others are not even skipped."""
    marked = mark_sheet(planar(), {"pose": pose()}, only="pose")
    assert [one.part.id for one in marked.parts] == ["pose"]
    assert marked.verdict is Verdict.RIGHT


@pytest.mark.parametrize("wrong", [{"answers": {"pse": "1"}, "only": None}, {"answers": {}, "only": "pse"}])
def test_an_unknown_part_is_refused_with_the_nearest(wrong: dict[str, object]) -> None:
    """In a sheet as in the option."""
    with pytest.raises(UnknownNameError, match="no part pse") as caught:
        mark_sheet(planar(), **wrong)  # type: ignore[arg-type]
    assert "pose" in caught.value.problems[0].hint


def test_an_exercise_whose_robot_lacks_lengths_says_so() -> None:
    """That is the author's fault and no verdict on the student."""
    robot = load_robot("dh-link")
    exercise = question_about(robot, "pose 0..1", numeric=True, given={"theta_i": Angle()})
    with pytest.raises(DhcliError, match="has no value for a_i"):
        check(exercise, "pose", "[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]")


# ------------------------------------------------------------------------------------------- whatever people type


@cache
def parts() -> tuple[tuple[Exercise, Part], ...]:
    """Every part of every exercise."""
    found = [load_exercise(entry.name) for entry in entries(Kind.EXERCISES)]
    return tuple((exercise, part) for exercise in found for part in exercise.parts)


@cache
def right_answer(index: int) -> str:
    """What would be right; nothing where a table has no own spelling."""
    exercise, part = parts()[index]
    try:
        return expected(exercise, part)
    except DhcliError:
        return ""


indices = st.deferred(lambda: st.integers(0, len(parts()) - 1))
LETTERS = "acdsxqθαπ√°12345670.,;:&|\\/*^+-_=()[]{}\"' \n\te"
texts = st.one_of(
    st.text(max_size=60),
    st.text(alphabet=LETTERS, max_size=60),
    st.lists(
        st.sampled_from(
            [
                *(
                    "c1",
                    "s12",
                    "-",
                    "+",
                    "*",
                    "/",
                    "^",
                    "(",
                    ")",
                    "[",
                    "]",
                    "{",
                    "}",
                    ";",
                    ",",
                    "&",
                    "\\\\",
                    "\n",
                    " ",
                    "0",
                ),
                *(
                    "1",
                    "90°",
                    "mm",
                    "m",
                    "rad",
                    "pi",
                    "sqrt(",
                    "\\frac{",
                    "\\begin{bmatrix}",
                    "\\end{bmatrix}",
                    "cos",
                    "=",
                ),
                *(
                    "Rot(z, ",
                    "Trans(",
                    "inv(",
                    "theta1",
                    "\\theta_1",
                    "a1",
                    "_",
                    "1e9",
                    "1e-9",
                    "0.5",
                    "atan2(",
                    "array(",
                ),
            ]
        ),
        max_size=25,
    ).map("".join),
)


def sane(judged: Mark) -> None:
    """What holds of every judgement."""
    assert isinstance(judged, Mark)
    assert 0 <= judged.earned <= 1
    if judged.verdict.passed or judged.verdict is Verdict.ROUNDED:
        assert judged.earned == 1
    if judged.verdict in (Verdict.CANNOT_READ, Verdict.SKIPPED):
        assert judged.earned == 0
    if judged.verdict is Verdict.CANNOT_READ:
        assert judged.remarks
        assert all(judged.remarks)


def shown(exercise: Exercise, part: Part, judged: Mark) -> str:
    """The judgement as a terminal shows it."""
    from dhcli.checking.marked import PartMark

    text = render("marks", SheetMark(exercise, (PartMark(part, judged),)), Look(paper=Paper()))
    assert part.heading(exercise).split("\n")[0][:10] in text
    return text


@given(indices, texts)
@examples(4 if NIGHT else 2)
def test_any_text_for_any_part_is_judged(index: int, text: str) -> None:
    """Never an exception, and nothing that would steer a terminal comes back."""
    exercise, part = parts()[index]
    judged = mark(exercise, part, text)
    sane(judged)
    assert shown(exercise, part, judged).replace("\n", "").isprintable()


@given(indices, st.data())
@examples(2.5)
def test_a_right_answer_with_a_slip_of_the_finger_is_judged(index: int, draw: st.DataObject) -> None:
    """Letters lost, doubled, exchanged or put in."""
    exercise, part = parts()[index]
    text = list(right_answer(index)[:400])
    for _ in range(draw.draw(st.integers(1, 4))):
        at = draw.draw(st.integers(0, len(text)))
        text[at : at + draw.draw(st.integers(0, 3))] = draw.draw(st.text(alphabet=LETTERS, max_size=3))
    judged = mark(exercise, part, "".join(text))
    sane(judged)
    assert shown(exercise, part, judged).replace("\n", "").isprintable()


@pytest.mark.parametrize(
    "blank", ["", " ", "\n", "_", "_ _ _\n_ _ _", "[]", "[[]]", "?", "-", "–", "...", "…", "( )", "\t"]
)
def test_a_blank_is_skipped_for_every_kind(blank: str) -> None:
    """A dash is no zero."""
    for exercise, part in parts()[::5]:
        assert mark(exercise, part, blank).verdict is Verdict.SKIPPED


HOSTILE = {
    "too long": "1 " * 150_000,
    "brackets": "[" * 12_000 + "1" + "]" * 12_000,
    "open brackets": "(" * 24_000,
    "sum": "1" + "+1" * 12_000,
    "signs": "-" * 24_000,
    "powers": "2" + "^2" * 12_000,
    "tower": "9**9**9**9**9",
    "factorial": "9!!!!!!",
    "sum to the 64th": "(c1+s1+a1+a2)^64",
    "power of a power": "((c1+s1)^64)^64",
    "product of sums": "*".join(["(c1+s2)"] * 200),
    "quotient of sums": "/".join(["(c1+s2)"] * 200),
    "roots": "√" * 24_000,
    "functions": "cos(" * 6_000,
    "fractions": "\\frac{" * 6_000,
    "environments": "\\begin{bmatrix}" * 4_000,
    "digits": "9" * 24_000,
    "exponent": "1e" + "9" * 50,
    "blanks and a caret": "^" + " " * 24_000 + "x",
    "blanks and an axis": "x" + " " * 24_000 + "!",
    "screen brackets": "⎡" * 24_000,
    "separators": ",;" * 12_000,
    "bars": "|" * 24_000,
    "equals": "x=" * 12_000,
    "one long name": "c1s2" * 15_000,
    "named numbers": "x = 1, " * 8_000,
    "halves": "v = (1, 2, 3), " * 4_000,
    "minutes": "2°28" * 12_000,
    "degrees in words": "2 deg 28 min " * 4_000,
    "words": "the answer is " * 4_000,
    "moves": "Rot(z, 1)" * 5_000,
    "inverses": "inv(" * 6_000,
    "unit vectors": "i+" * 12_000,
    "primes": "'" * 24_000,
    "escapes": "\x1b[31m\x1b]0;owned\x07\x9b2J" * 100,
    "direction of writing": "\u202e\u2066\u200f" * 100,
    "surrogate": "\ud800",
    "zero width": "\u200b" * 6_000,
    "rich markup": "[bold red]RIGHT[/] [link=http://x.org]x[/link]",
    "division by zero": "1/(c1-c1)",
    "hidden division by zero": "a1/(c1^2+s1^2-1)",
    "tangent of a right angle": "tan(90°)",
    "overflow": "(10^60)^64",
    "underflow": "(10^-60)^64",
}


@pytest.mark.parametrize(("name", "index_of_kind"), paired([*HOSTILE], range(12)))
def test_hostile_texts_end_at_a_cap(name: str, index_of_kind: int) -> None:
    """For one part of each kind, with a message, and without a control character on the way out."""
    exercise, part = one_of_each_kind()[index_of_kind]
    text = HOSTILE[name]
    if isinstance(part.question, TableQuestion) and len(text) < 256_000:
        text = text[:2_000]  # taking a table's dress off is quadratic in a few spellings
    judged = mark(exercise, part, text)
    sane(judged)
    assert judged.verdict in (Verdict.CANNOT_READ, Verdict.WRONG, Verdict.SKIPPED)
    assert shown(exercise, part, replace(judged, reading=judged.reading[:1000])).replace("\n", "").isprintable()


@cache
def one_of_each_kind() -> tuple[tuple[Exercise, Part], ...]:
    """A part of each kind of question."""
    wanted = [
        ("yim/planar-two-links", "a1"),
        ("yim/planar-two-links", "d02"),
        ("yim/planar-two-links", "table"),
        ("yim/planar-two-links", "blocks"),
        ("yim/planar-in-numbers", "t02"),
        ("yim/scara-in-numbers", "turn"),
        ("yim/scara-in-numbers", "heading"),
        ("yim/dh-factors", "order"),
        ("yim/planar-linkages", "f4"),
        ("yim/standard-configurations", "height"),
        ("inverse/planar-joints-in-numbers", "all"),
        ("motion/planar-jacobian", "whole"),
    ]
    return tuple((load_exercise(name), load_exercise(name).part(part)) for name, part in wanted)


@pytest.mark.parametrize(
    "code",
    [
        "__import__('pathlib').Path({path!r}).touch()",
        "[[__import__('os').system('touch {path}')]]",
        "exec(\"open({path!r}, 'w')\")",
        "eval(compile(\"open({path!r}, 'w')\", '', 'eval'))",
        "$(touch {path})",
        "`touch {path}`",
        "; touch {path}",
        "!!python/object/apply:os.system ['touch {path}']",
        "{{{{ ''.__class__.__mro__[1].__subclasses__() }}}}",
        "Symbol('x').__init__.__globals__['__builtins__']['open']({path!r}, 'w')",
        "sympify(\"open({path!r}, 'w')\")",
    ],
)
def test_code_is_never_run(code: str, tmp_path: Path) -> None:
    """Neither Python nor shell nor YAML."""
    path = tmp_path / "touched"
    for exercise, part in one_of_each_kind():
        judged = mark(exercise, part, code.format(path=str(path)))
        assert judged.verdict is Verdict.CANNOT_READ
    assert list(tmp_path.iterdir()) == []


def test_a_misprint_does_not_give_the_right_entry_away() -> None:
    """Who copies the document is told whose slip it is; what is right only where the exercise shows it."""
    exercise = load_exercise("yim/planar-two-links")
    part = exercise.part("a1")
    assert part.printed is not None
    remark = "entry (2,4) is what the document prints; it is a misprint"
    assert mark(exercise, part, part.printed.text).remarks[0] == remark
    shows = replace(exercise, shows_expected=True)
    assert mark(shows, part, part.printed.text).remarks[0] == f"{remark}, the right entry is a1*s1"


@pytest.mark.parametrize("numeric", [True, False])
def test_a_pose_in_the_plane_is_told_what_it_is_in_space(*, numeric: bool) -> None:
    """The homogeneous 3x3 of courses that stay in the plane, where a rotation or a 4x4 is asked for."""
    robot = load_robot("planar-2r")
    values = joint_values(robot, "30°,45°") if numeric else {}
    typed = "c12 -s12 a1*c1+a2*c12; s12 c12 a1*s1+a2*s12; 0 0 1"
    numbers = "0.2588 -0.9659 0.4241; 0.9659 0.2588 0.4898; 0 0 1"
    for ask, verdict in (("rotation of pose 0..2", Verdict.WRONG), ("pose 0..2", Verdict.CANNOT_READ)):
        exercise = question_about(robot, ask, numeric=numeric, given=values)
        judged = check(exercise, exercise.parts[0].id, numbers if numeric else typed)
        assert judged.verdict is verdict
        assert "looks like a pose in the plane" in judged.remarks[0]
        turn = "0 -1 0; 1 0 0; 0 0 1"
        assert "plane" not in str(check(exercise, exercise.parts[0].id, turn).remarks)
