"""Questions about motion: right answers against differences of poses, every slip by its name, bad questions refused."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.judge import Judge
from dhcli.checking.kinds import registry
from dhcli.checking.kinds.made import question_about
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import forward
from dhcli.kinematics.values import joint_values
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.parser import parse
from tests.nightly import in_turn
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise, Part

STEP = 1e-6
Q = {
    "planar-2r": (0.4, 0.9),
    "scara": (0.4, 0.9, 0.12),
    "cylindrical": (0.4, 0.2, 0.3),
    "articulated": (0.4, 0.7, -1.1),
    "stanford": (0.4, 0.7, 0.5, 0.3, 0.8, 0.2),
    "puma560": (0.3, -0.5, 0.4, 0.7, 0.9, -0.4),
    "ur5e": (0.3, -1.2, 1.1, -0.8, 1.3, 0.5),
}


@cache
def asked(robot: str, ask: str, q: tuple[float, ...] | None = None, **changes: object) -> tuple[Judge, Part]:
    """A question about a robot, in numbers where joint values are given; its judge is made once for all tests."""
    arm = load_robot(robot)
    values = joint_values(arm, list(q)) if q is not None else {}
    exercise: Exercise = question_about(arm, ask, numeric=q is not None, given=values)
    judge = Judge(replace(exercise, **changes))  # type: ignore[arg-type]
    return judge, judge.exercise.parts[0]


def told(robot: str, ask: str, answer: str, q: tuple[float, ...] | None = None, **changes: object) -> Mark:
    """An answer judged and explained."""
    judge, part = asked(robot, ask, q, **changes)
    return judge.check(part, answer)


def table(text: str) -> list[list[float]]:
    """Numbers out of an answer."""
    return [[float(cell.text) for cell in row] for row in parse_matrix(text)]


def differences(robot: str, q: tuple[float, ...]) -> list[list[float]]:
    """V above ω of the end frame for each joint, from poses on both sides of q."""
    arm = load_robot(robot)
    here = forward(arm, list(q)).rows
    columns = []
    for k in range(len(q)):
        one, other = (forward(arm, [x + s * STEP * (i == k) for i, x in enumerate(q)]).rows for s in (1, -1))
        change = [[(a - b) / (2 * STEP) for a, b in zip(r, s, strict=True)] for r, s in zip(one, other, strict=True)]
        spin = [[sum(change[i][m] * here[j][m] for m in range(3)) for j in range(3)] for i in range(3)]
        columns.append([change[0][3], change[1][3], change[2][3], spin[2][1], spin[0][2], spin[1][0]])
    return [list(row) for row in zip(*columns, strict=True)]


@pytest.mark.parametrize("robot", Q)
def test_the_jacobian_is_how_poses_differ(robot: str) -> None:
    """Central differences of the pose, for every kind of joint and convention."""
    judge, part = asked(robot, f"jacobian of 0..{len(Q[robot])}", Q[robot])
    shown, true = table(judge.expected(part)), differences(robot, Q[robot])
    assert all(abs(a - b) < 2e-4 for r, s in zip(shown, true, strict=True) for a, b in zip(r, s, strict=True))


@pytest.mark.parametrize("robot", Q)
def test_torques_and_rates_do_the_same_work(robot: str) -> None:
    """Tau · q' = F · v, at any rates."""
    end, q = len(Q[robot]), Q[robot]
    rates = [0.3, -0.5, 0.7, 0.2, -0.4, 0.6][:end]
    force = (3, -2, 5)
    judge, part = asked(robot, f"torques for {force} of 0..{end}", q)
    borne = [value for row in table(judge.expected(part)) for value in row]
    judge, part = asked(robot, f"velocity of 0..{end} with rates ({', '.join(map(str, rates))})", q)
    moved = [value for row in table(judge.expected(part)) for value in row]
    power = sum(a * b for a, b in zip(force, moved, strict=True))
    assert abs(sum(a * b for a, b in zip(borne, rates, strict=True)) - power) < 5e-3


@given(st.tuples(*[st.floats(0.2, 1.2)] * 3))
def test_joint_rates_give_the_velocity_back(q: tuple[float, float, float]) -> None:
    """J J⁻¹ v = v, where the arm is not singular."""
    judge, part = asked("articulated", "joint rates for (0.1, -0.2, 0.05) of 0..3", q)
    rates = [value for row in table(judge.expected(part)) for value in row]
    rows = differences("articulated", q)[:3]
    moved = [sum(a * b for a, b in zip(row, rates, strict=True)) for row in rows]
    assert all(abs(a - b) < 1e-3 for a, b in zip(moved, (0.1, -0.2, 0.05), strict=True))


@cache
def judge_in_letters(robot: str, ask: str) -> Judge:
    """The judge of a question about a robot that has letters of its own beside those of the robot."""
    names = ("dtheta1", "dtheta2", "v")
    arm = load_robot(robot)
    from dhcli.checking.exercise import Exercise, Part
    from dhcli.checking.kinds.registry import read_question
    from dhcli.checking.written import answer_scope

    part = Part("one", read_question(ask, answer_scope(arm, names)))
    return Judge(Exercise("one", "", "", "", (part,), arm, names=names))


@pytest.mark.parametrize(
    ("robot", "ask", "answer"),
    [
        ("planar-2r", "jacobian linear of 0..2 in frame 2", "[a1 s2, 0; a1 c2 + a2, a2; 0 0]"),
        ("planar-2r", "jacobian space of 0..2", "[0 0; 0 0; 1 1; 0 a1*s1; 0 -a1*c1; 0 0]"),
        ("planar-2r", "jacobian body of 0..2", "[0 0; 0 0; 1 1; a1*s2 0; a1*c2+a2 a2; 0 0]"),
        ("scara", "determinant of jacobian linear of 0..3", "-l2*l3*sin(theta2)"),
        ("spherical-wrist", "determinant of jacobian angular of 3..6", "-s5"),
        ("puma560", "entry 1 2 of jacobian of 0..4 in frame 3", "a2*s3 - d4"),
        ("articulated", "singular when linear of 0..3", "a2 c2 + a3 c23 = 0 or theta3 = 0 or 180°"),
        ("articulated", "singular when linear of 0..3", "a3*s3*(a2*c2 + a3*c23) = 0"),
        ("ur5e", "singular when 0..6", "s5, s3, a2 c2 + a3 c23 + d5 s234"),
        ("cylindrical", "singular when linear of 0..3", "d3 = 0"),
        ("planar-2r", "singular when linear of 0..2", "theta2 = k*180°"),
        ("spherical-wrist", "singular when angular of 3..6", "theta5 = n pi"),
        ("spherical-wrist", "singular when 3..6", "sin(theta5) = 0"),
        ("articulated", "singular when jacobian of 0..3", "s3 = 0, a2 c2 + a3 c23 = 0"),
        ("zhou-6r", "singular when 0..6", "theta3 = ±90°, s5 = 0, l2 c2 + l3 s23 = 0"),
        ("puma560", "singular when linear of 0..6", "a3 s3 + d4 c3 = 0 and a2 c2 + a3 c23 - d4 s23 = 0"),
        ("scara-yim", "singular when linear of 0..4", "s2 = 0"),
        ("scara-yim", "singular when angular of 0..4", "never"),
        ("ur5e", "singular when angular of 0..6", "s5 = 0 and s234 = 0"),
        ("ur5e", "singular when angular of 0..6", "s5 = s234 = 0"),
        ("ur5e", "singular when angular of 0..6", "s5 = 0\nand\ns234 = 0"),
        ("ur5e", "singular when angular of 0..6", "s5 = 0\n& s234 = 0"),
        ("ur5e", "singular when angular of 0..6", "(s5 = 0 and s234 = 0)"),
        (
            "scara-yim",
            "singular when linear of 0..4",
            "(theta2 = 0) or (theta2 = 180°)",
        ),
        ("ur5e", "singular when angular of 0..6", "theta5 = 0 or 180° and theta2+theta3+theta4 = 0 or 180°"),
        (
            "cylindrical-wrist",
            "singular when linear of 0..6",
            "d3 = 0 and s4 = 0 and c5 = 0; c4 = 0 and s5 = 0 and d3 + d6*c5 = 0",
        ),
        ("panda", "singular when angular of 0..7", "s2 = 0 ∧ s3 = 0 & s4 = 0 and s5 = 0 and s6 = 0"),
        ("planar-2r", "angular velocity of 0..2", "0, 0, dtheta1 + dtheta2"),
        ("planar-2r", "joint rates for (v, 0, 0) of 0..2 in frame 2", "v/(a1*s2), -v*(a1*c2 + a2)/(a1*a2*s2)"),
        ("planar-2r", "column 2 of jacobian linear of 0..2", "-a2 s12 i + a2 c12 j"),
        ("planar-2r", "column 2 of jacobian linear of 0..2", "(-a2*s12; a2*c12; 0)^T"),
        ("planar-2r", "column 2 of jacobian linear of 0..2", "[-a2*sin(q1+q2) a2*cos(q1+q2) 0].'"),
        ("planar-2r", "rank of jacobian linear of 0..2", "2"),
        ("planar-2r", "rank of jacobian linear of 0..2", "two"),
    ],
)
def test_any_form_of_the_right_answer_is_right(robot: str, ask: str, answer: str) -> None:
    """As books print it, and as people type it."""
    judge = judge_in_letters(robot, ask)
    mark = judge.check(judge.exercise.parts[0], answer)
    assert mark.verdict is Verdict.RIGHT, mark


SLIPS = [
    ("planar-2r", "jacobian of 0..2", "in-frame 2"),
    ("cylindrical", "jacobian of 0..3", "joint-kind d3"),
    ("cylindrical", "jacobian of 0..3", "joint-kind theta1"),
    ("articulated", "jacobian of 0..3", "axis-shifted"),
    ("puma560", "jacobian of 0..6", "axis-shifted"),
    ("articulated", "jacobian of 0..3", "joint-left-out theta1"),
    ("articulated", "jacobian of 0..3", "cross-reversed"),
    ("articulated", "jacobian linear of 0..3", "origin-not-subtracted"),
    ("puma560", "jacobian of 0..6 in frame 3", "reference 3"),
    ("articulated", "jacobian of 0..3", "angular-dropped"),
    ("articulated", "jacobian of 0..3", "columns-reversed"),
    ("articulated", "jacobian of 0..3", "rows-swapped"),
    ("cylindrical", "jacobian of 0..3", "slide-turns d2"),
    ("articulated", "jacobian angular of 0..3", "one-axis"),
    ("scara", "jacobian of 0..3", "zero-turned theta1 -90°"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "kilograms"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "millimetres"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "numbers-swapped 2 and 3"),
    ("articulated", "jacobian of 0..3", "entry-sign 4,2"),
    ("stanford", "determinant of jacobian of 0..6", "factor-forgotten d3"),
    ("stanford", "determinant of jacobian of 0..6", "factor-forgotten d3^2"),
    ("planar-2r", "jacobian linear of 0..2", "own-angle-only"),
    ("planar-2r", "jacobian linear of 0..2", "sums-from-base"),
    ("articulated", "jacobian linear of 0..3", "cosine-sign"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "transpose-forgotten"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "inverse-for-transpose"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "in-frame 3"),
    ("articulated", "torques for (1, 2, 3) of 0..3", "sign"),
    ("articulated", "joint rates for (0.1, 0.2, 0.3) of 0..3", "degrees"),
    ("articulated", "joint rates for (0.1, 0.2, 0.3) of 0..3", "transpose-for-inverse"),
    ("articulated", "velocity of 0..3 with rates (1, 2, -1)", "degrees"),
    ("articulated", "differential motion (0.1, 0.2, 0.3) turn (0.1, 0, 0.2) of 0..3", "other-side"),
    ("planar-2r", "determinant of jacobian linear of 0..2", "signs-of-minors"),
    ("planar-2r", "manipulability of jacobian linear of 0..2", "root-forgotten"),
    ("articulated", "singular when linear of 0..3", "half s3"),
    ("articulated", "singular when linear of 0..3", "factor-forgotten s3"),
    ("ur5e", "singular when angular of 0..6", "apart s234 and s5"),
    ("ur5e", "singular when angular of 0..6", "half s5"),
    ("ur5e", "singular when angular of 0..6", "sin-cos s234"),
    ("puma560", "rank of jacobian of 0..6", "full-rank"),
]


QUESTIONS = list(dict.fromkeys((robot, ask) for robot, ask, _ in SLIPS))
"""By day every other one is in numbers, for all its slips."""


@pytest.mark.parametrize(("robot", "ask", "slip"), SLIPS)
def test_a_slip_is_named_by_the_answer_it_leads_to(robot: str, ask: str, slip: str) -> None:
    """In numbers, and where the question has an answer in symbols there too; nothing else is named."""
    q = (0.3, -0.5, 0.4, 0.7, 0.0, -0.4) if ask.startswith("rank") else Q[robot]
    in_numbers = "degrees" in slip or ask.startswith(("manip", "rank"))
    for values in (q,) if in_numbers else in_turn((q, None), QUESTIONS.index((robot, ask)), 2):
        judge, part = asked(robot, ask, values)
        mark = judge.check(part, judge.answer_with(part, slip))
        assert mark.verdict is Verdict.WRONG
        assert mark.diagnosis is not None
        assert mark.diagnosis.ids == (slip,)


@row_by_row(
    ("ask", "problem"),
    [
        ("jacobian of 3..0", "frame 0 does not move against frame 3"),
        ("jacobian of 0..7", "has no frame 7"),
        ("column 4 of jacobian of 0..3", "6 rows and 3 columns"),
        ("determinant of jacobian of 0..2", "columns has no determinant"),
        ("determinant of jacobian angular of 0..3", "singular everywhere"),
        ("singular when angular of 0..3", "singular everywhere"),
        ("torques for (1, 2) of 0..3", "2 numbers, not three"),
        ("torques for (1, 2, 30°) of 0..3", ""),
        ("velocity of 0..3 with rates (1, 2)", "2 rates for 3 joints"),
        ("joint rates for (1, 0, 0) angular (0, 0, 1) of 0..3", "3 joints cannot make every velocity"),
        ("jacobian analytic xxy of 0..3", ""),
        ("jacobian sideways of 0..3", "asks nothing that is known"),
        ("differential motion (1, 0, 0) of 0..3 in frame 1", "one of the two frames"),
    ],
)
def test_a_question_that_cannot_be_asked_is_refused(ask: str, problem: str) -> None:
    """With what is wrong, when the exercise is read."""
    with pytest.raises(DhcliError) as error:
        asked("articulated", ask)
    assert problem in str(error.value)


@row_by_row(
    ("ask", "answer", "remark"),
    [
        ("jacobian linear of 0..2", "[1 2; 3 4]", "a 3x2 matrix was asked: rows of zeros are rows, too"),
        (
            "jacobian linear of 0..2",
            "1 2; 3 4; 0 0; 0 0; 0 0; 1 1",
            "matrix was asked: the rows of v or of ω alone",
        ),
        ("jacobian linear of 0..2", "1 2; 3 4; 0 0; 0 0", "the answer is 4x2; a 3x2 matrix was asked"),
        ("jacobian linear of 0..2", "[1 2 3; 4 5 6]", "3 rows and 2 columns were asked"),
        ("velocity of 0..2 with rates (1, 1)", "1, 2", "2 numbers are given, 3 were asked"),
        ("jacobian of 0..2", "1 2; 3 4; 5 6", "a 6x2 matrix was asked: half of its rows are missing, v or ω"),
        ("velocity of 0..2 with rates (1, 1)", "a1, 2, x", ""),
        ("singular when linear of 0..2", "a1 = 0", "write what the joints make zero"),
        ("singular when linear of 0..2", "theta2 = 1 rad", "write angles in degrees"),
        ("rank of jacobian linear of 0..2", "1.5", "a rank is a whole number"),
        ("manipulability of jacobian linear of 0..2", "_", ""),
    ],
)
def test_what_is_no_answer_is_not_wrong_but_unread(ask: str, answer: str, remark: str) -> None:
    """With what would be read."""
    mark = told("planar-2r", ask, answer, Q["planar-2r"])
    assert mark.verdict in (Verdict.CANNOT_READ, Verdict.SKIPPED)
    assert remark in " ".join(mark.remarks)


def test_a_sheet_in_millimetres_counts_lengths_and_their_powers_in_them() -> None:
    """A determinant of two lengths is in mm²; one in m² is right in another unit."""
    ask, q = "determinant of jacobian linear of 0..2", Q["planar-2r"]
    judge, part = asked("planar-2r", ask, q, unit="mm")
    assert abs(float(parse_number(judge.expected(part))) - 0.12e6 * 0.7833269) < 1
    assert "right in m" in " ".join(told("planar-2r", ask, "0.0940", q, unit="mm").remarks)


@pytest.mark.parametrize("unit", ["m", "mm"])
@pytest.mark.parametrize("ask", ["determinant of jacobian linear of 0..2", "manipulability of jacobian linear of 0..2"])
def test_an_area_may_have_its_unit(ask: str, unit: str) -> None:
    """Which is believed; a length and a volume are none, and say so. A bare number is in that of the sheet."""
    area = 0.4 * 0.3 * math.sin(0.9)
    right = [
        f"{area:.5f} m²",
        f"{area:.5f} m^2",
        f"{area * 1e6:.0f} mm²",
        f"w = {area * 1e4:.2f} cm^2",
        f"{area:.5f} m2",
    ]
    for answer in right[:-1]:
        assert told("planar-2r", ask, answer, (0.4, 0.9), unit=unit).verdict is Verdict.RIGHT, answer
    assert told("planar-2r", ask, f"{area * 1.005:.5f} m²", (0.4, 0.9), unit=unit).verdict is Verdict.CLOSE
    other = told("planar-2r", ask, f"{area * (1e6 if unit == 'm' else 1):.6f}", (0.4, 0.9), unit=unit)
    assert other.remarks == (f"right in {'mm' if unit == 'm' else 'm'}²; this sheet is in {unit}",)
    for typed, called in ((f"{area} m", "a length"), (f"{area} m^3", "a volume")):
        said = told("planar-2r", ask, typed, (0.4, 0.9), unit=unit).remarks[0]
        assert said == f"entry (1,1): this is {called}, an area is wanted"


def test_one_unit_behind_a_jacobian_is_that_of_its_lengths() -> None:
    """The rows of ω have none, and decimal commas may stand in it."""
    right = "[-427,7 -271,9; 495,1 126,7; 0 0; 0 0; 0 0; 1 1] mm"
    mark = told("planar-2r", "jacobian of 0..2", right, (0.4, 0.7346))
    assert mark.verdict is Verdict.RIGHT, mark.reading


def parse_number(text: str) -> str:
    """A number as it was typed, which must be one."""
    parse(text)
    return text


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        ("velocity of 0..2 with rates (0.5, -1)", "v_x = 66.65 mm/s, v_y = 0.1441 m/s, 0"),
        ("angular velocity of 0..2 with rates (0.5, -1)", "0, 0, -28.648 deg/s"),
        ("angular velocity of 0..2 with rates (0.5, -1)", "0 rad/s, 0, -0.5 rad/s"),
        ("torques for (0, 10, 0) of 0..2", "tau1 = 4.4867 N m, tau2 = 0.8025 N*m"),
        ("torques for (0, 10, 0) of 0..2", "τ_1 ≈ 4.4867 Nm; τ_2 ≈ 0.8025 Nm"),
        ("torques for (0, 10, 0) of 0..2", "4,4867 Nm; 0,8025 Nm"),
        ("torques for (0, 10, 0) of 0..2", "4486.7 Nmm, 802.5 N mm"),
        ("torques for (0, 10, 0) of 0..2", "448.67 Ncm; 80.25 N·cm"),
        ("torques for (0, 10, 0) of 0..2", "0.0044867 kN·m, 802.5 mNm"),
        ("torques for (0, 10, 0) of 0..2", "(4486.7, 802.5) Nmm"),
        ("torques for (0, 10, 0) of 0..2", "(4,4867; 0,8025) Nm"),
        ("torques for (0, 10, 0) of 0..2", "[4.4867; 0.8025]ᵀ"),
        ("velocity of 0..2 with rates (0.5, -1)", "(0,06665; 0,1441; 0) m/s"),
        ("velocity of 0..2 with rates (0.5, -1)", "v = (66.65 | 144.1 | 0)ᵀ mm/s"),
        ("angular velocity of 0..2 with rates (0.5, -1)", "0; 0; -0,5 rad/s"),
        ("angular velocity of 0..2 with rates (0.5, -1)", "0, 0, -0.5 rad·s⁻¹"),
        ("velocity of 0..2 with rates (0.5, -1)", "v_x ≈ 0.06665 m s^-1, v_y ≈ 0.1441 m s^{-1}, v_z = 0"),
    ],
)
def test_units_of_rates_and_forces_may_stand_behind_numbers(ask: str, answer: str) -> None:
    """As people write them; where none stands it is that of the sheet, radians and newtons."""
    mark = told("planar-2r", ask, answer, Q["planar-2r"])
    assert mark.verdict is Verdict.RIGHT, mark


@row_by_row(
    ("robot", "ask", "answer", "said"),
    [
        ("planar-2r", "torques for (0, 10, 0) of 0..2", "4.4867 N, 0.8025 N", "number 1 is in N; N m is wanted"),
        ("planar-2r", "torques for (0, 10, 0) of 0..2", "4.4867, 0.8025 N", "number 2 is in N; N m is wanted"),
        ("planar-2r", "torques for (0, 10, 0) of 0..2", "4.4867 kN, 0.8 N", "number 1 is in kN; N m is wanted"),
        ("planar-2r", "torques for (0, 10, 0) of 0..2", "4.4867 rad/s, 0.8", "number 1 is in rad/s; N m is wanted"),
        ("cylindrical", "torques for (0, 10, 0) of 0..3", "(1 N, 0, 2)", "number 1 is in N; N m is wanted"),
        ("cylindrical", "torques for (0, 10, 0) of 0..3", "(1 N m, 0, 2 N m)", "number 3 is in N m; N is wanted"),
        ("cylindrical", "torques for (0, 10, 0) of 0..3", "[1, 0 rad/s, 2]", "number 2 is in rad/s; N is wanted"),
        ("planar-2r", "joint rates for (0.1, 0.2, 0) of 0..2", "1 N, 2 N", "number 1 is in N; rad/s is wanted"),
        ("planar-2r", "joint rates for (0.1, 0.2, 0) of 0..2", "1 m/s, 2", "number 1 is in m/s; rad/s is wanted"),
        ("planar-2r", "velocity of 0..2 with rates (1, 2)", "1 m/s; 2 rad/s; 0", "number 2 is in rad/s; m/s is wanted"),
        ("planar-2r", "jacobian angular of 0..2", "[0 0; 0 0; 1 N, 1]", "N is a unit of another kind"),
        ("planar-2r", "jacobian linear of 0..2", "[asin(1/2) 0; 0 0; 0 0]", "an inverse function is an angle"),
    ],
)
def test_a_unit_of_another_kind_costs_no_try(robot: str, ask: str, answer: str, said: str) -> None:
    """It is told which is wanted where."""
    mark = told(robot, ask, answer, Q[robot])
    assert mark.verdict is Verdict.CANNOT_READ, mark
    assert said in mark.remarks[0]


@pytest.mark.parametrize("answer", ["(1 N m, 0 N, 2 N)", "1 N*m; 0; 2 N", "tau1 = 1 N·m, f2 = 0 N, f3 = 2 N"])
def test_torques_and_forces_of_an_arm_that_turns_and_slides_may_have_their_units(answer: str) -> None:
    """Each its own."""
    assert told("cylindrical", "torques for (0, 10, 0) of 0..3", answer, Q["cylindrical"]).verdict is Verdict.WRONG


def test_at_a_singular_pose_there_are_no_rates() -> None:
    """An error that says so, and no infinite numbers."""
    judge, part = asked("planar-2r", "joint rates for (0.1, 0, 0) of 0..2", (0.3, 0.0))
    with pytest.raises(DhcliError, match="singular at the values given"):
        judge.expected(part)


def test_only_one_of_two_angles_is_half_an_answer() -> None:
    """Sin theta2 = 0 has a second zero half a turn on."""
    mark = told("planar-2r", "singular when linear of 0..2", "theta2 = 0")
    assert mark.verdict is Verdict.WRONG
    assert "half a turn on" in " ".join(mark.remarks)
    assert told("planar-2r", "singular when linear of 0..2", "theta2 = 0, theta2 = 180°").verdict is Verdict.RIGHT
    for elsewhere in ("theta1 = 0", "theta2 = 90°"):
        other = told("planar-2r", "singular when linear of 0..2", elsewhere).remarks
        assert other == ("0 of 1 are right", f"the rank need not fall where {elsewhere.removesuffix('°')}°")


def test_a_half_right_list_earns_a_part() -> None:
    """One of two factors; a wrong one beside it costs as much."""
    ask = "singular when linear of 0..3"
    assert told("articulated", ask, "s3 = 0").earned == pytest.approx(0.5)
    assert told("articulated", ask, "s3 = 0, c2 = 0").earned == 0


@pytest.mark.parametrize(
    ("answer", "remark"),
    [
        ("s5 = 0", "the rank need not fall where s5 = 0"),
        ("s5 = 0, s234 = 0", "the rank need not fall where s5 = 0; s234 = 0"),
        ("s5 = 0 and s234 = 0 and s2 = 0", "asks for more than is needed"),
        ("s5 = 0 and theta2+theta3+theta4 = 0", "half a turn on"),
        ("never", "0 of 1 are right"),
    ],
)
def test_what_must_be_zero_at_once_is_not_enough_alone(answer: str, remark: str) -> None:
    """All axes of the UR5e lie along one plane only where two sines are zero together."""
    mark = told("ur5e", "singular when angular of 0..6", answer)
    assert (mark.verdict, mark.earned) == (Verdict.WRONG, 0)
    assert remark in " ".join(mark.remarks)


def test_a_list_of_singular_poses_that_nobody_would_read_is_not_asked_for() -> None:
    """A Panda has none; its rank may be asked for."""
    with pytest.raises(DhcliError, match="more than anybody would read"):
        asked("panda", "singular when 0..7")


def test_kinds_that_are_imported_when_asked_are_known_by_all_their_words() -> None:
    """A word of a kind that is missing in the table would never be asked."""
    for kind in registry.every_kind():
        known = registry.LATER if kind not in registry.KINDS else dict.fromkeys(kind.words)
        assert set(kind.words) <= known.keys()
        assert all(set(kind.words) & {example.split()[0], " ".join(example.split()[:2])} for example in kind.examples)


def test_a_slip_in_an_answer_in_another_unit_is_named_all_the_same() -> None:
    """The first column is right in mm; the second belongs to another row."""
    q = Q["planar-2r"]
    mark = told("planar-2r", "jacobian linear of 0..2", "-444.9 -289.1; 448.7 80.25; 0 0", q)
    assert mark.verdict is Verdict.CANNOT_READ
    mark = told("planar-2r", "jacobian of 0..2", "-444.9 -289.1; 448.7 80.25; 0 0; 0 0; 0 0; 0 0", q)
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == ("angular-dropped",)
    assert "the lengths are in mm; this sheet is in m" in mark.remarks[0]
