"""DH tables as students type them, and what a fair lecturer says of them."""

from __future__ import annotations

import sys
import time
from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import check, load_exercise
from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.tables.cells import dh_table_text
from dhcli.checking.tables.marking import answer_of, mark_table, write_table
from dhcli.checking.tables.typed_rows import read_table
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import Convention, moves_of
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Symbol, number
from tests.checking.tables.robots_with_tables import NAMES, Move, keeping, mutations, robot, rows_of
from tests.judging import answer_with, checked, slips
from tests.nightly import NIGHT, in_turn
from tests.row_by_row import row_by_row

MODIFIED, STANDARD = Convention.MODIFIED, Convention.STANDARD

PUMA = """
0    0   0   θ1
-90  0   0   θ2
0    a2  d3  θ3
-90  a3  d4  θ4
90   0   0   θ5
-90  0   0   θ6
"""
FREE = "Draw frames of your own and write down the table."
ZHOU = "[0 90 l1 θ1; l2 0 d2 θ2; 0 90 0 θ3; 0 -90 l3 θ4; 0 90 0 θ5; 0 0 0 θ6]"


def exercise(name: str, **more: object) -> Exercise:
    """An exercise about a robot of the library; without a task it gives no freedom."""
    task = more.pop("task", "")
    return Exercise(name, name, "", task, (), robot(name), **more)


def marked(
    name: str, text: str, compare: str = "same-robot", convention: Convention | None = None, **more: object
) -> Mark:
    """The judgement of a table; options of the exercise and of the task."""
    flags = {key: more.pop(key) for key in ("end_free", "tolerance") if key in more}
    task = exercise(name, **more)
    return judged(task, text, compare, convention, **flags)


def judged(
    task: Exercise, text: str, compare: str = "same-robot", convention: Convention | None = None, **flags: object
) -> Mark:
    """The judgement of a table, in the convention of the robot if no other one is asked for."""
    arm = task.robot
    rows = read_table(text, arm, task.scope, arm.columns, task.unit)
    return mark_table(answer_of(Memo(task), convention or arm.convention, rows, compare, **flags))


def changed(text: str, old: str, new: str) -> str:
    """A table with one thing typed otherwise."""
    assert text.count(old) == 1
    return text.replace(old, new)


# --- reading ---------------------------------------------------------------------------------------------------------

LINES = tuple(PUMA.strip().splitlines())
NUMBERED = tuple(enumerate(LINES, 1))

SPELLINGS = {
    "rows by lines": PUMA,
    "MATLAB": "[" + ";".join(LINES) + "]",
    "with a label": "T = [" + ";".join(LINES) + "]",
    "commas": ",".join(f"[{','.join(line.split())}]" for line in LINES),
    "link numbers": "\n".join(f"{i} {line}" for i, line in NUMBERED),
    "link and its number": "\n".join(f"link {i} | {' | '.join(line.split())}" for i, line in NUMBERED),
    "Markdown with heads": "| # | α_{i-1} | a_{i-1} | d_i | θ_i |\n|---|---|---|---|---|\n"
    + "\n".join(f"| {i} | {' | '.join(line.split())} |" for i, line in NUMBERED),
    "heads in another order": "i,theta,d,a,alpha\n1,q1,0,0,0\n2,q2,0,0,-90°\n3,q3,d3,a2,0\n4,q4,d4,a3,-pi/2\n"
    "5,q5,0,0,π/2\n6,q6,0,0,-90 deg",
    "heads as the slides misprint them": "α_i - 1   a_i - 1   d_i   θ_i" + PUMA,
    "heads in a list": "[[alpha, a, d, theta], " + ", ".join(f"[{', '.join(line.split())}]" for line in LINES) + "]",
    "radians in the heads": "alpha [rad]  a [m]  d [m]  theta [rad]" + PUMA.replace("90", "1.5708"),
    "stars": PUMA.replace("θ1", "θ1*").replace("θ2", "θ2^*").replace("θ3", "θ_3^*"),
    "values in the pose drawn": PUMA.replace("θ4", "θ4(-90°)").replace("θ6", "θ6*(90)").replace("θ5", "θ5(pi/2)*"),
    "LaTeX": r"\begin{tabular}{c|cccc} $i$ & $\alpha_{i-1}$ & $a_{i-1}$ & $d_i$ & $\theta_i$ \\ \hline "
    r"1 & 0 & 0 & 0 & $\theta_1^*$ \\ 2 & $-90^\circ$ & 0 & 0 & \theta_2 \\ 3 & 0 & a_2 & d_3 & \theta_3 \\ "
    r"4 & -\frac{\pi}{2} & a_3 & d_4 & \theta_4 \\ 5 & 90 & 0 & 0 & \theta_5 \\ 6 & -90 & 0 & 0 & \theta_6 "
    r"\end{tabular}",
    "a robot file": "- {alpha: 0, a: 0, d: 0, theta: theta1}\n- {alpha: -90°, a: 0, d: 0, theta: theta2}\n"
    "- {theta: theta3, alpha: 0, a: a2, d: d3}\n- {alpha: -90°, a: a3, d: d4, theta: theta4}\n"
    "- {alpha: 90°, a: 0, d: 0, theta: theta5}\n- {alpha: -90°, a: 0, d: 0, theta: theta6}",
    "YAML lists": "\n".join(f"- [{', '.join(line.split())}]" for line in LINES),
    "dhcli's own page": " i   α_{i-1}   a_{i-1}   d_i   θ_i      joint\n ───────────────────────────\n"
    + "\n".join(f" {i}   {line}   revolute" for i, line in NUMBERED)
    + "\nA_i = Rot(x, α_{i-1}) Trans(x, a_{i-1}) Trans(z, d_i) Rot(z, θ_i)\n",
}


@row_by_row("spelling", SPELLINGS)
def test_every_spelling_of_the_right_table_is_right(spelling: str) -> None:
    """One table in all the ways in which it is typed or pasted."""
    mark = marked("puma560", SPELLINGS[spelling])
    assert mark.verdict is Verdict.RIGHT
    assert mark.remarks == ()
    assert mark.earned == 1.0


@row_by_row("name", NAMES)
def test_what_is_shown_as_right_is_read_and_right(name: str) -> None:
    """The expected answer can be pasted back."""
    task = exercise(name)
    text = write_table(task, robot(name).convention)
    for compare in ("literal", "same-motion", "same-robot"):
        mark = marked(name, text, compare)
        assert mark.verdict is Verdict.RIGHT
        assert mark.reading == mark.expected == text
    rows = read_table(text, robot(name))
    assert tuple(typed.row for typed in rows) == rows_of(name)


def test_cells_keep_their_text_and_their_place() -> None:
    """A cell knows what was typed and where."""
    rows = read_table("[0 0 0 θ1*; 0 -90 d θ2]", _two_joints())
    assert rows[1].cells["alpha"].text == "-90"
    assert rows[1].cells["d"].start == 18
    assert rows[1].row.alpha == Angle.in_degrees(-90)
    assert rows[1].row.theta == Angle.of("theta2")


def _two_joints() -> Robot:
    two = robot("planar-2r")
    return replace(two, parameters={"d": None, **two.parameters})


def test_a_single_row_of_letters_is_a_row_and_not_its_heads() -> None:
    """`a_i alpha_i d_i theta_i` is an answer where it stands alone."""
    assert marked("dh-link", "a_i alpha_i d_i theta_i").verdict is Verdict.RIGHT
    assert marked("dh-link", "a alpha d theta\na_i alpha_i d_i theta_i").verdict is Verdict.RIGHT
    assert marked("dh-link", "0 alpha_i d_i theta_i").verdict is Verdict.WRONG


@row_by_row(
    ("text", "said"),
    [
        (changed(PUMA, "-90  0   0   θ2", "-90  0   0"), "row 2 has 3 cells"),
        ("1 2 3", "the rows have 3 cells; a DH table has the four columns alpha, a, d, theta"),
        (changed(PUMA, "a3  d4", "a3  d9"), "d9 is not a name that is known here"),
        (changed(PUMA, "a3  d4", "90°  d4"), "row 4, a: 90°: deg is a unit of angle, a length is wanted"),
        (changed(PUMA, "a3  d4", "a3  theta4"), "row 4, d: theta4 is an angle, and this column holds lengths"),
        (changed(PUMA, "d4  θ4", "d4  a2"), "this column holds angles; the columns are alpha, a, d, theta"),
        (changed(PUMA, "d4  θ4", "d4  30mm"), "row 4, theta: 30mm: mm is a unit of length"),
        (
            changed(PUMA, "d4  θ4", "d4  0"),
            "no row has theta4: a table holds the variables of its joints and not their values; write theta4 in",
        ),
        (changed(PUMA, "d4  θ4", "d4  θ3"), "row 4, theta: theta3 stands in row 3, theta too"),
        (changed(PUMA, "d4  θ4", "d4  θ4+θ5"), "row 4 moves with theta4 and theta5"),
        (changed(PUMA, "a3  d4", "a3*cos(theta4)  d4"), "row 4, a: a3*cos(theta4) moves with a joint"),
        ("_ _ _ _", ""),
    ],
)
def test_what_cannot_be_read_names_row_and_column(text: str, said: str) -> None:
    """A format fault is no wrong answer, and says where it is."""
    with pytest.raises(UnreadableError) as error:
        marked("puma560", text)
    assert said in error.value.remarks[0]


def test_a_slide_is_a_variable_plus_a_constant() -> None:
    """Drawn values and offsets of sliding joints."""
    right = "[0 -90 d1 0; 0 90 d2 90; 0 0 d3 0]"
    assert marked("cartesian", right).verdict is Verdict.RIGHT
    assert marked("cartesian", changed(right, "d3", "d3(0.1)*")).verdict is Verdict.RIGHT
    offset = marked("cartesian", changed(right, "d3", "d3-0.2"))
    assert offset.verdict.passed
    with pytest.raises(UnreadableError, match=r"d3\^2 is not d3 plus a constant"):
        marked("cartesian", changed(right, "d3", "d3^2"))


@given(st.text(alphabet="θ123 ;,[]()*-90°adl|&\n_{}:πmtheap", max_size=60))
def test_any_text_is_judged_or_refused_in_words(text: str) -> None:
    """No text crashes the reader."""
    try:
        mark = marked("planar-2r", text)
    except UnreadableError as error:
        assert error.remarks
        assert all(error.remarks)
    else:
        assert mark.verdict in (Verdict.RIGHT, Verdict.EQUIVALENT, Verdict.WRONG, Verdict.CLOSE)


# --- units -----------------------------------------------------------------------------------------------------------


def test_bare_angles_are_degrees_and_written_units_are_kept() -> None:
    """Degrees are the unit of the sheet, modulo a turn, to 0.05°."""
    text = PUMA.replace("-90", "-pi/2", 1).replace("90   0   0   θ5", "1.5708rad 0 0 θ5")
    assert marked("puma560", text, "literal").verdict is Verdict.RIGHT
    assert marked("puma560", changed(PUMA, "90   0   0   θ5", "450 0 0 θ5"), "literal").verdict is Verdict.RIGHT
    assert marked("puma560", changed(PUMA, "90   0   0   θ5", "89.96 0 0 θ5"), "literal").verdict is Verdict.RIGHT
    assert marked("puma560", changed(PUMA, "90   0   0   θ5", "89.9 0 0 θ5"), "literal").verdict is Verdict.CLOSE
    assert marked("puma560", changed(PUMA, "90   0   0   θ5", "89 0 0 θ5"), "literal").verdict is Verdict.WRONG


@pytest.mark.parametrize("compare", ["literal", "same-motion", "same-robot"])
def test_radians_without_their_unit_are_a_unit_fault_and_not_wrong(compare: str) -> None:
    """The units speak before the values."""
    text = PUMA.replace("90", "1.5708")
    with pytest.raises(UnreadableError, match="right in radians; the angles of this sheet are in degrees"):
        marked("puma560", text, compare)


def test_radians_in_some_cells_are_named_there() -> None:
    """Where only some angles are in radians the table is wrong, and the cells say why."""
    mark = marked("puma560", changed(PUMA, "90   0   0   θ5", "1.5708 0 0 θ5"), "literal")
    assert mark.verdict is Verdict.WRONG
    assert mark.remarks[0] == "1.5708 would be right in radians: write the unit"
    assert [(cell.row, cell.column) for cell in mark.cells if cell.note] == [(4, 0)]


NUMBERS = "0 0 0 θ1\n-90 0 0 θ2\n0 431.8 150.05 θ3\n-90 20.3 431.8 θ4\n90 0 0 θ5\n-90 0 0 θ6"


def test_lengths_in_numbers_have_the_unit_of_the_sheet() -> None:
    """Bare lengths are in the unit of the sheet or of the heads."""
    assert marked("puma560", NUMBERS, unit="mm").verdict is Verdict.RIGHT
    assert marked("puma560", NUMBERS.replace("431.8", "432"), unit="mm").verdict is Verdict.RIGHT
    with pytest.raises(UnreadableError, match="right in mm; this sheet is in m"):
        marked("puma560", NUMBERS)
    assert (
        marked("puma560", NUMBERS.replace("0 20.3", "0 2.03 cm").replace("-90 20.3", "-90 2.03cm"), unit="mm").verdict
        is Verdict.RIGHT
    )
    heads = "alpha a [mm] d [mm] theta\n"
    assert marked("puma560", heads + NUMBERS).verdict is Verdict.RIGHT
    near = marked("puma560", NUMBERS.replace("0 431.8 150", "0 435 150"), unit="mm")
    assert near.verdict is Verdict.CLOSE
    assert marked("puma560", NUMBERS.replace("150.05", "15.05"), unit="mm").verdict is Verdict.WRONG


def test_given_values_may_stand_for_their_letters() -> None:
    """What the task gives may be typed as letter or as number."""
    given = {"a2": number(Fraction(1, 2)), "alpha": Angle.in_degrees(30)}
    assert marked("puma560", changed(PUMA, "a2", "0.5"), given=given).verdict is Verdict.RIGHT
    assert marked("puma560", changed(PUMA, "a2", "0.6"), given=given).verdict is Verdict.WRONG
    assert marked("puma560", PUMA, given={"theta1": Angle.in_degrees(30)}).verdict is Verdict.RIGHT
    assert marked("puma560", changed(PUMA, "a2", "2*0.5*a2")).verdict is Verdict.RIGHT
    assert marked("puma560", changed(PUMA, "a2", "0.9999*a2")).verdict.passed
    link = {"alpha_i": Angle.in_degrees(-90)}
    assert marked("dh-link", "a_i -90 d_i theta_i", given=link).verdict is Verdict.RIGHT


# --- verdicts --------------------------------------------------------------------------------------------------------


def test_other_frames_are_right_and_named() -> None:
    """A split of two d: right where a task leaves frames open, else equivalent, wrong as cells."""
    split = PUMA.replace("-90  0   0   θ2", "-90 0 d3 θ2").replace("a2  d3", "a2 0")
    mark = marked("puma560", split)
    assert mark.verdict is Verdict.EQUIVALENT
    assert marked("puma560", split, task=FREE).verdict is Verdict.RIGHT
    assert mark.remarks == ("you split d2 and d3 along the parallel axes differently",)
    assert {cell.verdict for cell in mark.cells} == {Verdict.RIGHT, Verdict.EQUIVALENT}
    assert marked("puma560", split, "same-motion").verdict is Verdict.EQUIVALENT
    literal = marked("puma560", split, "literal")
    assert literal.verdict is Verdict.WRONG
    assert literal.remarks[0].startswith("a right table of the same robot")


@pytest.mark.parametrize(
    ("text", "remarks"),
    [
        (
            "[0 90 l1 θ1; -l2 0 d2 θ2+180; 0 90 0 θ3-180; 0 -90 l3 θ4; 0 90 0 θ5; 0 0 0 θ6]",
            ("your x2 points the other way",),
        ),
        (
            "[0 90 l1 θ1; l2 0 d2 θ2; 0 -90 0 θ3; 0 90 -l3 -θ4; 0 90 0 θ5; 0 0 0 θ6]",
            ("your z3 points the other way",),
        ),
        (
            "[0 90 l1 θ1; l2 0 d2 θ2; 0 -90 0 θ3; 0 90 -l3 θ4; 0 90 0 θ5; 0 0 0 θ6]",
            ("your z3 points the other way, so theta4 counts the other way",),
        ),
        (
            "[0 90 0 θ1; l2 0 d2 θ2; 0 90 0 θ3; 0 -90 l3 θ4; 0 90 0 θ5; 0 0 0 θ6]",
            ("your frame 0 sits elsewhere along z0",),
        ),
    ],
)
def test_each_freedom_has_its_words(text: str, remarks: tuple[str, ...]) -> None:
    """What a student has drawn otherwise, in words."""
    mark = marked("zhou-6r", text)
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks == remarks
    given = marked("zhou-6r", text, task=FREE)
    assert given.verdict is Verdict.RIGHT
    assert given.remarks == remarks


def test_other_zeros_alone_are_equivalent() -> None:
    """Joints counted otherwise, with the frames of the solution."""
    mark = marked("zhou-6r", changed(ZHOU, "θ2", "θ2 + 90"))
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks == ("your theta2 has another zero (+90°)",)
    mark = marked("zhou-6r", changed(ZHOU, "θ2", "θ2 + 90"), task="Draw frames. Joint zero: stretched out.")
    assert mark.verdict is Verdict.EQUIVALENT  # a zero that the task has fixed is no freedom that it gave
    assert marked("zhou-6r", changed(ZHOU, "θ2", "θ2 + 90"), task=FREE).verdict is Verdict.RIGHT
    mark = marked("zhou-6r", changed(ZHOU, "θ3", "-θ3"))
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks == ("your theta3 counts the other way",)


def test_the_other_convention_is_its_own_verdict() -> None:
    """Columns of one convention read in the other."""
    rows = rows_of("puma560-standard")
    text = dh_table_text(rows, robot("puma560").columns, robot("puma560").writing)
    mark = marked("puma560", text)
    assert mark.verdict is Verdict.WRONG
    assert mark.remarks == ("right for standard DH; this exercise uses modified",)
    text = dh_table_text(rows_of("zhou-3r-modified"), robot("zhou-3r").columns, robot("zhou-3r").writing)
    assert marked("zhou-3r", text).remarks == ("right for modified DH; this exercise uses standard",)
    assert marked("zhou-3r", text, convention=MODIFIED).verdict is Verdict.RIGHT
    assert marked("zhou-3r", text, "same-motion", MODIFIED).verdict is Verdict.RIGHT


def test_the_other_convention_is_not_blamed_for_an_accident() -> None:
    """[a1, a1] read as modified drops the last length; nobody meant that."""
    assert marked("planar-2r", "[a1 0 0 θ1; a1 0 0 θ2]").remarks == (
        "all joints are right; your end frame is shifted along x",
        "look at row 2",
    )
    assert "right for modified DH" in marked("planar-2r", "[0 0 0 θ1; a1 0 0 θ2]").remarks[0]


def test_the_first_wrong_joint_is_named() -> None:
    """Joints have the numbers of the robot."""
    turned = marked("puma560", changed(PUMA, "-90  a3", "90 a3"))  # axis 4 is the same line; the wrist lies behind it
    assert turned.remarks == (
        "the axes of joints 1, 2, 3 and 4 are right; the axis of joint 5 lies elsewhere",
        "look at the signs of alpha, a and d in rows 3 and 4",  # d3 or d4 the other way is the same arm as this one
    )
    wrong = marked("puma560", changed(PUMA, "0    a2", "0    a3"))
    assert wrong.remarks == (
        "the axes of joints 1 and 2 are right; the axis of joint 3 lies elsewhere",
        "look at row 3, and at d in row 2",
    )
    assert wrong.verdict is Verdict.WRONG
    assert 0.9 < wrong.earned < 1
    wrist = marked("spherical-wrist", "[0 -60 0 θ4; 0 90 0 θ5; 0 0 d6 θ6]")
    assert wrist.remarks == (
        "the axis of joint 4 is right; the axis of joint 5 points another way",
        "look at alpha in row 4",
    )


@pytest.mark.parametrize("name", ["puma560", "puma560-standard", "stanford", "scara-yim", "zhou-3r", "zhou-6r"])
def test_the_row_that_holds_a_slip_is_among_those_to_look_at(name: str) -> None:
    """In standard DH the axis of joint k + 1 is placed by row k, in modified by row k + 1."""
    task = question_about_table(robot(name), robot(name).convention)
    seen = 0
    for slip in in_turn(slips(task, task.parts[0]), 1, 5):
        mark = checked(task, task.parts[0], answer_with(task, task.parts[0], slip.name))
        row = slip.name.partition(" ")[2]
        if slip.name.startswith("thetas-swapped"):
            assert mark.remarks[0].startswith("your joints come as")
        elif mark.verdict is Verdict.WRONG and row.isdecimal() and "stands under" not in mark.remarks[0]:
            look = next(remark for remark in mark.remarks if remark.startswith("look at"))
            assert row in look.replace(",", "").split(), (slip.name, mark.remarks)
            seen += 1
    assert seen > (3 if NIGHT else 0)


def test_a_forgotten_last_length_is_found_unless_the_end_frame_is_free() -> None:
    """E is free only where the task says so."""
    text = "[0 -90 0 θ4; 0 90 0 θ5; 0 0 0 θ6]"
    mark = marked("spherical-wrist", text)
    assert mark.verdict is Verdict.WRONG
    assert mark.remarks == ("all joints are right; your end frame is shifted along z", "look at row 6")
    free = marked("spherical-wrist", text, end_free=True)
    assert free.verdict is Verdict.EQUIVALENT
    assert free.remarks == ("your frame 6 sits elsewhere along z6",)
    assert marked("spherical-wrist", text, end_free=True, task=FREE).verdict is Verdict.RIGHT


def test_same_motion_holds_base_zeros_and_senses_and_says_so() -> None:
    """The stricter comparison tells that the robot is the same."""
    mark = marked("zhou-6r", changed(ZHOU, "θ2", "θ2 + 90"), "same-motion", task=FREE)
    assert mark.verdict is Verdict.WRONG
    assert mark.remarks[0] == "the same robot, but this task fixes base, end frame, zeros and senses"
    asked = marked("zhou-6r", changed(ZHOU, "θ2", "θ2 + 90"), "same-motion")
    assert asked.remarks[0] == "the same robot, but this comparison fixes base, end frame, zeros and senses"
    assert "your theta2 has another zero (+90°)" in mark.remarks


def test_variables_under_other_columns_and_in_another_order_are_wrong() -> None:
    """A slide under a, and joints that come in another order."""
    stanford = "[0 -90 0 θ1; 0 90 d2 θ2; 0 0 d3 0; 0 -90 0 θ4; 0 90 0 θ5; 0 0 d6 θ6]"
    assert marked("stanford", stanford).verdict is Verdict.RIGHT
    swapped = marked("stanford", changed(stanford, "0 0 d3 0", "d3 0 0 0"))
    assert swapped.verdict is Verdict.WRONG
    assert swapped.remarks == ("row 3: d3 stands under a, not under d or theta; the columns are a, alpha, d, theta",)
    order = marked("stanford", "[0 -90 0 θ1; 0 90 d2 θ2; 0 -90 0 θ4; 0 0 d3 0; 0 90 0 θ5; 0 0 d6 θ6]")
    assert order.remarks[0].startswith("your joints come as theta1, theta2, theta4, d3")


def test_the_second_truth_of_an_exercise_is_accepted_with_its_note() -> None:
    """Both readings of a doubtful table are accepted."""
    text = "[0 0 0 θ1; 0 -90 d θ2; b 0 -a θ3; 0 -90 c θ4(-90°); 0 90 0 θ5; 0 90 0 θ6(90°)]"
    assert marked("puma200", text).verdict is Verdict.WRONG
    puma = robot("puma200")
    rows = read_table(text, puma)
    links = tuple(
        replace(link, row=r.row, moves=moves_of(r.row, MODIFIED)) for link, r in zip(puma.links, rows, strict=True)
    )
    wrist = replace(puma, links=links)
    for compare in ("literal", "same-motion", "same-robot"):
        mark = marked("puma200", text, compare, also=(wrist, "the axes of the wrist meet"))
        assert mark.verdict is Verdict.EQUIVALENT
        assert mark.remarks == ("the axes of the wrist meet",)
    offsets = text.replace("θ4(-90°)", "θ4 - 90°").replace("θ6(90°)", "θ6 + 90°")
    mark = marked("puma200", offsets, also=(wrist, "the axes of the wrist meet"))
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks[0] == "the axes of the wrist meet"


def test_a_table_may_go_on_to_the_tool() -> None:
    """A row more, for the tool of the robot."""
    mark = marked("zhou-6r", ZHOU[:-1] + "; 0 0 d7 0]")
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks == ("the table goes on to the tool frame",)


def test_a_robot_given_as_products_has_a_table_too() -> None:
    """The answer is compared with the chain, whatever it was written in."""
    right = "[l2 0 l1 θ1+90; l3 0 0 θ2; 0 0 -d3 -90]"
    task = Exercise("scara", "", "", "", (), robot("scara"))
    assert judged(task, right, convention=STANDARD).verdict is Verdict.RIGHT
    assert judged(task, right, "same-motion", STANDARD).verdict is Verdict.RIGHT
    forgotten = judged(task, changed(right, "-90", "0"), convention=STANDARD)
    assert forgotten.remarks == ("all joints are right; your end frame is turned by +90° about z", "look at row 3")
    with pytest.raises(RobotError, match="has no table in standard DH"):
        write_table(task, STANDARD)
    with pytest.raises(RobotError, match="to compare cells with"):
        judged(task, right, "literal", STANDARD)


def test_of_two_ways_to_lie_right_the_plainer_is_told() -> None:
    """One end frame turned, rather than three joints that count the other way; and all that a task fixes is told."""
    task = load_exercise("bajd/scara-as-dh-table")
    turned = check(task, "table", "l2 0 l1 θ1+90; l3 180 0 θ2; 0 0 d3 -90")
    assert turned.remarks[:2] == (
        "all joints are right; your end frame is turned by 180° about y",
        "look at row 3, and at alpha in row 2",  # z2 is turned round there; row 3 could turn it back
    )
    both = check(task, "table", "l2 0 l1 θ1; l3 0 0 θ2; 0 0 -d3 0")
    assert both.remarks == (
        "all axes are right, but this task fixes base, end frame, zeros and senses",
        "your theta1 has another zero (-90°)",
        "your end frame is turned by +90° about z",
    )
    last = check(task, "table", "l2 0 l1 θ1+90; l3 0 0 θ2; 0 0 -d3 0")
    assert last.remarks == ("all joints are right; your end frame is turned by +90° about z", "look at row 3")


def test_rows_that_only_stand_still_may_be_split_off() -> None:
    """Rows need not be as many as in the solution."""
    text = "[0 90 l1 θ1; l2 0 d2 θ2; 0 90 0 θ3; 0 -90 l3 θ4; 0 90 0 θ5; 0 0 0 θ6; 0 0 0 0]"
    mark = marked("zhou-6r", text)
    assert mark.verdict is Verdict.EQUIVALENT
    assert mark.remarks == ("another table of the same motion",)
    assert marked("zhou-6r", text, "literal").remarks[-1] == "your table has 7 rows, the right one has 6"


# --- laws ------------------------------------------------------------------------------------------------------------


def _letters(name: str) -> list[object]:
    lengths = [Symbol(n) for n in robot(name).parameters if n not in robot(name).angles]
    return lengths or [number(Fraction(1, 8))]


@given(st.sampled_from(NAMES), st.data())
def test_a_table_in_other_frames_is_right_as_text(name: str, data: st.DataObject) -> None:
    """From text to verdict, whatever the frames."""
    rows = rows_of(name)
    moves: list[Move] = data.draw(st.lists(keeping(_letters(name)), max_size=5))
    for move in moves:
        rows = move(rows, robot(name).convention)
    text = dh_table_text(rows, robot(name).columns, robot(name).writing)
    mark = marked(name, text)
    assert mark.verdict in (Verdict.RIGHT, Verdict.EQUIVALENT)
    assert mark.earned == 1.0
    assert not any("another zero" in remark or "your frame 0" in remark for remark in mark.remarks)
    assert marked(name, text, "same-motion").verdict.passed


@given(st.sampled_from(NAMES), st.data())
def test_a_slip_is_never_right_unless_it_names_a_freedom(name: str, data: st.DataObject) -> None:
    """What is not the solution is never accepted in silence."""
    _, rows = data.draw(st.sampled_from(mutations(rows_of(name), robot(name).variables)))
    text = dh_table_text(rows, robot(name).columns, robot(name).writing)
    mark = marked(name, text, names=("b9",))
    assert mark.verdict in (Verdict.RIGHT, Verdict.EQUIVALENT, Verdict.WRONG)
    if mark.verdict.passed:
        assert mark.remarks
        assert marked(name, text, "same-motion", names=("b9",)).verdict in (Verdict.WRONG, Verdict.EQUIVALENT)
    else:
        assert mark.remarks
        assert mark.earned < 1


def test_how_long_a_table_takes() -> None:
    """Prints times, with `pytest -s`; nobody asserts them."""
    tables = {
        "right": PUMA,
        "other frames": PUMA.replace("-90  0   0   θ2", "-90 0 d3 θ2").replace("a2  d3", "a2 0"),
        "wrong": changed(PUMA, "0    a2", "0    a3"),
        "numbers": NUMBERS.replace("431.8", "0.432").replace("150.05", "0.15").replace("20.3", "0.0203"),
    }
    for what, text in tables.items():
        start = time.perf_counter()
        mark = marked("puma560", text)
        sys.stdout.write(f"a table of six joints, {what}: {1000 * (time.perf_counter() - start):.1f} ms\n")
        assert mark.verdict.passed is (what != "wrong")
