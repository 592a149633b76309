"""Formulas as books derive them: their letters, and that they give what the engine gives."""

from __future__ import annotations

import math
import random
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from dhcli import forward, inverse, load_robot
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive import NoFormError, derive
from dhcli.kinematics.inverse.derive_points import pose_values
from dhcli.kinematics.inverse.derive_values import TRIED, joint_values, poses_proved
from dhcli.kinematics.inverse.derive_words import condition_text
from dhcli.kinematics.values import numbers, parameter_values
from dhcli.notation.tree import negate
from dhcli.notation.writer import write
from tests.kinematics.inverse.test_special import drawn
from tests.nightly import cases_for_nights

DATA = Path(__file__).parents[2] / "data"

DERIVED = (
    *(
        "planar-2r",
        "scara",
        "scara-standard",
        "scara-yim",
        "scara-zhou",
        "cylindrical",
        "cylindrical-wrist",
        "cartesian",
    ),
    *("articulated", "spherical-wrist", "stanford", "zhou-3r", "zhou-3r-modified", "zhou-6r", "ur5e"),
    *("puma560", "puma560-standard", "puma560-unimation", "puma200-spherical-wrist"),
)

USUAL = ("planar-2r", "scara-yim", "cylindrical-wrist", "spherical-wrist", "zhou-3r", "puma560")
"""What ordinary runs try: each rule occurs in them; formulas of others are run as code, in tests of its languages."""


@cache
def derived(name: str) -> Derivation:
    """The derivation for a robot, made once."""
    return derive(load_robot(name))


def shown(derivation: Derivation) -> dict[str, str]:
    """Each step's formula, by its rule and what it finds."""
    joints = derivation.robot.writing
    found = {}
    for step in derivation.steps:
        text = write(step.value, "short", joints)
        if step.spread is not None:
            text = f"{'' if text == '0' else text + ' '}± {write(step.spread, 'short', joints)}"
        if step.two == "opposite":
            text += " (+ 180°)"
        name = step.atom if isinstance(step.atom, str) else "+".join(n for n, _ in step.atom)
        found[name] = f"{step.rule}: {text}"
    return found


def test_planar_arm_comes_out_as_in_books() -> None:
    """The law of cosines for theta2, and theta1 as the difference of two angles."""
    assert shown(derived("planar-2r")) == {
        "theta2": "SQUARES: ± acos((px^2 + py^2 - a1^2 - a2^2)/(2*a1*a2))",
        "theta1": "BOTH: atan2(py, px) - atan2(a2*s2, a1 + a2*c2)",
    }


def test_puma_comes_out_by_the_rules_of_craig() -> None:
    """theta1 from the entry that only holds it, theta3 from squares, theta2 from both, and the wrist last."""
    found = shown(derived("puma560"))
    assert list(found) == ["theta1", "theta3", "theta2+theta3", "theta2", "theta4", "theta5", "theta6"]
    assert [text.split(":")[0] for text in found.values()] == [
        "ONE", "SQUARES", "BOTH", "SUM", "RATIO", "BOTH", "BOTH",
    ]  # fmt: skip
    assert found["theta1"] == "ONE: atan2(-px, py) ± acos(d3/sqrt(px^2 + py^2))"
    assert found["theta3"].startswith("SQUARES: atan2(-d4, a3) ± acos(")


def test_a_wrist_comes_out_as_euler_angles() -> None:
    """Z Y Z: theta4 and its opposite from the third column, the others from both their equations."""
    assert shown(derived("spherical-wrist")) == {
        "theta4": "RATIO: atan2(r23, r13) (+ 180°)",
        "theta5": "BOTH: atan2(r13*c4 + r23*s4, r33)",
        "theta6": "BOTH: atan2(-r11*s4 + r21*c4, -r12*s4 + r22*c4)",
    }


@pytest.mark.parametrize("name", cases_for_nights(DERIVED, *USUAL))
def test_formulas_give_the_solutions_that_the_engine_gives(name: str) -> None:
    """At random poses: as many, each of them, and each reaches the pose; no combination of signs is a stranger."""
    robot = load_robot(name)
    derivation = derived(name)
    lengths = numbers(parameter_values(robot, {}))
    chain = between(robot, derivation.start, derivation.end)
    draw = random.Random(5)  # noqa: S311  a fixed seed, for the same poses every time
    for _ in range(3):
        q = {j.name: draw.uniform(-2, 2) if j.kind == "revolute" else draw.uniform(0.2, 0.9) for j in robot.joints}
        pose = forward(robot, q)
        found = list(joint_values(derivation, {**lengths, **pose_values(chain, {**lengths, **q})}))
        task = "position" if derivation.place_only else "pose"
        engine = inverse(robot, pose, task=task)
        assert len(found) == len(engine) <= derivation.branches
        for values in found:
            row = [values[joint] for joint in robot.variables]
            reached = forward(robot, row).matrix - pose.matrix
            assert np.abs(reached[:3, 3] if derivation.place_only else reached).max() < 1e-9
            assert engine.distances(row).min() < 1e-6


@pytest.mark.parametrize("name", ["five-axis", "five-joints"])
def test_arms_of_five_joints_have_formulas(name: str) -> None:
    """No equation is used that says 0 = 0 in every pose of the arm; what signs lead elsewhere do so by far."""
    derivation = derived(str(DATA / f"{name}.yaml"))
    robot = derivation.robot
    lengths, chain = numbers(parameter_values(robot, {})), between(robot, derivation.start, derivation.end)
    assert shown(derivation)["theta1"].endswith("(+ 180°)")
    assert derivation.strangers is (name == "five-joints")
    for q in ([0.4, 0.7, 0.5, -0.6, 0.8], [-1.2, 1.1, -0.9, 0.3, 2.0]):
        pose = forward(robot, q)
        known = {**lengths, **pose_values(chain, {**lengths, **dict(zip(robot.variables, q, strict=True))})}
        rows = [[values[joint] for joint in robot.variables] for values in joint_values(derivation, known)]
        gaps = [np.abs(np.array(forward(robot, row).matrix) - pose.matrix).max() for row in rows]
        solutions = [row for row, gap in zip(rows, gaps, strict=True) if gap < 1e-9]
        engine = inverse(robot, pose)
        assert len(solutions) == len(engine) == 2
        assert (len(rows) > len(solutions)) is derivation.strangers
        assert max(engine.distances(row).min() for row in solutions) < 1e-6
        assert min([gap for gap in gaps if gap > 1e-9], default=1) > 1e-3


def test_where_a_formula_says_nothing_another_serves() -> None:
    """With the hand of a five-axis arm above its base it is the wrist that tells theta1; the steps say so."""
    robot = load_robot(str(DATA / "five-axis.yaml"))
    derivation = derived(str(DATA / "five-axis.yaml"))
    first = derivation.steps[0]
    assert first.instead is not None
    assert write(first.instead.value, "short") == "atan2(py - d5*r23, px - d5*r13)"
    said = condition_text(first, "short", derivation)
    assert said.startswith("where a1 + a2*c2 + a3*c23 + d5*s234 = 0 it is atan2(py - ")
    lengths, chain = numbers(parameter_values(robot, {})), between(robot, derivation.start, derivation.end)
    a1, a2, a3, d5 = (float(lengths[name]) for name in ("a1", "a2", "a3", "d5"))  # type: ignore[arg-type]  # numbers
    q = [0.7, 2.271, -2.386]
    q += [math.asin(-(a1 + a2 * math.cos(q[1]) + a3 * math.cos(q[1] + q[2])) / d5) - q[1] - q[2], -0.636]
    pose = np.round(forward(robot, q).matrix, 13)
    assert not pose[:2, 3].any()
    named = pose_values(chain, {**lengths, **dict(zip(robot.variables, q, strict=True))})
    found = list(joint_values(derivation, {**lengths, **named, "px": 0.0, "py": 0.0}))
    assert len(found) == len(inverse(robot, pose)) == 4
    for values in found:
        there = forward(robot, [values[joint] for joint in robot.variables]).matrix
        assert np.abs(np.array(there) - pose).max() < 1e-9


def test_an_offset_in_radians_is_an_angle_and_no_arc_of_its_cosine() -> None:
    """A joint of a URDF follows another with 0.25 rad added: no root of cos^2 + sin^2, and decimals for decimals."""
    found = shown(derive(load_robot(str(DATA / "urdf" / "levelled.urdf"))))
    assert found["theta2"].startswith("ONE: 0.25 ± acos(-5*(0.15 - sin(0.25)*(0.45 - pz) + ")
    assert found["d3"].startswith("SLIDE: -(0.075 - 0.4*s(theta2-0.25) + ")


def test_a_hand_that_hangs_down_leaves_the_first_joint_its_formula() -> None:
    """theta1 of a five-axis arm comes from where the hand is, not from where it points."""
    derivation = derived(str(DATA / "five-axis.yaml"))
    assert shown(derivation)["theta1"] == "RATIO: atan2(py, px) (+ 180°)"


def test_a_wrong_formula_is_found_out() -> None:
    """A sign left out, two exchanged, or a half of the solutions missing: the random poses tell."""
    right = derived("planar-2r")
    assert right.proved == poses_proved(right) == TRIED
    elbow, shoulder = right.steps
    turned = replace(shoulder, value=negate(shoulder.value))
    assert poses_proved(replace(right, steps=(elbow, turned))) == 0
    one_elbow = replace(elbow, value=elbow.spread, spread=None, two="")
    assert poses_proved(replace(right, steps=(one_elbow, shoulder))) == 0


@pytest.mark.parametrize("name", ["panda", "puma200"])
def test_what_the_rules_do_not_find_is_said_so(name: str) -> None:
    """An arm with a joint to spare, and one whose printed table has an offset wrist."""
    with pytest.raises(NoFormError, match="no textbook form by these rules"):
        derive(load_robot(name))


def test_a_derivation_needs_no_sympy() -> None:
    """The algebra is our own."""
    before = set(sys.modules)
    derive(load_robot("planar-2r"))
    assert not {"sympy", "mpmath"} & (set(sys.modules) - before)


def test_sums_that_are_known_end_the_search_for_the_joints_in_them() -> None:
    """Of three parallel axes, of which two are one, theta1 follows from two sums and the others do not: none is asked
    for again and again.
    """  # noqa: D205  one sentence
    rows = "0 0.4 0.1 theta, 0 0 0.2 theta, 90 0.1 0.2 theta, 90 0 .3 theta, -90 0 0 theta, 0 0 .1 theta"
    with pytest.raises(NoFormError, match="no textbook form"):
        derive(drawn("standard", rows))
