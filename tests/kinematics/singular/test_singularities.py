"""Singularities by rules: the determinants of the books, proved in residues, and zero where the numeric rank falls."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhcli import jacobian, singularities
from dhcli.algebra.floats import Floats
from dhcli.algebra.residues import Residues, field_of_the_day
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.moves import Rot, Trans
from dhcli.kinematics.robot import Link, Robot
from dhcli.kinematics.singular.finding import MOST_JOINTS
from dhcli.kinematics.singular.modular import determinant
from dhcli.kinematics.singular.result import Singularities
from dhcli.kinematics.values import numbers, parameter_values
from dhcli.kinematics.velocity.form import GEOMETRIC, Which
from dhcli.kinematics.velocity.jacobian import six_rows
from dhcli.kinematics.velocity.view import MotionView, parts
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Product, Symbol, number, power
from dhcli.notation.walk import operations
from dhcli.notation.writer import write
from tests.kinematics.arms import (
    COBOT,
    FIVE,
    IIWA,
    PAN_TILT,
    PLANAR_4R,
    hinges,
    joint_point,
    moving_robots,
    robot_once,
    with_values,
)
from tests.nightly import NIGHT, in_turn

if TYPE_CHECKING:
    from numpy.typing import NDArray

DETERMINANTS = {
    "planar-2r": "a1*a2*s2",
    "scara-yim": "a1*a2*s2",
    "scara": "-l2*l3*s2",
    "articulated": "-a2*a3*s3*(a2*c2 + a3*c23)",
    "cylindrical": "d3",
    "spherical-wrist": "-s5",
    "stanford": "d3^2*s2*s5",
    "puma560": "-a2*s5*(a2*c2 + a3*c23 - d4*s23)*(a3*s3 + d4*c3)",
    "zhou-6r": "-l2*l3*c3*s5*(l2*c2 + l3*s23)",
    "ur5e": "a2*a3*s3*s5*(a2*c2 + a3*c23 + d5*s234)",
    "puma200": "-b*c*c2*s4*(b*(c3*c4*c5 - s3*s5) - s4*c5*(d - a))",
}
"""As the books print them."""

SQUARE = [name for name in moving_robots() if name not in {"panda", "zhou-3r", "zhou-3r-modified"}]
SQUARE = [name for name in SQUARE if not name.startswith("dh-link")]


def factors_in(text: str) -> set[str]:
    """The factors of a product as text, in no order; the sign of the whole is one of them."""
    sign, body = ("-", text[1:]) if text.startswith("-") else ("", text)
    depth, found, piece = 0, [], ""
    for letter in body:
        depth += (letter == "(") - (letter == ")")
        if letter == "*" and not depth:
            found.append(piece)
            piece = ""
        else:
            piece += letter
    return {sign, *found, piece}


@pytest.mark.parametrize("name", DETERMINANTS)
def test_the_determinants_are_those_of_the_books(name: str) -> None:
    """To the letter, up to the order of the factors, sign included."""
    robot = robot_once(name)
    found = singularities(robot)
    assert found.determinant is not None
    text = write(found.determinant, "short", robot.writing)
    assert factors_in(text) == factors_in(DETERMINANTS[name])


@pytest.mark.parametrize("name", SQUARE)
def test_the_factors_multiply_to_the_determinant(name: str) -> None:
    """At random points of the field, exactly, sign included; the rows in the axes of the start."""
    robot = robot_once(name)
    found = singularities(robot)
    assert found.determinant is not None
    view = MotionView.of(robot)
    joints = found.joints
    made = tuple(parts(robot, view, joints, merged=False))
    kept = [GEOMETRIC.labels.index(label) for label in found.rows]
    for _ in range(50 if NIGHT else 4):
        at = Residues(angles=[move.angle for move in robot.chain if isinstance(move, Rot)])
        linear, angular = six_rows(made, len(joints), at)
        rows = [[at.value(entry) for entry in row] for row in (*linear, *angular)]
        assert at.value(found.determinant) == determinant([rows[k] for k in kept], at.field)


@pytest.mark.parametrize("name", SQUARE)
def test_the_rank_falls_where_a_factor_is_zero_and_not_elsewhere(name: str) -> None:
    """By singular values, at a pose found for each factor and at others with nothing special about them."""
    robot, found = robot_once(name), singularities(robot_once(name))
    parameters = with_values(robot)
    for seed in in_turn((1, 2, 3), SQUARE.index(name), 3):
        assert rank_at(robot, found, joint_point(robot, seed), parameters) == found.rank
    assert len(found.factors) == len({factor.zeros for factor in found.factors})
    for factor in found.factors:
        q = root_of(robot, factor.zeros[0], factor.joints, joint_point(robot, 1), parameters)
        assert q is not None, factor
        assert rank_at(robot, found, q, parameters) < found.rank


CONDITIONS = [
    ("puma560", "linear"),
    ("zhou-6r", "linear"),
    ("scara-yim", "linear"),
    ("cylindrical-wrist", "linear"),
    ("ur5e", "angular"),
    ("stanford", "angular"),
    ("panda", "angular"),
    ("spherical-wrist", "all"),
]


@pytest.mark.parametrize(("name", "part"), CONDITIONS)
def test_every_singular_pose_meets_a_condition(name: str, part: Which) -> None:
    """Poses with a wrench on which no joint works, by Newton's steps from anywhere: all of them are on the list."""
    robot, parameters = robot_once(name), with_values(robot_once(name))
    found = singularities(robot, part=part)
    assert found.finding == "conditions"
    lengths = numbers(parameter_values(robot, parameters))
    kept = [GEOMETRIC.labels.index(label) for label in found.rows]
    count = len(robot.variables)

    def columns(many: NDArray[np.float64]) -> NDArray[np.float64]:
        rows = jacobian(robot, many, parameters=parameters)[:, kept]
        return rows if rows.shape[1] <= count else rows.transpose(0, 2, 1)

    draw, met = np.random.default_rng(4), 0
    for _ in range(10 if NIGHT else 6):
        q = draw.uniform(-1.5, 1.5, count)
        assert np.linalg.matrix_rank(columns(q[None])[0], 1e-6) == found.rank
        u = np.linalg.svd(columns(q[None])[0])[0][:, -1]
        for _ in range(30):
            around = np.vstack([q, q + 1e-6 * np.eye(count), q - 1e-6 * np.eye(count)])
            here, *others = columns(around)
            slopes = [(up - down).T @ u / 2e-6 for up, down in zip(others[:count], others[count:], strict=True)]
            wanted = np.array([*(here.T @ u), u @ u - 1])
            matrix = np.block([[np.array(slopes).T, here.T], [np.zeros((1, count)), 2 * u[None]]])
            step = np.linalg.lstsq(matrix, -wanted)[0]
            q, u = q + step[:count], u + step[count:]
            if np.abs(step).max() < 1e-13:
                break
        if np.linalg.svd(columns(q[None])[0], compute_uv=False)[-1] < 1e-9:
            over = Floats({**lengths, **dict(zip(robot.variables, q.tolist(), strict=True))})
            assert any(all(abs(over.value(zero)) < 1e-3 for zero in factor.zeros) for factor in found.factors)
            met += 1
    assert met > 2


def rank_at(robot: Robot, found: Singularities, q: list[float], parameters: dict[str, str | float]) -> int:
    """The rank of the task's Jacobian by its singular values."""
    matrix = jacobian(robot, q, part=found.part, parameters=parameters)
    values = np.linalg.svd(matrix, compute_uv=False)
    return int(np.count_nonzero(values > 1e-7 * values[0]))


def root_of(
    robot: Robot, zero: Expr, joints: tuple[str, ...], q: list[float], parameters: dict[str, str | float]
) -> list[float] | None:
    """Joint values at which an expression is zero, by halving; the joints that it depends on are tried in turn."""
    lengths = numbers(parameter_values(robot, parameters))

    def value(at: list[float]) -> float:
        return Floats({**lengths, **dict(zip(robot.variables, at, strict=True))}).value(zero)

    for joint in joints:
        k = robot.variables.index(joint)

        def moved(x: float, k: int = k) -> list[float]:
            return [x if j == k else v for j, v in enumerate(q)]

        grid = [-3.1 + 0.0617 * i for i in range(101)]
        after = value(moved(grid[0]))
        for left, right in pairwise(grid):
            before, after = after, value(moved(right))
            if before * after <= 0:
                low, high = left, right
                for _ in range(50):
                    middle = (low + high) / 2
                    low, high = (low, middle) if before * value(moved(middle)) <= 0 else (middle, high)
                return moved(low)
    return None


@pytest.mark.parametrize(
    ("name", "zero", "words"),
    [
        ("planar-2r", "s2", "axes 1 and 2 and the origin of frame 2 lie in one plane: the arm is stretched or folded"),
        ("puma560", "s5", "axes 4 and 6 fall in line"),
        (
            "puma560",
            "a3*s3 + d4*c3",
            "axes 2 and 3 and the wrist centre lie in one plane: the arm is stretched or folded",
        ),
        (
            "puma560",
            "a2*c2 + a3*c23 - d4*s23",
            "the wrist centre lies in the plane through axis 1 parallel to axis 2",
        ),
        ("articulated", "a2*c2 + a3*c23", "the origin of frame 3 lies on axis 1"),
        ("stanford", "d3", "the wrist centre lies on axis 2"),
        ("stanford", "s2", "the wrist centre lies in the plane through axis 1 parallel to axis 2"),
        ("ur5e", "s3", "axes 2, 3 and 4 lie in one plane: the arm is stretched or folded"),
        ("ur5e", "s5", "axes 4 and 6 are parallel"),
        ("cylindrical", "d3", "the origin of frame 3 lies on axis 1"),
        ("spherical-wrist", "s5", "axes 4 and 6 fall in line"),
    ],
)
def test_each_factor_is_said_in_words(name: str, zero: str, words: str) -> None:
    """Found by what becomes special there, whatever the robot is called."""
    robot = robot_once(name)
    said = {write(factor.zeros[0], "short", robot.writing): factor.words for factor in singularities(robot).factors}
    assert said[zero] == words


@pytest.mark.parametrize(
    ("name", "zero", "lost", "dependent"),
    [
        ("planar-2r", "s2", "moving the origin of frame 2 along the line from axis 1 to it", "theta1 theta2"),
        (
            "puma560",
            "s5",
            "turning about the perpendicular to axes 4 and 5, with the wrist centre at rest",
            "theta4 theta6",
        ),
        ("puma560", "a2*c2 + a3*c23 - d4*s23", "moving the wrist centre along axis 2", "theta1 theta2"),
        ("articulated", "a2*c2 + a3*c23", "moving the origin of frame 3 along axis 2", "theta1"),
        ("scara", "s2", "moving the origin of frame 3 along the line from axis 1 to it", "theta1 theta2"),
    ],
)
def test_each_factor_names_the_motion_that_is_lost(name: str, zero: str, lost: str, dependent: str) -> None:
    """And the joints that move alike there."""
    robot = robot_once(name)
    said = {write(factor.zeros[0], "short", robot.writing): factor for factor in singularities(robot).factors}
    assert said[zero].lost == lost
    assert " ".join(said[zero].dependent) == dependent


def test_simple_factors_are_said_as_joint_values() -> None:
    """Sines at 0 or 180°, cosines at right angles, slides at 0; others by what they are."""
    said = [factor.angles for factor in singularities(robot_once("stanford")).factors]
    assert sorted(said) == ["d3 is 0", "theta2 is 0 or 180°", "theta5 is 0 or 180°"]
    assert [f.angles for f in singularities(robot_once("zhou-6r")).factors if str(f.zeros[0]) == "c3"] == [
        "theta3 is 90° or -90°"
    ]
    assert [f.exponent for f in singularities(robot_once("stanford")).factors if f.joints == ("d3",)] == [2]


ELBOW = Robot.from_dh(
    [
        *((0.15, "-90°", 0.45, "q1"), (0.6, 0, 0, "q2 - 90°"), (0.115, "-90°", 0, "q3")),
        *((0, "90°", 0.63, "q4"), (0, "-90°", 0, "q5"), (0, 0, 0.095, "q6")),
    ],
    variables=[f"q{i}" for i in range(1, 7)],
)
"""An arm in numbers: the factor of its elbow has a root among the residues of every second prime only."""


def fields(robot: Robot, count: int = 8 if NIGHT else 4) -> list[Singularities]:
    """What is found with several primes."""
    found = []
    for _ in range(count):
        field_of_the_day.cache_clear()
        found.append(singularities(robot.copy()))
    return found


def test_what_a_factor_in_numbers_means_does_not_depend_on_the_prime() -> None:
    """It is said in words each time, and in joint values at which the rank falls."""
    for found in fields(ELBOW):
        (elbow,) = (factor for factor in found.factors if factor.joints == ("q3",))
        assert elbow.words.endswith("lie in one plane: the arm is stretched or folded")
        assert elbow.angles == "q3 is 100.34° or -79.66°"
    for q3 in (math.atan2(0.63, -0.115), math.atan2(-0.63, 0.115)):
        assert abs(math.degrees(q3) - {True: 100.34, False: -79.66}[q3 > 0]) < 0.005
        sizes = np.linalg.svd(jacobian(ELBOW, [0.3, 0.5, q3, 0.7, 0.9, 1.1]), compute_uv=False)
        assert sizes[-1] < 1e-12 < sizes[-2]


def test_a_picture_that_holds_at_special_points_alone_is_not_told() -> None:
    """The one factor of a wrist with an offset holds three joints and more: its points are drawn at random."""
    ((factor,),) = {found.factors for found in fields(COBOT, 8 if NIGHT else 2)}
    assert factor.words == "the columns of q1, q2, q3, q4, q5 and q6 become dependent"


@pytest.mark.parametrize(
    ("d4", "said"),
    [(0.0, "q3 is 0 or 180°"), (0.115, "q3 is 135° or -45°"), (-0.115, "q3 is 45° or -135°")],
)
def test_joint_values_are_told_of_a_factor_in_numbers(d4: float, said: str) -> None:
    """Of the elbow, a3 s3 + d4 c3."""
    rows = [(0.1, "-90°", 0.4, "q1"), (0.6, 0, 0, "q2"), (0.115, "-90°", 0, "q3")]
    arm = Robot.from_dh(rows, variables=["q1", "q2", "q3"])
    found = singularities(arm, point=(0, 0, d4))
    assert said in [factor.angles for factor in found.factors]


def test_a_factor_that_no_joint_value_makes_zero_says_so() -> None:
    """Its number is larger than its sine and cosine together."""
    arm = Robot.from_dh([(0.5, 0, 0, "q1"), (0.2, "90°", 0, "q2"), (0.1, 0, 0, "q3")], variables=["q1", "q2", "q3"])
    (never,) = (factor for factor in singularities(arm).factors if factor.angles == "at no value of q3")
    assert not never.words + never.lost


def test_seven_joints_have_conditions() -> None:
    """Those known of this arm, each a set of zeros, none of which follows from another."""
    found = singularities(IIWA)
    assert (found.finding, found.rank, found.determinant) == ("conditions", 6, None)
    assert str(found).split("\n") == ["s4 = 0", "s2 = 0 and c3 = 0", "s2 = 0 and s6 = 0", "c5 = 0 and s6 = 0"]
    assert found.factors[0].words == "axes 3 and 5 fall in line"


@pytest.mark.parametrize(
    ("zeros", "rank"),
    [
        ({4: 0}, 5),
        ({2: 0, 3: 90}, 5),
        ({2: 180, 6: 0}, 5),
        ({5: -90, 6: 180}, 5),
        ({2: 0}, 6),
        ({6: 0}, 6),
        ({3: 90}, 6),
    ],
)
def test_the_conditions_of_seven_joints_hold_in_numbers(zeros: dict[int, float], rank: int) -> None:
    """Alone, none of two is enough."""
    q = [math.radians(zeros.get(k, 17 + 23 * k)) for k in range(1, 8)]
    matrix = jacobian(IIWA, q, parameters={"d1": 0.34, "d3": 0.4, "d5": 0.4, "d7": 0.126})
    values = np.linalg.svd(matrix, compute_uv=False)
    assert np.count_nonzero(values > 1e-9) == rank


def test_five_joints_have_conditions() -> None:
    """By the determinants of five rows each."""
    found = singularities(FIVE)
    assert str(found).split("\n") == ["s3 = 0", "s234 = 0 and a1 + a2*c2 + a3*c23 = 0"]
    assert (found.finding, found.rank, found.part) == ("conditions", 5, "all")


def test_a_redundant_planar_arm_is_singular_where_it_is_straight() -> None:
    """All four axes in one plane."""
    assert str(singularities(PLANAR_4R)) == "s2 = 0 and s3 = 0"


def test_a_part_is_another_task() -> None:
    """The velocity of the wrist alone is a matter of three joints; the turning rates of the other ones too."""
    found = singularities(robot_once("puma560"), part="linear", end=4)
    assert str(found).split("\n") == ["a2*c2 + a3*c23 - d4*s23 = 0", "a3*s3 + d4*c3 = 0"]
    assert found.still == ("theta4",)
    assert singularities(robot_once("articulated"), part="all").finding == "never"


def test_two_axes_at_right_angles_lose_nothing_or_reach() -> None:
    """A 3x2 matrix has three minors: it falls only where the point is on axis 1 with axis 2 across, never together."""
    found = singularities(PAN_TILT)
    assert (found.part, found.rank, found.rows) == ("linear", 2, ("v_x", "v_y", "v_z"))
    assert str(found) == "a1 + a2*c2 = 0"


def test_the_place_of_the_point_decides() -> None:
    """The velocity of frame 3 of zhou-3r has no third freedom anywhere; that of its tool's tip has."""
    robot = robot_once("zhou-3r")
    found = singularities(robot)
    assert (found.finding, found.rank, found.still) == ("everywhere", 2, ("theta3",))
    tip = singularities(robot, point=("-e*cos(alpha)", "-e*sin(alpha)", "c"))
    assert (tip.finding, tip.rank) == ("factors", 3)
    assert len(tip.factors) == 2


def test_the_determinant_of_six_does_not_depend_on_the_point() -> None:
    """That of v alone does."""
    robot = robot_once("puma560")
    assert str(singularities(robot, point=("x", "y", "z"))) == str(singularities(robot))
    planar = robot_once("planar-2r")
    assert str(singularities(planar, point=("x", "y", 0)).determinant) != str(singularities(planar).determinant)


def test_a_longer_base_changes_nothing_but_the_axes() -> None:
    """From base to tool as from 0 to 6."""
    robot = robot_once("zhou-6r")
    assert str(singularities(robot, start="base", end="tool")) == str(singularities(robot))


def test_where_no_list_is_readable_right_angles_are_tried() -> None:
    """Panda: said, with what one or two joints at right angles do."""
    found = singularities(robot_once("panda"))
    assert (found.finding, found.rank, found.factors) == ("unreadable", 6, ())
    assert {"theta2": 0, "theta4": 0} in found.probed
    for turns in found.probed:
        q = [math.radians(90 * turns[n] if n in turns else 31 + 17 * k) for k, n in enumerate(found.joints)]
        assert np.linalg.matrix_rank(jacobian(robot_once("panda"), q), tol=1e-9) < 6


def test_a_general_arm_of_six_axes_is_not_written_out() -> None:
    """Nothing parallel, nothing meets: its determinant fills pages."""
    rows = [(f"a{k}", 50 + 7 * k, f"d{k}") for k in range(1, 7)]
    found = singularities(hinges("general", *rows))
    assert found.finding == "unreadable"
    assert found.rank == 6


def test_many_joints_are_not_tried() -> None:
    """Fifty have more determinants than there is time for."""
    found = singularities(hinges("snake", *[("a", 90, "")] * 50))
    assert (found.finding, found.probed) == ("unreadable", ())
    assert len(found.joints) > MOST_JOINTS


def test_slides_alone_are_never_singular() -> None:
    """A gantry moves everywhere alike."""
    found = singularities(robot_once("cartesian"))
    assert (found.finding, str(found.determinant)) == ("never", "-1")


def test_one_joint_is_never_singular() -> None:
    """Its end moves on a circle."""
    found = singularities(hinges("one", ("a", 0, "")))
    assert (found.finding, found.rank) == ("never", 1)


def test_two_parallel_slides_are_one_too_many() -> None:
    """Of three joints two move alike, everywhere."""
    x = Trans(Symbol("d1"), ZERO, ZERO)
    links = (
        Link(1, (x,)),
        Link(2, (Trans(Symbol("d2"), ZERO, ZERO),)),
        Link(3, (Rot("z", Angle.of("theta3")), Trans(Symbol("a"), ZERO, ZERO))),
    )
    robot = Robot("twins", "twins", "here", robot_once("scara").convention, ("d1", "d2", "theta3"), links, {"a": None})
    found = singularities(robot, part="linear")
    assert found.finding == "conditions"
    assert str(found) == "c3 = 0"


def test_lengths_may_be_put_in() -> None:
    """PUMA 560 without its offset at the elbow is simpler."""
    robot = robot_once("puma560")
    found = singularities(robot, parameters={"a3": 0})
    assert found.determinant is not None
    assert factors_in(str(found.determinant)) == factors_in("-a2*d4*s5*c3*(a2*c2 - d4*s23)".replace("s5*c3", "c3*s5"))


def test_an_angle_that_is_no_residue_is_put_back() -> None:
    """Twists of 1.1 rad: what is proved for any twist is written with this one."""
    twist = Angle(radians=Fraction(11, 10))
    robot = three_axes(twist, -twist)
    found = singularities(robot)
    assert found.determinant is not None
    assert "1.1" in str(found.determinant)
    q = [0.4, 0.7, 1.1]
    matrix = jacobian(robot, q, part="linear")
    at = Floats(dict(zip(robot.variables, q, strict=True)))
    assert at.value(found.determinant) == pytest.approx(np.linalg.det(matrix))


def three_axes(first: Angle, second: Angle) -> Robot:
    """Three hinges, a metre and a twist apart."""
    twists = (first, second, Angle())
    links = tuple(
        Link(k, (Rot("z", Angle.of(f"theta{k}")), Trans(number(1), ZERO, ZERO), Rot("x", twist)))
        for k, twist in enumerate(twists, 1)
    )
    variables = ("theta1", "theta2", "theta3")
    return Robot("odd", "odd", "here", Convention.PRODUCT, variables, links)


def test_a_root_that_is_no_residue_is_told() -> None:
    """The field holds the roots of small primes only."""
    root = power(number(37), Fraction(1, 2))
    robot = three_axes(Angle.in_degrees(90), Angle())
    links = (*robot.links[:2], Link(3, (*robot.links[2].moves, Trans(root, ZERO, ZERO))))
    with pytest.raises(RobotError, match="cannot be proved"):
        singularities(Robot("odd", "odd", "here", Convention.PRODUCT, robot.variables, links))


def test_numbers_in_the_table_stay_decimals() -> None:
    """0.4 times 0.3 is 0.12."""
    robot = robot_once("planar-2r")
    found = singularities(robot, parameters={"a1": "0.4 m", "a2": "0.3 m"})
    assert str(found.determinant) == "0.12*s2"


def test_a_coupled_joint_has_a_determinant_without_a_picture() -> None:
    """Half of its angle stands in the table; the determinant is proved all the same."""
    half = Angle.of("theta2") * Fraction(1, 2)
    links = (
        Link(1, (Rot("z", Angle.of("theta1")), Trans(Symbol("a"), ZERO, ZERO))),
        Link(2, (Rot("z", half), Trans(Symbol("b"), ZERO, ZERO))),
    )
    robot = Robot("gear", "gear", "here", Convention.PRODUCT, ("theta1", "theta2"), links, {"a": None, "b": None})
    found = singularities(robot)
    assert str(found.determinant) == "a*b*s(theta2/2)/2"
    assert [factor.joints for factor in found.factors] == [("theta2",)]


def test_determinants_have_no_more_operations_than_in_the_books() -> None:
    """Counted as the writer shows them."""
    for name, text in DETERMINANTS.items():
        found = singularities(robot_once(name)).determinant
        assert found is not None
        printed = sum(text.count(sign) for sign in "*+^") + text.count(" - ")
        assert operations(found) <= printed
        assert isinstance(found, Product) or operations(found) == 0
