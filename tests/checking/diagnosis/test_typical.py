"""Slips that people make again and again, worked out here by hand: each has its name, and a hint without the answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import reduce
from typing import TypeAlias

import pytest

from dhcli.checking.diagnosis.result import Diagnosis
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values

Matrix: TypeAlias = list[list[float]]
Row: TypeAlias = tuple[float, float, float, float]

QUARTER = math.pi / 2


def product(*matrices: Matrix) -> Matrix:
    """Rows by columns."""

    def two(left: Matrix, right: Matrix) -> Matrix:
        return [[sum(row[k] * right[k][c] for k in range(4)) for c in range(4)] for row in left]

    return reduce(two, matrices)


def turned(axis: int, angle: float) -> Matrix:
    """A turn about x (0) or z (2)."""
    found = [[float(r == c) for c in range(4)] for r in range(4)]
    one, two = ((1, 2), (2, 0), (0, 1))[axis]
    found[one][one] = found[two][two] = math.cos(angle)
    found[one][two], found[two][one] = -math.sin(angle), math.sin(angle)
    return found


def moved(x: float, z: float) -> Matrix:
    """A shift."""
    found = turned(0, 0)
    found[0][3], found[2][3] = x, z
    return found


def standard(row: Row) -> Matrix:
    """Turn and shift along z, shift and turn along x: of a, alpha, d, theta."""
    a, alpha, d, theta = row
    return product(turned(2, theta), moved(0, d), moved(a, 0), turned(0, alpha))


def modified(row: Row) -> Matrix:
    """The other way round."""
    a, alpha, d, theta = row
    return product(turned(0, alpha), moved(a, 0), turned(2, theta), moved(0, d))


def inverse(matrix: Matrix) -> Matrix:
    """Transposed, and the position with it."""
    turn = [[matrix[c][r] for c in range(3)] for r in range(3)]
    return [*([*row, -sum(row[k] * matrix[k][3] for k in range(3))] for row in turn), matrix[3]]


def text(matrix: Matrix) -> str:
    """As it is typed."""
    return "[" + "; ".join(", ".join(f"{value:.6f}" for value in row) for row in matrix) + "]"


def asked(robot: Robot, ask: str, q: str) -> Judge:
    """One question in numbers."""
    return Judge(question_about(robot, ask, numeric=True, given=joint_values(robot, q)))


def explained(judge: Judge, answer: str) -> Diagnosis:
    """Why an answer is wrong."""
    mark = judge.check(judge.exercise.parts[0], answer)
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    return mark.diagnosis


ONE, TWO, THREE = 0.6, 0.9, 0.4
STANFORD: tuple[Row, ...] = ((0, -QUARTER, 0, ONE), (0, QUARTER, 0.154, TWO), (0, 0, THREE, 0))


def chain(rows: Sequence[Row], link: Callable[[Row], Matrix] = standard) -> Matrix:
    """The product of links."""
    return product(*map(link, rows))


def with_row(index: int, row: Row) -> Matrix:
    """The product with another row."""
    return chain([row if k == index else one for k, one in enumerate(STANFORD)])


RIGHT = chain(STANFORD)

SLIPS: dict[str, Matrix] = {
    "row-sign 2": [RIGHT[0], [-value for value in RIGHT[1]], *RIGHT[2:]],
    "column-sign 1": [*([-row[0], *row[1:]] for row in RIGHT[:3]), RIGHT[3]],
    "column-sign 4": [*([*row[:3], -row[3]] for row in RIGHT[:3]), RIGHT[3]],
    "sin-cos-all": chain([(a, alpha, d, QUARTER - theta if theta else 0) for a, alpha, d, theta in STANFORD]),
    "theta-alpha-swapped 2": with_row(1, (0, TWO, 0.154, QUARTER)),
    "theta-alpha-swaps": chain([(a, theta, d, alpha) for a, alpha, d, theta in STANFORD]),
    "a-d-swapped 2": with_row(1, (0.154, QUARTER, 0, TWO)),
    "alpha-sign 2": with_row(1, (0, -QUARTER, 0.154, TWO)),
    "thetas-swapped 1 and 2": chain([(0, -QUARTER, 0, TWO), (0, QUARTER, 0.154, ONE), STANFORD[2]]),
    "shifted alpha down": chain([(0, 0, 0, ONE), (0, -QUARTER, 0.154, TWO), (0, QUARTER, THREE, 0)]),
    "convention": chain(STANFORD, modified),
    "order-reversed": chain(STANFORD[::-1]),
    "inverse": inverse(RIGHT),
    "transposed": [*([*(RIGHT[c][r] for c in range(3)), RIGHT[r][3]] for r in range(3)), RIGHT[3]],
    "other-frames 0 2": chain(STANFORD[:2]),
}


@pytest.mark.parametrize("name", SLIPS)
def test_a_typical_slip_in_a_pose_has_its_name_and_a_hint(name: str) -> None:
    """Just that one; the hint says where to look and holds no number but that of a row, or of two."""
    found = explained(asked(load_robot("stanford"), "pose 0..3", f"{ONE},{TWO},{THREE},0,0,0"), text(SLIPS[name]))
    assert found.ids == (name,)
    assert len(found.hints) == 1
    assert not set(found.hints[0]) & set("0.-+=")


PLANAR = """
format: 1
title: Planar arm
source: made for a test
convention: standard
variables: [theta1, theta2, theta3]
parameters: {a1: 0.4 m, a2: 0.3 m, a3: 0.2 m}
base: Trans(0.1, 0.2, 0.3) Rot(x, 30°)
tool: Trans(0.05, 0, 0.07)
links:
  - {a: a1, alpha: 0, d: 0, theta: theta1}
  - {a: a2, alpha: 0, d: 0, theta: theta2}
  - {a: a3, alpha: 0, d: 0, theta: theta3}
"""


def planar(*angles: float) -> Matrix:
    """Three level links, each with the angle to the one before."""
    return chain([(a, 0, 0, theta) for a, theta in zip((0.4, 0.3, 0.2), angles, strict=True)])


BASE = product([[1, 0, 0, 0.1], [0, 1, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]], turned(0, math.pi / 6))
HAND = moved(0.05, 0.07)
ANGLES = (0.5, 0.7, 0.4)


@pytest.mark.parametrize(
    ("ask", "answer", "name"),
    [
        ("pose 0..3", planar(0.5, 0.2, 0.4), "theta-absolute 2"),
        ("pose 0..3", planar(0.5, 0.7, -0.3), "theta-absolute 3"),
        ("pose 0..3", planar(0.5, 0.2, -0.3), "thetas-absolute"),
        ("pose base..tool", product(BASE, planar(*ANGLES)), "tool-forgotten"),
        ("pose base..tool", product(planar(*ANGLES), HAND), "base-forgotten"),
    ],
)
def test_a_typical_slip_in_a_planar_arm_has_its_name(ask: str, answer: Matrix, name: str) -> None:
    """An angle counted from x0, a tool or a base left out."""
    robot = read_robot(PLANAR, "planar.yaml", "planar")
    judge = asked(robot, ask, ",".join(map(str, ANGLES)))
    assert judge.mark(judge.exercise.parts[0], judge.expected(judge.exercise.parts[0])).verdict is Verdict.RIGHT
    assert explained(judge, text(answer)).ids == (name,)


def test_an_angle_counted_from_the_reference_has_one_name_in_letters_too() -> None:
    """C2 for c12, in the pose as in the position alone."""
    robot = load_robot("planar-2r")
    for ask, answer in (
        ("pose 0..2", "c2 -s2 0 a1*c1+a2*c2; s2 c2 0 a1*s1+a2*s2; 0 0 1 0; 0 0 0 1"),
        ("position of pose 0..2", "a1*c1+a2*c2; a1*s1+a2*s2; 0"),
    ):
        judge = Judge(question_about(robot, ask, numeric=False, given={}))
        assert explained(judge, f"[{answer}]").ids == ("theta-absolute 2",)


@pytest.mark.parametrize(
    ("rows", "name"),
    [
        ("0, theta1, 0, -90; 0, theta2, d2, 90; 0, 0, d3, 0", "theta-alpha-swaps"),
        ("0, -90, 0, theta1; 0, theta2, d2, 90; 0, 0, d3, 0", "theta-alpha-swapped 2"),
    ],
)
def test_columns_of_a_table_in_each_other_s_place_have_a_name(rows: str, name: str) -> None:
    """Theta stands where alpha belongs."""
    robot = load_robot("stanford")
    rest = "; 0, -90, 0, theta4; 0, 90, 0, theta5; 0, 0, d6, theta6"
    if name == "theta-alpha-swaps":
        rest = "; 0, theta4, 0, -90; 0, theta5, 0, 90; 0, theta6, d6, 0"
    judge = Judge(question_about(robot, "table standard", numeric=False, given={}))
    assert explained(judge, f"[{rows}{rest}]").ids == (name,)
