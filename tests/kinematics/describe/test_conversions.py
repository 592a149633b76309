"""Every description from every other: written, read again, and moved as exponentials of screws say."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from dhcli.algebra.floats import Floats
from dhcli.files.urdf.robots import read_urdf
from dhcli.files.urdf.writing import urdf_text
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.files.yaml.writing import described_text
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.describe.asked import FORMS, Asked, Form
from dhcli.kinematics.describe.description import describe, known_values
from dhcli.kinematics.describe.drawn import Drawing
from dhcli.kinematics.describe.process import walk
from dhcli.kinematics.describe.products import chains_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.robot import Link, Robot
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number, Symbol
from tests.kinematics.describe.test_tables import JOINTED, end_by_screws, nasty_arm
from tests.nightly import NIGHT, cases_for_nights, in_turn, paired

OTHERS = (*FORMS, "urdf")


def robot_of(drawing: Drawing) -> Robot:
    """An arm as a robot of products."""
    links = tuple(Link(i, chain) for i, chain in enumerate(chains_of(drawing), 1))
    names = tuple(line.name for line in drawing.lines)
    return Robot("arm", "arm", "drawn by chance", Convention.PRODUCT, names, links)


def again(robot: Robot, form: str, pose: dict[str, Angle | Number] | None = None) -> Robot:
    """A robot in another description, by way of its file."""
    if form == "urdf":
        return read_urdf(urdf_text(robot), "x", "arm", tip="tool0", as_typed=True)
    return read_robot(described_text(describe(robot, Asked(form, pose=pose))), "x", "arm")  # type: ignore[arg-type]


def gap(robot: Robot, q: dict[str, float], expected: np.ndarray) -> float:
    """The largest difference of a robot's pose, base to tool, from what it should be."""
    return float(np.abs(np.array(fold(robot.chain, Floats({**known_values(robot), **q}))) - expected).max())


def values_of(robot: Robot, q: dict[str, float]) -> dict[str, float]:
    """Joint values by the names that a URDF has given the joints."""
    return {variable: q[robot.called.get(variable, variable)] for variable in robot.variables}


@pytest.mark.parametrize("seed", cases_for_nights(range(1000), *range(3)))
def test_an_arm_with_axes_as_bad_as_they_come_is_the_same_in_every_description(seed: int) -> None:
    """Against exponentials of its lines, to 1e-13 of its size; slides and screws among its joints."""
    draw = random.Random(seed)  # noqa: S311  the same arms every time
    drawing = nasty_arm(draw)
    robot = robot_of(drawing)
    q = {line.name: draw.uniform(-3, 3) for line in drawing.lines}
    expected = end_by_screws(drawing, q)
    size = max(
        1.0,
        np.abs(expected).max(),
        *(abs(x) for line in drawing.lines for v in (line.through or {}).values() for x in v),
    )
    feet = [abs(x) for leg in walk(drawing).legs for v in leg.normal.end.values() for x in v]
    for form in OTHERS:
        found = again(robot, form)
        reach = max(size, *feet) if form in ("standard", "modified") else size
        given = values_of(found, q) if form == "urdf" else q
        assert gap(found, given, expected) <= 1e-13 * reach * len(q), form


@pytest.mark.parametrize(
    ("name", "form"),
    paired(
        cases_for_nights(JOINTED, "cartesian", "puma560", "scara", "stanford", "zhou-3r"),
        ("standard", "modified", "axes", "product"),
    ),
)
def test_a_robot_drawn_anywhere_is_the_same_robot(name: str, form: Form) -> None:
    """In 20 poses at night; lengths that have no value get one."""
    robot = load_robot(name)
    draw = random.Random(f"{name} {form}")  # noqa: S311  the same poses every time
    lacking = [length for length, value in robot.parameters.items() if value is None]
    given = {length: Number(Fraction(1, 4) + i, 2) for i, length in enumerate(lacking)}
    robot = replace(robot, parameters={**robot.parameters, **given})
    for _ in range(20 if NIGHT else 1):
        pose = {
            joint.name: Angle(radians=_decimal(draw, 3)) if joint.kind == "revolute" else Number(_decimal(draw, 1), 3)
            for joint in robot.joints
        }
        found = again(robot, form, pose)
        q = {variable: draw.uniform(-3, 3) for variable in robot.variables}
        expected = np.array(fold(robot.chain, Floats({**known_values(robot), **q})))
        reach = max(1.0, np.abs(expected).max())
        assert gap(found, q, expected) <= 1e-13 * reach * len(q)


@pytest.mark.parametrize(("turn", "first", "second"), [(k, *pair) for k, pair in enumerate(product(FORMS, repeat=2))])
def test_each_description_leads_to_each_other(turn: int, first: Form, second: Form) -> None:
    """Through two files, for a robot with letters or one with a slide."""
    for name in in_turn(("puma560", "stanford"), turn + turn // len(FORMS), 2):
        robot = load_robot(name)
        found = again(again(robot, first), second)
        q = {variable: 0.3 + 0.1 * i for i, variable in enumerate(robot.variables)}
        expected = np.array(fold(robot.chain, Floats({**known_values(robot), **q})))
        assert gap(found, q, expected) <= 1e-14
        assert set(found.parameters) == set(robot.parameters)


SCREW = """\
format: 1
title: A lead screw behind a joint
source: made up
convention: product
variables: [q1, q2]
parameters: {p: 2 mm, l: 0.3}
links: ["Rot(z, q1) * Trans(l, 0, 0)", "Rot(x, 90°) * Trans(0, 0, p*q2) * Rot(z, q2) * Trans(0, 0, 0.1)"]
"""


@pytest.mark.parametrize("form", FORMS)
def test_a_screw_keeps_its_letter_and_its_proof_for_all_values(form: Form) -> None:
    """Its pitch is written with the letter, in every description."""
    robot = read_robot(SCREW, "x", "arm")
    found = describe(robot, Asked(form))
    assert found.proof.kind == "exact"
    text = described_text(found)
    assert read_robot(text, "x", "arm").parameters.keys() == robot.parameters.keys()


def _decimal(draw: random.Random, size: float) -> Fraction:
    """A number with three decimals."""
    return Fraction(round(draw.uniform(-size, size) * 1000), 1000)


@pytest.mark.parametrize(
    "links",
    [
        "Rot(z, q1) * Trans(p*q1, 0, 0)",
        "Trans(0, 0, p*q1), Rot(z, q2), Rot(z, q1)",
        "Rot(z, q1), Rot(z, q2), Trans(0, 0, p*q1)",
        "Rot(z, q1), Rot(z, q2), Rot(x, q1)",
    ],
)
def test_what_is_no_screw_is_described_move_by_move(links: str) -> None:
    """A slide across the axis, or a turn somewhere else, has a joint of its own."""
    names = "q1, q2" if "q2" in links else "q1"
    text = f"format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [{names}]\nparameters: {{p: 0.1}}\n"
    rows = "".join(f"  - {link})\n" for link in links.removesuffix(")").split("), "))
    found = describe(read_robot(f"{text}links:\n{rows}", "x", "arm"), Asked("screws"))
    assert len(found.screws) == names.count("q") + 1
    assert list(found.shared.values()) in ([Symbol("p") * Symbol("q1")], [Angle.of("q1")])
