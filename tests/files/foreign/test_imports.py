"""Robots from files of others, each against numbers that dhcli has no part in."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhcli.errors import DhcliError, FileError
from dhcli.files.foreign.forms import Form, form_of
from dhcli.files.foreign.importing import Wish, import_robot
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.files.yaml.writing import robot_text
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.forward import forward
from dhcli.kinematics.robot import Robot
from dhcli.notation.quantity import value_text
from dhcli.render.look import Look
from dhcli.render.text.robot import robot_csv
from tests.coupled import COUPLED
from tests.nightly import in_turn
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from numpy.typing import NDArray

DATA = Path(__file__).parents[2] / "data"
ROBOTS = sorted({path.stem for path in (Path(__file__).parents[3] / "robots").glob("*.yaml")} - {*COUPLED})
TABLES = [name for name in ROBOTS if load_robot(name).convention is not Convention.PRODUCT]

ARM_URDF = "<robot name='r'><link name='a'/></robot>"


def imported(text: str, **wish: str) -> Robot:
    """A robot of a text, by way of the file that `dhcli new robot` writes."""
    robot = import_robot(text, "x", Wish("arm", **wish))  # type: ignore[arg-type]
    return read_robot(robot_text(robot), "x", "arm")


def of_file(name: str, **wish: str) -> Robot:
    """A robot of one of the files."""
    return imported((DATA / name).read_text("utf-8"), **wish)


def turn(axis: str, angle: float) -> NDArray[np.float64]:
    """An elementary rotation."""
    pose, (i, j) = np.eye(4), {"x": (1, 2), "z": (0, 1)}[axis]
    pose[[i, j], [i, j]] = math.cos(angle)
    pose[i, j], pose[j, i] = -math.sin(angle), math.sin(angle)
    return pose


def shift(x: float, y: float, z: float) -> NDArray[np.float64]:
    """A translation."""
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def standard(theta: float, d: float, a: float, alpha: float) -> NDArray[np.float64]:
    """One row of a standard table."""
    return turn("z", theta) @ shift(0, 0, d) @ shift(a, 0, 0) @ turn("x", alpha)


def modified(theta: float, d: float, a: float, alpha: float) -> NDArray[np.float64]:
    """One row of a modified table."""
    return turn("x", alpha) @ shift(a, 0, 0) @ turn("z", theta) @ shift(0, 0, d)


def gap(robot: Robot, q: list[float], expected: NDArray[np.float64], **frames: str) -> float:
    """The largest difference of a pose from what it should be."""
    return float(np.abs(forward(robot, q, **frames).matrix - expected).max())  # type: ignore[arg-type]


def test_a_listing_of_matlab_is_the_robot_that_the_toolbox_makes_of_it() -> None:
    """The toolbox's manual prints the pose at qn = [0 pi/4 pi 0 pi/4 0]; and all else by the four matrices of a row."""
    robot = of_file("foreign/puma560.m")
    assert (robot.title, robot.convention, robot.pattern) == ("Puma 560", Convention.STANDARD, "RRRRRR")
    printed = [[0, 0, 1, 0.5963], [0, 1, 0, -0.1501], [-1, 0, 0, -0.01435], [0, 0, 0, 1]]
    assert gap(robot, [0, math.pi / 4, math.pi, 0, math.pi / 4, 0], np.array(printed)) < 6e-5
    q = [0.3, -0.8, 1.1, 0.4, -1.3, 0.7]
    dh = [(0, 0, 1), (0, 0.4318, 0), (0.15005, 0.0203, -1), (0.4318, 0, 1), (0, 0, -1), (0, 0, 0)]
    rows = [standard(angle, d, a, quarters * math.pi / 2) for angle, (d, a, quarters) in zip(q, dh, strict=True)]
    assert gap(robot, q, np.linalg.multi_dot(rows)) < 1e-15
    assert [str(robot.limits[name][0].degrees) for name in robot.variables] == [  # type: ignore[union-attr]
        "-160",
        "-45",
        "-225",
        "-110",
        "-100",
        "-266",
    ]


def test_a_listing_keeps_its_letters_slides_offsets_and_ends() -> None:
    """Vectors are theta d a alpha sigma offset; theta of a turning joint is nobody's, as in the toolbox."""
    robot = of_file("foreign/four-links.m")
    assert robot.variables == ("theta1", "d2", "d3", "theta4")
    assert set(robot.parameters) == {"a1", "d6"}
    assert robot.derived
    q = [0.3, 0.2, -0.1, 0.8]
    rows = [
        shift(0.1, 0, 0),
        modified(0.3, 0.1, 0.3, math.pi / 2),
        modified(0, 0.25, 0.2, -math.pi / 2),
        modified(math.pi / 4, -0.1, 0.2, -math.pi / 2),
        modified(0.8 - math.pi / 2, 0.6, 0, 0),
        shift(0, 0, 0.1) @ turn("z", math.pi / 4),
    ]
    assert gap(robot, q, np.linalg.multi_dot(rows), start="base", end="tool") < 1e-15
    assert robot.limits["theta4"][1].degrees == 90  # type: ignore[union-attr]
    longer = robot.copy(parameters={"a1": 0.4})
    assert float(str(longer.parameters["d6"])) == 0.8


def test_a_listing_of_python_is_read_and_not_run() -> None:
    """Keywords, np.pi, deg2rad, arrays, SE3."""
    robot = of_file("foreign/three-links.txt")
    q = [0.3, 0.5, 0.2]
    rows = [
        standard(0.3, 0.4, 0.025, math.pi / 2),
        standard(0.5 + math.pi / 2, 0, 0.56, 0),
        standard(0, 0.2, 0, -math.pi / 2),
        shift(0, 0, 0.2) @ turn("x", math.pi / 2),
    ]
    assert gap(robot, q, np.linalg.multi_dot(rows), start="base", end="tool") < 1e-15
    assert set(robot.limits) == {"theta1", "d3"}


def test_a_matrix_of_serial_link_and_links_of_before_version_9_have_their_own_orders() -> None:
    """Theta d a alpha, and alpha a theta d."""
    new = imported("r = SerialLink([0 0.1 0.3 pi/2; 0 0 0.2 0]);")
    old = imported("L{1} = link([pi/2 0.3 0 0.1 0], 'standard'); L{2} = link([0 0.2 0 0 0], 'standard');")
    expected = standard(0.4, 0.1, 0.3, math.pi / 2) @ standard(0.7, 0, 0.2, 0)
    assert gap(new, [0.4, 0.7], expected) < 1e-15
    assert gap(old, [0.4, 0.7], expected) < 1e-15


def test_links_come_in_the_order_in_which_the_robot_names_them_and_their_unit_can_be_said() -> None:
    """Not in that of the text."""
    text = "B = Link('a', 200, 'd', 0); A = Link('a', 300, 'd', 0); r = SerialLink([A B]);"
    robot = imported(text, units="mm")
    assert gap(robot, [0.4, 0.7], standard(0.4, 0, 0.3, 0) @ standard(0.7, 0, 0.2, 0)) < 1e-15


@row_by_row(
    ("text", "said"),
    [
        ("L = Link('d', q, 'alpha', zz(3))", "zz(...) is not read"),
        ("L(1) = Link([0 0 1 0]); L(2) = Link([0 0 1 0], 'modified');", "some links are standard and some modified"),
        ("a = b; b = a; L = Link('a', a)", "a and b follow from each other"),
        ("L = Link('a', 1, 'tool', 2); r = SerialLink(L, 'tool', foo(3))", "tool: 'foo(3)' is not read"),
        ("for i=1:6\n L(i) = Link([0 0 1 0]);\nend", "has a loop"),
        ("r = DHRobot([RevoluteDH(a=0.1) for i in range(6)])", "has a loop"),
        ("L(1) = Link([0 0 1 0]);\nL(2) = Link([0 0 1 0", "a bracket is never closed"),
        ("L = Link('a', 1); L2.offset = 3", "L2.offset is of no link"),
        ("L = Link('a', '__import__(1)')", "import__(...) is not read"),
        ("L = Link('a', 1, 'qlim', 3)", "qlim: two values are wanted"),
        ("r = SerialLink(L, 'a', 1)", "names no link"),
        ("L = Link(1, 'a', 2)", "'1' is not read"),
    ],
)
def test_what_a_listing_does_not_say_is_not_guessed(text: str, said: str) -> None:
    """Each in a sentence."""
    with pytest.raises(DhcliError) as caught:
        imported(text)
    assert said in str(caught.value)


@pytest.mark.parametrize("name", TABLES)
def test_the_csv_of_a_robot_is_imported_as_its_table(name: str) -> None:
    """What `show --format csv` prints, row for row."""
    robot = load_robot(name)
    letters = "".join("R" if link.row and link.row.theta.names & set(robot.variables) else "" for link in robot.links)
    joints = "" if len(letters) == len(robot.links) else _letters(robot)
    again = imported(robot_csv(robot, Look()), convention=robot.convention.value, joints=joints)
    assert [link.row for link in again.links] == [link.row for link in robot.links]
    assert again.variables == robot.variables


def _letters(robot: Robot) -> str:
    """What each row does, where a table alone does not say it."""
    kinds = {joint.link: "P" if joint.kind == "prismatic" else "R" for joint in robot.joints}
    return "".join(kinds.get(link.number, "F") for link in robot.links)


def test_a_table_in_a_page_has_units_in_its_heads_and_stars_at_its_variables() -> None:
    """Indices i-1 say that it is modified."""
    robot = of_file("foreign/craig.md")
    assert (robot.convention, robot.variables) == (Convention.MODIFIED, ("theta1", "theta2", "d3"))
    assert robot.parameters == {"d1": None, "a2": None}
    known = robot.copy(parameters={"d1": 0.4, "a2": 0.3})
    rows = [
        modified(0.1, 0.4, 0, 0),
        modified(0.2 + math.pi / 2, 0, 0.25, -math.pi / 2),
        modified(0, 0.15, 0.3, math.pi),
    ]
    assert gap(known, [0.1, 0.2, 0.15], np.linalg.multi_dot(rows)) < 1e-15


@pytest.mark.parametrize(
    "text",
    [
        "a;alpha;d;theta\n0,4;90 deg;0;q1\n0,3;0;0;q2\n",
        "theta\ta\talpha\td\nq1\t0.4\tpi/2\t0\nq2\t0.3\t0\t0\n",
        "theta alpha a d\nq1 90° 400mm 0\nq2 0 300mm 0\n",
        "# my arm\ni, a [cm], alpha [deg], d, theta\n1, 40, 90, 0, θ1\n\n2, 30, 0, 0, θ2\n",
        "link length [m],link twist [rad],link offset,joint angle\n0.4,1.5708,0,q_1\n0.3,0,0,q_2\n",
    ],
)
def test_tables_come_between_any_signs(text: str) -> None:
    """The same arm each time."""
    robot = imported(text, convention="standard")
    assert gap(robot, [0.3, 0.5], standard(0.3, 0, 0.4, math.pi / 2) @ standard(0.5, 0, 0.3, 0)) < 1e-15


@row_by_row("first", ["1", "0", "Gelenk 1", "0-1", "L1"])
@row_by_row(
    ("head", "sign"),
    [("Gelenk", " | "), ("Gelenk (i)", " | "), ("", "| "), ("Segment", "\t"), ("", "\t"), ("i", ", "), ("", ",")],
)
def test_numbers_of_rows_stand_under_any_head_or_none(first: str, head: str, sign: str) -> None:
    """They say nothing of the arm."""
    second = first.replace("1", "2").replace("0", "1")
    rows = [(first, "0.4", "90°", "0", "q1"), (second, "0.3", "0", "0", "q2")]
    text = "\n".join(sign.join(row) for row in ((head, "a", "alpha", "d", "theta"), *rows))
    robot = imported(text, convention="standard")
    assert gap(robot, [0.3, 0.5], standard(0.3, 0, 0.4, math.pi / 2) @ standard(0.5, 0, 0.3, 0)) < 1e-15


@pytest.mark.parametrize("head", ["Segment ", "link ", "  "])
def test_numbers_of_rows_stand_between_blanks_too(head: str) -> None:
    """As a table looks that was copied from a page; a line of prose with the same words is none."""
    prose = "Columns a alpha d theta\nof the arm\n"
    robot = imported(f"{prose}{head}a alpha d theta\n1 0.4 90° 0 q1\n2 0.3 0 0 q2\n", convention="standard")
    assert gap(robot, [0.3, 0.5], standard(0.3, 0, 0.4, math.pi / 2) @ standard(0.5, 0, 0.3, 0)) < 1e-15


@pytest.mark.parametrize("head", ["prismatic", "offset2"])
def test_numbers_behind_the_first_column_number_no_rows(head: str) -> None:
    """There 0 and 1 say something of the arm, as whether a joint slides."""
    with pytest.raises(FileError, match=f"x:1:17: {head} is no column"):
        imported(f"a,alpha,d,theta,{head}\n0.3,0,0,q1,0\n0,0,q2,0,1\n", convention="standard")


@pytest.mark.parametrize("texts", [("1", "3"), ("2", "3"), ("5", "5"), ("a", "b")])
def test_other_numbers_under_a_head_that_is_not_known_are_told(texts: tuple[str, str]) -> None:
    """They may be what somebody has mistyped."""
    rows = "".join(f"{text},1,0,0,q{i}\n" for i, text in enumerate(texts, 1))
    with pytest.raises(FileError, match=r"x:1:1: mast is no column"):
        imported(f"mast,a,alpha,d,theta\n{rows}", convention="standard")


@pytest.mark.parametrize(
    ("above", "hint"),
    [
        ("Modified DH parameters", "the text above it says modified: add --convention modified"),
        ("After Craig (2005)", "the text above it says modified: add --convention modified"),
        ("The classical table, as usual", "the text above it says standard: add --convention standard"),
        ("Standard and modified tables differ", "add --convention standard or --convention modified"),
        ("An arm", "add --convention standard or --convention modified"),
    ],
)
def test_what_a_page_calls_its_convention_is_proposed_and_not_taken(above: str, hint: str) -> None:
    """It may speak of another table."""
    with pytest.raises(FileError) as caught:
        imported(f"{above}\n\n| a | alpha | d | theta |\n|---|---|---|---|\n| 1 | 0 | 0 | q1 |\n")
    assert [problem.hint for problem in caught.value.problems] == [hint]


def test_a_table_in_a_paper_has_units_stars_and_rules() -> None:
    """And text around it with signs of its own."""
    robot = of_file("foreign/scara.tex").copy(parameters={"l2": 0.21})
    rows = [
        standard(0.3, 0.32, 0.25, 0),
        standard(-0.5, 0, 0.21, math.pi),
        standard(0, 0.1, 0, 0),
        standard(0.7, 0.06, 0, 0),
    ]
    assert (robot.variables, robot.convention) == (("theta1", "theta2", "d3", "theta4"), Convention.STANDARD)
    assert gap(robot, [0.3, -0.5, 0.1, 0.7], np.linalg.multi_dot(rows)) < 1e-15


@pytest.mark.parametrize("ends", [("", ""), ("\\hline ", ""), ("  ", "[2pt]  \\hline")])
@pytest.mark.parametrize("dollar", ["", "$"])
def test_a_table_in_latex_is_read(ends: tuple[str, str], dollar: str) -> None:
    """With what stands around it, rules and spaces among the rows, and formulas in dollars."""
    before, after = ends
    heads = " & ".join(("Link", *(f"{dollar}{head}{dollar}" for head in (r"a_i", r"\alpha_i", "d_i", r"\theta_i"))))
    rows = [("1", "0.4", r"\frac{\pi}{2}", "0", r"\theta_1"), ("2", "0.3", r"0^{\circ}", "0", r"\theta_2")]
    cells = [" & ".join((row[0], *(f"{dollar}{cell}{dollar}" for cell in row[1:]))) for row in rows]
    lines = [r"\begin{tabular}{c|cccc}", r"\toprule", heads + r" \\ \hline", r"\midrule"]
    lines += [f"{before}{line} \\\\{after}" for line in cells]
    text = "\n".join(["We see & know.", *lines, r"\bottomrule", r"\end{tabular}", "more & more"])
    robot = imported(text)
    assert robot.convention is Convention.STANDARD
    assert gap(robot, [0.3, 0.5], standard(0.3, 0, 0.4, math.pi / 2) @ standard(0.5, 0, 0.3, 0)) < 1e-15


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_fifth_column_makes_a_calibrated_arm(convention: str) -> None:
    """A turn about y behind a standard row, and in front of a modified one."""
    robot = imported("a,alpha,d,theta,β [deg]\n0.4,90deg,0,q1,0.1\n0.3,0,0,q2,0\n", convention=convention)
    tilt = np.eye(4)
    angle = math.radians(0.1)
    tilt[[0, 2], [0, 2]], tilt[0, 2], tilt[2, 0] = math.cos(angle), math.sin(angle), -math.sin(angle)
    if convention == "standard":
        expected = standard(0.3, 0, 0.4, math.pi / 2) @ tilt @ standard(0.5, 0, 0.3, 0)
    else:
        expected = tilt @ modified(0.3, 0, 0.4, math.pi / 2) @ modified(0.5, 0, 0.3, 0)
    assert gap(robot, [0.3, 0.5], expected) < 1e-15


@pytest.mark.parametrize(
    "text",
    [
        "theta d a alpha\nq1 0.1 0.4 0;\nq2 0 0.3 pi/2;\n",
        "theta, d, a, alpha\n- [q1, 0.1, 0.4, 0]\n- [q2, 0, 0.3, pi/2]\n",
        "# theta, d, a, alpha\ndh = [[q1, 0.1, 0.4, 0],\n      [q2, 0, 0.3, pi/2]]\nprint(dh)\n",
        "%  theta  d   a   alpha\nDH = [ q1 0.1 0.4 0;\n       q2 0   0.3 pi/2 ];\nrobot = made(DH);\n",
        "% theta d a alpha\nDH = [\n  q1 0.1 0.4 0\n  q2 0 0.3 pi/2\n];\n",
    ],
)
def test_rows_may_stand_in_brackets_as_programs_have_them(text: str) -> None:
    """Below a line with their heads, which may be a comment; what comes behind the list is no row."""
    robot = imported(text, convention="standard")
    expected = standard(0.3, 0.1, 0.4, 0) @ standard(0.5, 0, 0.3, math.pi / 2)
    assert gap(robot, [0.3, 0.5], expected) < 1e-15


@pytest.mark.parametrize(
    "text", ["0.4 0 0 q1\n0.3 0 0 q2", "# arm\n- [a1, 0, 0, q1]\n", "DH = [0 0.1 0.4 pi/2;\n 1 0 0.3 1];"]
)
def test_rows_without_heads_are_told(text: str) -> None:
    """Nobody knows which column is which."""
    with pytest.raises(FileError, match=r"rows of a DH table. they have no heads .name the columns in a line above"):
        imported(text, convention="standard")


def test_limits_and_what_says_nothing_of_links_stand_in_tables_of_makers() -> None:
    """Limits of a turn in degrees and of a slide in millimetres, as the heads say; other columns are named."""
    text = (
        "Kinematics,θ [deg],a [mm],d [mm],α [deg],Mass [kg],min,max\n"
        "Joint 1,q1,0,290,-90,3.7,-165°,165°\nJoint 2,q2-90,270,0,0,8.4,,\nJoint 3,0,0,q3,0,0.2,0,0.1 m\n"
    )
    robot = imported(text, convention="standard")
    assert {name: tuple(map(value_text, pair)) for name, pair in robot.limits.items()} == {
        "q1": ("-165°", "165°"),
        "q3": ("0 m", "0.1 m"),
    }
    assert import_robot(text, "x", Wish("arm", "standard")).remarks == ("left out: Mass [kg]",)
    expected = standard(0.3, 0.29, 0, -math.pi / 2) @ standard(0.5 - math.pi / 2, 0, 0.27, 0) @ shift(0, 0, 0.05)
    assert gap(robot, [0.3, 0.5, 0.05], expected) < 1e-15


def test_units_of_bare_numbers_may_be_said_beside_the_file() -> None:
    """Of lengths, of angles, or of both; what has its own unit keeps it, and so does the offset of a slide."""
    text = "a,alpha,d,theta,offset,lower,upper\n400,90,0.1 m,q1,45,-90,pi/2\n0,0,q2,0,50,0,200\n"
    robot = imported(text, convention="standard", units="mm,deg")
    expected = standard(0.3 + math.pi / 4, 0.1, 0.4, math.pi / 2) @ shift(0, 0, 0.15)
    assert gap(robot, [0.3, 0.1], expected) < 1e-15
    assert [tuple(map(value_text, pair)) for pair in robot.limits.values()] == [("-90°", "90°"), ("0 m", "0.2 m")]


@pytest.mark.parametrize(
    "text",
    [
        '[{"a": 0.4, "alpha": 90, "d": 0, "theta_offset": 45}, {"a": 0.3, "alpha": 0, "d": 0, "theta_offset": 0}]',
        "a,alpha,d,offset\n0.4,90,0,45\n0.3,0,0,0\n",
    ],
)
def test_an_offset_alone_stands_in_the_place_of_theta(text: str) -> None:
    """The variable, which is not written, is added to it."""
    robot = imported(text, convention="standard", units="deg", joints="RR")
    expected = standard(0.3 + math.pi / 4, 0, 0.4, math.pi / 2) @ standard(0.5, 0, 0.3, 0)
    assert gap(robot, [0.3, 0.5], expected) < 1e-15


@pytest.mark.parametrize(
    "text", ["a,alpha,d,theta\n0.4,1.5708 rad,0,q1\n", "L(1) = Link([0 0 0.4 1.5708]);\nr = SerialLink(L);\n"]
)
def test_right_angles_may_stay_as_they_were_typed(text: str) -> None:
    """In tables and listings as in a URDF; the file that is written says so."""
    for typed, alpha in ((True, 1.5708), (False, math.pi / 2)):
        robot = import_robot(text, "x", Wish("arm", "standard", as_typed=typed))
        assert gap(read_robot(robot_text(robot), "x", "arm"), [0.3], standard(0.3, 0, 0.4, alpha)) < 1e-15


def test_ranges_of_makers_are_limits() -> None:
    """One number for both, two in any order of signs, from one to the other; a unit in the head."""
    robot = imported(
        "i\ta(i-1)\talpha(i-1) [deg]\td(i)\ttheta(i)\tRange [deg]\n1\t0\t0\t0\tq1\t±170\n"
        "2\t0.1\t-90\t0\tq2\t+90°/-80°\n3\t0\t90\t*\t0\t0..100 mm\n4\t0\t0\t-\tvar\t-\n",
        convention="modified",
    )
    assert {name: tuple(map(value_text, pair)) for name, pair in robot.limits.items()} == {
        "q1": ("-170°", "170°"),
        "q2": ("-80°", "90°"),
        "d3": ("0 m", "0.1 m"),
    }
    expected = modified(0.3, 0, 0, 0) @ modified(0.5, 0, 0.1, -math.pi / 2)
    expected = expected @ modified(0, 0.05, 0, math.pi / 2) @ modified(0.7, 0, 0, 0)
    assert gap(robot, [0.3, 0.5, 0.05, 0.7], expected) < 1e-15
    with pytest.raises(FileError, match=r"x:2:15: 'free' is no range .write ±170° or -170°..170°"):
        imported("a,alpha,d,theta,range\n0.1,pi/2,0,t1,free\n", convention="standard")


@pytest.mark.parametrize(
    "text",
    [
        "arm:\n  - {name: base, theta: q1, d: 100, a: 0, 'alpha [deg]': 90}\n  - {theta: q2, d: 0, a: 400, alpha: 0}\n",
        (
            '{"dh": {"base": {"theta": "q1", "d": 100, "a": 0, "alpha": "pi/2", "name": 1}, '
            '"top": {"theta": "q2", "d": 0, "a": 400, "alpha": 0, "type": "revolute"}}}'
        ),
    ],
)
def test_rows_may_have_keys_as_in_yaml_and_json(text: str) -> None:
    """In a list, or by name; other keys are named."""
    robot = imported(text, convention="standard", units="mm")
    assert import_robot(text, "x", Wish("arm", "standard")).remarks == ("left out: name",)
    expected = standard(0.3, 0.1, 0, math.pi / 2) @ standard(0.5, 0, 0.4, 0)
    assert gap(robot, [0.3, 0.5], expected) < 1e-15


@row_by_row(
    ("text", "said"),
    [
        ("- {a: 0, alpha: 90, d: 0, theta: q1}\n", "x:1:17: alpha: the angle 90 has no unit"),
        ("- {a: 0, alpha: 0, d: 0, theta: q1}\n- {a: 0, d: 0, theta: q2}\n", "x:2:3: alpha is missing in this row"),
        ("- {a: [0], alpha: 0, d: 0, theta: q1}\n", "x:1:7: a: one value is wanted"),
        ("- {a: 0, alpha: 0, d: 0, theta: q1, type: ball}\n", "'ball' is no kind of joint"),
    ],
)
def test_rows_with_keys_are_refused_at_their_place(text: str, said: str) -> None:
    """As cells of a table are."""
    with pytest.raises(FileError) as caught:
        imported(text, convention="standard")
    assert said in str(caught.value)


def test_json_that_is_broken_is_told_where_its_name_promises_json() -> None:
    """Elsewhere a text may be anything."""
    with pytest.raises(FileError, match=r"arm.json:1:1: this '{' is never closed"):
        import_robot('{"a": 1', "arm.json", Wish("arm", "standard"))
    with pytest.raises(FileError, match="none of the forms"):
        imported('{"a": 1', convention="standard")


def test_rows_with_keys_say_no_convention_either() -> None:
    """Unless their file speaks of one."""
    with pytest.raises(FileError, match=r"the text above it says modified"):
        imported("# modified DH\n- {a: 0, alpha: 0, d: 0, theta: q1}\n")


def test_rows_of_numbers_get_the_joints_that_are_said() -> None:
    """By an offset column and kinds, or by letters; what stands in the cell is added."""
    robot = imported("theta,d,a,alpha,offset,type\nq1,0,1,1.5708 rad,90deg,R\n0,q2,0,0,0.1,P", convention="standard")
    assert [str(link.row.theta.degrees) for link in robot.links if link.row] == ["90", "0"]
    bare = imported("a,alpha,d,theta\n1,0,0,90°\n1,0,0.2,0\n0,0,0.1,0", convention="standard", joints="rpf")
    assert (bare.variables, bare.pattern) == (("theta1", "d2"), "RP")
    assert gap(bare, [0.3, 0.5], standard(0.3 + math.pi / 2, 0, 1, 0) @ shift(1, 0, 0.8)) < 1e-15


@row_by_row(
    ("text", "wish", "said"),
    [
        ("a,alpha,d,theta\n1,0,0,q1\n", {}, "does not say which convention"),
        ("a_{i-1},α_{i-1},d_i,θ_i\n1,0,0,q1\n", {"convention": "standard"}, "those of the modified convention"),
        ("a,alpha,d,theta\n", {"convention": "standard"}, "holds heads and no rows"),
        ("a,alpha,d,theta\n1,90,0,q1\n", {"convention": "standard"}, "x:2:3: alpha: the angle 90 has no unit"),
        ("a,alpha,d,theta\n1,0,0\n", {"convention": "standard"}, "3 cells, and 4 heads"),
        ("a,alpha,d,theta,ofset\n1,0,0,q1,3\n", {"convention": "standard"}, "did you mean offset?"),
        ("a,alpha,d,theta\n1,0,0,0\n", {"convention": "standard"}, "no row holds a joint variable"),
        ("a,alpha,d,theta\n1,0,0,q1\n1,0,0,q1\n", {"convention": "standard"}, "q1 stands in two rows"),
        ("a,alpha,d,theta\n1,0,0,q1+q2\n", {"convention": "standard"}, "row 1 names q1 and q2"),
        ("a,alpha,d,theta\n1,0,0,q1]\n", {"convention": "standard"}, "x:2:"),
        ("a,alpha,d,theta\n1,0,0,0\n", {"convention": "standard", "joints": "RR"}, "1 row, and --joints RR"),
        ("a,alpha,d,theta,type\n1,0,0,0,ball\n", {"convention": "standard"}, "'ball' is no kind of joint"),
        ("a,alpha,d,theta\n1,0,0,q1\n", {"convention": "standrad"}, "did you mean standard"),
        (
            "a,alpha,d,theta\n1,0,0,q1\n",
            {"convention": "standard", "units": "mn"},
            "mn is no unit of lengths or angles",
        ),
        (
            "a,alpha,d,theta\n1,0,0,q1\n",
            {"convention": "standard", "units": "mm,cm"},
            "mm,cm are two units of one kind",
        ),
        (ARM_URDF, {"units": "deg"}, "angles of a URDF are in radians, not in deg"),
        ("a,alpha,d,theta\n1,0,0,q1\n", {"convention": "standard", "tip": "t"}, "only a URDF has links"),
        (ARM_URDF, {"units": "mm"}, "lengths of a URDF are in metres, not in mm (divide them in the file"),
        (
            "x: {x: 1, y: 0, z: 0, roll: 0, pitch: 0, yaw: 0}",
            {"units": "cm"},
            "lengths of a kinematics file of ROS are",
        ),
        (ARM_URDF, {"joints": "RR"}, "a URDF says itself what its joints do (leave --joints out)"),
        ("SerialLink([Link([0 0 1 0])])", {"joints": "R"}, "a listing of a robotics toolbox says itself what its"),
        ("hello", {}, "none of the forms"),
        ("<sdf/>", {}, "this is an SDF"),
    ],
)
def test_a_table_that_is_none_is_refused(text: str, wish: dict[str, str], said: str) -> None:
    """With line and column where there are some."""
    with pytest.raises(DhcliError) as caught:
        imported(text, **wish)
    assert said in str(caught.value)


def test_the_kinematics_of_ros_are_the_robot_of_the_data_sheet() -> None:
    """The UR5e of the library has its numbers from the maker's DH table."""
    robot, known = of_file("foreign/ur5e-kinematics.yaml"), load_robot("ur5e")
    draw = np.random.default_rng(1)
    for _ in range(20):
        q = draw.uniform(-3, 3, 6).tolist()
        assert gap(robot, q, forward(known, q).matrix) < 1e-9
    table = of_file("foreign/ur5e-kinematics.yaml", convention="standard")
    assert table.convention is Convention.STANDARD
    assert gap(table, q, forward(known, q).matrix, start="base", end="tool") < 1e-9


def test_a_slide_among_the_kinematics_of_ros_is_said() -> None:
    """Nothing in the file tells."""
    text = "a: {x: 0, y: 0, z: 0.3, roll: 0, pitch: 0, yaw: 0}\nb: {x: 0.1, y: 0, z: 0, roll: 0, pitch: 1.57, yaw: 0}\n"
    robot = imported(text, joints="RP")
    assert robot.pattern == "RP"
    assert forward(robot, [0, 0.2]).position == pytest.approx((0.3, 0, 0.3))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a: {x: 0, y: 0, z: 0, roll: 0, pitch: 0}\n", "yaw: is missing"),
        ("a: {x: 0, y: 0, z: one, roll: 0, pitch: 0, yaw: 0}\n", "z: 'one' is no number"),
        ("kinematics:\n  a: {x: 0, y: 0, z: nan, roll: 0, pitch: 0, yaw: 0, w: 3}\n", "w: unknown key"),
        ("kinematics: 3\nroll: 3\nyaw: 3\n", "names no joint"),
    ],
)
def test_kinematics_that_are_none_are_refused(text: str, said: str) -> None:
    """All at once."""
    with pytest.raises(FileError) as caught:
        imported(text)
    assert said in str(caught.value)


def test_a_urdf_is_written_as_products_or_as_a_table() -> None:
    """The same chain."""
    text = (DATA / "urdf" / "three-joints.urdf").read_text("utf-8")
    products, table = imported(text, tip="tool0"), imported(text, tip="tool0", convention="modified")
    assert (products.convention, table.convention) == (Convention.PRODUCT, Convention.MODIFIED)
    q = [0.3, -1.1, 0.5]
    assert gap(table, q, forward(products, q).matrix, start="base", end="tool") < 1e-14


@row_by_row(
    ("text", "form"),
    [
        ("<?xml version='1.0'?><robot name='x'/>", Form.URDF),
        ("<robot xmlns:xacro='http://x' name='x'/>", Form.XACRO),
        ("<!-- c --><sdf version='1.6'/>", Form.SDF),
        ("<mujoco model='x'/>", Form.MJCF),
        ("<html/>", Form.XML),
        ("\ufeffa,alpha,d,theta\n", Form.TABLE),
        ("text\n\n| i | a_i | α_i | d_i | θ_i |\n", Form.TABLE),
        ("r = SerialLink([0 0 1 0]);", Form.LISTING),
        ("joint:\n  x: 0\n  roll: 1\n  yaw: 2\n", Form.KINEMATICS),
        ('{\n  "dhcli": 1,\n  "command": "show"', Form.RESULT),
        ('{"links": [{"dhcli": 1}]}', None),
        ("format: 1\ntitle: t\n", None),
        ("a, b, c, d\n1, 2, 3, 4\n", None),
        ("My links: see Link (3)", None),
        ("", None),
    ],
)
def test_a_file_is_told_by_how_it_begins(text: str, form: Form | None) -> None:
    """And nothing is taken for what it is not."""
    assert form_of(text) is form


def test_a_result_for_programs_is_no_table() -> None:
    """Its rows are there without the lengths, the limits and what stands still."""
    content = {"convention": "modified", "links": [{"a": "0", "alpha": "0", "d": "d_f", "theta": "0"}]}
    text = json.dumps({"dhcli": 1, "command": "show", "ok": True, "data": content, "problems": []}, indent=2)
    with pytest.raises(
        FileError, match=r"this is a result for programs.*dhcli describe ROBOT --as standard -o arm.yaml"
    ):
        imported(text, convention="modified")


def test_looking_at_a_file_takes_no_longer_than_its_length() -> None:
    """Whatever it repeats; a pattern that tries again and again would not end."""
    for piece in ("Link(", "a,", "|", "<", "roll", "(", "a alpha d theta ", "{roll", "'", "\t", " "):
        assert form_of(piece * 30_000) in (None, *Form)


def test_every_file_of_the_library_is_one_of_dhclis_own() -> None:
    """None is taken for something else."""
    root = Path(__file__).parents[3]
    for path in in_turn([*root.glob("robots/**/*.yaml"), *root.glob("exercises/**/*.yaml")], 0, 3):
        assert form_of(path.read_text("utf-8")) in (None, Form.TABLE, Form.LISTING)


def test_exact_numbers_stay_exact() -> None:
    """0.1 is a tenth."""
    robot = imported("a,alpha,d,theta\n0.1,0,0,q1\n", convention="standard")
    row = robot.links[0].row
    assert row is not None
    assert row.a.value == Fraction(1, 10)  # type: ignore[attr-defined]
