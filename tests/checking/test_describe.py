"""What a part asks for, in words: the numbers in them are those that the marking means."""

from __future__ import annotations

from dhcli.checking.exercise import Case, Exercise, Memo
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import read_exercise
from tests.judging import mark
from tests.row_by_row import row_by_row


@row_by_row("unit", ["mm", "m", "none"])
@row_by_row(
    ("piece", "typed", "shown"),
    [
        ("point", "(0.2, 0, 0)", "(0.2, 0, 0)"),
        ("point", "(200, 0, 0)", "(200, 0, 0)"),
        ("vector", "(0.6, 0, 0.8)", "(0.6, 0, 0.8)"),
    ],
)
def test_points_and_vectors_are_shown_in_the_unit_in_which_the_answer_is_judged(
    piece: str, typed: str, shown: str, unit: str
) -> None:
    """Turned by half a turn, what is shown comes back with its sign changed; a direction has no unit."""
    exercise = read_exercise(
        f"""
        format: 1
        title: x
        source: x
        task: x
        numeric: true
        unit: {unit}
        tolerance: {{position: 0.00001}}
        parts:
          - {{id: turned, ask: '{piece} {typed} of product "Rot(z, 180°)"'}}
        """,
        "x.yaml",
        "x",
    )
    [part] = exercise.parts
    assert f"the {piece} {shown}" in part.question.describe(exercise)
    x, y, z = (float(number) for number in shown[1:-1].split(","))
    assert mark(exercise, part, f"{-x}, {-y}, {z}").verdict is Verdict.RIGHT


def about_motion(asked: str, unit: str) -> Exercise:
    """A question about the motion of the cylindrical robot on a sheet in some unit of length."""
    return read_exercise(
        f"""
        format: 1
        title: x
        source: x
        task: x
        numeric: true
        unit: {unit}
        robot: cylindrical
        given: {{theta1: 30°, d2: 0.2 m, d3: 0.3 m}}
        parts:
          - {{id: it, ask: "{asked}"}}
        """,
        "x.yaml",
        "x",
    )


@row_by_row("unit", ["mm", "m"])
@row_by_row(
    ("asked", "shown"),
    [
        (
            "velocity of 0..3 with rates (0.1, 0.2, 0)",
            "[{unit}/s] of frame 3 seen from frame 0: three numbers, for the joint rates (0.1 rad/s, 0.2 m/s, 0)",
        ),
        ("velocity of 0..1 with rates (0.1)", "for the joint rates (0.1) rad/s"),
        ("velocity of point (0, 0, 0.05) of 0..3 with rates (0, 0, 0)", "of the point (0, 0, 0.05) m of frame 3"),
        ("velocity of point (0, 0, 50 mm) of 0..3 with rates (0, 0, 0)", "of the point (0, 0, 0.05) m of frame 3"),
        (
            "joint rates for (0.1, 0.2, 0) of 0..3",
            "the joint rates [rad/s, of a slide {unit}/s] for the velocity (0.1, 0.2, 0) m/s",
        ),
        (
            "joint rates for angular (0, 0, 0.5) of 0..1",
            "the joint rates [rad/s] for the angular velocity (0, 0, 0.5) rad/s",
        ),
        (
            "differential motion (0.002, 0, 0) turn (0, 0, 0.01) of 0..3",
            "for the small displacement (0.002, 0, 0) m and the small turn (0, 0, 0.01) rad",
        ),
        ("torques for (10, 0, 0) of 0..3 at (0, 0, 0.1)", "of the point (0, 0, 0.1) m of frame 3"),
    ],
)
def test_numbers_of_a_question_about_motion_are_shown_with_their_units(asked: str, shown: str, unit: str) -> None:
    """They are metres, radians and seconds, and the sheet may be in millimetres."""
    exercise = about_motion(asked, unit)
    assert shown.format(unit=unit) in exercise.parts[0].question.describe(exercise)


def test_letters_of_a_question_about_motion_have_no_unit() -> None:
    """They stand for a number with its unit."""
    exercise = read_exercise(
        """
        format: 1
        title: x
        source: x
        task: x
        robot: cylindrical
        names: [w, v_x, v_y, c]
        parts:
          - {id: moved, ask: "velocity of point (0, 0, c) of 0..3 with rates (w, 0.2, 0)"}
          - {id: rates, ask: "joint rates for (v_x, v_y, 0) of 0..3"}
        """,
        "x.yaml",
        "x",
    )
    moved, rates = (part.question.describe(exercise) for part in exercise.parts)
    assert "of the point (0, 0, c) of frame 3" in moved
    assert "for the joint rates (w, 0.2 m/s, 0)" in moved
    assert rates == "the joint rates for the velocity (v_x, v_y, 0) of frame 3 seen from frame 0, one for each joint"


@row_by_row(
    ("asked", "said"),
    [
        ("velocity of 0..3 with rates (0.1, 200, 0)", ["200 m/s is beyond any arm"]),
        ("velocity of 0..3 with rates (20, 0.2, 0)", []),
        ("velocity of point (0, 0, 50) of 0..3 with rates (0, 0, 0)", ["50 m is beyond any arm"]),
        ("velocity of point (0, 0, 50 mm) of 0..3 with rates (0, 0, 0)", []),
        ("joint rates for (100, 20, 0) of 0..3", ["100 m/s is beyond any arm", "20 m/s is beyond any arm"]),
        ("differential motion (20, 0, 0) of 0..3", ["20 m is beyond any arm"]),
        ("torques for (500, 0, 0) of 0..3", []),
        ("jacobian of 0..3 at (0, 0, 100)", ["100 m is beyond any arm"]),
    ],
)
@row_by_row("unit", ["mm", "none"])
def test_numbers_of_an_author_who_has_millimetres_in_mind_are_found(asked: str, said: list[str], unit: str) -> None:
    """Numbers in a question are metres and seconds, whatever the sheet is in; without units they are what one likes."""
    exercise = about_motion(asked, unit)
    [part] = exercise.parts
    found = list(part.question.findings(Case(part, Memo(exercise)), ("parts", 0)))
    assert [one.message for one in found] == ([f"it: {words}" for words in said] if unit == "mm" else [])
    assert all(one.is_warning for one in found)
